// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CityMPI.cxx
 * @brief A city spread over the processes of mpirun: one picture, and a table of what each process
 * has drawn in the last frame, and sent (the milliseconds are mostly those of waiting for others).
 *
 *     mpirun -n 4 city-mpi city.png          each process has a part of the city
 *     mpirun -n 4 city-mpi city.png random   neighbours belong to different processes
 */
#include "CameraPath.h"
#include "Frames.h"
#include "LoadScene.h"
#include "Spread.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferParallelDepthExchange.h"

#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSynchronizedRenderWindows.h"

#include <cstdio>

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  const int processes = controller->GetNumberOfProcesses();
  const int process = controller->GetLocalProcessId();
  {
    NBufferExamples::Scene city = NBufferExamples::LoadScene({ "city" }, { argv[0] });
    double bounds[6];
    city.GetBounds().GetBounds(bounds);
    const auto owners = NBufferExamples::SpreadActors(city, argc > 2 ? argv[2] : "kd", processes);

    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(960, 720);
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    city.AddTo(renderer);
    for (std::size_t i = 0; i < owners.size(); ++i)
    {
      if (owners[i] != process)
      {
        renderer->RemoveViewProp(city.Actors[i]);
      }
    }

    // As in every program of VTK that composites the pictures of several processes.
    vtkNew<vtkSynchronizedRenderWindows> windows;
    windows->SetRenderWindow(window);
    windows->SetParallelController(controller);
    windows->SetIdentifier(1);
    windows->RenderEventPropagationOff(); // All processes call Render().
    vtkNew<vtkCompositedSynchronizedRenderers> renderers;
    renderers->SetRenderer(renderer);
    renderers->SetParallelController(controller);

    // What the walls of one process hide, no other process draws.
    vtkNew<vtkNBufferParallelDepthExchange> exchange;
    exchange->SetController(controller);
    exchange->SetRenderer(renderer);
    vtkNew<vtkNBufferCuller> culler;
    culler->SetDepthExchange(exchange);
    renderer->AddCuller(culler);

    for (const auto& pose : NBufferExamples::MakePath(city, "street", 10, 1))
    {
      NBufferExamples::ApplyPose(pose, bounds, renderer);
      window->Render();
    }

    const double mine[5] = { 1.0 * renderer->GetViewProps()->GetNumberOfItems(),
      1.0 * renderer->GetNumberOfPropsRendered(), 1.0 * exchange->GetNumberOfExchanges(),
      exchange->GetNumberOfBytes() / 1024.0, exchange->GetExchangeTime() };
    std::vector<double> all(5 * processes);
    controller->Gather(mine, all.data(), 5, 0);
    for (int i = 0; i < processes && process == 0; ++i)
    {
      const double* row = &all[5 * i];
      std::printf("%s", i == 0 ? "rank props drawn exchanges   KiB    ms\n" : "");
      std::printf("%4d %5g %5g %9g %5.1f %5.1f\n", i, row[0], row[1], row[2], row[3], row[4]);
    }
    if (process == 0 && argc > 1)
    {
      NBufferExamples::WriteFrame(window, argv[1]);
    }
  }
  controller->Finalize();
  return 0;
}
