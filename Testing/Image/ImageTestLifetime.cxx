// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Observers that remove and delete what is being drawn, and frames that are aborted.
#include "CullerTest.h"
#include "LargeProps.h"
#include "Once.h"
#include "Scenes.h"

#include "vtkActorCollection.h"
#include "vtkCallbackCommand.h"
#include "vtkCullerCollection.h"
#include "vtkMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSphereSource.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <thread>

using Scenes::Wall;

namespace
{
/// A translucent box, seen between camera and wall.
constexpr int Glass = Wall::Count;

void BuildWallAndGlass(Stage& stage)
{
  Scenes::BuildWall(stage);
  Scenes::AddBox(stage, 1.0, 0.5, 3.0, 1.0, 1.0, 1.0);
  stage.GetActor(Glass)->GetProperty()->SetOpacity(0.5);
  // Uncovered by the very frame in which it is removed, so that the culler holds it back.
  Scenes::AddBox(stage, 6.5, 0.0, -8.0, 0.4, 0.4, 0.4);
}

/// What the observer removes: the wall itself, a hidden prop, one that is seen, a translucent one,
/// and one that comes out from behind the wall.
const int Removed[] = { Wall::Index, Wall::FirstBehind, Wall::FirstInFront, Glass, Glass + 1 };

/// Where the observer sits.
struct Moment : NamedCase
{
  std::function<vtkObject*(Stage&)> Where;
  unsigned long Event;
};

using CullerLifetime = testing::TestWithParam<Moment>;
}

// Hazard: an observer removes and deletes a prop during the frame, while the list of the frame has
// a plain pointer to it. With the culler the prop must live until the frame ends, and no longer.
// Stock VTK would draw freed memory, so that the reference keeps the props itself.
TEST_P(CullerLifetime, PropsDeletedByAnObserver)
{
  const Moment& moment = this->GetParam();
  for (bool moving : { true, false })
  {
    SCOPED_TRACE(moving ? "while the camera moves" : "after still frames");
    Comparison comparison(BuildWallAndGlass);
    const double step = moving ? 0.05 : 0.0;
    Scenes::FramesOfWall(comparison, { 0.0, step, 2.0 * step });
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind), Verdict::Hidden);
    EXPECT_EQ(comparison.GetVerdict(Glass), Verdict::Translucent);

    std::vector<vtkSmartPointer<vtkProp>> keptByReference;
    std::vector<vtkWeakPointer<vtkProp>> removed;
    for (int prop : Removed)
    {
      keptByReference.push_back(comparison.Reference.Props[prop]);
      removed.emplace_back(comparison.Culled.Props[prop].Get());
    }
    comparison.Both(
      [&moment](Stage& stage)
      {
        Observe(moment.Where(stage), moment.Event,
          [&stage]
          {
            for (int prop : Removed)
            {
              stage.GetRenderer()->RemoveViewProp(stage.Props[prop]);
              stage.Props[prop] = nullptr;
            }
          });
      });
    if (moving)
    {
      Scenes::MoveWallCamera(comparison, 4.0);
    }
    comparison.Frame("removed");
    for (const vtkWeakPointer<vtkProp>& prop : removed)
    {
      EXPECT_EQ(prop, nullptr) << "kept beyond the frame";
    }
    keptByReference.clear();
    comparison.Frame("the next one");
    EXPECT_EQ(comparison.GetStatistics().Props, Wall::Count + 2 - 5);
    EXPECT_LT(comparison.GetHidden(), Wall::Behind / 4) << "without the wall";
    comparison.Frame("still");
    Scenes::FrameOfWall(comparison, 0.3, "moved");
  }
}

INSTANTIATE_TEST_SUITE_P(At, CullerLifetime,
  testing::Values(
    Moment{ "MapperStart", [](Stage& s) -> vtkObject* { return s.GetActor(0)->GetMapper(); },
      vtkCommand::StartEvent },
    Moment{ "RendererStart", [](Stage& s) -> vtkObject* { return s.GetRenderer(); },
      vtkCommand::StartEvent },
    Moment{
      "RendererEnd", [](Stage& s) -> vtkObject* { return s.GetRenderer(); }, vtkCommand::EndEvent },
    Moment{
      "WindowStart", [](Stage& s) -> vtkObject* { return s.Window; }, vtkCommand::StartEvent },
    Moment{ "WindowEnd", [](Stage& s) -> vtkObject* { return s.Window; }, vtkCommand::EndEvent }),
  GetCaseName);

// Hazard: an observer deletes the culler, which owns the proxy in the renderer's list, while the
// frame is drawn.
TEST(CullerLifetimeOnce, CullerDeletedByAnObserver)
{
  ComparisonOptions options;
  options.CompareDraws = false; // of a culler that is gone
  Comparison comparison(Scenes::BuildWall, options);
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.1, 0.2 }, Wall::Hidden);
  Stage& culled = comparison.Culled;
  const vtkWeakPointer<vtkNBufferCuller> culler(culled.Culler.Get());
  Observe(culled.GetActor(Wall::Index)->GetMapper(), vtkCommand::StartEvent,
    [&culled]
    {
      culled.GetRenderer()->GetCullers()->RemoveItem(culled.Culler);
      culled.Culler = nullptr;
    });
  Scenes::FrameOfWall(comparison, 5.0, "culler deleted");
  EXPECT_EQ(culler, nullptr) << "kept beyond the frame";
  Scenes::FrameOfWall(comparison, 0.0, "without a culler");
  culled.Culler = vtkSmartPointer<vtkNBufferCuller>::New();
  culled.GetRenderer()->AddCuller(culled.Culler);
  comparison.Frame("with another one");
  EXPECT_GT(comparison.GetHidden(), 0);
}

// Hazard: a culler that lives longer than a renderer keeps alive the props that it held for the
// renderer's frames.
TEST(CullerLifetimeOnce, PropsDieWithTheirRenderer)
{
  vtkSmartPointer<vtkNBufferCuller> culler;
  vtkWeakPointer<vtkProp> props[2];
  {
    Comparison comparison(
      [](Stage& stage)
      {
        Scenes::BuildWall(stage);
        Scenes::AddWall(stage, stage.AddRenderer(0.0, 0.0, 0.5, 0.5));
      });
    comparison.Frame();
    EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
    EXPECT_GE(comparison.GetHidden(1), Wall::Hidden);
    culler = comparison.Culled.Culler;
    props[0] = comparison.Culled.Props[Wall::FirstBehind];
    props[1] = comparison.Culled.Props[Wall::Count + Wall::FirstBehind];
  }
  EXPECT_EQ(props[0], nullptr);
  EXPECT_EQ(props[1], nullptr);
}

// Hazard: an observer adds props while the frame is drawn; they are not in the list of this frame.
TEST(CullerLifetimeOnce, PropsAddedByAnObserver)
{
  Comparison comparison(Scenes::BuildWall);
  Scenes::FrameOfWall(comparison, 0.1, "before");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Both(
    [](Stage& stage)
    {
      Observe(stage.GetActor(Wall::Index)->GetMapper(), vtkCommand::StartEvent,
        [&stage]
        {
          for (int i = 0; i < 40; ++i)
          {
            Scenes::AddBox(stage, 0.1 * i - 2.0, 0.0, i % 2 ? 3.0 : -3.0, 0.3, 0.3, 0.3);
          }
        });
    });
  Scenes::FrameOfWall(comparison, 0.2, "added meanwhile");
  EXPECT_EQ(comparison.GetStatistics().Props, Wall::Count);
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.2 + 0.1 * i, "after that");
    EXPECT_EQ(comparison.GetStatistics().Props, Wall::Count + 40);
  }
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden + 15);
}

//------------------------------------------------------------------------------------------------
namespace
{
/// Give up the frame that is drawn next, when the mapper of a prop is about to draw. The other
/// stage gives its own up likewise.
void AbortNextFrame(Comparison& comparison, int prop, bool byCheck)
{
  comparison.Both(
    [prop, byCheck](Stage& stage)
    {
      vtkRenderWindow* window = stage.Window;
      const auto abort = [window] { window->SetAbortRender(1); };
      Observe(stage.GetActor(prop)->GetMapper(), vtkCommand::StartEvent,
        [=]
        {
          if (byCheck)
          {
            // VTK invokes the event five times a second at most.
            std::this_thread::sleep_for(std::chrono::milliseconds(250));
            Observe(window, vtkCommand::AbortCheckEvent, abort);
          }
          else
          {
            abort();
          }
        });
      window->Render();
    });
}
}

// Hazard: an aborted frame has drawn only some props. Neither its depth nor its verdicts may be
// used in the next frame.
TEST(CullerLifetimeOnce, AbortedFramesAreNotLearntFrom)
{
  Comparison comparison(Scenes::BuildWall);
  Scenes::FrameOfWall(comparison, 0.0, "before");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  for (bool byCheck : { false, true })
  {
    // The wall is the first to be drawn; of those before it some come later, some are held back.
    for (int prop : { static_cast<int>(Wall::Index), static_cast<int>(Wall::FirstInFront) })
    {
      SCOPED_TRACE(std::to_string(prop) + (byCheck ? " by AbortCheckEvent" : " by SetAbortRender"));
      Scenes::MoveWallCamera(comparison, 9.0);
      AbortNextFrame(comparison, prop, byCheck);
      EXPECT_LT(comparison.Culled.GetDraws(Wall::Index), 3);
      comparison.Frame("the next one, of the same view");
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled) << "not taken for still";
      EXPECT_GT(comparison.GetHidden(), 0);
      comparison.Frame("still");
      Scenes::MoveWallCamera(comparison, 0.0);
      AbortNextFrame(comparison, prop, byCheck);
      Scenes::FrameOfWall(comparison, 0.1, "the next one, of another view");
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      Scenes::FrameOfWall(comparison, 0.0, "and the one after that");
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    }
  }
}

// Hazard: a large prop is deleted between two frames, and a new one has its address and its place
// in the list.
TEST(CullerLifetimeOnce, NewPropAtTheAddressOfADeletedLargeOne)
{
  bool haveSameAddress = false;
  // Nothing but the renderer keeps the actor.
  const auto add = [](vtkRenderer* renderer, double radius) -> const void*
  {
    vtkNew<vtkActor> actor;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(40);
    sphere->SetPhiResolution(40);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    return actor;
  };
  Comparison comparison(
    [&add](Stage& stage)
    {
      Scenes::BuildWall(stage);
      add(stage.GetRenderer(), 2.0);
    },
    LargeProps::MakeOptionsWithoutDraws());
  Scenes::FramesOfWall(comparison, { 0.0, 0.05, 0.1, 0.15, 0.2, 0.25 });
  EXPECT_GT(comparison.GetStatistics().Units, 0);
  comparison.Both(
    [&](Stage& stage)
    {
      vtkActor* old = stage.GetRenderer()->GetActors()->GetLastActor();
      const void* before = old;
      stage.GetRenderer()->RemoveActor(old);
      const void* after = add(stage.GetRenderer(), 3.0);
      haveSameAddress = haveSameAddress || (&stage == &comparison.Culled && after == before);
    });
  Scenes::FramesOfWall(comparison, { 0.0, 0.05, 0.1, 0.15, 0.2, 0.25 });
  EXPECT_GT(comparison.GetStatistics().Units, 0);
  if (!haveSameAddress)
  {
    GTEST_SKIP() << "SKIPPED: the new actor has another address here";
  }
}

// Hazard: an observer of the application sets a uniform of a large prop's shader, after its units
// have been drawn.
TEST(CullerLifetimeOnce, ObserverSetsAUniformOfALargeProp)
{
  Comparison comparison(
    [](Stage& stage)
    {
      LargeProps::AddSphereAndWalls(stage);
      vtkNew<vtkCallbackCommand> command;
      command->SetCallback(
        [](vtkObject*, unsigned long, void*, void* program)
        {
          const float red[3] = { 1.0F, 0.0F, 0.0F };
          static_cast<vtkShaderProgram*>(program)->SetUniform3f("diffuseColorUniform", red);
        });
      stage.GetActor(0)->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, command);
    },
    LargeProps::MakeOptions());
  const LargeProps::Units units = LargeProps::CompareWalk(comparison, LargeProps::Walk);
  EXPECT_GT(units.Hidden, 0);
}
