// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// When the culler does not test a frame: its decision says so, and it does no work.
#include "CullerTest.h"
#include "LargeProps.h"
#include "Scenes.h"
#include "Tune.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferUnitTrial.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkGL2PSExporter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <cstdio>
#include <fstream>
#include <iterator>

using Scenes::Wall;

namespace
{
/// A culler of an application, which removes nothing.
class OwnCuller : public vtkCuller
{
public:
  static OwnCuller* New();
  vtkTypeMacro(OwnCuller, vtkCuller);
  double Cull(vtkRenderer*, vtkProp**, int& count, int&) override { return count; }
};
vtkStandardNewMacro(OwnCuller);

/// Boxes side by side: all visible.
void BuildNothingHidden(Stage& stage)
{
  for (int i = 0; i < 10; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      Scenes::AddBox(stage, 1.2 * i - 5.4, 1.0 * j - 3.5, 0.0, 0.4, 0.4, 0.4);
    }
  }
  Scenes::SetWallCamera(stage.GetRenderer());
}

/// A mesh that is seen whole, behind two narrow walls.
void BuildScreen(Stage& stage)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(30.0, -12.0, -8.0);
  plane->SetPoint1(30.0, 12.0, -8.0);
  plane->SetPoint2(30.0, -12.0, 16.0);
  plane->SetResolution(20, 20);
  plane->Update();
  const double white[3] = { 1.0, 1.0, 1.0 };
  stage.AddActor(plane->GetOutput(), white);
  LargeProps::AddWalls(stage);
}

ComparisonOptions MakeTimedOptions()
{
  ComparisonOptions options = LargeProps::MakeOptions();
  options.Tuning.TimeUnits = true;
  return options;
}

/// Compares a frame, seen from a place of its own, and returns whether it has been drawn unit by
/// unit.
bool DrawsUnits(Comparison& comparison, int frame)
{
  comparison.Frame(
    [frame](Stage& stage)
    {
      vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
      camera->SetPosition(0.1 * frame - 40.0, 0.0, 4.0);
      camera->SetFocalPoint(30.0, 0.0, 4.0);
      camera->SetViewUp(0.0, 0.0, 1.0);
      camera->SetClippingRange(0.05, 200.0);
    });
  return comparison.GetStatistics().Units > 0;
}

void DrawUntilDivided(Comparison& comparison)
{
  int frames = 0;
  while (!DrawsUnits(comparison, frames))
  {
    ASSERT_LT(++frames, 10) << "no units";
  }
}
}

// Hazard: a read-back of depth takes longer than drawing a few props.
TEST(CullerDecisions, FewCandidates)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 12.0, 6.0, 0.5);
      for (int i = 0; i < 20; ++i)
      {
        Scenes::AddBox(stage, 0.2 * i - 2.0, 0.0, -3.0, 0.5, 0.5, 0.5);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
    EXPECT_EQ(comparison.GetDecision(), Decision::FewCandidates);
    EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
    EXPECT_EQ(comparison.GetVerdict(1), Verdict::Untested);
  }
  Tune(comparison.GetCuller(), &vtkNBufferTuning::MinimumNumberOfCandidates, 21);
  Scenes::FrameOfWall(comparison, 0.5, "21 are enough now");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  EXPECT_GT(comparison.GetHidden(), 5);
}

// Hazard: props outside the frustum are counted where the culler decides whether a test is worth
// its cost.
TEST(CullerDecisions, FewCandidatesInTheFrustum)
{
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  Comparison comparison(
    [](Stage& stage)
    {
      for (int i = 0; i < 100; ++i)
      {
        Scenes::AddBox(stage, 40.0 + i, 0.0, 0.0, 0.5, 0.5, 0.5);
      }
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0);
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  comparison.Frame();
  EXPECT_EQ(comparison.GetDecision(), Decision::FewCandidates);
  EXPECT_EQ(comparison.GetStatistics().GetCount(Verdict::Outside), 100);
  EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
}

// Hazard: the default culler, in front of vtkNBufferCuller in the list, leaves few of many props,
// and stays in front because these few are not worth a test.
TEST(CullerDecisions, FewOfManyAreInView)
{
  constexpr int inView = 5;
  constexpr int outside = 10000;
  ComparisonOptions options;
  options.StockReference = true;
  Comparison comparison(
    [](Stage& stage)
    {
      for (int i = 0; i < inView; ++i)
      {
        Scenes::AddBox(stage, 2.0 * i - 4.0, 0.0, 0.0, 1.0, 1.0, 1.0);
      }
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(Scenes::MakeBox({ 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.5 }));
      for (int i = 0; i < outside; ++i)
      {
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->SetPosition(40.0 + i % 100, i / 100, 0.0);
        stage.Add(actor);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
    EXPECT_EQ(comparison.GetDecision(), Decision::FewCandidates);
    EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
    EXPECT_EQ(comparison.GetStatistics().Props, i == 0 ? inView : inView + outside)
      << "after one frame the default culler comes behind ours";
    EXPECT_EQ(comparison.GetStatistics().GetCount(Verdict::Outside), i == 0 ? 0 : outside);
  }
}

// Hazard: all candidates are hidden by props that are not candidates, and yet the nearest
// candidates are drawn untested in every frame.
TEST(CullerDecisions, AllAreHiddenByOtherProps)
{
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  options.MayBeOfOneColor = true; // that of the wall
  Comparison comparison(
    [](Stage& stage)
    {
      const int wall = Scenes::AddBox(stage, 0.0, 0.0, 0.0, 60.0, 60.0, 0.5);
      stage.GetActor(wall)->GetProperty()->VertexVisibilityOn(); // no candidate
      for (int i = 0; i < 60; ++i)
      {
        Scenes::AddBox(stage, i % 10 - 5.0, i / 10 - 3.0, -4.0, 0.5, 0.5, 0.5);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i);
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_EQ(comparison.GetStatistics().DrawnInRound[1], i == 0 ? options.Tuning.RoundSize : 0)
      << i;
    // Those that were drawn as a guess are tested, too, and not drawn again.
    EXPECT_EQ(comparison.GetHidden(), i == 0 ? 60 - options.Tuning.RoundSize : 60) << i;
  }
  // The same holds if the camera stands still after a cut.
  comparison.Frame(
    "away", [](Stage& stage) { stage.GetRenderer()->GetActiveCamera()->Yaw(180.0); });
  Scenes::FrameOfWall(comparison, 0.0, "back");
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(comparison.GetDecision(), i < 2 ? Decision::Culled : Decision::Still) << i;
    EXPECT_EQ(comparison.GetHidden(), i == 0 ? 60 - options.Tuning.RoundSize : 60) << i;
    comparison.Frame("still");
  }
}

// Hazard: VTK redraws at every expose event; a frame in which nothing has changed must not be
// tested again.
TEST(CullerDecisions, StillCamera)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame("first");
  // What is drawn for the first time is modified by being drawn.
  comparison.Frame("second");
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("still");
    EXPECT_EQ(comparison.GetDecision(), Decision::Still) << i;
    EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind), Verdict::Hidden);
    EXPECT_EQ(comparison.GetStatistics().Refreshed, 0);
  }
  Scenes::FrameOfWall(comparison, 0.1, "moved");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  comparison.Frame("still again");
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::ReuseWhenStill, false);
  comparison.Frame("reuse off");
  EXPECT_NE(comparison.GetDecision(), Decision::Still);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: Modified() without a change of position may cost one test at most.
TEST(CullerDecisions, CameraTouchedButNotMoved)
{
  Comparison comparison(Scenes::BuildWall);
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame([](Stage& stage) { stage.GetRenderer()->GetActiveCamera()->Modified(); });
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  }
}

// Hazard: tests are wasted while nothing is hidden; they must pause then, and resume when something
// is hidden again.
TEST(CullerDecisions, BacksOffWhereNothingIsHiddenAndProbes)
{
  ComparisonOptions options;
  options.Tuning.BackOff = true;
  Comparison comparison(BuildNothingHidden, options);
  int tested = 0;
  int backedOff = 0;
  for (int i = 0; i < 60; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.01 * i);
    tested += comparison.GetDecision() == Decision::Culled;
    if (comparison.GetDecision() == Decision::BackedOff)
    {
      ++backedOff;
      EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
      EXPECT_EQ(comparison.GetVerdict(0), Verdict::Untested);
    }
  }
  EXPECT_GT(backedOff, 20);
  EXPECT_LE(tested, 30);
  comparison.Both([](Stage& stage) { Scenes::AddBox(stage, 0.0, 0.0, 2.0, 14.0, 9.0, 0.2); });
  int frames = 0;
  for (; frames < 100 && comparison.GetHidden() < 40; ++frames)
  {
    Scenes::FrameOfWall(comparison, 0.01 * frames, "wall put up");
  }
  EXPECT_LT(frames, 100) << "a probe must find the new wall";
}

// Hazard: although all props are visible, they are held back and drawn after a test that finds
// nothing hidden.
TEST(CullerDecisions, NothingHeldWhereEverythingWasVisible)
{
  ComparisonOptions options;
  options.Tuning.BackOff = true;
  Comparison comparison(BuildNothingHidden, options);
  for (int i = 0; i < 6; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.01 * i);
    EXPECT_EQ(comparison.GetHidden(), 0);
    if (comparison.GetDecision() == Decision::NothingHeld)
    {
      EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
      EXPECT_EQ(comparison.GetStatistics().HeldBack, 0);
    }
  }
}

// Hazard: levels are built that no rectangle needs.
TEST(CullerDecisions, SmallPropsNeedFewLevels)
{
  const auto build = [](double size)
  {
    return [size](Stage& stage)
    {
      for (int i = 0; i < 12 * 20; ++i)
      {
        Scenes::AddBox(stage, 0.5 * (i % 20) - 4.75, 0.5 * (i / 20) - 2.75, 0.0, 0.5, 0.5, 0.5);
      }
      for (int i = 0; i < 40; ++i)
      {
        Scenes::AddBox(stage, 0.1 * i - 2.0, 0.0, -6.0, size, size, 0.1);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    };
  };
  Comparison small(build(0.05));
  Comparison large(build(4.0));
  for (int i = 0; i < 3; ++i)
  {
    Scenes::MoveWallCamera(small, 0.1 * i);
    Scenes::MoveWallCamera(large, 0.1 * i);
    small.Frame("small");
    large.Frame("large");
  }
  EXPECT_GE(small.GetHidden(), 30);
  EXPECT_GE(large.GetHidden(), 30);
  EXPECT_LT(small.GetStatistics().Levels, large.GetStatistics().Levels);
  EXPECT_LE(small.GetStatistics().BytesRead, 4LL * 301 * 173 * small.GetStatistics().ReadBacks);
  EXPECT_LE(small.GetStatistics().Texels, large.GetStatistics().Texels);
}

// Hazard: bounds are expensive to compute, and are computed again for props that have not changed.
TEST(CullerDecisions, OnlyChangedPropsAreRefreshed)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  EXPECT_EQ(comparison.GetStatistics().Refreshed, comparison.GetStatistics().Props);
  Scenes::FrameOfWall(comparison, 0.05);
  Scenes::FrameOfWall(comparison, 0.1);
  EXPECT_EQ(comparison.GetStatistics().Refreshed, 0);
  comparison.Both([](Stage& stage) { stage.GetActor(5)->SetPosition(0.1, 0.0, 0.0); });
  Scenes::FrameOfWall(comparison, 0.2);
  EXPECT_EQ(comparison.GetStatistics().Refreshed, 1);
}

// Hazard: a setting of VTK for all mappers moves depths without modifying any prop.
TEST(CullerDecisions, SettingsOfAllMappersEndTheStill)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame();
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  comparison.Frame("moved");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}

// Hazard: TestSlivers is switched on in a still frame, and the old verdicts, for which slivers were
// not tested, stay.
TEST(CullerDecisions, SliversAreTestedFromTheNextFrameOn)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  comparison.GetCuller()->SetTestSlivers(false);
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame();
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  comparison.GetCuller()->SetTestSlivers(true);
  comparison.Frame("with slivers");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
}

// Hazard: frozen verdicts must stay while the camera moves, and the first frame without Freeze must
// be right.
TEST(CullerDecisions, FreezeKeepsTheVerdicts)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  std::vector<Verdict> verdicts;
  for (int i = 0; i < Wall::Count; ++i)
  {
    verdicts.push_back(comparison.GetVerdict(i));
  }
  comparison.GetCuller()->FreezeOn();
  for (double shift : { 3.0, 9.0, -15.0 })
  {
    Scenes::MoveWallCamera(comparison, shift);
    comparison.Culled.ResetDraws();
    comparison.Culled.Window->Render();
    EXPECT_EQ(comparison.GetDecision(), Decision::Frozen);
    EXPECT_TRUE(DidNoWork(comparison.GetStatistics()));
    for (int i = 0; i < Wall::Count; ++i)
    {
      EXPECT_EQ(comparison.GetVerdict(i), verdicts[i]) << i;
      const bool culled = verdicts[i] == Verdict::Hidden || verdicts[i] == Verdict::Outside;
      EXPECT_TRUE(!culled || comparison.Culled.GetDraws(i) == 0) << i;
    }
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  }
  comparison.GetCuller()->FreezeOff();
  comparison.Frame("thawed");
  EXPECT_NE(comparison.GetDecision(), Decision::Frozen);
}

// Hazard: a prop changes while the verdicts are frozen, and is not seen as changed afterwards.
TEST(CullerDecisions, ChangesOfFrozenFramesCountWhenThawed)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame();
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  comparison.GetCuller()->FreezeOn();
  comparison.Both([](Stage& stage) { stage.GetActor(Wall::Index)->SetPosition(7.0, 0.0, 0.0); });
  for (int i = 0; i < 2; ++i)
  {
    comparison.Culled.Window->Render();
    EXPECT_EQ(comparison.GetDecision(), Decision::Frozen);
  }
  comparison.GetCuller()->FreezeOff();
  comparison.Culled.ResetDraws();
  comparison.Frame("thawed");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
}

// Hazard: a prop that is added while the verdicts are frozen has no verdict.
TEST(CullerDecisions, PropsThatJoinWhileFrozenAreDrawn)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  comparison.GetCuller()->FreezeOn();
  comparison.Both([](Stage& stage) { Scenes::AddBox(stage, 0.0, 0.0, 4.0, 1.0, 1.0, 1.0); });
  comparison.Culled.ResetDraws();
  comparison.Culled.Window->Render();
  EXPECT_EQ(comparison.Culled.GetDraws(Wall::Count), 1);
}

//------------------------------------------------------------------------------------------------
// Hazard: a vector export captures geometry and draws no depth; nothing may be missing in it.
TEST(CullerDecisions, GL2PSExportIsTheSame)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  std::string text[2];
  for (Stage* stage : { &comparison.Reference, &comparison.Culled })
  {
    const int which = stage == &comparison.Culled;
    const std::string prefix = testing::TempDir() + "nbuffer-gl2ps-" + std::to_string(which);
    vtkNew<vtkGL2PSExporter> exporter;
    exporter->SetRenderWindow(stage->Window);
    exporter->SetFileFormatToSVG();
    exporter->CompressOff();
    exporter->Write3DPropsAsRasterImageOff();
    exporter->SetFilePrefix(prefix.c_str());
    exporter->Write();
    std::ifstream file(prefix + ".svg", std::ios::binary);
    text[which].assign(std::istreambuf_iterator<char>(file), {});
    file.close();
    std::remove((prefix + ".svg").c_str());
  }
  EXPECT_FALSE(text[0].empty());
  EXPECT_EQ(text[0].size(), text[1].size());
  comparison.Frame("after the export");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: verdicts are stored by the pointers of props; reading the verdict of a prop that is not
// among them must not crash.
TEST(CullerDecisions, VerdictsOfStrangers)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  vtkNew<vtkActor> stranger;
  vtkNew<vtkRenderer> elsewhere;
  EXPECT_EQ(comparison.GetCuller()->GetVerdict(stranger), Verdict::Unknown);
  EXPECT_EQ(comparison.GetCuller()->GetVerdict(nullptr), Verdict::Unknown);
  EXPECT_EQ(
    comparison.GetCuller()->GetVerdict(comparison.Culled.Props[0], elsewhere), Verdict::Unknown);
  EXPECT_EQ(comparison.GetCuller()->GetVerdict(comparison.Culled.Props[0]), Verdict::Visible);
}

// Hazard: the culler's proxy gets into the renderer's own collections of props, where applications
// would find it.
TEST(CullerDecisions, TheRendererKeepsItsProps)
{
  Comparison comparison(Scenes::BuildWall);
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.2 * i);
    vtkPropCollection* props = comparison.Culled.GetRenderer()->GetViewProps();
    ASSERT_EQ(props->GetNumberOfItems(), Wall::Count);
    for (int prop = 0; prop < Wall::Count; ++prop)
    {
      EXPECT_EQ(props->GetItemAsObject(prop), comparison.Culled.Props[prop]);
    }
    EXPECT_EQ(comparison.Culled.GetRenderer()->GetNumberOfPropsRendered(),
      comparison.GetStatistics().GetNumberOfPropsDrawn());
  }
}

// Hazard: frames that are to be compared are drawn in the same way, or the trial never begins.
TEST(CullerDecisions, FramesAreTimedWithAndWithoutUnits)
{
  Comparison comparison(BuildScreen, MakeTimedOptions());
  DrawUntilDivided(comparison);
  constexpr int settling = vtkNBufferContest::SettlingFrames;
  for (int i = 1; i < settling + 2 * vtkNBufferContest::FramesOfEach; ++i)
  {
    EXPECT_EQ(DrawsUnits(comparison, i), i < settling || (i - settling) % 2 == 0) << i;
  }
  // One of both ways has won.
  const bool hasUnits = DrawsUnits(comparison, 0);
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_EQ(DrawsUnits(comparison, i), hasUnits) << i;
  }
}

// Hazard: a software renderer draws everything in some frames, although most of it is hidden.
TEST(CullerDecisions, MostlyHiddenUnitsAreNotTimedOnSoftwareRenderers)
{
  Comparison comparison(LargeProps::AddSphereAndWalls, MakeTimedOptions());
  DrawUntilDivided(comparison);
  if (!vtkNBufferGL::GetSoftwareRenderer())
  {
    GTEST_SKIP() << "the renderer is no software renderer";
  }
  for (int i = 0; i < 3 * vtkNBufferContest::FramesOfEach; ++i)
  {
    EXPECT_TRUE(DrawsUnits(comparison, i)) << i;
  }
}

// Hazard: VTK's own culler, which has been moved behind vtkNBufferCuller, gets settings afterwards,
// or another culler comes behind. Either would see proxies instead of what is held back.
TEST(CullerDecisions, OtherCullersBehindAreNoticed)
{
  ComparisonOptions options;
  options.StockReference = true;
  Comparison comparison(Scenes::BuildWall, options);
  vtkRenderer* renderer = comparison.Culled.GetRenderer();
  comparison.Frame("default settings");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  comparison.Frame("other settings",
    [](Stage& stage)
    {
      vtkCullerCollection* cullers = stage.GetRenderer()->GetCullers();
      for (int i = 0; i < cullers->GetNumberOfItems(); ++i)
      {
        if (auto* culler = vtkFrustumCoverageCuller::SafeDownCast(cullers->GetItemAsObject(i)))
        {
          culler->SetMinimumCoverage(1e-6);
        }
      }
    });
  EXPECT_EQ(comparison.GetDecision(), Decision::OtherCuller);
  renderer->RemoveCuller(comparison.Culled.Culler);
  renderer->AddCuller(comparison.Culled.Culler);
  comparison.Frame("added again");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  renderer->AddCuller(vtkNew<OwnCuller>());
  comparison.Frame("another culler");
  EXPECT_EQ(comparison.GetDecision(), Decision::OtherCuller);
}
