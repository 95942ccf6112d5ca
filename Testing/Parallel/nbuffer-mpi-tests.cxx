// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-mpi-tests.cxx
 * @brief A scene spread over the processes of mpirun, with and without the culler, and its pictures
 * compared to the byte.
 *
 *     mpirun -n 4 nbuffer-mpi-tests --spread random --path street --frames 60
 *
 * The last line also counts the frames in which VTK alone draws another picture on one process.
 * These are no errors: where props of two processes have the same depth in a pixel, compositing
 * decides which one is seen, and on one process the order of drawing.
 *
 * With --case one process does not do what the others do. The last lines say how many props were
 * drawn, and the CPU time of each process, without the time of waiting for others.
 */
#include "CameraPath.h"
#include "LoadScene.h"
#include "Messages.h"
#include "SortLast.h"
#include "Spread.h"

#include "vtkNBufferParallelDepthExchange.h"

#include "vtkActor.h"
#include "vtkCullerCollection.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"

#if VTKNBUFFER_TEST_HAS_RENDERING_PARALLEL
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkSynchronizedRenderWindows.h"
#endif

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <string>
#include <vector>

namespace
{
struct Options
{
  std::string Scene = "city";
  std::string Path = "street";
  std::string Spread = "kd";
  std::string Case = "none";
  std::string Compositing = "own";
  int Frames = 12;
  int Size[2] = { 480, 360 };
  int TileSize = 4;
  bool Local = false;
  bool NoBackOff = false;
};

/// Counts the CPU time that a process spends in waiting for others.
class TimedExchange : public vtkNBufferParallelDepthExchange
{
public:
  static TimedExchange* New();
  vtkTypeMacro(TimedExchange, vtkNBufferParallelDepthExchange);
  bool ReduceToMinimum(const float* values, float* minima, int count) override
  {
    const double begin = GetProcessTime();
    const bool done = this->Superclass::ReduceToMinimum(values, minima, count);
    this->Time += GetProcessTime() - begin;
    return done;
  }
  double Time = 0.0;
};
vtkStandardNewMacro(TimedExchange);

/// A window of a process.
struct Window
{
  Window(const Options& options, vtkMultiProcessController* controller)
  {
    this->Render->SetOffScreenRendering(1);
    this->Render->SetMultiSamples(0);
    this->Render->SetSize(options.Size[0], options.Size[1]);
    this->Render->AddRenderer(this->Renderer);
    if (controller && options.Compositing == "own")
    {
      this->Parallel->Attach(this->Renderer, controller);
      this->IsOwn = true;
    }
#if VTKNBUFFER_TEST_HAS_RENDERING_PARALLEL
    else if (controller)
    {
      static int identifier = 0;
      this->Windows->SetRenderWindow(this->Render);
      this->Windows->SetParallelController(controller);
      this->Windows->SetIdentifier(++identifier);
      this->Windows->RenderEventPropagationOff();
      this->Renderers->SetRenderer(this->Renderer);
      this->Renderers->SetParallelController(controller);
    }
  }
  vtkNew<vtkSynchronizedRenderWindows> Windows;
  vtkNew<vtkCompositedSynchronizedRenderers> Renderers;
#else
  }
#endif
  /// On the first process: the picture of all.
  TestScene::Picture GetPicture() const
  {
    return this->IsOwn ? this->Parallel->GetPicture() : TestScene::TakePicture(this->Render);
  }
  bool IsOwn = false;
  vtkNew<vtkRenderWindow> Render;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<SortLast> Parallel;
};

/// What one process does in a case before a frame, in a window.
void Disturb(const std::string& name, int frame, Window& window, vtkNBufferCuller* culler)
{
  vtkRenderer* renderer = window.Renderer;
  if (name == "no-props")
  {
    renderer->RemoveAllViewProps();
  }
  else if (name == "few-props")
  {
    while (renderer->GetViewProps()->GetNumberOfItems() > 10)
    {
      renderer->RemoveViewProp(renderer->GetViewProps()->GetLastProp());
    }
  }
  else if (name == "off" && culler)
  {
    culler->SetEnabled(frame % 3 == 0);
  }
  else if (name == "removed" && culler)
  {
    renderer->GetCullers()->RemoveAllItems();
  }
  else if (name == "setting" && culler)
  {
    culler->GetDepthExchange()->SetTileSize(frame % 4 == 3 ? 2 : 4);
  }
  else if (name == "wall" && frame >= 5)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      vtkActor::SafeDownCast(props->GetItemAsObject(i))->SetPosition(0.0, 0.0, 1.0e4);
    }
  }
  else if (name == "unreadable")
  {
    window.Render->SetMultiSamples(4);
  }
  else if (name == "killed" && culler && frame == 4)
  {
    std::raise(SIGKILL);
  }
}

struct Totals
{
  long long Drawn = 0;
  long long Inside = 0;
  long long Exchanges = 0;
  double Stock = 0.0;
  double Culled = 0.0;
};

/// Returns the number of frames whose pictures differ.
int Run(const Options& options, const char* program, vtkMPIController* controller)
{
  const int rank = controller->GetLocalProcessId();
  const int processes = controller->GetNumberOfProcesses();
  const NBufferExamples::Scene scene = NBufferExamples::LoadScene({ options.Scene }, { program });
  double bounds[6];
  scene.GetBounds().GetBounds(bounds);
  const std::vector<int> owners = NBufferExamples::SpreadActors(scene, options.Spread, processes);

  Window alone(options, nullptr); // Everything on one process.
  Window stock(options, controller);
  Window culled(options, controller);
  std::vector<NBufferExamples::Scene> scenes;
  for (Window* window : { &alone, &stock, &culled })
  {
    // Actors of its own: VTK would make their OpenGL objects anew whenever the window changes.
    scenes.push_back(NBufferExamples::LoadScene({ options.Scene }, { program }));
    scenes.back().AddTo(window->Renderer);
    for (std::size_t i = 0; i < owners.size() && window != &alone; ++i)
    {
      if (owners[i] != rank)
      {
        window->Renderer->RemoveViewProp(scenes.back().Actors[i]);
      }
    }
  }
  vtkNew<TimedExchange> exchange;
  vtkNew<vtkNBufferCuller> culler;
  culled.Renderer->AddCuller(culler);
  if (!options.Local)
  {
    exchange->SetController(controller);
    exchange->SetRenderer(culled.Renderer);
    exchange->SetTileSize(options.TileSize);
    exchange->SetBackOff(!options.NoBackOff);
    culler->SetDepthExchange(exchange);
  }

  const NBufferExamples::CameraPath path =
    NBufferExamples::MakePath(scene, options.Path, options.Frames, 1);
  int differing = 0;
  int tied = 0; // Frames in which VTK alone draws another picture on one process.
  Totals totals;
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    const int still = options.Case == "wall" ? 0 : frame;
    for (Window* window : { &alone, &stock, &culled })
    {
      // The other processes get the camera of the first one.
      NBufferExamples::ApplyPose(path[rank == 0 ? still : 0], bounds, window->Renderer);
      if (rank == processes - 1 && frame >= 2 && window != &alone)
      {
        Disturb(options.Case, frame, *window, window == &culled ? culler.Get() : nullptr);
      }
      if (options.Case == "resized" && frame % 4 == 3)
      {
        window->Render->SetSize(options.Size[0] - 10 * frame, options.Size[1]);
      }
      if (window != &alone || (rank == 0 && options.Case == "none"))
      {
        window->Render->Render();
      }
    }
    // The first two frames include what is made once.
    if (frame >= 2)
    {
      totals.Stock += stock.Parallel->GetTime();
      totals.Culled += culled.IsOwn ? culled.Parallel->GetTime() - exchange->Time : 0.0;
      totals.Drawn += culler->GetNumberOfPropsDrawn();
      totals.Inside += culler->GetNumberOfProps() - culler->GetNumberOfPropsOutside();
      totals.Exchanges += exchange->GetNumberOfExchanges();
    }
    exchange->Time = 0.0;
    if (rank == 0)
    {
      const std::string difference =
        TestScene::FindDifference(stock.GetPicture(), culled.GetPicture());
      if (options.Case == "none" &&
        !TestScene::FindDifference(TestScene::TakePicture(alone.Render), stock.GetPicture())
           .empty())
      {
        ++tied;
      }
      differing += difference.empty() ? 0 : 1;
      std::cout << (difference.empty() ? "" : "frame " + std::to_string(frame) + ": ") << difference
                << std::flush;
    }
  }

  const double mine[] = { static_cast<double>(totals.Drawn), static_cast<double>(totals.Inside),
    static_cast<double>(totals.Exchanges), totals.Stock, totals.Culled };
  std::vector<double> all(5 * processes);
  controller->Gather(mine, all.data(), 5, 0);
  const double frames = std::max(options.Frames - 2, 1);
  double sums[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < processes && rank == 0; ++i)
  {
    const double* values = &all[5 * i];
    std::cout << "process " << i << ": " << values[0] / frames << " of " << values[1] / frames
              << " props drawn, " << values[2] / frames << " exchanges, " << values[4] / frames
              << " ms (VTK alone " << values[3] / frames << " ms)\n";
    std::transform(values, values + 5, sums, sums, std::plus<double>());
  }
  if (rank == 0)
  {
    std::cout << "all: " << sums[0] / frames << " of " << sums[1] / frames << " props drawn, "
              << sums[4] / frames << " ms (VTK alone " << sums[3] / frames << " ms), " << differing
              << " of " << options.Frames << " frames differ (VTK alone on one process: " << tied
              << ")" << std::endl;
  }
  controller->Broadcast(&differing, 1, 0);
  return differing;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Options options;
  CLI::App app("A scene spread over the processes of mpirun, its picture compared to the byte");
  app.add_option("--scene", options.Scene, "as nbuffer-bench");
  app.add_option("--path", options.Path, "street, rooftop, drone, cuts, orbit");
  app.add_option("--spread", options.Spread)->check(CLI::IsMember({ "kd", "random" }));
  app.add_option("--case", options.Case)
    ->check(CLI::IsMember({ "none", "no-props", "few-props", "off", "removed", "unreadable",
      "resized", "killed", "setting", "wall" }));
  app
    .add_option("--compositing", options.Compositing,
      "by this program, or by vtkCompositedSynchronizedRenderers (then without times)")
    ->check(CLI::IsMember({ "own", "vtk" }));
  app.add_option("--frames", options.Frames);
  app.add_option("--width", options.Size[0]);
  app.add_option("--height", options.Size[1]);
  app.add_option("--tile", options.TileSize);
  app.add_flag("--local", options.Local, "without the exchange");
  app.add_flag("--no-back-off", options.NoBackOff);
  int failures = 0;
  try
  {
    app.parse(argc, argv);
    const std::string fault = FindWindowFault();
    if (!fault.empty())
    {
      std::cout << "SKIPPED: " << fault << std::endl;
    }
    else
    {
      failures = Run(options, argv[0], controller);
    }
  }
  catch (const CLI::ParseError& error)
  {
    failures = app.exit(error);
  }
  std::string messages = TakeMessages();
  std::cout << messages;
  if (options.Case == "setting" && failures == 0)
  {
    messages = messages.find("different settings") == std::string::npos ? "no warning" : "";
  }
  controller->Finalize();
  return failures > 0 || !messages.empty() ? 1 : 0;
}
