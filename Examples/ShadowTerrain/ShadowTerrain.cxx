// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowTerrain.cxx
 * @brief Hills with towers, and a flock of birds over them, in the light of a low sun.
 *
 * The hills are data, towers and birds synthetic. Birds are larger than life, 160 m
 * from wing to wing, so that their shadows can be seen from 5 km.
 */
#include "Example.h"
#include "LoadScene.h"
#include "Random.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkImageDataGeometryFilter.h"
#include "vtkImageInterpolator.h"
#include "vtkImageResize.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkTriangleFilter.h"
#include "vtkWarpScalar.h"

#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace
{
/// Elevations around the Jacksboro Fault in Tennessee, 7.1 by 8.9 km (Examples/Data/README.md names
/// their source), as a surface of triangles in metres: x points to the east, y to the north, z up;
/// the origin is in the south-west. The data have 97 x 97 points, 3 arc seconds apart; two more
/// points are interpolated by cubics between neighbours in each direction.
vtkSmartPointer<vtkPolyData> MakeTerrain(const std::string& program)
{
  constexpr int side = 97;
  vtkNew<vtkImageData> data;
  data->SetDimensions(side, side, 1);
  data->SetSpacing(74.41, 92.66, 1.0); // Of 3 arc seconds at 36.6 degrees north.
  data->AllocateScalars(VTK_FLOAT, 1);
  std::ifstream file(NBufferExamples::FindData(program, "jacksboro-heights.csv"));
  for (int i = 0; i < side * side; ++i)
  {
    // The first row is the northernmost. A comma or the end of the line follows each number.
    file >> *static_cast<float*>(data->GetScalarPointer(i % side, side - 1 - i / side, 0));
    file.ignore();
  }
  if (!file)
  {
    throw std::runtime_error("jacksboro-heights.csv is missing or damaged");
  }
  vtkNew<vtkImageInterpolator> cubic;
  cubic->SetInterpolationModeToCubic();
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(data);
  resize->SetInterpolator(cubic);
  resize->SetOutputDimensions(3 * side - 2, 3 * side - 2, 1);
  vtkNew<vtkImageDataGeometryFilter> plane;
  plane->SetInputConnection(resize->GetOutputPort());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(warp->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

/// Head in direction x, tail, and two wings that are raised a little; metres.
vtkSmartPointer<vtkPolyData> MakeBird()
{
  vtkNew<vtkPoints> points;
  for (const auto& p : { std::array<double, 3>{ 40.0, 0.0, 0.0 }, { -30.0, 0.0, 0.0 },
         { -20.0, -80.0, 25.0 }, { -20.0, 80.0, 25.0 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> wings;
  wings->InsertNextCell({ 0, 1, 2 });
  wings->InsertNextCell({ 0, 3, 1 });
  auto bird = vtkSmartPointer<vtkPolyData>::New();
  bird->SetPoints(points);
  bird->SetPolys(wings);
  return bird;
}
}

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("Hills with towers and a flock of birds", "shadows");
  const auto show = [&]()
  {
    const vtkSmartPointer<vtkPolyData> terrain = MakeTerrain(argv[0]);
    example.AddMesh(terrain, { 0.58, 0.64, 0.44 });

    NBufferExamples::Random random(5);
    for (int i = 0; i < 40; ++i)
    {
      double foot[3];
      terrain->GetPoint(random.Index(terrain->GetNumberOfPoints()), foot);
      const double height = random.Between(150.0, 350.0);
      example.AddCuboid({ foot[0], foot[1], foot[2] + 0.5 * height - 50.0 },
        { 60.0, 60.0, height + 100.0 }, { 0.88, 0.84, 0.78 });
    }
    const vtkSmartPointer<vtkPolyData> bird = MakeBird();
    for (int i = 0; i < 150; ++i)
    {
      // Denser in the middle; all fly about west.
      const double angle = random.Between(0.0, 2.0 * vtkMath::Pi());
      const double distance = 1600.0 * random.Between(0.0, 1.0);
      vtkActor* actor = example.AddMesh(bird, { 0.97, 0.96, 0.94 });
      actor->SetPosition(3300.0 + distance * std::cos(angle), 2600.0 + distance * std::sin(angle),
        random.Between(1150.0, 1350.0));
      actor->RotateZ(random.Between(150.0, 200.0));
    }

    vtkRenderer* renderer = example.GetRenderer();
    renderer->SetBackground(0.66, 0.79, 0.92);
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(-0.8, -0.25, 0.7);
    sun->SetColor(1.0, 0.95, 0.85);
    renderer->AddLight(sun);
    example.AddFill(0.2);

    vtkNew<vtkShadowVolumeClampPass> shadows;
    shadows->SetLightCasts(sun, example.IsOn());
    renderer->SetPass(shadows);

    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(3600.0, -2600.0, 3400.0);
    camera->SetFocalPoint(3570.0, 3400.0, 700.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCameraClippingRange();
    example.Show("shadow-terrain", shadows);
  };
  return example.Run(argc, argv, show);
}
