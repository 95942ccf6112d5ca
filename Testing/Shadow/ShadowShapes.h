// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowShapes.h
 * @brief Meshes of VTK's in scenes that are described by scenarios otherwise.
 */
#ifndef ShadowShapes_h
#define ShadowShapes_h

#include "SceneBuilder.h"
#include "Shapes.h"

#include <functional>
#include <vector>

class vtkActor;
class vtkRenderer;

namespace ShadowShapes
{
using Point = glm::dvec3;
using TestScene::MakeBox;
using TestScene::SceneBuilder;
using Polygon = std::vector<int>;

/// Points are stored in double precision.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Point>& points, const std::vector<Polygon>& polygons);

/// VTK's sphere source: one point at each pole, one seam.
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution);

/// An actor with surfaces of a colour that follows from its number in the renderer, as those of
/// scenarios.
vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh);

/// Add to a renderer what is described; its viewport stays.
void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build);

/// The renderer's camera as SceneBuilder::Look() has it.
void Look(vtkRenderer* renderer, const Point& eye, const Point& focalPoint);

/// The parallelogram at a corner with these two sides, one quad.
TestScene::Prop& AddSheet(SceneBuilder& scene, const Point& corner, const Point& u, const Point& v);
}

#endif
