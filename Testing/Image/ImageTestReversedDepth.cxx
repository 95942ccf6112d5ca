// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Reversed depth: the near plane is at 1, the far plane and the background are at 0, and the larger
// depth wins. An application sets it up with glClipControl(), and the culler follows.
#include "CullerTest.h"
#include "LargeProps.h"
#include "RankFrames.h"
#include "ReversedDepth.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkNBufferGL.h"
#include "vtkShadowVolumeClampPass.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkLightsPass.h"
#include "vtkMapper.h"
#include "vtkOpaquePass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTextureObject.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <cstdlib>

using Scenes::Wall;
using TestScene::PassKind;

namespace
{
/// How reversed depth is drawn.
struct ReversedWay : NamedCase
{
  bool Float = false;
  bool InfiniteFar = false;
  int MultiSamples = 0;
  bool Reversed = true;
};

/// Lets the first renderer of a stage draw in this way. Must be called before the camera is set.
void Reverse(Stage& stage, const ReversedWay& way)
{
  if (way.Float)
  {
    Scenes::SetDepthFormat(stage, vtkTextureObject::Float32);
  }
  if (!way.Reversed)
  {
    return;
  }
  vtkNew<TestScene::ReversedCamera> camera;
  camera->SetInfiniteFar(way.InfiniteFar);
  stage.GetRenderer()->SetActiveCamera(camera);
  stage.GetRenderer()->SetPass(TestScene::MakePass(PassKind::Reversed));
}

TestScene::ReversedDepthPass* GetReversedPass(Stage& stage)
{
  return static_cast<TestScene::ReversedDepthPass*>(
    static_cast<vtkCameraPass*>(stage.GetRenderer()->GetPass())->GetDelegatePass());
}

ComparisonOptions GetReversedOptions(const ReversedWay& way)
{
  ComparisonOptions options;
  options.MultiSamples = way.MultiSamples;
  options.CompareDepth = way.MultiSamples == 0;
  options.ReadRendered = way.Float;
  return options;
}

class CullerReversedDepth : public testing::TestWithParam<ReversedWay>
{
protected:
  void SetUp() override
  {
    Stage stage(8, 8);
    stage.Window->Render();
    if (!vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control"))
    {
      GTEST_SKIP() << "this renderer has no glClipControl()";
    }
  }
};
using CullerReversedDepthOnce = CullerReversedDepth;

/// How many pixels of two pictures differ by more than a step of color.
std::size_t CountDifferences(const TestScene::Picture& a, const TestScene::Picture& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.Colors.size() / 4; ++i)
  {
    count += std::equal(a.GetColor(i), a.GetColor(i) + 4, b.GetColor(i),
               [](int x, int y) { return std::abs(x - y) <= 1; })
      ? 0
      : 1;
  }
  return count;
}

const ReversedWay ReversedWays[] = { { "Finite" }, { "InfiniteFar", false, true },
  { "Float", true }, { "FloatInfiniteFar", true, true }, { "MultiSamples4", false, true, 4 },
  { "FloatMultiSamples4", true, false, 4 } };
INSTANTIATE_TEST_SUITE_P(Each, CullerReversedDepth, testing::ValuesIn(ReversedWays), GetCaseName);
INSTANTIATE_TEST_SUITE_P(
  Each, CullerReversedDepthOnce, testing::Values(ReversedWay{ "Finite" }), GetCaseName);
}

// Hazard: the nearest props count as the farthest ones. The culler has to hide the same props as
// with VTK's depth, and VTK has to show the same scene.
TEST_P(CullerReversedDepth, Wall)
{
  ComparisonOptions options = GetReversedOptions(this->GetParam());
  Comparison comparison(
    [this](Stage& stage)
    {
      Reverse(stage, this->GetParam());
      Scenes::BuildWall(stage);
    },
    options);
  Comparison ordinary(
    Scenes::BuildWall, GetReversedOptions({ "Ordinary", false, false, options.MultiSamples }));
  for (int i = 0; i < 5; ++i)
  {
    for (Comparison* each : { &comparison, &ordinary })
    {
      Scenes::FrameOfWall(*each, i < 3 ? 0.2 * i : 4.0 * i, "moved");
      EXPECT_EQ(each->GetDecision(), Decision::Culled);
    }
    EXPECT_NEAR(comparison.GetHidden(), ordinary.GetHidden(), 2);
    EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
    // Edges between surfaces may be a pixel farther to one side.
    const auto takePicture = [](const Comparison& each)
    {
      return TestScene::TakePicture(
        each.Reference.Window, false, TestScene::PictureSource::Rendered);
    };
    EXPECT_LT(CountDifferences(takePicture(comparison), takePicture(ordinary)), 301U * 173U / 200U);
  }
  comparison.Frame("still");
  comparison.Frame("still");
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
}

// Hazard: after a cut nothing that was visible helps to find what is hidden now.
TEST_P(CullerReversedDepth, StreetAndCuts)
{
  ComparisonOptions options = GetReversedOptions(this->GetParam());
  options.Tuning.ReuseWhenStill = false;
  Comparison comparison(
    [this](Stage& stage)
    {
      Reverse(stage, this->GetParam());
      Scenes::BuildCity(stage);
    },
    options);
  options.ReadRendered = false;
  Comparison ordinary([](Stage& stage) { Scenes::BuildCity(stage); }, options);
  int hidden = 0;
  int ofOrdinary = 0;
  for (int i = 0; i < 12; ++i)
  {
    const double t = i % 4 == 3 ? 0.07 * (12 - i) : 0.02 * i;
    Scenes::FrameOfCity(comparison, t);
    Scenes::FrameOfCity(ordinary, t);
    hidden += comparison.GetHidden();
    ofOrdinary += ordinary.GetHidden();
  }
  EXPECT_GT(hidden, ofOrdinary * 0.97);
  EXPECT_LT(hidden, ofOrdinary * 1.03 + 1.0);
  EXPECT_GT(hidden, 400);
}

// Hazard: triangles that are culled inside of a prop are compared with depths, and not orders.
TEST_P(CullerReversedDepth, DividedProp)
{
  LargeProps::Units units[2];
  for (const bool isReversed : { false, true })
  {
    const ReversedWay way = isReversed
      ? this->GetParam()
      : ReversedWay{ "Ordinary", false, false, this->GetParam().MultiSamples, false };
    ComparisonOptions options = LargeProps::MakeOptions();
    options.MultiSamples = way.MultiSamples;
    options.CompareDepth = way.MultiSamples == 0;
    options.ReadRendered = way.Float;
    options.Backend = vtkNBufferCuller::CPU; // OpenGL hides fewer units, because it has no pixels.
    Comparison comparison(
      [&way](Stage& stage)
      {
        Reverse(stage, way);
        LargeProps::AddSphereAndWalls(stage);
      },
      options);
    units[isReversed] = LargeProps::CompareWalk(comparison, LargeProps::WalkFromOutside);
  }
  EXPECT_GT(units[1].Hidden, 200);
  EXPECT_NEAR(units[1].Hidden, units[0].Hidden, 0.05 * units[0].Hidden);
}

// Hazard: equal depths. Of several fragments with the same depth the last one wins with GL_GEQUAL,
// too.
TEST_P(CullerReversedDepth, Ties)
{
  const auto set = [this](Stage& stage)
  {
    vtkCamera* old = stage.GetRenderer()->GetActiveCamera();
    old->Register(nullptr);
    Reverse(stage, this->GetParam());
    stage.GetRenderer()->GetActiveCamera()->DeepCopy(old);
    old->UnRegister(nullptr);
  };
  int redrawn = 0;
  for (const unsigned int seed : { 1U, 2U, 3U })
  {
    redrawn += Scenes::MoveTheDoorBeforeTies(seed, 8, set, GetReversedOptions(this->GetParam()));
  }
  EXPECT_GT(redrawn, 0);
}

// Hazard: translucent props behind the wall are hidden by what is drawn, and those before it not.
TEST_P(CullerReversedDepth, TranslucentProps)
{
  Comparison comparison(
    [this](Stage& stage)
    {
      Reverse(stage, this->GetParam());
      Scenes::BuildWall(stage);
      Scenes::AddTranslucentBoxes(stage);
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    GetReversedOptions(this->GetParam()));
  Scenes::FramesOfWall(comparison, { 0.0, 0.2, 0.4, 0.6, 0.8 });
  int hidden = 0;
  int shown = 0;
  for (int i = 0; i < 8; ++i)
  {
    const Verdict verdict = comparison.GetVerdict(Wall::Count + i);
    hidden += verdict == Verdict::Hidden ? 1 : 0;
    shown += verdict == Verdict::Translucent ? 1 : 0;
  }
  EXPECT_GT(hidden, 0);
  EXPECT_GT(shown, 0);
}

// Small floats are precise: at half of the distance of a far plane at 1e7 times the near one, a
// wall hides what is a tenth farther. VTK's depth cannot tell these two apart.
TEST_P(CullerReversedDepthOnce, FarAwayFloatsStayPrecise)
{
  for (const ReversedWay& way : { ReversedWay{ "Ordinary", true, false, 0, false },
         ReversedWay{ "Finite", true }, ReversedWay{ "InfiniteFar", true, true } })
  {
    SCOPED_TRACE(way.Name);
    ComparisonOptions options = Scenes::MakeExactOptions(301, 173);
    options.ReadRendered = true;
    Comparison comparison(
      [&](Stage& stage)
      {
        Reverse(stage, way);
        Scenes::AddBox(stage, 0.0, 0.0, -5.0e5, 4.0e5, 4.0e5, 10.0);
        for (int i = 0; i < 8; ++i)
        {
          Scenes::AddBox(stage, 2.0e4 * (i - 4), 0.0, -5.5e5, 1.0e4, 1.0e4, 10.0);
        }
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.0, 0.0, 0.0);
        camera->SetFocalPoint(0.0, 0.0, -1.0);
        camera->SetClippingRange(0.1, 1.0e6);
      },
      options);
    Scenes::Settle(comparison);
    EXPECT_EQ(comparison.GetHidden(), way.Reversed ? 8 : 0);
  }
}

// The state may also be set by observers, without a render pass.
TEST_P(CullerReversedDepthOnce, SetUpByObservers)
{
  ComparisonOptions options;
  for (const bool hasTranslucent : { false, true })
  {
    Comparison comparison(
      [&](Stage& stage)
      {
        TestScene::ReverseByObservers(stage.GetRenderer());
        Scenes::BuildWall(stage);
        if (hasTranslucent)
        {
          Scenes::AddTranslucentBoxes(stage);
          Scenes::SetWallCamera(stage.GetRenderer());
        }
      },
      options);
    for (int i = 0; i < 4; ++i)
    {
      Scenes::FrameOfWall(comparison, 0.2 * i);
      // VTK then draws translucent props by order-independent transparency.
      EXPECT_EQ(comparison.GetDecision(), hasTranslucent ? Decision::OtherView : Decision::Culled);
    }
    EXPECT_EQ(comparison.GetHidden() > Wall::Behind / 3, !hasTranslucent);
  }
}

// Hazard: ranks share depth whose smaller values are farther. VTK composites its own depth alone.
TEST_P(CullerReversedDepthOnce, RanksCullAlone)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int)
  { stages.Both([](Stage& stage) { TestScene::ReverseByObservers(stage.GetRenderer()); }); };
  const std::vector<RankFrame> frames = DrawRanks(options);
  EXPECT_LT(Sum({ frames.back() }), 14 * 14 / 2);
}

// Hazard: what is outside of the view, or hidden, is decided by the depth that was stored in the
// last frame.
TEST_P(CullerReversedDepthOnce, SwitchedOnAndOff)
{
  enum class Case
  {
    Perspective,
    Parallel,  // Half of the scene has a negative z in VTK's clip coordinates.
    StateAlone // With the camera for reversed depth alone, VTK draws what is farthest.
  };
  for (const Case kind : { Case::Perspective, Case::Parallel, Case::StateAlone })
  {
    SCOPED_TRACE(static_cast<int>(kind));
    Comparison comparison(
      [](Stage& stage)
      {
        Reverse(stage, { "Finite" });
        Scenes::BuildWall(stage);
      });
    for (int i = 0; i < 16; ++i)
    {
      const bool isReversed = i / 2 % 2 == 1;
      comparison.Frame(
        [&](Stage& stage)
        {
          vtkRenderer* renderer = stage.GetRenderer();
          if (kind != Case::StateAlone)
          {
            renderer->SetActiveCamera(isReversed
                ? vtkSmartPointer<vtkCamera>(vtkSmartPointer<TestScene::ReversedCamera>::New())
                : vtkSmartPointer<vtkCamera>::New());
          }
          Scenes::SetWallCamera(renderer, 0.2 * i);
          renderer->GetActiveCamera()->SetParallelProjection(kind == Case::Parallel);
          renderer->GetActiveCamera()->SetParallelScale(5.0);
          renderer->SetPass(
            TestScene::MakePass(isReversed ? PassKind::Reversed : PassKind::OpaqueTranslucent));
        });
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    }
  }
}

// Hazard: what a pass draws first hides other props than what it draws a second time, in reversed
// depth.
TEST_P(CullerReversedDepthOnce, DrawnTwiceInUnlikeDepths)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Reverse(stage, { "Finite" });
      vtkNew<TestScene::ReversedDepthPass> reversed;
      reversed->Delegate = vtkSmartPointer<vtkOpaquePass>::New();
      reversed->DrawsTwice = true;
      stage.GetRenderer()->SetPass(
        TestScene::MakeSequence({ vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), reversed }));
      Scenes::BuildWall(stage);
    });
  Scenes::ExpectStepsAside(comparison, { 0.0, 0.2, 0.4, 0.6 }, Decision::OtherView);
}

// Hazard: an offset that pushes surfaces away from the eye pulls them towards the eye.
TEST_P(CullerReversedDepthOnce, StepsAsideForOffsets)
{
  for (const bool isGlobal : { false, true })
  {
    Comparison comparison(
      [&](Stage& stage)
      {
        Reverse(stage, this->GetParam());
        Scenes::BuildWall(stage);
        if (!isGlobal)
        {
          stage.GetActor(Wall::FirstBehind)->GetProperty()->EdgeVisibilityOn();
        }
      });
    vtkMapper::SetResolveCoincidentTopology(
      isGlobal ? VTK_RESOLVE_POLYGON_OFFSET : VTK_RESOLVE_OFF);
    Scenes::ExpectStepsAside(comparison, { 0.0, 0.2, 0.4 }, Decision::OtherView);
    vtkMapper::SetResolveCoincidentTopologyToDefault();
  }
}

// Hazard: VTK's shaders for translucent props take reversed depth for VTK's own, and show what is
// behind opaque props.
TEST_P(CullerReversedDepthOnce, StepsAsideWhereShadersCompareDepth)
{
  for (const bool isOIT : { false, true })
  {
    Comparison comparison(
      [&](Stage& stage)
      {
        Reverse(stage, this->GetParam());
        Scenes::BuildWall(stage);
        Scenes::AddTranslucentBoxes(stage);
        Scenes::SetWallCamera(stage.GetRenderer());
        vtkNew<vtkTranslucentPass> translucent;
        vtkSmartPointer<vtkRenderPass> around;
        if (isOIT)
        {
          vtkNew<vtkOrderIndependentTranslucentPass> pass;
          pass->SetTranslucentPass(translucent);
          around = pass;
        }
        else
        {
          vtkNew<vtkDualDepthPeelingPass> pass;
          pass->SetTranslucentPass(translucent);
          around = pass;
        }
        vtkNew<vtkRenderPassCollection> passes;
        passes->AddItem(vtkNew<vtkLightsPass>());
        passes->AddItem(vtkNew<vtkOpaquePass>());
        passes->AddItem(around);
        vtkNew<vtkSequencePass> sequence;
        sequence->SetPasses(passes);
        GetReversedPass(stage)->Delegate = sequence;
      });
    Scenes::ExpectStepsAside(comparison, { 0.0, 0.2, 0.4 }, Decision::OtherView);
  }
}

// Hazard: other depth functions let other fragments win.
TEST_P(CullerReversedDepthOnce, StepsAsideForOtherDepthFunctions)
{
  for (const GLenum passes : { GL_GREATER, GL_ALWAYS, GL_LEQUAL })
  {
    ComparisonOptions options;
    options.MayBeOfOneColor = passes == GL_LEQUAL; // Nothing is farther than infinity.
    Comparison comparison(
      [&](Stage& stage)
      {
        Reverse(stage, this->GetParam());
        GetReversedPass(stage)->DepthFunction = passes;
        Scenes::BuildWall(stage);
      },
      options);
    Scenes::ExpectStepsAside(comparison, { 0.0, 0.2, 0.4 }, Decision::OtherView);
  }
}

// Shadow volumes are counted in VTK's depth alone.
TEST_P(CullerReversedDepthOnce, ShadowPassDrawsWithoutShadows)
{
  ComparisonOptions options;
  options.KeepMessages = true;
  Comparison comparison(
    [&](Stage& stage)
    {
      Reverse(stage, this->GetParam());
      Scenes::BuildWall(stage);
      Scenes::SetSpotLight(stage);
      if (stage.Culler)
      {
        vtkNew<vtkShadowVolumeClampPass> shadows;
        stage.GetRenderer()->SetPass(TestScene::MakePass(PassKind::Reversed, shadows));
      }
    },
    options);
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.2, 0.4 }, 1);
  const std::size_t first = comparison.Messages.find("Drawn without shadows. Depth is reversed");
  EXPECT_NE(first, std::string::npos) << comparison.Messages;
  EXPECT_EQ(comparison.Messages.find("Drawn without shadows", first + 1), std::string::npos);
}
