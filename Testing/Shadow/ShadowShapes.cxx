// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowShapes.h"

#include "Fill.h"
#include "LightRig.h"
#include "SceneBuilder.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace ShadowShapes
{
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Point>& points, const std::vector<Polygon>& polygons)
{
  TestScene::SceneBuilder scene;
  scene.UsesDoubles = true;
  return TestScene::MakeShape(scene.Mesh(points, polygons).Shape);
}

vtkActor* AddMesh(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const int number = renderer->GetActors()->GetNumberOfItems();
  actor->GetProperty()->SetColor(
    0.4 + 0.1 * (number % 7), 0.4 + 0.1 * (number % 5), 0.4 + 0.2 * (number % 3));
  renderer->AddActor(actor);
  return actor;
}

namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(
  ShapeKind kind, const Point& centre, const Point& size, int detail)
{
  TestScene::SceneBuilder scene;
  scene.UsesDoubles = true;
  return TestScene::MakeShape(scene.Add(kind, centre, size, detail).Shape);
}
}

vtkSmartPointer<vtkPolyData> MakeGlobe(const Point& centre, double radius, int resolution)
{
  return MakeMesh(ShapeKind::Globe, centre, Point(2.0 * radius), resolution);
}

vtkActor* AddShape(vtkRenderer* renderer, TestScene::ShapeKind kind, const Point& centre,
  const Point& size, int detail)
{
  return AddMesh(renderer, MakeMesh(kind, centre, size, detail));
}

vtkActor* AddSphere(vtkRenderer* renderer, const Point& centre, double radius, int resolution)
{
  return AddShape(renderer, ShapeKind::Globe, centre, Point(2.0 * radius), resolution);
}

vtkActor* AddFloor(vtkRenderer* renderer, double halfSize, double z)
{
  TestScene::SceneBuilder scene;
  scene.UsesDoubles = true;
  return AddMesh(renderer, TestScene::MakeShape(scene.Floor(halfSize, z).Shape));
}

namespace
{
vtkLight* AddMade(vtkRenderer* renderer, const TestScene::Light& light)
{
  vtkSmartPointer<vtkLight> made = TestScene::MakeLight(light);
  renderer->AddLight(made);
  return made;
}
}

vtkLight* AddDirectional(vtkRenderer* renderer, const Point& direction)
{
  return AddMade(renderer, TestScene::SceneBuilder().Directional(direction));
}

vtkLight* AddSpot(
  vtkRenderer* renderer, const Point& position, const Point& focalPoint, double cone)
{
  return AddMade(renderer, TestScene::SceneBuilder().Spot(position, focalPoint, cone));
}

vtkLight* AddPoint(vtkRenderer* renderer, const Point& position)
{
  return AddMade(renderer, TestScene::SceneBuilder().PointLight(position));
}

void Look(vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double viewAngle)
{
  TestScene::SetView(renderer, TestScene::SceneBuilder().Look(eye, focalPoint, viewAngle));
}

void LookParallel(vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double scale)
{
  TestScene::SetView(renderer, TestScene::SceneBuilder().LookParallel(eye, focalPoint, scale));
}
}
