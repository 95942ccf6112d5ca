// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RenderedTriangles.h
 * @brief The triangles that a renderer draws for its opaque actors, in double world coordinates.
 */
#ifndef RenderedTriangles_h
#define RenderedTriangles_h

#include <vector>

class vtkActor;
class vtkProp;
class vtkRenderer;

/// A prop of the renderer and the actor of one of its paths. They are the same object unless the
/// prop is an assembly.
struct RenderedActor
{
  vtkProp* Prop = nullptr;
  vtkActor* Actor = nullptr;
};

struct RenderedTriangles
{
  std::vector<double> Corners; ///< Nine coordinates for each triangle.
  std::vector<int> Owners;     ///< For each triangle, the place of its actor in Actors.
  std::vector<RenderedActor> Actors;
};

/**
 * Collects the triangles of all actors that are visible, opaque and drawn as surfaces: those of
 * assemblies by their paths, those of the visible blocks of composite data, and those of the
 * instances of glyphs with one source, whose places follow from vtkTransform. Polygons are cut into
 * triangles by the mapper's own function, and clipping planes are applied. Triangles with a
 * coordinate that is not finite are left out.
 *
 * Throws std::invalid_argument for a mapper whose triangles are not known here.
 */
RenderedTriangles CollectRenderedTriangles(vtkRenderer* renderer);

#endif
