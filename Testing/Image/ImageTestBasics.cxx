// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// One renderer, one window: the image is the same and culling takes place, with every setting.
#include "CullerTest.h"
#include "Scenes.h"
#include "Tune.h"

#include "vtkNBufferMath.h"
#include "vtkShadowVolumeClampPass.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"

#include <iterator>
#include <numeric>
#include <sstream>

using Scenes::Wall;

namespace
{
/// The culler exactly as it comes.
ComparisonOptions Defaults()
{
  ComparisonOptions options;
  options.Tuning = vtkNBufferTuning();
  return options;
}

void WalkPastTheWall(Comparison& comparison, int frames, double from = 0.0, double step = 0.01)
{
  for (int i = 0; i < frames; ++i)
  {
    Scenes::FrameOfCity(comparison, from + step * i, "walk");
  }
}

int GetPropsDrawnInRounds(const vtkNBufferStatistics& statistics)
{
  return std::accumulate(std::begin(statistics.DrawnInRound), std::end(statistics.DrawnInRound), 0);
}
}

// Hazard: the culler works only in its own test scenes: hidden props must be found in a plain one,
// and those that the first round drew untested must be hidden in the next frame.
TEST(CullerBasics, WallHidesWhatIsBehindIt)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  EXPECT_EQ(comparison.GetVerdict(Wall::Index), Verdict::Visible);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  Scenes::FrameOfWall(comparison, 0.1, "next");
  Scenes::FrameOfWall(comparison, 0.2, "and the one after that");
  for (int i = 0; i < Wall::Behind; ++i)
  {
    EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + i), Verdict::Hidden) << i;
  }
  EXPECT_EQ(comparison.GetHidden(), Wall::Behind);
  EXPECT_EQ(comparison.GetCuller()->GetNumberOfHiddenProps(), Wall::Behind);
  EXPECT_EQ(comparison.GetCuller()->GetNumberOfProps(), Wall::Count);
  EXPECT_STREQ(comparison.GetCuller()->GetDecision(), "Culled");
}

// Hazard: nothing is known in the first frame, which is often the only one that a screenshot needs.
TEST(CullerBasics, FirstFrameIsCulled)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, Defaults());
  comparison.Frame("first");
  const vtkNBufferStatistics& statistics = comparison.GetStatistics();
  EXPECT_EQ(statistics.Decision, Decision::Culled);
  EXPECT_GT(comparison.GetHidden(), 40);
  EXPECT_GT(statistics.GetCount(Verdict::Outside), 0);
  EXPECT_GE(statistics.Rounds, 1);
  EXPECT_LE(statistics.Rounds, 6);
  EXPECT_GT(statistics.Levels, 0);
  // In the first frame the default culler still stood before ours.
  EXPECT_GT(statistics.Props, 100);
  EXPECT_EQ(GetPropsDrawnInRounds(statistics),
    statistics.Candidates - statistics.GetNumberOfPropsNotDrawn());
}

// Hazard: a moving camera uncovers what was hidden; nothing may appear one frame late.
TEST(CullerBasics, WalkThroughTheCity)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, Defaults());
  for (int i = 0; i < 40; ++i)
  {
    WalkPastTheWall(comparison, 1, 0.025 * i);
    const vtkNBufferStatistics& statistics = comparison.GetStatistics();
    if (i < 20)
    {
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled) << i;
      EXPECT_GT(comparison.GetHidden(), 10) << i;
    }
    if (comparison.GetDecision() == Decision::Culled)
    {
      EXPECT_EQ(GetPropsDrawnInRounds(statistics),
        statistics.Candidates - statistics.GetNumberOfPropsNotDrawn())
        << i;
    }
  }
}

// Hazard: after a cut of the camera the verdicts of the last frame are of no use; rounds must find
// the new occluders.
TEST(CullerBasics, CameraCuts)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage, 18); }, Defaults());
  const double times[] = { 0.45, 0.05, 0.3, 0.05, 0.45, 0.2 };
  for (double t : times)
  {
    WalkPastTheWall(comparison, 1, t);
    EXPECT_GT(comparison.GetHidden(), 50) << t;
    EXPECT_LE(comparison.GetStatistics().Rounds, 6) << t;
  }
  // Turned round on the spot: the two visible sets have next to nothing in common.
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("turned",
      [](Stage& stage)
      {
        stage.GetRenderer()->GetActiveCamera()->Yaw(175.0);
        stage.GetRenderer()->ResetCameraClippingRange();
      });
    EXPECT_LE(comparison.GetStatistics().Rounds, 6);
  }
}

// Hazard: the camera jumps between two views, and each begins with the visible props of the other,
// which hide nothing.
TEST(CullerBasics, JumpingToAndFro)
{
  Comparison comparison(Scenes::BuildWall);
  for (int i = 0; i < 16; ++i)
  {
    comparison.Frame(i % 4 >= 2 ? "behind" : "before",
      [i](Stage& stage)
      {
        // Two frames on each side of the wall.
        const bool behind = i % 4 >= 2;
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition((behind ? 3.0 : -1.0) + 0.1 * (i % 2), 0.5, behind ? -20.0 : 20.0);
        stage.GetRenderer()->ResetCameraClippingRange();
      });
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_TRUE(i % 4 >= 2 || comparison.GetHidden() >= Wall::Hidden) << comparison.GetHidden();
  }
}

// Hazard: VTK builds the list of props in every Render(), so that a culler may be added at any
// time.
TEST(CullerBasics, AddedAfterTheFirstRenderAndRemovedAgain)
{
  ComparisonOptions options;
  options.AddCuller = false;
  Comparison comparison(Scenes::BuildWall, options);
  comparison.Culled.Window->Render();
  comparison.Culled.Window->Render();
  comparison.AddCuller();
  comparison.Frame("added");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Culled.GetRenderer()->GetCullers()->RemoveItem(comparison.GetCuller());
  Scenes::MoveWallCamera(comparison, 1.0);
  comparison.Culled.ResetDraws();
  comparison.Culled.Window->Render();
  for (int i = 0; i < Wall::Count; ++i)
  {
    // Stock VTK culls what is outside.
    EXPECT_TRUE(i > Wall::Behind || comparison.Culled.GetDraws(i) == 1) << i;
  }
  comparison.AddCuller();
  comparison.Frame("added again");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: without vtkFrustumCoverageCuller no other culler tests the frustum.
TEST(CullerBasics, WithoutTheDefaultCuller)
{
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, options);
  WalkPastTheWall(comparison, 6);
  EXPECT_GT(comparison.GetHidden(), 60);
  EXPECT_GT(comparison.GetStatistics().GetCount(Verdict::Outside), 0);
}

// Hazard: with TakeOverFrustumCulling off, the default culler stays in front, and has removed and
// sorted props before vtkNBufferCuller gets the list.
TEST(CullerBasics, BehindTheDefaultCuller)
{
  ComparisonOptions options;
  options.StockReference = true;
  options.Tuning.TakeOverFrustumCulling = false;
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, options);
  WalkPastTheWall(comparison, 6);
  EXPECT_GT(comparison.GetHidden(), 60);
}

// Hazard: a prop is added to the renderer or removed from it between two frames.
TEST(CullerBasics, PropsComeAndGo)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  comparison.Frame("one in front added",
    [](Stage& stage) { Scenes::AddBox(stage, 0.0, 0.0, 3.0, 1.0, 1.0, 1.0); });
  comparison.Frame(
    "one behind added", [](Stage& stage) { Scenes::AddBox(stage, 1.0, 1.0, -3.0, 1.0, 1.0, 1.0); });
  EXPECT_EQ(comparison.GetVerdict(Wall::Count + 1), Verdict::Hidden);
  comparison.Frame("one behind removed",
    [](Stage& stage) { stage.GetRenderer()->RemoveViewProp(stage.Props[Wall::FirstBehind]); });
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind), Verdict::Unknown);
  comparison.Frame("the wall removed",
    [](Stage& stage) { stage.GetRenderer()->RemoveViewProp(stage.Props[Wall::Index]); });
  EXPECT_LT(comparison.GetHidden(), Wall::Behind / 2);
  comparison.Frame("the wall back, now last in the list",
    [](Stage& stage) { stage.GetRenderer()->AddViewProp(stage.Props[Wall::Index]); });
  Scenes::FrameOfWall(comparison, 0.1, "the wall known to hide");
  Scenes::FrameOfWall(comparison, 0.2, "what it hides held back");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Frame("every other one invisible",
    [](Stage& stage)
    {
      for (int i = 1; i < Wall::Count; i += 2)
      {
        stage.Props[i]->SetVisibility(false);
      }
    });
  comparison.Frame("all removed", [](Stage& stage) { stage.GetRenderer()->RemoveAllViewProps(); });
  comparison.Frame("another scene", Scenes::BuildWall);
}

// Hazard: a new prop at the address of a deleted one gets the verdict of that one.
TEST(CullerBasics, ManyGenerationsOfProps)
{
  Comparison comparison(Scenes::BuildWall);
  for (int i = 0; i < 6; ++i)
  {
    comparison.Frame("generation " + std::to_string(i),
      [i](Stage& stage)
      {
        stage.GetRenderer()->RemoveAllViewProps();
        Stage fresh;
        fresh.Window = stage.Window;
        fresh.Renderers = stage.Renderers;
        fresh.Culler = stage.Culler;
        stage = fresh;
        Scenes::BuildWall(stage);
        Scenes::SetWallCamera(stage.GetRenderer(), 0.5 * i);
      });
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  }
}

// Hazard: an empty renderer, a single prop.
TEST(CullerBasics, NoPropsAndOneProp)
{
  Comparison comparison([](Stage& stage) { stage.GetRenderer()->SetBackground(0.3, 0.1, 0.1); });
  comparison.Frame("no props");
  EXPECT_EQ(comparison.GetHidden(), 0);
  comparison.Frame("one prop",
    [](Stage& stage)
    {
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0);
      stage.GetRenderer()->ResetCamera();
    });
  EXPECT_EQ(comparison.GetVerdict(0), Verdict::Untested);
}

// Hazard: with Enabled off something is still culled, or with Enabled on again the verdicts of long
// ago are used.
TEST(CullerBasics, EnabledOffDrawsAll)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame();
  comparison.GetCuller()->EnabledOff();
  comparison.Frame("off");
  EXPECT_EQ(comparison.GetDecision(), Decision::Disabled);
  EXPECT_EQ(comparison.GetHidden(), 0);
  Scenes::MoveWallCamera(comparison, 8.0);
  comparison.GetCuller()->EnabledOn();
  comparison.Frame("on again");
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
}

//------------------------------------------------------------------------------------------------
namespace
{
struct Setting : NamedCase
{
  void (*Set)(ComparisonOptions&);
  bool TestSlivers = true;
};

using CullerSettings = testing::TestWithParam<Setting>;

const Setting Settings[] = {
  { "BaseFactor1", [](ComparisonOptions& o) { o.Tuning.BaseFactor = 1; } },
  { "BaseFactor2", [](ComparisonOptions& o) { o.Tuning.BaseFactor = 2; } },
  { "BaseFactor8", [](ComparisonOptions& o) { o.Tuning.BaseFactor = 8; } },
  { "BackendCPU", [](ComparisonOptions& o) { o.Backend = vtkNBufferCuller::CPU; } },
  { "BackendOpenGL", [](ComparisonOptions& o) { o.Backend = vtkNBufferCuller::OpenGL; } },
  { "BackendOpenGLFactor1",
    [](ComparisonOptions& o)
    {
      o.Backend = vtkNBufferCuller::OpenGL;
      o.Tuning.BaseFactor = 1;
    } },
  { "OneRound", [](ComparisonOptions& o) { o.Tuning.MaximumNumberOfRounds = 1; } },
  { "EightRoundsOfFour",
    [](ComparisonOptions& o)
    {
      o.Tuning.MaximumNumberOfRounds = 8;
      o.Tuning.RoundSize = 4;
    } },
  { "NoPixels", [](ComparisonOptions& o) { o.Tuning.TestPixels = false; } },
  { "NoSlivers", [](ComparisonOptions&) {}, false },
  { "Slivers", [](ComparisonOptions&) {} },
  { "NoReuse", [](ComparisonOptions& o) { o.Tuning.ReuseWhenStill = false; } },
  { "BackOff", [](ComparisonOptions& o) { o.Tuning.BackOff = true; } },
};
}

// Hazard: a combination of settings is wrong that no other test uses on a walk.
TEST_P(CullerSettings, WalkThroughTheCity)
{
  ComparisonOptions options;
  this->GetParam().Set(options);
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, options);
  comparison.GetCuller()->SetTestSlivers(this->GetParam().TestSlivers);
  WalkPastTheWall(comparison, 8, 0.2, 0.03);
  EXPECT_GT(comparison.GetHidden(), 50);
  EXPECT_LE(
    comparison.GetStatistics().Rounds, comparison.GetCuller()->GetTuning().MaximumNumberOfRounds);
}

INSTANTIATE_TEST_SUITE_P(Each, CullerSettings, testing::ValuesIn(Settings), GetCaseName);

// The device reduces the depth, and level 0 alone is read back, once for each round. Where many
// boxes are in doubt, as they are with a coarse level 0, their pixels are read as well, each once.
TEST(CullerBasics, DevicesReadBackTheBaseLevel)
{
  for (const bool testPixels : { false, true })
  {
    SCOPED_TRACE(testPixels);
    ComparisonOptions options;
    options.Backend = vtkNBufferCuller::OpenGL;
    options.Tuning.TestPixels = testPixels;
    options.Tuning.BaseFactor = 8;
    Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage, 24); }, options);
    const int* size = comparison.Culled.Window->GetSize();
    const auto getBytes = [size](int factor)
    {
      return static_cast<long long>(sizeof(float)) * vtkNBufferMath::GetBaseSize(size[0], factor) *
        vtkNBufferMath::GetBaseSize(size[1], factor);
    };
    long long pixels = 0;
    for (int i = 0; i < 4; ++i)
    {
      WalkPastTheWall(comparison, 1, 0.1 * i);
      const vtkNBufferStatistics& statistics = comparison.GetStatistics();
      ASSERT_EQ(statistics.Decision, vtkNBufferDecision::Culled);
      const long long more = statistics.BytesRead - statistics.Rounds * getBytes(8);
      EXPECT_EQ(more != 0, statistics.ReadBacks > statistics.Rounds);
      EXPECT_GE(more, 0);
      EXPECT_LE(more, statistics.Rounds * getBytes(1));
      pixels += more;
    }
    EXPECT_EQ(pixels > 0, testPixels);
  }
}

// The host reads all pixels if props lie in all rows, once for each round.
TEST(CullerBasics, TheHostReadsAllPixels)
{
  ComparisonOptions options;
  options.Backend = vtkNBufferCuller::CPU;
  Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage); }, options);
  WalkPastTheWall(comparison, 1);
  const vtkNBufferStatistics& statistics = comparison.GetStatistics();
  ASSERT_EQ(statistics.Decision, vtkNBufferDecision::Culled);
  EXPECT_EQ(statistics.ReadBacks, statistics.Rounds);
  EXPECT_EQ(statistics.BytesRead,
    static_cast<long long>(sizeof(float)) * options.Width * options.Height * statistics.ReadBacks);
}

// Hazard: rows are read that hold nothing but background; rows are left out in which something has
// been drawn that is no candidate; or depth of an earlier frame is left in a row.
TEST(CullerBasics, TheHostReadsOnlyRowsInWhichPropsLie)
{
  const std::pair<const char*, Comparison::Change> cases[] = {
    { "candidates", nullptr },
    { "depth is preserved", [](Stage& stage) { stage.GetRenderer()->PreserveDepthBufferOn(); } },
    { "a prop of another kind",
      [](Stage& stage)
      {
        const int box = Scenes::AddBox(stage, 0.0, 0.0, 5.0, 0.2, 0.2, 0.2);
        vtkNew<vtkAssembly> assembly;
        assembly->AddPart(stage.GetActor(box));
        stage.GetRenderer()->RemoveViewProp(stage.GetActor(box));
        stage.Add(assembly);
      } },
  };
  for (const auto& [name, change] : cases)
  {
    SCOPED_TRACE(name);
    ComparisonOptions options;
    options.Backend = vtkNBufferCuller::CPU;
    Comparison comparison(Scenes::BuildWall, options);
    for (int i = 0; i < 12; ++i)
    {
      // The wall is a band that goes up and down.
      comparison.Both(
        [i](Stage& stage)
        {
          vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
          camera->SetViewAngle(100.0);
          camera->SetFocalPoint(0.0, i % 2 ? 8.0 : -8.0, 0.0);
        });
      comparison.Frame("band", i == 4 ? change : nullptr);
      const bool readsAll = change && i >= 4;
      const vtkNBufferStatistics& statistics = comparison.GetStatistics();
      ASSERT_EQ(statistics.Decision, vtkNBufferDecision::Culled);
      const auto row = static_cast<long long>(sizeof(float)) * options.Width;
      EXPECT_EQ(statistics.BytesRead % row, 0);
      EXPECT_EQ(statistics.BytesRead == row * options.Height * statistics.ReadBacks, readsAll);
      EXPECT_TRUE(comparison.GetHidden() > 0 || change);
      if (!readsAll && i > 2)
      {
        EXPECT_LT(statistics.BytesRead, row * options.Height * 3 / 4);
        EXPECT_GT(statistics.BytesRead, row * options.Height / 8);
      }
    }
  }
}

// Hazard: the two back-ends must agree on every verdict, or one of them is wrong.
TEST(CullerBasics, BackendsAgreeOnEveryVerdict)
{
  const auto make = [](int backend)
  {
    ComparisonOptions options;
    options.Backend = backend;
    options.Tuning.TestPixels = false; // of which the back-ends see more or less
    return options;
  };
  Comparison a([](Stage& stage) { Scenes::BuildCity(stage); }, make(vtkNBufferCuller::CPU));
  Comparison b([](Stage& stage) { Scenes::BuildCity(stage); }, make(vtkNBufferCuller::OpenGL));
  for (int i = 0; i < 4; ++i)
  {
    WalkPastTheWall(a, 1, 0.1 * i);
    WalkPastTheWall(b, 1, 0.1 * i);
    EXPECT_EQ(a.GetCuller()->GetBackendInUse(), vtkNBufferCuller::CPU);
    EXPECT_EQ(b.GetCuller()->GetBackendInUse(), vtkNBufferCuller::OpenGL);
    for (std::size_t prop = 0; prop < a.Culled.Props.size(); ++prop)
    {
      EXPECT_EQ(a.GetVerdict(static_cast<int>(prop)), b.GetVerdict(static_cast<int>(prop)))
        << "frame " << i << " prop " << prop;
    }
  }
}

namespace
{
/// Each valid value becomes the setting, in silence. Each other one changes nothing, whatever comes
/// with it, and an error says which member it is and which values it may have.
template <typename Object, typename Tuning>
void CheckRange(Object* object, bool Tuning::*validToo, int Tuning::*member, const char* name,
  const char* range, const std::vector<int>& valid, const std::vector<int>& refused)
{
  SCOPED_TRACE(name);
  TakeMessages();
  for (const int value : valid)
  {
    Tune(object, member, value);
    EXPECT_EQ(object->GetTuning().*member, value);
  }
  EXPECT_EQ(TakeMessages(), "");
  const Tuning before = object->GetTuning();
  const vtkMTimeType time = object->GetMTime();
  for (const int value : refused)
  {
    Tuning tuning = before;
    tuning.*validToo = !(tuning.*validToo);
    tuning.*member = value;
    object->SetTuning(tuning);
    EXPECT_TRUE(object->GetTuning() == before) << value;
    EXPECT_EQ(object->GetMTime(), time) << value;
    const std::string error = TakeMessages();
    for (const std::string& part :
      { name + std::string(" must be ") + range + ", not " + std::to_string(value),
        std::string("stays as it was") })
    {
      EXPECT_NE(error.find(part), std::string::npos) << error << " lacks " << part;
    }
  }
}
}

// Hazard: a refused value must leave the setting as it was, and say so.
TEST(CullerBasics, BaseFactorsOtherThanPowersUpToEightAreRefused)
{
  vtkNew<vtkNBufferCuller> culler;
  CheckRange(culler.Get(), &vtkNBufferTuning::TestPixels, &vtkNBufferTuning::BaseFactor,
    "BaseFactor", "1, 2, 4 or 8", { 1, 2, 4, 8 }, { 0, -4, 3, 5, 6, 7, 9, 16 });
}

// Hazard: other constants of the tuning accept values out of their range.
TEST(CullerBasics, TuningsOutOfRangeAreRefused)
{
  constexpr int most = VTK_INT_MAX;
  constexpr int least = VTK_INT_MIN;
  vtkNew<vtkNBufferCuller> culler;
  CheckRange(culler.Get(), &vtkNBufferTuning::TestPixels,
    &vtkNBufferTuning::MinimumNumberOfCandidates, "MinimumNumberOfCandidates", "1 to 2147483647",
    { 1, 32, most }, { 0, -1, least });
  CheckRange(culler.Get(), &vtkNBufferTuning::TestPixels, &vtkNBufferTuning::MaximumNumberOfRounds,
    "MaximumNumberOfRounds", "1 to 8", { 1, 8 }, { 0, -1, 9, most, least });
  CheckRange(culler.Get(), &vtkNBufferTuning::TestPixels, &vtkNBufferTuning::RoundSize, "RoundSize",
    "1 to 2147483647", { 1, 64, most }, { 0, -1, least });
  CheckRange(culler.Get(), &vtkNBufferTuning::TestPixels, &vtkNBufferTuning::HierarchySize,
    "HierarchySize", "0 to 2147483647", { 0, 10000, most }, { -1, least });

  vtkNew<vtkShadowVolumeClampPass> pass;
  CheckRange(pass.Get(), &vtkShadowTuning::CountFragments, &vtkShadowTuning::LitmapResolution,
    "LitmapResolution", "1 to 4096", { 1, 256, 4096 }, { 0, -1, 4097, most, least });
  CheckRange(pass.Get(), &vtkShadowTuning::CountFragments, &vtkShadowTuning::SlabGap, "SlabGap",
    "1 to 64", { 1, 4, 64 }, { 0, -1, 65, most, least });
  CheckRange(pass.Get(), &vtkShadowTuning::CountFragments, &vtkShadowTuning::BoxCost, "BoxCost",
    "0 to 1000000000", { 0, 256, 1000000000 }, { -1, 1000000001, most, least });
}

// Hazard: the reason that is given for a back-end is that of the back-end which was set before.
TEST(CullerBasics, BackendReasonIsThatOfTheSetting)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  vtkNBufferCuller* culler = comparison.Culled.GetCuller();
  const std::string set = "set by the application";
  for (int i = 0; i < 4; ++i)
  {
    const bool isSet = i % 2 == 1;
    culler->SetBackend(isSet ? vtkNBufferCuller::CPU : vtkNBufferCuller::Auto);
    Scenes::FrameOfWall(comparison, 0.2 * i);
    EXPECT_EQ(culler->GetBackendReason() == set, isSet) << culler->GetBackendReason();
  }
}

// Hazard: the culler crashes if its results are read before the first frame, or for a renderer that
// it never saw.
TEST(CullerBasics, QuestionsBeforeTheFirstFrame)
{
  TakeMessages();
  vtkNew<vtkNBufferCuller> culler;
  vtkNew<vtkActor> actor;
  vtkNew<vtkRenderer> renderer;
  EXPECT_EQ(culler->GetVerdict(actor), Verdict::Unknown);
  EXPECT_EQ(culler->GetVerdict(actor, renderer), Verdict::Unknown);
  EXPECT_EQ(culler->GetVerdict(nullptr), Verdict::Unknown);
  EXPECT_EQ(culler->GetStatistics().Decision, Decision::None);
  EXPECT_EQ(culler->GetStatistics(renderer).Decision, Decision::None);
  EXPECT_EQ(culler->GetBackendInUse(), vtkNBufferCuller::Auto);
  EXPECT_NE(culler->GetBackendReason(), nullptr);
  std::ostringstream text;
  culler->Print(text);
  for (const char* field : { "Enabled", "Backend", "BaseFactor", "MinimumNumberOfCandidates",
         "MaximumNumberOfRounds", "RoundSize", "ReuseWhenStill", "BackOff",
         "TakeOverFrustumCulling", "TestPixels", "TestSlivers", "Freeze" })
  {
    EXPECT_NE(text.str().find(field), std::string::npos) << field;
  }
  EXPECT_EQ(TakeMessages(), "");
}
