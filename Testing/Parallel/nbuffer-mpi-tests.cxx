// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-mpi-tests.cxx
 * @brief A scene spread over the processes of mpirun, with and without the culler, and its pictures
 * compared to the byte.
 *
 *     mpirun -n 4 nbuffer-mpi-tests --spread random --path street --frames 60 --modes shared,local
 *
 * VTK alone on one process has to draw the same pictures, too. Where props of two processes have
 * the same depth in a pixel, compositing shows that of the process with the lower number, and one
 * process shows what it draws last. So its window has the props of the last process first, and
 * those of the first process at the end. (VTK's own compositing has another rule. With it, the
 * frames in which one process draws another picture are only counted.)
 *
 * After cuts of the camera there must be as many exchanges as vtkNBufferExchangePlan says, and few
 * props drawn. With --case one process does not do what the others do, or all of them select. The
 * last lines say how many props were drawn, and the CPU time of each process, without the time of
 * waiting for others.
 */
#include "CameraPath.h"
#include "LoadScene.h"
#include "Messages.h"
#include "SortLast.h"
#include "Spread.h"

#include "vtkNBufferExchangePlan.h"
#include "vtkNBufferParallelDepthExchange.h"

#include "vtkActor.h"
#include "vtkCommunicator.h"
#include "vtkCullerCollection.h"
#include "vtkHardwareSelector.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkSelection.h"

#if VTKNBUFFER_TEST_HAS_RENDERING_PARALLEL
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkCompressCompositer.h"
#include "vtkSynchronizedRenderWindows.h"
#endif

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <deque>
#include <functional>
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
  std::string Compositer = "tree";
  std::vector<std::string> Modes = { "shared" };
  int Frames = 12;
  int Size[2] = { 480, 360 };
  int TileSize = 4;
  int Thinned = 1; ///< One of so many houses of the city is drawn.
  bool NoBackOff = false;
  bool OnScreen = false;
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
    this->Render->SetOffScreenRendering(!options.OnScreen);
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
      if (options.Compositer == "compress")
      {
        this->Renderers->SetCompositer(vtkNew<vtkCompressCompositer>());
      }
      this->Renderers->SetRenderer(this->Renderer);
      this->Renderers->SetParallelController(controller);
    }
  }
  vtkNew<vtkSynchronizedRenderWindows> Windows;
  vtkNew<vtkCompositedSynchronizedRenderers> Renderers;
#else
  }
#endif
  /// Aborts every second frame from now on, before anything is drawn.
  void Abort()
  {
    this->Render->SetAbortRender(this->Aborts = !this->Aborts);
  }
  /// Whether this process synchronizes its frames with the others. True by default.
  void SetParallelRendering(bool on)
  {
    this->Parallel->SetParallelRendering(on);
#if VTKNBUFFER_TEST_HAS_RENDERING_PARALLEL
    this->Renderers->SetParallelRendering(on);
    this->Windows->SetParallelRendering(on);
#endif
  }
  /// On the first process: the picture of all.
  TestScene::Picture GetPicture() const
  {
    return this->IsOwn ? this->Parallel->GetPicture() : TestScene::TakePicture(this->Render);
  }
  bool IsOwn = false;
  bool Aborts = false; ///< Whether Abort() has aborted the last frame.
  vtkNew<vtkRenderWindow> Render;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<SortLast> Parallel;
};

/// Makes a hardware selection in a window. Each of its passes draws a frame.
void Select(Window& window)
{
  vtkNew<vtkHardwareSelector> selector;
  const int* size = window.Render->GetSize();
  selector->SetRenderer(window.Renderer);
  selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
  vtkSmartPointer<vtkSelection>::Take(selector->Select());
}

/// Draws the renderer of a window in front of another one.
void AddLayer(Window& window)
{
  vtkNew<vtkRenderer> behind;
  behind->SetBackground(0.2, 0.4, 0.3);
  window.Render->SetNumberOfLayers(2);
  window.Renderer->SetLayer(1);
  window.Render->AddRenderer(behind);
}

/// What a process does in a case before a frame, in a window.
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
  else if (name == "invisible")
  {
    vtkPropCollection* props = renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      static_cast<vtkProp*>(props->GetItemAsObject(i))->VisibilityOff();
    }
  }
  else if (name == "layer" && renderer->GetLayer() == 0)
  {
    AddLayer(window);
  }
  else if (name == "aborted" && frame == 2)
  {
    renderer->AddObserver(vtkCommand::StartEvent, &window, &Window::Abort);
  }
  else if (name == "selected")
  {
    Select(window);
  }
  else if (name == "selected-alone")
  {
    window.SetParallelRendering(false);
    vtkNBufferDepthExchange* exchange = culler ? culler->GetDepthExchange() : nullptr;
    if (exchange)
    {
      exchange->ParallelRenderingOff();
    }
    Select(window);
    if (exchange)
    {
      exchange->ParallelRenderingOn();
    }
    window.SetParallelRendering(true);
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

/// A window with a culler, and what its frames after the first two have cost in total.
struct CulledWindow
{
  CulledWindow(const Options& options, vtkMultiProcessController* controller, bool isShared)
    : Shown(options, controller)
  {
    this->Shown.Renderer->AddCuller(this->Culler);
    if (isShared)
    {
      this->Exchange->SetController(controller);
      this->Exchange->SetRenderer(this->Shown.Renderer);
      this->Exchange->SetTileSize(options.TileSize);
      this->Exchange->SetBackOff(!options.NoBackOff);
      this->Culler->SetDepthExchange(this->Exchange);
    }
  }

  void AddFrame(const Window& stock)
  {
    const double frame[] = { static_cast<double>(this->Culler->GetNumberOfPropsDrawn()),
      static_cast<double>(
        this->Culler->GetNumberOfProps() - this->Culler->GetNumberOfPropsOutside()),
      static_cast<double>(this->Exchange->GetNumberOfExchanges()),
      this->Shown.IsOwn ? this->Shown.Parallel->GetTime() - this->Exchange->Time : 0.0,
      stock.Parallel->GetTime() };
    std::transform(
      this->Totals.begin(), this->Totals.end(), frame, this->Totals.begin(), std::plus<double>());
  }

  /// To be called by all processes. The first one prints the means of all.
  void Print(vtkMultiProcessController* controller, int frames, const std::string& mode) const
  {
    const int processes = controller->GetNumberOfProcesses();
    std::vector<double> all(this->Totals.size() * processes);
    controller->Gather(this->Totals.data(), all.data(), this->Totals.size(), 0);
    std::array<double, 5> sums{};
    const auto print = [&](const std::string& name, const std::array<double, 5>& values)
    {
      std::cout << mode << ", " << name << ": " << values[0] / frames << " of "
                << values[1] / frames << " props drawn, " << values[2] / frames << " exchanges, "
                << values[3] / frames << " ms (VTK alone " << values[4] / frames << " ms)\n";
    };
    for (int i = 0; i < processes && controller->GetLocalProcessId() == 0; ++i)
    {
      std::array<double, 5> values;
      std::copy_n(all.begin() + i * values.size(), values.size(), values.begin());
      print("process " + std::to_string(i), values);
      std::transform(values.begin(), values.end(), sums.begin(), sums.begin(), std::plus<double>());
    }
    if (controller->GetLocalProcessId() == 0)
    {
      print("all", sums);
    }
  }

  Window Shown;
  vtkNew<TimedExchange> Exchange;
  vtkNew<vtkNBufferCuller> Culler;
  std::array<double, 5> Totals{}; ///< In the order in which Print() prints them.
};

/// Returns whether a frame after a cut of the camera had another number of exchanges than it may
/// have, or the frames so far have drawn too many props. Where each process keeps as many of its
/// visible props as it loses, the view is not new for it, and there is one exchange. To be called
/// by all processes.
bool IsCutWrong(const CulledWindow& window, vtkMultiProcessController* controller, int frame)
{
  const int mine[] = { window.Exchange->GetNumberOfExchanges(),
    window.Culler->GetStatistics().HeldBack };
  int most[2];
  controller->AllReduce(mine, most, 2, vtkCommunicator::MAX_OP);
  double sums[2]; // The props that are drawn, and those in the frustum.
  controller->AllReduce(window.Totals.data(), sums, 2, vtkCommunicator::SUM_OP);
  const int allowed = most[1] > vtkNBufferExchangePlan::FewNewProps ? 2 : 1;
  constexpr int FirstCuts = 4; // Each of these views is new for some process.
  const bool isWrong =
    most[0] > allowed || (frame < FirstCuts && most[0] < allowed) || sums[0] > 0.05 * sums[1];
  if (controller->GetLocalProcessId() == 0)
  {
    std::cout << "cut " << frame << ": " << most[0] << " exchanges, at most " << most[1]
              << " props held back on a process, " << sums[0] << " of " << sums[1]
              << " props drawn so far" << (isWrong ? ", which is wrong\n" : "\n");
  }
  return isWrong;
}

/// Loads the scene without the houses that --thinned leaves out.
NBufferExamples::Scene LoadThinned(const Options& options, const char* program)
{
  NBufferExamples::Scene scene = NBufferExamples::LoadScene({ options.Scene }, { program });
  // The ground and the streets, which come after the houses, stay.
  const std::size_t houses = scene.Plan ? scene.Plan->Buildings.size() : 0;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (std::size_t i = 0; i < scene.Actors.size(); ++i)
  {
    if (i >= houses || i % options.Thinned == 0)
    {
      actors.push_back(scene.Actors[i]);
    }
  }
  scene.Actors.swap(actors);
  return scene;
}

/// Adds copies of the actors that belong to a process, or of those of all processes, the last one's
/// first. They have mappers of their own: VTK would make the OpenGL objects of a mapper anew if
/// several windows had it.
void AddActors(const NBufferExamples::Scene& scene, const std::vector<int>& owners, int processes,
  int rank, vtkRenderer* renderer)
{
  NBufferExamples::Scene copy = scene;
  copy.Actors.clear();
  for (int process = processes - 1; process >= 0; --process)
  {
    for (std::size_t i = 0; i < owners.size(); ++i)
    {
      if (owners[i] == process && (rank < 0 || rank == process))
      {
        vtkNew<vtkPolyDataMapper> mapper;
        // Not that of vtkOpenGLPolyDataMapper, whose use of its own functions VTK 9.1 warns of.
        mapper->vtkPolyDataMapper::ShallowCopy(scene.Actors[i]->GetMapper());
        copy.Actors.push_back(vtkSmartPointer<vtkActor>::New());
        copy.Actors.back()->ShallowCopy(scene.Actors[i]);
        copy.Actors.back()->SetMapper(mapper);
      }
    }
  }
  copy.AddTo(renderer);
}

/// On the first process: prints how two pictures of a frame differ, and returns whether they do.
bool Differ(const TestScene::Picture& expected, const TestScene::Picture& actual,
  const std::string& mode, int frame)
{
  const std::string difference = TestScene::FindDifference(expected, actual);
  if (!difference.empty())
  {
    std::cout << mode << ", frame " << frame << ": " << difference << std::flush;
  }
  return !difference.empty();
}

/// Returns the number of frames whose pictures differ, or that are wrong after a cut.
int Run(const Options& options, const char* program, vtkMPIController* controller)
{
  const int rank = controller->GetLocalProcessId();
  const int processes = controller->GetNumberOfProcesses();
  const NBufferExamples::Scene scene = LoadThinned(options, program);
  double bounds[6];
  scene.GetBounds().GetBounds(bounds);
  const std::vector<int> owners = NBufferExamples::SpreadActors(scene, options.Spread, processes);
  const bool drawsAlone = rank == 0 && options.Case == "none";

  Window alone(options, nullptr); // Everything on one process.
  Window stock(options, controller);
  std::deque<CulledWindow> culled;
  std::vector<Window*> windows = { &alone, &stock };
  for (const std::string& mode : options.Modes)
  {
    culled.emplace_back(options, controller, mode == "shared");
    windows.push_back(&culled.back().Shown);
  }
  for (Window* window : windows)
  {
    if (window != &alone || drawsAlone)
    {
      AddActors(scene, owners, processes, window == &alone ? -1 : rank, window->Renderer);
    }
  }

  const NBufferExamples::CameraPath path =
    NBufferExamples::MakePath(scene, options.Path, options.Frames, 1);
  int differing = 0;
  int wrong = 0;
  int unlike = 0; // Frames in which VTK alone draws another picture on one process.
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    const int still = options.Case == "wall" ? 0 : frame;
    for (Window* window : windows)
    {
      // The other processes get the camera of the first one.
      NBufferExamples::ApplyPose(path[rank == 0 ? still : 0], bounds, window->Renderer);
      const bool isUnlike = rank == processes - 1 || options.Case == "selected";
      if (isUnlike && frame >= 2 && window != &alone)
      {
        const auto found = std::find_if(culled.begin(), culled.end(),
          [window](const CulledWindow& candidate) { return &candidate.Shown == window; });
        Disturb(
          options.Case, frame, *window, found == culled.end() ? nullptr : found->Culler.Get());
      }
      if (options.Case == "resized" && frame % 4 == 3)
      {
        window->Render->SetSize(options.Size[0] - 10 * frame, options.Size[1]);
      }
      if (window != &alone || drawsAlone)
      {
        window->Render->Render();
      }
    }
    if (rank == 0 && options.Case == "killed")
    {
      std::cout << "frame " << frame << " is drawn" << std::endl;
    }
    for (CulledWindow& window : culled)
    {
      // The first two frames include what is made once.
      if (frame >= 2)
      {
        window.AddFrame(stock);
      }
      window.Exchange->Time = 0.0;
      const bool isCut = options.Path == "cuts" && options.Case == "none" && processes > 1;
      if (isCut && window.Culler->GetDepthExchange() && IsCutWrong(window, controller, frame))
      {
        ++wrong;
      }
    }
    if (drawsAlone)
    {
      unlike += Differ(TestScene::TakePicture(alone.Render), stock.GetPicture(), "VTK alone", frame)
        ? 1
        : 0;
    }
    for (std::size_t i = 0; rank == 0 && i < culled.size(); ++i)
    {
      differing +=
        Differ(stock.GetPicture(), culled[i].Shown.GetPicture(), options.Modes[i], frame) ? 1 : 0;
    }
  }

  for (std::size_t i = 0; i < culled.size(); ++i)
  {
    culled[i].Print(controller, std::max(options.Frames - 2, 1), options.Modes[i]);
  }
  if (rank == 0)
  {
    std::cout << differing << " of " << options.Frames * options.Modes.size()
              << " frames differ, VTK alone on one process: " << unlike << " of "
              << (drawsAlone ? options.Frames : 0) << std::endl;
    differing += options.Compositing == "own" ? unlike : 0;
  }
  controller->Broadcast(&differing, 1, 0);
  return differing + wrong;
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
    ->check(CLI::IsMember(
      { "none", "no-props", "few-props", "invisible", "layer", "off", "removed", "unreadable",
        "resized", "aborted", "selected", "selected-alone", "killed", "setting", "wall" }));
  app
    .add_option("--compositing", options.Compositing,
      "by this program, or by vtkCompositedSynchronizedRenderers (then without times)")
    ->check(CLI::IsMember({ "own", "vtk" }));
  app.add_option("--compositer", options.Compositer, "vtkTreeCompositer or vtkCompressCompositer")
    ->check(CLI::IsMember({ "tree", "compress" }));
  app.add_option("--frames", options.Frames);
  app.add_option("--thinned", options.Thinned, "use one of so many houses of the city")
    ->check(CLI::PositiveNumber);
  app.add_option("--width", options.Size[0]);
  app.add_option("--height", options.Size[1]);
  app.add_option("--tile", options.TileSize);
  app
    .add_option("--modes", options.Modes, "shared (with the exchange) and local (without), or one")
    ->delimiter(',')
    ->check(CLI::IsMember({ "shared", "local" }));
  app.add_flag("--no-back-off", options.NoBackOff);
  app.add_flag("--on-screen", options.OnScreen);
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
    const bool isRight =
      CountWarnings(messages) == 1 && messages.find("different settings") != std::string::npos;
    messages = isRight ? "" : "not one warning";
  }
  controller->Finalize();
  return failures > 0 || !messages.empty() ? 1 : 0;
}
