// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowShapes.h
 * @brief Meshes, lights and cameras of the shadow scenes. The world's z axis points up.
 */
#ifndef ShadowShapes_h
#define ShadowShapes_h

#include "Shapes.h"

#include <vector>

class vtkActor;
class vtkLight;
class vtkRenderer;

namespace ShadowShapes
{
using Point = glm::dvec3;
using TestScene::MakeBox;
using TestScene::ShapeKind;
using Polygon = std::vector<int>;

/// Points are stored in double precision.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Point>& points, const std::vector<Polygon>& polygons);

/// VTK's sphere source: one point at each pole, one seam.
vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution);

/// Actors with surfaces of a colour that follows from their number in the renderer.
vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh);
vtkActor* AddShape(vtkRenderer* renderer, TestScene::ShapeKind kind, const Point& centre,
  const Point& size, int detail = 1);
vtkActor* AddSphere(vtkRenderer* renderer, const Point& centre, double radius, int resolution = 16);

/// The parallelogram at a corner with these two sides, one quad.
vtkActor* AddSheet(vtkRenderer* renderer, const Point& corner, const Point& u, const Point& v);

/// The square [-halfSize, halfSize]^2 at height z, one quad.
vtkActor* AddFloor(vtkRenderer* renderer, double halfSize, double z = 0.0);

vtkLight* AddDirectional(vtkRenderer* renderer, const Point& direction);
/// `cone` is VTK's cone angle: from the axis to the cone's surface, degrees.
vtkLight* AddSpot(
  vtkRenderer* renderer, const Point& position, const Point& focalPoint, double cone);
vtkLight* AddPoint(vtkRenderer* renderer, const Point& position);

/// Camera with z up (y up if it looks straight down), clipping range from the scene.
void Look(
  vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double viewAngle = 40.0);

/// The same with parallel projection; `scale` is half the height of the view.
void LookParallel(vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double scale);
}

#endif
