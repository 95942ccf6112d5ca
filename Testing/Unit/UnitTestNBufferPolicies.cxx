// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The order of equal depths against a simulated depth buffer, when the culler backs off, and which
// frames it tests.
#include "Pixels.h"
#include "ProjectedBox.h"
#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPartition.h"
#include "vtkNBufferTieOrder.h"
#include "vtkNBufferUnitTrial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace
{
constexpr int WindowSide = 12; // of the simulated window

/// What was drawn of a prop with these bounds, in the first round.
vtkNBufferDrawnProp MakeDrawn(const vtkNBufferProjection& projection,
  const std::array<double, 6>& bounds, int index = 0, int round = 0)
{
  const ProjectedBox box(projection, bounds);
  EXPECT_TRUE(box.IsInside());
  vtkNBufferDrawnProp drawn;
  drawn.Index = index;
  drawn.Round = round;
  drawn.Bounded = true;
  drawn.KeepsScissor = true;
  drawn.Box = box.Box;
  drawn.Screen = box.Screen;
  return drawn;
}

struct Prop
{
  vtkNBufferRectangle Rectangle; // in pixels
  double Depth;
  vtkNBufferDrawnProp Drawn;
};

struct Pixel
{
  double Depth = 1.0;
  int Owner = -1; // the Index of a prop

  bool operator==(const Pixel& other) const
  {
    return this->Depth == other.Depth && this->Owner == other.Owner;
  }
};

void Draw(const Prop& prop, std::vector<Pixel>& window,
  const vtkNBufferRectangle& region = { 0, 0, WindowSide, WindowSide })
{
  for (const auto& [x, y] : Pixels(region.GetIntersection(prop.Rectangle)))
  {
    Pixel& pixel = window[y * WindowSide + x];
    if (prop.Depth <= pixel.Depth)
    {
      pixel.Depth = prop.Depth;
      pixel.Owner = prop.Drawn.Index;
    }
  }
}

/// All levels of the depth in a window.
vtkNBufferLevels MakeLevels(const std::vector<Pixel>& window)
{
  std::vector<float> depth(window.size());
  std::transform(window.begin(), window.end(), depth.begin(),
    [](const Pixel& pixel) { return static_cast<float>(pixel.Depth); });
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), WindowSide, WindowSide, 1, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(vtkNBufferMath::GetNumberOfLevels(WindowSide, WindowSide));
  return levels;
}
}

// Hazard: with equal depths the picture depends on the order of drawing. Props that are drawn in
// any rounds, and then once more where the rule says, must give the picture of the renderer's
// order.
TEST(NBufferTieOrder, RedrawsRestoreTheOrder)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  std::mt19937 random(41);
  int redrawn = 0;
  int regions = 0;
  int hidden = 0;
  for (int n = 0; n < 6000; ++n)
  {
    const int count = 2 + static_cast<int>(random() % 12);
    const int rounds = 1 + static_cast<int>(random() % 4);
    std::vector<Prop> props(count);
    std::ostringstream text;
    for (int i = 0; i < count; ++i)
    {
      Prop& prop = props[i];
      int ends[2][2];
      for (auto& [begin, end] : ends)
      {
        begin = static_cast<int>(random() % (WindowSide - 1));
        end = std::min<int>(begin + 1 + static_cast<int>(random() % 6), WindowSide);
      }
      const vtkNBufferRectangle& r =
        prop.Rectangle = { ends[0][0], ends[1][0], ends[0][1], ends[1][1] };
      prop.Depth = 0.25 * static_cast<double>(1 + random() % 3);
      prop.Drawn = MakeDrawn(projection,
        { r.X0 + 0.3, r.X1 - 0.3, r.Y0 + 0.3, r.Y1 - 0.3, prop.Depth, prop.Depth }, i,
        static_cast<int>(random() % rounds));
      prop.Drawn.Bounded = random() % 8 != 0;
      prop.Drawn.KeepsScissor = random() % 8 != 0;
      text << r << " at " << prop.Depth << ", round " << prop.Drawn.Round << "; ";
    }
    SCOPED_TRACE(text.str());
    std::vector<Pixel> expected(WindowSide * WindowSide);
    std::vector<Pixel> window(WindowSide * WindowSide);
    for (const Prop& prop : props)
    {
      Draw(prop, expected);
    }
    std::vector<vtkNBufferDrawnProp> drawn;
    // Of a part of the draws the depth is known.
    const int knownRounds = static_cast<int>(random() % (rounds + 1));
    vtkNBufferLevels levels;
    for (int round = 0; round < rounds; ++round)
    {
      if (round == knownRounds)
      {
        levels = MakeLevels(window);
      }
      for (const Prop& prop : props)
      {
        if (prop.Drawn.Round == round)
        {
          Draw(prop, window);
          drawn.push_back(prop.Drawn);
        }
      }
    }
    const bool inRegions = n % 3 != 0;
    vtkNBufferOcclusionTest test(levels);
    const auto isHidden = [&test](const vtkNBufferContact& tie)
    { return test.IsHidden(tie.Screen); };
    const std::vector<vtkNBufferRedraw> redraws =
      vtkNBufferTieOrder::GetRedraws(projection, drawn, inRegions, isHidden);
    hidden += redraws.size() < vtkNBufferTieOrder::GetRedraws(projection, drawn, inRegions).size();
    for (const vtkNBufferRedraw& redraw : redraws)
    {
      const Prop& prop = props[drawn[redraw.Position].Index];
      ASSERT_LE(redraw.Regions.size(), 4u);
      ASSERT_TRUE(redraw.Regions.empty() || (inRegions && prop.Drawn.KeepsScissor));
      for (const vtkNBufferRectangle& region : redraw.Regions)
      {
        Draw(prop, window, region);
        ++regions;
      }
      if (redraw.Regions.empty())
      {
        Draw(prop, window);
      }
    }
    redrawn += static_cast<int>(redraws.size());
    ASSERT_TRUE(window == expected);
    ASSERT_TRUE(redraws.empty() || rounds > 1) << "one round is the renderer's order";
  }
  EXPECT_GT(redrawn, 2000);
  EXPECT_GT(regions, 1000);
  EXPECT_GT(hidden, 100);
}

// Hazard: props that touch behind a wall are drawn twice for nothing; or those that touch just
// before it are not.
TEST(NBufferTieOrder, TiesBehindWhatIsDrawnDoNotCount)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  const auto getRedraws = [&projection](double wall)
  {
    const vtkNBufferLevels levels =
      MakeLevels(std::vector<Pixel>(WindowSide * WindowSide, Pixel{ wall }));
    vtkNBufferOcclusionTest test(levels);
    // Both reach before the wall, but the face between them is at 0.5.
    std::vector<vtkNBufferDrawnProp> drawn = {
      MakeDrawn(projection, { 1.0, 5.0, 1.0, 5.0, 0.2, 0.5 }, 0, 1),
      MakeDrawn(projection, { 1.0, 5.0, 1.0, 5.0, 0.5, 0.8 }, 1, 0),
    };
    return vtkNBufferTieOrder::GetRedraws(projection, drawn, true,
      [&test](const vtkNBufferContact& tie) { return test.IsHidden(tie.Screen); })
      .size();
  };
  // The slack for sides seen edge-on is a twentieth of the depth of the first box.
  EXPECT_EQ(getRedraws(0.45), 0u);
  EXPECT_EQ(getRedraws(0.5), 1u);
  EXPECT_EQ(getRedraws(0.55), 1u);
}

// Hazard: because of its first prop, a whole chain of props that touch each other is drawn again.
TEST(NBufferTieOrder, ChainsEndWhereRegionsDoNotMeet)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  std::vector<vtkNBufferDrawnProp> drawn;
  for (int i = 0; i < 5; ++i)
  {
    // Two pixels wide each, side by side: faces touch between pixels 2 i + 1 and 2 i + 2.
    drawn.push_back(MakeDrawn(
      projection, { 2.0 * i + 1.0, 2.0 * i + 3.0, 1.0, 5.0, 0.25, 0.75 }, i, i == 0 ? 1 : 0));
  }
  EXPECT_EQ(vtkNBufferTieOrder::GetRedraws(projection, drawn, false).size(), 4u);

  const std::vector<vtkNBufferRedraw> redraws =
    vtkNBufferTieOrder::GetRedraws(projection, drawn, true);
  ASSERT_EQ(redraws.size(), 1u);
  EXPECT_EQ(redraws[0].Position, 1);
  ASSERT_EQ(redraws[0].Regions.size(), 1u);
  // The face at x = 3 and 1/16 of a pixel on both sides.
  EXPECT_EQ(redraws[0].Regions[0].X0, 2);
  EXPECT_EQ(redraws[0].Regions[0].X1, 4);
}

// Hazard: a large prop that touches many small ones is drawn again in its whole rectangle, or in
// too many regions.
TEST(NBufferTieOrder, RegionsAreNoMoreThanFour)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  std::vector<vtkNBufferDrawnProp> drawn;
  for (int i = 0; i < 6; ++i)
  {
    // Six columns of half a pixel on a floor, as seen from above.
    const double x = 0.3 + 2.0 * i;
    drawn.push_back(MakeDrawn(projection, { x, x + 0.4, 4.3, 4.7, 0.25, 0.5 }, i, 1));
  }
  drawn.push_back(MakeDrawn(projection, { 0.3, 11.7, 0.3, 11.7, 0.5, 0.6 }, 6));
  const std::vector<vtkNBufferRedraw> redraws =
    vtkNBufferTieOrder::GetRedraws(projection, drawn, true);
  ASSERT_EQ(redraws.size(), 1u);
  EXPECT_EQ(redraws[0].Position, 6);
  ASSERT_EQ(redraws[0].Regions.size(), 4u);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_TRUE(std::any_of(redraws[0].Regions.begin(), redraws[0].Regions.end(),
      [i](const vtkNBufferRectangle& region) { return IsIn(2 * i, 4, region); }));
  }
}

// Hazard: props that cannot touch are drawn twice for nothing.
TEST(NBufferTieOrder, OnlyPropsThatTouchTie)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  const auto make = [&projection](double x, double y, double z) {
    return MakeDrawn(projection, { x, x + 2.0, y, y + 2.0, z, z + 0.05 });
  };
  const vtkNBufferDrawnProp a = make(1.0, 1.0, 0.5);
  vtkNBufferRectangle pixels;
  const auto tie = [&](const vtkNBufferDrawnProp& first, const vtkNBufferDrawnProp& second)
  {
    pixels = vtkNBufferTieOrder::GetTie(projection, first, second).Screen.Pixels;
    return !pixels.IsEmpty();
  };
  EXPECT_TRUE(tie(a, a));
  EXPECT_TRUE(tie(a, make(2.0, 2.0, 0.52)));
  EXPECT_TRUE(tie(a, make(1.0, 1.0, 0.55))) << "face to face";
  EXPECT_FALSE(tie(a, make(5.0, 1.0, 0.5))) << "beside";
  EXPECT_FALSE(tie(a, make(1.0, 1.0, 0.7))) << "behind";
  EXPECT_TRUE(tie(a, make(2.5, 1.5, 0.5)));
  EXPECT_EQ(pixels, (vtkNBufferRectangle{ 2, 1, 4, 4 }));
  vtkNBufferDrawnProp unbounded = make(8.0, 8.0, 0.1);
  unbounded.Bounded = false;
  EXPECT_TRUE(tie(a, unbounded));
  EXPECT_TRUE(tie(unbounded, a));
  EXPECT_EQ(pixels.X0, a.Screen.Pixels.X0) << "within the pixels of the one that is known";
  EXPECT_EQ(pixels.Y1, a.Screen.Pixels.Y1);
  EXPECT_TRUE(tie(unbounded, unbounded));
  EXPECT_EQ(pixels.GetWidth(), WindowSide);
}

// Hazard: of a prop that is drawn in parts, the part that was drawn first is covered by a part that
// comes before it in the mesh; or the whole prop is drawn again everywhere.
TEST(NBufferTieOrder, PartsOfOnePropAreRestored)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  std::vector<vtkNBufferDrawnProp> drawn = {
    MakeDrawn(projection, { 1.0, 7.0, 1.0, 7.0, 0.5, 0.5 }, 3, 0),
    MakeDrawn(projection, { 2.0, 4.0, 2.0, 4.0, 0.5, 0.5 }, 3, 2),
    MakeDrawn(projection, { 6.5, 7.0, 6.5, 7.0, 0.5, 0.5 }, 4, 0),
  };
  const std::vector<vtkNBufferRedraw> redraws =
    vtkNBufferTieOrder::GetRedraws(projection, drawn, true);
  ASSERT_EQ(redraws.size(), 1u) << "the next prop does not touch the late part";
  EXPECT_EQ(drawn[redraws[0].Position].Index, 3);
  ASSERT_EQ(redraws[0].Regions.size(), 1u);
  EXPECT_EQ(redraws[0].Regions[0], (vtkNBufferRectangle{ 1, 1, 5, 5 }));
}

// Hazard: a part that does not touch what was drawn late is drawn once more with the rest of its
// prop, and covers the next prop.
TEST(NBufferTieOrder, PropsAreDrawnAgainWithAllParts)
{
  const vtkNBufferProjection projection = MapWorldToPixels(WindowSide, WindowSide);
  std::vector<vtkNBufferDrawnProp> drawn = {
    MakeDrawn(projection, { 1.0, 4.0, 1.0, 4.0, 0.3, 0.3 }, 1, 2),
    MakeDrawn(projection, { 2.0, 3.0, 2.0, 3.0, 0.3, 0.3 }, 3, 1),
    MakeDrawn(projection, { 2.0, 3.0, 2.0, 3.0, 0.7, 0.7 }, 3, 1),
    MakeDrawn(projection, { 2.0, 3.0, 2.0, 3.0, 0.7, 0.7 }, 4, 1),
  };
  const std::vector<vtkNBufferRedraw> redraws =
    vtkNBufferTieOrder::GetRedraws(projection, drawn, true);
  ASSERT_EQ(redraws.size(), 2u);
  EXPECT_EQ(drawn[redraws[0].Position].Index, 3);
  EXPECT_EQ(drawn[redraws[1].Position].Index, 4);
}

// Hazard: a pause of the tests never begins, so that tests are wasted; or it never ends, so that
// nothing is hidden any more.
TEST(NBufferBackOff, RestsAndProbes)
{
  vtkNBufferBackOff backOff;
  EXPECT_FALSE(backOff.CountPausedFrame());
  for (int i = 0; i < vtkNBufferBackOff::PoorTestsBeforePause; ++i)
  {
    EXPECT_FALSE(backOff.CountPausedFrame()) << i;
    backOff.Learn(1, 100);
  }
  int expected = vtkNBufferBackOff::ShortestPause;
  for (int probe = 0; probe < 6; ++probe)
  {
    int rest = 0;
    while (backOff.CountPausedFrame())
    {
      ASSERT_LE(++rest, vtkNBufferBackOff::LongestPause);
    }
    EXPECT_EQ(rest, expected) << probe;
    expected = std::min(2 * expected, vtkNBufferBackOff::LongestPause);
    backOff.Learn(0, 100);
  }
  while (backOff.CountPausedFrame())
  {
  }
  backOff.Learn(50, 100);
  EXPECT_FALSE(backOff.CountPausedFrame()) << "a probe that hides much ends it";
  backOff.Learn(0, 100);
  EXPECT_FALSE(backOff.CountPausedFrame()) << "and all begins anew";
}

namespace
{
/// Counts frames whose times in milliseconds are those of the two ways until a contest ends.
/// Returns how many frames were drawn in the second way.
int RunContest(vtkNBufferContest& contest, double first, double second)
{
  int ofSecond = 0;
  for (int i = 0; i < vtkNBufferContest::SettlingFrames + 2 * vtkNBufferContest::FramesOfEach; ++i)
  {
    EXPECT_EQ(contest.IsTimed(), i >= 3 * vtkNBufferContest::SettlingFrames);
    EXPECT_TRUE(contest.UsesFirst() || i >= vtkNBufferContest::SettlingFrames);
    ofSecond += !contest.UsesFirst();
    contest.CountFrame(contest.UsesFirst() ? first : second);
  }
  return ofSecond;
}

/// Counts the frames of a term, all of which are drawn in one way.
int RunTerm(vtkNBufferContest& contest, bool usesFirst)
{
  int frames = 0;
  for (; contest.UsesFirst() == usesFirst && frames < 2 * vtkNBufferContest::LongestTerm; ++frames)
  {
    EXPECT_FALSE(contest.IsTimed());
    contest.CountFrame(0.0);
  }
  return frames;
}
}

// Hazard: the slower way wins, the first contest decides for ever, or contests cost more than the
// faster way gains.
TEST(NBufferContest, TheFasterWayWinsForATerm)
{
  vtkNBufferContest contest;
  for (const auto& [slower, term] :
    { std::pair(102.0, 64), { 108.0, 144 }, { 200.0, 1800 }, { 900.0, 4096 } })
  {
    EXPECT_EQ(RunContest(contest, slower, 100.0), vtkNBufferContest::FramesOfEach);
    EXPECT_EQ(RunTerm(contest, false), term);
  }
  EXPECT_EQ(RunContest(contest, 100.0, 150.0), vtkNBufferContest::FramesOfEach);
  for (int i = 0; i < 900; ++i)
  {
    EXPECT_TRUE(contest.UsesFirst());
    EXPECT_FALSE(contest.IsTimed());
    contest.CountFrame(0.0);
  }
  for (const auto& [first, wins] : { std::pair(97.0, true), { 99.0, false }, { 100.0, false } })
  {
    vtkNBufferContest close;
    EXPECT_EQ(RunContest(close, first, 100.0), vtkNBufferContest::FramesOfEach);
    EXPECT_EQ(close.UsesFirst(), wins) << first;
  }
}

// Hazard: one frame that something else has made slow decides.
TEST(NBufferContest, OneSlowFrameDoesNotCount)
{
  vtkNBufferContest contest;
  for (int i = 0; i < 3 * vtkNBufferContest::SettlingFrames; ++i)
  {
    contest.CountFrame(1000.0);
  }
  for (const double first : { 2.0, 90.0, 3.0 })
  {
    contest.CountFrame(first);
    contest.CountFrame(4.0);
  }
  EXPECT_FALSE(contest.IsTimed());
  EXPECT_TRUE(contest.UsesFirst());
}

// Hazard: with an empty frustum there is a division by 0.
TEST(NBufferBackOff, EmptyFrustum)
{
  vtkNBufferBackOff backOff;
  for (int i = 0; i < 10; ++i)
  {
    backOff.Learn(0, 0);
  }
  EXPECT_FALSE(backOff.CountPausedFrame());
}

namespace
{
using Decision = vtkNBufferDecision;

constexpr int Minimum = 32;

/// A frame that is worth a test: some props are kept, some are held back.
vtkNBufferFrustumCounts MakeCounts()
{
  vtkNBufferFrustumCounts counts;
  counts.Candidates = 200;
  counts.Inside = 100;
  counts.Kept = 60;
  counts.HeldBack = 30;
  return counts;
}

Decision Decide(const vtkNBufferFrustumCounts& counts, vtkNBufferBackOff* backOff = nullptr)
{
  return vtkNBufferCullingPolicy::ChooseDecision(counts, Minimum, backOff);
}
}

// Hazard: a frame is not tested, and the reason that is given is not the first one that applies.
TEST(NBufferCullingPolicy, NamesTheReasonNotToTest)
{
  EXPECT_EQ(Decide(MakeCounts()), Decision::Culled);

  vtkNBufferFrustumCounts counts = MakeCounts();
  counts.Inside = Minimum;
  EXPECT_EQ(Decide(counts), Decision::Culled);
  counts.Inside = Minimum - 1;
  EXPECT_EQ(Decide(counts), Decision::FewCandidates);
  counts.Blended = 1;
  EXPECT_EQ(Decide(counts), Decision::Blending) << "the others come after a prop that blends";
  counts.Inside = Minimum;
  EXPECT_EQ(Decide(counts), Decision::Culled) << "enough of them come before it";
  counts.Blending = true;
  EXPECT_EQ(Decide(counts), Decision::Blending);

  counts = MakeCounts();
  counts.Kept = counts.HeldBack = 0;
  EXPECT_EQ(Decide(counts), Decision::NothingHeld) << "all of them cross the near plane";
}

// Hazard: where nothing is held back there are no proxy and no test, so that nothing would ever be
// found hidden again.
TEST(NBufferCullingPolicy, TestsEveryFewFramesWhereNothingIsHeldBack)
{
  vtkNBufferFrustumCounts counts = MakeCounts();
  counts.HeldBack = 0;
  EXPECT_EQ(Decide(counts), Decision::Culled) << "every frame without back-off";

  vtkNBufferBackOff backOff;
  int tested = 0;
  for (int frame = 0; frame < 8 * 10; ++frame)
  {
    const Decision decision = Decide(counts, &backOff);
    EXPECT_TRUE(decision == Decision::Culled || decision == Decision::NothingHeld);
    tested += decision == Decision::Culled;
  }
  EXPECT_EQ(tested, 10);

  counts.Translucent = Minimum;
  for (int frame = 0; frame < 16; ++frame)
  {
    EXPECT_EQ(Decide(counts, &backOff), Decision::Culled) << "many translucent props";
  }
}

// Hazard: frames that are not tested for other reasons are counted as part of the pause after
// useless tests.
TEST(NBufferCullingPolicy, RestsAreCountedInFramesThatCouldBeTested)
{
  vtkNBufferBackOff backOff;
  for (int i = 0; i < vtkNBufferBackOff::PoorTestsBeforePause; ++i)
  {
    EXPECT_EQ(Decide(MakeCounts(), &backOff), Decision::Culled);
    backOff.Learn(0, 100);
  }
  vtkNBufferFrustumCounts few = MakeCounts();
  few.Inside = 1;
  int rest = 0;
  while (Decide(MakeCounts(), &backOff) == Decision::BackedOff)
  {
    EXPECT_EQ(Decide(few, &backOff), Decision::FewCandidates);
    ASSERT_LE(++rest, vtkNBufferBackOff::LongestPause);
  }
  EXPECT_EQ(rest, vtkNBufferBackOff::ShortestPause);
}

// Hazard: half a million props are tested in six rounds, each of which draws almost nothing.
TEST(NBufferPartition, AGreatManyPropsHaveLargerRounds)
{
  EXPECT_EQ(vtkNBufferPartition::GetLimit(64, 100), 64u);
  EXPECT_EQ(vtkNBufferPartition::GetLimit(64, 64 * 512 + 511), 64u);
  EXPECT_EQ(vtkNBufferPartition::GetLimit(64, 512 * 1000), 1000u);
}
