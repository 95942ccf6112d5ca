// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CityMPI.cxx
 * @brief A city spread over the processes of mpirun: one picture, and a table of what each process
 * has drawn.
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

#include <iostream>

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
    const std::vector<int> owners =
      NBufferExamples::SpreadActors(city, argc > 2 ? argv[2] : "kd", processes);

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

    const int mine[2] = { renderer->GetViewProps()->GetNumberOfItems(),
      renderer->GetNumberOfPropsRendered() };
    std::vector<int> all(2 * processes);
    controller->Gather(mine, all.data(), 2, 0);
    for (int i = 0; i < processes && process == 0; ++i)
    {
      std::cout << "process " << i << ": " << all[2 * i + 1] << " of " << all[2 * i]
                << " props drawn\n";
    }
    if (process == 0 && argc > 1)
    {
      NBufferExamples::WritePNG(
        NBufferExamples::MakeColorImage(window, NBufferExamples::GrabPixels(window)), argv[1]);
    }
  }
  controller->Finalize();
  return 0;
}
