// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowShapes.h
 * @brief Adds meshes of VTK, and what a scenario describes, to renderers of shadow tests.
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

/// Makes a sphere by vtkSphereSource. It has one point at each pole and one seam.
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution);

/// Adds an actor. Its colour follows from its number in the renderer, as in scenarios.
vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh);

/// Adds what `build` describes to a renderer, whose viewport does not change.
void Fill(vtkRenderer* renderer, const std::function<void(SceneBuilder&)>& build);
}

#endif
