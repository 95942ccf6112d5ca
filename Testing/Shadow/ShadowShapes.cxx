// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowShapes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

namespace ShadowShapes
{
vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Point>& points, const std::vector<Polygon>& polygons)
{
  vtkNew<vtkPoints> meshPoints;
  meshPoints->SetDataTypeToDouble();
  for (const Point& point : points)
  {
    meshPoints->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeBox(const Point& centre, const Point& size)
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetCenter(centre[0], centre[1], centre[2]);
  source->SetXLength(size[0]);
  source->SetYLength(size[1]);
  source->SetZLength(size[2]);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeSharedBox(const Point& centre, const Point& size)
{
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ centre[0] + (i & 1 ? 0.5 : -0.5) * size[0],
      centre[1] + (i & 2 ? 0.5 : -0.5) * size[1], centre[2] + (i & 4 ? 0.5 : -0.5) * size[2] });
  }
  return MakeMesh(points,
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } });
}

vtkSmartPointer<vtkPolyData> MakeSphere(const Point& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetCenter(centre[0], centre[1], centre[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeTetrahedron(const std::array<Point, 4>& corners)
{
  return MakeMesh(
    { corners.begin(), corners.end() }, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
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

vtkActor* AddBox(vtkRenderer* renderer, const Point& centre, const Point& size)
{
  return AddMesh(renderer, MakeBox(centre, size));
}

vtkActor* AddSphere(vtkRenderer* renderer, const Point& centre, double radius, int resolution)
{
  return AddMesh(renderer, MakeSphere(centre, radius, resolution));
}

vtkActor* AddFloor(vtkRenderer* renderer, double halfSize, double z)
{
  return AddMesh(renderer,
    MakeMesh({ { -halfSize, -halfSize, z }, { halfSize, -halfSize, z }, { halfSize, halfSize, z },
               { -halfSize, halfSize, z } },
      { { 0, 1, 2, 3 } }));
}

vtkLight* AddDirectional(vtkRenderer* renderer, const Point& direction)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetPosition(-direction[0], -direction[1], -direction[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  return light;
}

vtkLight* AddSpot(
  vtkRenderer* renderer, const Point& position, const Point& focalPoint, double cone)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetPosition(position.data());
  light->SetFocalPoint(focalPoint.data());
  light->SetConeAngle(cone);
  renderer->AddLight(light);
  return light;
}

vtkLight* AddPoint(vtkRenderer* renderer, const Point& position)
{
  return AddSpot(renderer, position, { position[0], position[1], position[2] - 1.0 }, 90.0);
}

void Look(vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double viewAngle)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const bool alongZ = eye[0] == focalPoint[0] && eye[1] == focalPoint[1];
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(0.0, alongZ ? 1.0 : 0.0, alongZ ? 0.0 : 1.0);
  camera->SetViewAngle(viewAngle);
  renderer->ResetCameraClippingRange();
}

void LookParallel(vtkRenderer* renderer, const Point& eye, const Point& focalPoint, double scale)
{
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(scale);
  Look(renderer, eye, focalPoint);
}
}
