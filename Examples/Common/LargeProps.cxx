// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that are one prop, which vtkNBufferCuller culls unit by unit.
#include "SceneKinds.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <random>

namespace NBufferExamples
{
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data, const glm::dvec3& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetStatic(true);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  return actor;
}

Scene::PathMaker MakePathOf(std::function<CameraPose(int frame, int frames)> look)
{
  return [look = std::move(look)](int frames, std::uint64_t)
  {
    CameraPath path;
    for (int i = 0; i < frames; ++i)
    {
      path.push_back(look(i, frames));
    }
    return path;
  };
}

namespace
{
/// A gyroid of six periods along each axis in the cube from -1 to 1: 0.9 million triangles.
vtkSmartPointer<vtkPolyData> MakeGyroid()
{
  constexpr int size = 126;
  const double frequency = 6.0 * vtkMath::Pi();
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / (size - 1), 2.0 / (size - 1), 2.0 / (size - 1));
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    image->GetPoint(i, glm::value_ptr(point));
    const glm::dvec3 s = glm::sin(frequency * point);
    const glm::dvec3 c = glm::cos(frequency * point);
    values->SetValue(i, static_cast<float>(s.x * c.y + s.y * c.z + s.z * c.x));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// The height of hilly ground that is 8 wide.
double GetHeight(double x, double y)
{
  return 0.25 * std::sin(2.1 * x + 0.4) * std::cos(1.7 * y) +
    0.08 * std::sin(5.3 * x - 1.0) * std::sin(4.9 * y + 0.7) + 0.02 * std::cos(17.0 * x + 11.0 * y);
}

/// Half a million triangles, row by row.
vtkSmartPointer<vtkPolyData> MakeGroundMesh()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -4.0, 0.0);
  plane->SetPoint1(4.0, -4.0, 0.0);
  plane->SetPoint2(-4.0, 4.0, 0.0);
  plane->SetResolution(500, 500);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  vtkPolyData* flat = triangles->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(flat->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    flat->GetPoint(i, glm::value_ptr(point));
    points->SetPoint(i, point.x, point.y, GetHeight(point.x, point.y));
  }
  auto ground = vtkSmartPointer<vtkPolyData>::New();
  ground->SetPoints(points);
  ground->SetPolys(flat->GetPolys());
  return ground;
}

/// Coordinates from -1 to 1. (The order in which the arguments of a function are evaluated would be
/// that of the compiler.)
glm::dvec3 DrawPoint(std::minstd_rand& random)
{
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  const double z = uniform(random);
  const double y = uniform(random);
  const double x = uniform(random);
  return { x, y, z };
}

vtkSmartPointer<vtkActor> MakeCloud(vtkPoints* points, const glm::dvec3& color)
{
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell({ i });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  const vtkSmartPointer<vtkActor> cloud = MakeActor(data, color);
  cloud->GetProperty()->SetPointSize(2.0F);
  return cloud;
}

/// Hides what is between -1 and 1 from the first half of the path "past".
vtkSmartPointer<vtkActor> MakeWall()
{
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-3.0, -2.0, -3.0);
  wall->SetPoint1(3.0, -2.0, -3.0);
  wall->SetPoint2(-3.0, -2.0, 3.0);
  wall->Update();
  return MakeActor(wall->GetOutput(), { 0.6, 0.6, 0.6 });
}

/// With the planes at 0 they are fitted to the scene.
CameraPose Look(const glm::dvec3& eye, const glm::dvec3& target, double viewAngle,
  double near = 0.0, double far = 0.0)
{
  return { eye, target, { 0.0, 0.0, 1.0 }, viewAngle, near, far };
}

CameraPose LookPast(int frame)
{
  return Look({ -0.5 + 0.01 * frame, -6.0, 0.2 }, { 0.0, 0.0, 0.0 }, 30.0);
}
}

Scene MakeIsosurface()
{
  Scene scene;
  scene.Name = "isosurface";
  scene.Actors = { MakeActor(MakeGyroid(), { 0.8, 0.7, 0.5 }) };
  const auto lookFromOutside = [](int frame, int)
  {
    const double angle = 0.5 + 0.01 * frame;
    return Look({ 4.5 * std::cos(angle), 4.5 * std::sin(angle), 2.0 }, { 0.0, 0.0, 0.0 }, 30.0);
  };
  // Along an axis on which the gyroid leaves a channel open, looking around.
  const auto lookFromInside = [](int frame, int)
  {
    const glm::dvec3 eye(0.125, 0.0, -0.6 + 0.004 * frame);
    const double turn = 0.02 * frame;
    return Look(eye, eye + glm::dvec3(std::cos(turn), std::sin(turn), 0.5 * std::sin(2.0 * turn)),
      60.0, 0.005, 4.0);
  };
  scene.Paths = { { "outside", MakePathOf(lookFromOutside) },
    { "inside", MakePathOf(lookFromInside) } };
  return scene;
}

Scene MakePointsBehindWall(int count)
{
  std::minstd_rand random(1);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, glm::value_ptr(DrawPoint(random)));
  }
  Scene scene;
  scene.Name = "points-wall";
  scene.Actors = { MakeWall(), MakeCloud(points, { 0.9, 0.3, 0.2 }) };
  scene.Paths = { { "past", MakePathOf([](int frame, int) { return LookPast(frame); }) } };
  return scene;
}

Scene MakeTerrain(int count)
{
  Scene scene;
  scene.Name = count > 0 ? "points-terrain" : "terrain";
  scene.Actors = { MakeActor(MakeGroundMesh(), { 0.45, 0.6, 0.3 }) };
  if (count > 0)
  {
    std::minstd_rand random(2);
    std::uniform_real_distribution<> uniform(-4.0, 4.0);
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double x = uniform(random);
      const double y = uniform(random);
      points->SetPoint(i, x, y, GetHeight(x, y) + 0.01);
    }
    scene.Actors.push_back(MakeCloud(points, { 0.9, 0.5, 0.2 }));
  }
  const auto lookAhead = [](int frame, int)
  {
    const double x = -2.5 + 0.02 * frame;
    const double y = 0.3 * std::sin(0.05 * frame);
    const glm::dvec3 eye(x, y, GetHeight(x, y) + 0.06);
    return Look(eye, eye + glm::dvec3(1.0, 0.4 * std::sin(0.03 * frame), -0.03), 50.0, 0.01, 12.0);
  };
  const auto lookDown = [](int frame, int)
  {
    const double x = -0.5 + 0.01 * frame;
    return Look({ x, -0.01, 10.0 }, { x, 0.0, 0.0 }, 45.0);
  };
  scene.Paths = { { "eye-height", MakePathOf(lookAhead) }, { "above", MakePathOf(lookDown) } };
  return scene;
}

Scene MakeGlyphs(const std::string& name, int count)
{
  const bool isLayer = name == "glyph-open";
  std::minstd_rand random(1);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  // A layer of 5 columns for 4 rows.
  const int columns = static_cast<int>(std::ceil(std::sqrt(1.25 * count)));
  const double distance = 2.0 / columns;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const glm::dvec3 point = isLayer ? glm::dvec3(distance * static_cast<double>(i % columns) - 1.0,
                                         distance * static_cast<double>(i / columns) - 0.8, 0.0)
                                     : DrawPoint(random);
    points->SetPoint(i, glm::value_ptr(point));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  // With this length 7,200 cubes of the cloud own a pixel of 960 x 720.
  const double length = isLayer ? 0.75 * distance : 0.038;
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(length);
  cube->SetYLength(length);
  cube->SetZLength(length);
  cube->Update();
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceData(cube->GetOutput());
  mapper->ScalingOff();
  mapper->OrientOff();
  mapper->ScalarVisibilityOff();
  mapper->SetStatic(true);
  auto glyphs = vtkSmartPointer<vtkActor>::New();
  glyphs->SetMapper(mapper);
  glyphs->GetProperty()->SetColor(0.9, 0.5, 0.2);

  Scene scene;
  scene.Name = name;
  if (name == "glyph-wall")
  {
    scene.Actors.push_back(MakeWall());
  }
  scene.Actors.push_back(glyphs);
  const auto look = [isLayer](int frame, int)
  {
    const double x = 0.1 * (-0.5 + 0.01 * frame);
    return isLayer ? Look({ x, -0.01, 5.0 }, { x, 0.0, 0.0 }, 30.0) : LookPast(frame);
  };
  scene.Paths = { { "past", MakePathOf(look) } };
  return scene;
}

} // namespace NBufferExamples
