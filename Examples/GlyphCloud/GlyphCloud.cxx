// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GlyphCloud.cxx
 * @brief A ball of 200,000 cubes, all instances of one vtkGlyph3DMapper. The culler draws only
 * those of them that can be seen. Prints the times with and without it.
 */
#include "Example.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <iostream>
#include <random>

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("200,000 cubes that are one actor", "culler");
  int frames = 12;
  example.AddOption("--frames", frames, "How many frames are drawn and timed", 1, 10000);
  const auto show = [&]()
  {
    std::minstd_rand random(1);
    std::uniform_real_distribution<> uniform(-1.0, 1.0);
    vtkNew<vtkPoints> points;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    while (points->GetNumberOfPoints() < 200000)
    {
      const double x = uniform(random), y = uniform(random), z = uniform(random);
      if (x * x + y * y + z * z < 1.0)
      {
        points->InsertNextPoint(x, y, z);
        colors->InsertNextTuple3(190.0 + 60.0 * z, 150.0 + 60.0 * y, 130.0 - 60.0 * z);
      }
    }
    vtkNew<vtkPolyData> ball;
    ball->SetPoints(points);
    ball->GetPointData()->SetScalars(colors);
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.02);
    cube->SetYLength(0.02);
    cube->SetZLength(0.02);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(ball);
    mapper->SetSourceConnection(cube->GetOutputPort());
    mapper->ScalingOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkRenderer* renderer = example.GetRenderer();
    renderer->AddActor(actor);
    renderer->SetBackground(0.9, 0.92, 0.95);
    example.AddFill(1.0);

    vtkNew<vtkNBufferCuller> culler;
    renderer->AddCuller(culler); // Nothing else: large props are culled unit by unit by default.

    const auto setCamera = [renderer](int frame)
    {
      vtkCamera* camera = renderer->GetActiveCamera();
      const double angle = 0.02 * frame;
      camera->SetPosition(4.0 * std::sin(angle), -4.0 * std::cos(angle), 1.0);
      camera->SetViewUp(0.0, 0.0, 1.0);
      renderer->ResetCameraClippingRange();
    };
    example.Compare(culler, frames, setCamera);
    int hidden = 0;
    for (int point = 0; point < points->GetNumberOfPoints(); ++point)
    {
      hidden += culler->GetVerdict(actor, point) == vtkNBufferVerdict::Hidden;
    }
    std::cout << "glyph-cloud: " << hidden << " of 200000 cubes hidden\n";
    example.Show("glyph-cloud");
  };
  return example.Run(argc, argv, show);
}
