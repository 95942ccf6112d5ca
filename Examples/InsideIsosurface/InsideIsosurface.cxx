// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InsideIsosurface.cxx
 * @brief A gyroid of 0.9 million triangles in one mesh, seen from inside. The culler draws only the
 * groups of triangles that can be seen. Prints the times with and without it.
 */
#include "Example.h"
#include "LoadScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <iostream>

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("An isosurface seen from inside", "culler");
  int frames = 12;
  example.AddOption("--frames", frames, "How many frames are drawn and timed", 1, 10000);
  const auto show = [&]()
  {
    const NBufferExamples::Scene scene = NBufferExamples::LoadScene({ "isosurface" }, { argv[0] });
    auto* mesh = vtkPolyData::SafeDownCast(scene.Actors.front()->GetMapper()->GetInput());
    std::cout << "inside-isosurface: " << mesh->GetNumberOfPolys() << " triangles\n";
    example.AddMesh(mesh, { 0.8, 0.7, 0.5 });
    example.AddFill(1.0);

    vtkRenderer* renderer = example.GetRenderer();
    renderer->SetBackground(0.9, 0.92, 0.95);
    vtkNew<vtkNBufferCuller> culler;
    renderer->AddCuller(culler); // Nothing else: large props are culled unit by unit by default.

    const auto setCamera = [renderer](int frame)
    {
      // Along the middle of a channel that goes straight through the gyroid, looking to its sides.
      vtkCamera* camera = renderer->GetActiveCamera();
      const double x = 1.0 / 12.0;
      const double z = -0.6 + 0.004 * frame;
      const double turn = 0.3 + 0.02 * frame;
      camera->SetPosition(x, 0.0, z);
      camera->SetFocalPoint(x + 0.5 * std::cos(turn), 0.5 * std::sin(turn), z + 1.0);
      camera->SetViewUp(0.0, 1.0, 0.0);
      camera->SetViewAngle(60.0);
      camera->SetClippingRange(0.005, 4.0);
    };
    example.Compare(culler, frames, setCamera);
    example.Show("inside-isosurface");
  };
  return example.Run(argc, argv, show);
}
