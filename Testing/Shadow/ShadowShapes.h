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
using TestScene::MakeMesh;
using TestScene::SceneBuilder;
using Polygon = std::vector<int>;

/// VTK's sphere source: one point at each pole, one seam.
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution);

/// An actor with surfaces of a colour that follows from its number in the renderer, as those of
/// scenarios.
vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh);

/// Add to a renderer what is described; its viewport stays.
void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build);
}

#endif
