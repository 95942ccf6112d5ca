// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The two scenes of which section 3.1 of the N-buffer paper says what is found and what is not.
#include "SceneKinds.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <random>

namespace NBufferExamples
{
namespace
{
vtkSmartPointer<vtkPolyData> MakeBall(const glm::dvec3& center, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x, center.y, center.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(2 * resolution);
  sphere->SetPhiResolution(resolution + 1);
  sphere->Update();
  return sphere->GetOutput();
}

/// Square leaves in all directions, at places spread evenly over a ball.
vtkSmartPointer<vtkPolyData> MakeCrown(
  const glm::dvec3& center, double radius, int leaves, std::minstd_rand& random)
{
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  const auto inBall = [&]()
  {
    glm::dvec3 point;
    do
    {
      point = { uniform(random), uniform(random), uniform(random) };
    } while (glm::dot(point, point) > 1.0);
    return point;
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < leaves; ++i)
  {
    const glm::dvec3 middle = center + radius * inBall();
    const glm::dvec3 side = 0.06 * glm::normalize(inBall());
    const glm::dvec3 other = glm::length(side) * glm::normalize(glm::cross(side, inBall()));
    vtkIdType corners[4];
    int corner = 0;
    for (const glm::dvec3& offset : { side + other, side - other, -side - other, other - side })
    {
      corners[corner++] = points->InsertNextPoint(glm::value_ptr(middle + 0.5 * offset));
    }
    quads->InsertNextCell(4, corners);
  }
  auto crown = vtkSmartPointer<vtkPolyData>::New();
  crown->SetPoints(points);
  crown->SetPolys(quads);
  return crown;
}

void AddPath(Scene& scene, const glm::dvec3& from, double reach)
{
  const auto look = [from, reach](int frame, int) -> CameraPose
  {
    return { from + glm::dvec3(reach * std::sin(0.3 * frame), 0.0, 0.0), { 0.0, 0.0, 0.0 },
      { 0.0, 0.0, 1.0 } };
  };
  scene.Paths = { { "past", MakePathOf(look) } };
}
}

Scene MakeSpheresInSpheres()
{
  constexpr int side = 8;
  Scene scene;
  scene.Name = "shells";
  for (int i = 0; i < side * side; ++i)
  {
    const glm::dvec3 center(2.5 * (i % side - 3.5), 0.0, 2.5 * (i / side - 3.5));
    scene.Actors.push_back(MakeActor(MakeBall(center, 1.0, 32), { 0.5, 0.6, 0.7 }));
    const double radius = 0.5 + 0.45 * i / (side * side - 1);
    // So few triangles that each of them may be tested.
    scene.Actors.push_back(MakeActor(MakeBall(center, radius, 8), { 0.9, 0.4, 0.2 }));
  }
  AddPath(scene, { 0.0, -42.0, 0.0 }, 0.5);
  return scene;
}

Scene MakeForest()
{
  std::minstd_rand random(1);
  Scene scene;
  scene.Name = "leaves";
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 8; ++column)
    {
      for (int layer = 0; layer < 4; ++layer)
      {
        const glm::dvec3 center(
          1.2 * (column - 3.5) + 0.4 * (row % 2), -1.5 * row, 1.2 * (layer - 1.5));
        const double shade = 0.4 + 0.1 * row + 0.05 * layer;
        scene.Actors.push_back(
          MakeActor(MakeCrown(center, 0.9, 4000, random), { 0.3 * shade, shade, 0.2 * shade }));
      }
    }
  }
  for (int i = 0; i < 400; ++i)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.4 * (i % 20 - 9.5), 6.0, 0.2 * (i / 20 - 9.5));
    cube->SetXLength(0.15);
    cube->SetYLength(0.15);
    cube->SetZLength(0.15);
    cube->Update();
    scene.Actors.push_back(MakeActor(cube->GetOutput(), { 0.8, 0.2, 0.2 }));
  }
  AddPath(scene, { 0.0, -14.0, 0.0 }, 1.0);
  return scene;
}

} // namespace NBufferExamples
