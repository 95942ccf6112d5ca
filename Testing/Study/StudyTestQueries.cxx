// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The algorithms of occlusion queries without OpenGL: a host that knows which props are visible.
#include "ClipBox.h"
#include "CoherentQueries.h"
#include "FlatQueries.h"
#include "PaperMeasures.h"
#include "Pixels.h"
#include "RandomBoxes.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace
{
using namespace NBufferPeers;

constexpr int QueriesWidth = 320;
constexpr int QueriesHeight = 200;

vtkNBufferBox MakeCubeAt(double x, double y, double size = 0.5)
{
  const double bounds[6] = { x, x + size, y, y + size, -size, size };
  return vtkNBufferBox::FromBounds(bounds);
}

/// Answers yes for every box that contains one of the visible props; answers come late.
class KnowingHost : public QueryHost
{
public:
  KnowingHost(std::vector<vtkNBufferBox> boxes, int delay)
    : Boxes(std::move(boxes))
    , Projection(StudyTest::LookAlongY(QueriesWidth, QueriesHeight))
    , Delay(delay)
  {
  }

  PlacedBox Place(const vtkNBufferBox& box) override
  {
    PlacedBox placed;
    placed.Box = box;
    placed.Placement = this->Projection.Project(box, placed.Screen);
    return placed;
  }

  int Query(const PlacedBox& box) override
  {
    bool visible = false;
    for (int i : this->Visible)
    {
      visible = visible || Contains(box.Box, this->Boxes[i]);
    }
    this->Answers.push_back({ visible, this->Delay });
    return static_cast<int>(this->Answers.size()) - 1;
  }

  bool HasAnswer(int query) override { return --this->Answers[query].second < 0; }

  bool IsVisible(int query) override { return this->Answers[query].first; }

  void Draw(int prop) override
  {
    EXPECT_TRUE(this->Drawn.insert(prop).second) << prop << " is drawn twice";
  }

  static bool Contains(const vtkNBufferBox& outer, const vtkNBufferBox& inner)
  {
    return glm::all(glm::lessThanEqual(
      glm::abs(inner.Center - outer.Center) + inner.HalfSize, outer.HalfSize + 1e-9));
  }

  std::vector<vtkNBufferBox> Boxes;
  vtkNBufferProjection Projection;
  int Delay;
  std::set<int> Visible;
  std::set<int> Drawn;
  std::vector<std::pair<bool, int>> Answers;
};

std::vector<vtkNBufferBox> MakeGrid(int count)
{
  std::vector<vtkNBufferBox> boxes;
  for (int i = 0; i < count; ++i)
  {
    boxes.push_back(MakeCubeAt(-6.0 + i % 13, 30.0 + 3.0 * (i / 13)));
  }
  return boxes;
}

TEST(StudyQueries, FlatAsksEveryPropOnceNearestFirst)
{
  KnowingHost host(MakeGrid(60), 0);
  host.Visible = { 3, 40 };
  std::vector<FlatItem> items;
  for (int i = 0; i < 60; ++i)
  {
    items.push_back({ host.Place(host.Boxes[i]), i });
  }
  std::reverse(items.begin(), items.end());
  DrawByFlatQueries(host, items);
  EXPECT_EQ(host.Drawn, host.Visible);
  EXPECT_EQ(host.Answers.size(), 60u);
  for (std::size_t i = 1; i < items.size(); ++i)
  {
    EXPECT_LE(items[i - 1].Box.GetNearest(), items[i].Box.GetNearest());
  }
}

TEST(StudyQueries, WhatReachesTheEyeIsDrawnUnasked)
{
  KnowingHost host({ MakeCubeAt(-1.0, -1.0, 20.0) }, 0);
  std::vector<FlatItem> items = { { host.Place(host.Boxes[0]), 0 } };
  DrawByFlatQueries(host, items);
  EXPECT_EQ(host.Drawn.size(), 1u);
  EXPECT_TRUE(host.Answers.empty());
}

/// Whatever was visible before and however late answers come.
TEST(StudyQueries, CoherentDrawsAllThatIsVisibleAndNoMoreThanWasOrIs)
{
  std::mt19937 random(5);
  for (int delay : { 0, 1, 7, 1000 })
  {
    KnowingHost host(MakeGrid(100), delay);
    std::vector<int> props(100);
    std::iota(props.begin(), props.end(), 0);
    CoherentQueries queries;
    queries.Build(host.Boxes, props);
    EXPECT_EQ(queries.GetNumberOfNodes(), 199u);
    std::set<int> before;
    for (int frame = 0; frame < 12; ++frame)
    {
      host.Visible.clear();
      for (int i = 0; i < 100; ++i)
      {
        if (random() % 4 == 0 || (before.count(i) > 0 && random() % 4 != 0))
        {
          host.Visible.insert(i);
        }
      }
      host.Drawn.clear();
      host.Answers.clear();
      queries.Draw(host);
      EXPECT_TRUE(std::includes(
        host.Drawn.begin(), host.Drawn.end(), host.Visible.begin(), host.Visible.end()));
      for (int i : host.Drawn)
      {
        EXPECT_TRUE(host.Visible.count(i) > 0 || before.count(i) > 0) << i;
      }
      EXPECT_LE(host.Answers.size(), queries.GetNumberOfNodes());
      EXPECT_LE(queries.GetNumberOfVisits(), static_cast<int>(queries.GetNumberOfNodes()));
      before = host.Visible;
    }
  }
}

TEST(StudyQueries, CoherentOpensWhatWasVisibleUnasked)
{
  KnowingHost host(MakeGrid(64), 0);
  std::vector<int> props(64);
  std::iota(props.begin(), props.end(), 0);
  host.Visible.insert(props.begin(), props.end());
  CoherentQueries queries;
  queries.Build(host.Boxes, props);
  const auto countAnswers = [&]()
  {
    host.Answers.clear();
    host.Drawn.clear();
    queries.Draw(host);
    return host.Answers.size();
  };
  EXPECT_EQ(countAnswers(), 127u);
  EXPECT_EQ(countAnswers(), 64u) << "leaves alone";
  host.Visible.clear();
  countAnswers();
  EXPECT_EQ(countAnswers(), 1u) << "the root alone";
  EXPECT_TRUE(host.Drawn.empty());
}

TEST(StudyQueries, CoherentWithoutProps)
{
  KnowingHost host({}, 0);
  CoherentQueries queries;
  queries.Build({}, {});
  queries.Draw(host);
  EXPECT_TRUE(host.Drawn.empty());
}

/// Every corner of the box, moved by the slack in any direction, is within the padded box's outline
/// and behind its nearest corner.
TEST(StudyQueries, PaddedBoxesReachBeyondWhatIsDrawn)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  const vtkNBufferProjection projection = StudyTest::LookAlongY(QueriesWidth, QueriesHeight);
  int asked = 0;
  for (int n = 0; n < 2000; ++n)
  {
    const double low[3] = { place(random), place(random) + 60.0, place(random) };
    std::array<double, 6> bounds;
    for (int j = 0; j < 3; ++j)
    {
      bounds[2 * j] = low[j];
      bounds[2 * j + 1] = low[j] + (random() % 3 == 0 ? 0.0 : std::abs(place(random)) * 0.2);
    }
    const ProjectedBox box(projection, bounds);
    ClipBox clip;
    if (!box.IsInside() || !MakeClipBox(projection, box.Box, box.Screen, clip))
    {
      continue;
    }
    ++asked;
    glm::dvec3 lowest(1e9);
    glm::dvec3 highest(-1e9);
    for (const auto& corner : clip.Corners)
    {
      ASSERT_GT(corner[3], 0.0f);
      ASSERT_GT(corner[2], -corner[3]);
      const glm::dvec3 ndc = glm::dvec3(corner[0], corner[1], corner[2]) / double(corner[3]);
      lowest = glm::min(lowest, ndc);
      highest = glm::max(highest, ndc);
    }
    const glm::dvec2 size(QueriesWidth, QueriesHeight);
    const glm::dvec2 least = glm::dvec2(box.Screen.Slack) + 0.25 / size;
    for (const glm::dvec2& corner : projection.GetCorners(box.Box))
    {
      const glm::dvec2 ndc = 2.0 * corner / size - 1.0;
      EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::dvec2(lowest), ndc - least)));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(glm::dvec2(highest), ndc + least)));
    }
    EXPECT_LE(0.5 + 0.5 * lowest[2], box.Screen.Nearest);
  }
  EXPECT_GT(asked, 500);
}

TEST(StudyQueries, WhatTouchesTheNearPlaneIsNotQueried)
{
  const vtkNBufferProjection projection = StudyTest::LookAlongY(QueriesWidth, QueriesHeight);
  int inside = 0;
  for (double y = 0.0; y < 4.0; y += 0.001)
  {
    const vtkNBufferBox box = MakeCubeAt(-0.05, y, 0.1);
    vtkNBufferScreenBox screen;
    ClipBox clip;
    if (projection.Project(box, screen) == vtkNBufferPlacement::Inside &&
      MakeClipBox(projection, box, screen, clip))
    {
      ++inside;
      for (const auto& corner : clip.Corners)
      {
        EXPECT_GT(corner[2], -corner[3]) << y;
      }
    }
  }
  EXPECT_GT(inside, 100);
}

// Outlines of boxes, by brute force.
TEST(StudyOutline, IsThatOfTheDoubleLoopOverPixelCentres)
{
  const vtkNBufferProjection projection = StudyTest::LookAlongY(300, 200);
  int boxesSeen = 0;
  for (const vtkNBufferBox& box : MakeRandomBoxes(400, 5))
  {
    vtkNBufferScreenBox screen;
    if (projection.Project(box, screen) != vtkNBufferPlacement::Inside || screen.Clipped)
    {
      continue;
    }
    ++boxesSeen;
    const std::array<glm::dvec2, 8> corners = projection.GetCorners(box);
    long long count = 0;
    for (const auto& [x, y] : Pixels(screen.Pixels))
    {
      count += StudyTest::IsInHull(corners, x + 0.5, y + 0.5);
    }
    EXPECT_EQ(NBufferStudy::CountOutlinePixels(projection, box, screen), count);
  }
  EXPECT_GT(boxesSeen, 100);
}
}
