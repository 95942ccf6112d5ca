// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What is true of a node must be true of everything below it.
#include "RandomBoxes.h"
#include "SampledViews.h"
#include "vtkNBufferHierarchy.h"
#include "vtkNBufferProjection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{
using Node = vtkNBufferHierarchy::Node;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Whether what may be drawn of the inner box may be drawn of the outer one, margin and rounding
/// included.
bool Contains(const vtkNBufferBox& outer, const vtkNBufferBox& inner)
{
  return outer.Margin >= inner.Margin && outer.Origin == glm::dvec3(0.0) &&
    glm::all(glm::lessThanEqual(outer.Center - outer.HalfSize, inner.Center - inner.HalfSize)) &&
    glm::all(glm::lessThanEqual(inner.Center + inner.HalfSize, outer.Center + outer.HalfSize)) &&
    glm::all(glm::lessThanEqual(glm::abs(inner.Origin) + inner.Magnitude, outer.Magnitude));
}

/// Nothing is ever known of it, in any view.
void CheckUnknown(const vtkNBufferBox& box)
{
  ViewSampler sampler(11);
  for (int i = 0; i < 20; ++i)
  {
    const View view = sampler.MakeView(0.0);
    const vtkNBufferProjection projection = MakeProjection(view);
    vtkNBufferScreenBox screen;
    EXPECT_FALSE(projection.IsOutside(box));
    EXPECT_EQ(projection.Project(box, screen), vtkNBufferPlacement::Crossing);
  }
}

/// Every place once, in nodes that contain it, and children beneath their parents.
void CheckNodes(
  const vtkNBufferHierarchy& tree, const std::vector<vtkNBufferBox>& boxes, std::vector<int> places)
{
  std::vector<int> order = tree.GetOrder();
  for (const Node& node : tree.GetNodes())
  {
    for (int slot = node.Begin; slot < node.End; ++slot)
    {
      EXPECT_TRUE(Contains(node.Box, boxes[order[slot]]));
    }
    int below = 0;
    tree.Visit(tree.GetIndex(node),
      [&below](const Node& other)
      {
        below += other.Left < 0 ? other.End - other.Begin : 0;
        return true;
      });
    EXPECT_EQ(below, node.End - node.Begin);
    if (node.Left >= 0)
    {
      EXPECT_EQ(tree.GetNodes()[node.Left].Begin, node.Begin);
      EXPECT_EQ(tree.GetNodes()[node.Left].End, tree.GetNodes()[node.Right].Begin);
      EXPECT_EQ(tree.GetNodes()[node.Right].End, node.End);
      EXPECT_EQ(tree.GetNodes()[node.Left].Next, node.Right);
      EXPECT_EQ(tree.GetNodes()[node.Right].Next, node.Next);
    }
  }
  std::vector<int> asked;
  tree.Visit(0,
    [&](const Node& node)
    {
      EXPECT_EQ(&node, &tree.GetNodes()[tree.GetIndex(node)]);
      if (node.Left < 0)
      {
        asked.insert(
          asked.end(), tree.GetOrder().begin() + node.Begin, tree.GetOrder().begin() + node.End);
      }
      return true;
    });
  EXPECT_EQ(asked, order);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, places);
  for (std::size_t i = 0; i < boxes.size() + 2; ++i)
  {
    EXPECT_EQ(tree.Has(static_cast<int>(i)),
      std::binary_search(places.begin(), places.end(), static_cast<int>(i)));
  }
}

std::vector<int> GetAll(const std::vector<vtkNBufferBox>& boxes)
{
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Replace all boxes. Returns how many nodes were fitted.
int MoveAll(vtkNBufferHierarchy& tree, const std::vector<vtkNBufferBox>& boxes)
{
  for (int i : GetAll(boxes))
  {
    tree.Move(i, boxes[static_cast<std::size_t>(i)]);
  }
  return tree.Refit();
}

void ExpectSameBoxes(const vtkNBufferHierarchy& a, const vtkNBufferHierarchy& b)
{
  ASSERT_EQ(a.GetNodes().size(), b.GetNodes().size());
  for (std::size_t i = 0; i < a.GetNodes().size(); ++i)
  {
    EXPECT_TRUE(a.GetNodes()[i].Box == b.GetNodes()[i].Box) << "node " << i;
  }
}
}

TEST(NBufferHierarchy, NodesContainWhatIsBelowThem)
{
  for (int count : { 0, 1, 2, 5, 8, 9, 1000 })
  {
    for (int leafSize : { 0, 1, 4, vtkNBufferHierarchy::DefaultLeafSize })
    {
      std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(count, 3);
      for (std::size_t i = 0; i < boxes.size(); i += 7)
      {
        boxes[i].Margin = 0.25 * static_cast<double>(i);
        boxes[i].Origin[1] = 1000.0;
      }
      vtkNBufferHierarchy tree;
      tree.Build(boxes, leafSize);
      CheckNodes(tree, boxes, GetAll(boxes));
    }
  }
}

TEST(NBufferHierarchy, OfSomeOfTheBoxes)
{
  const std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(300, 3);
  std::vector<int> places;
  for (int i = 1; i < 300; i += 3)
  {
    places.push_back(i);
  }
  vtkNBufferHierarchy tree;
  tree.Build(boxes, places);
  CheckNodes(tree, boxes, places);
  tree.Clear();
  CheckNodes(tree, boxes, {});
  tree.Build(boxes, std::vector<int>());
  CheckNodes(tree, boxes, {});
}

// No box below a node that is wholly in the view is tested against the frustum.
TEST(NBufferHierarchy, EverythingBelowANodeWhollyInsideIsInside)
{
  ViewSampler sampler(5);
  int wholly = 0;
  for (int n = 0; n < 150; ++n)
  {
    const View view = sampler.MakeView(n % 3 == 0 ? 0.0 : n % 3 == 1 ? 1e3 : 1e5, n % 2 == 0);
    const vtkNBufferProjection projection = MakeProjection(view);
    std::vector<vtkNBufferBox> boxes;
    for (int i = 0; i < 40; ++i)
    {
      boxes.push_back(vtkNBufferBox::FromBounds(sampler.MakeBounds(view).data()));
    }
    vtkNBufferHierarchy tree;
    tree.Build(boxes, 2);
    for (const Node& node : tree.GetNodes())
    {
      vtkNBufferScreenBox screen;
      if (projection.Project(node.Box, screen) != vtkNBufferPlacement::Inside ||
        !projection.IsWhollyInside(screen))
      {
        continue;
      }
      for (int slot = node.Begin; slot < node.End; ++slot)
      {
        ++wholly;
        vtkNBufferScreenBox inner;
        EXPECT_EQ(
          projection.Project(boxes[tree.GetOrder()[slot]], inner), vtkNBufferPlacement::Inside)
          << view.Text;
      }
    }
  }
  EXPECT_GT(wholly, 100);
}

// All boxes become twice as large, so that a new build gives the same tree, and nothing is rounded
// differently.
TEST(NBufferHierarchy, RefitEqualsAnotherBuild)
{
  std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(500, 3);
  vtkNBufferHierarchy tree;
  vtkNBufferHierarchy moved;
  tree.Build(boxes);
  moved.Build(boxes);
  for (vtkNBufferBox& box : boxes)
  {
    box.Center *= 2.0;
    box.HalfSize *= 2.0;
    box.Magnitude *= 2.0;
  }
  vtkNBufferHierarchy built;
  built.Build(boxes);
  MoveAll(tree, boxes);
  EXPECT_EQ(MoveAll(moved, boxes), static_cast<int>(moved.GetNodes().size()));
  EXPECT_EQ(built.GetOrder(), tree.GetOrder());
  ExpectSameBoxes(tree, built);
  ExpectSameBoxes(moved, built);
  EXPECT_EQ(built.GetGrowth(), 1.0);
  EXPECT_NEAR(tree.GetGrowth(), 2.0, 1e-9);
  EXPECT_NEAR(moved.GetGrowth(), 2.0, 1e-9);
}

TEST(NBufferHierarchy, OnlyWhatIsAboveAMoveIsRefit)
{
  std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(64, 3);
  vtkNBufferHierarchy tree;
  tree.Build(boxes, 8);
  EXPECT_EQ(tree.GetNodes().size(), 15u);
  EXPECT_EQ(tree.Refit(), 0);
  for (int place : { 0, 17, 63 })
  {
    boxes[static_cast<std::size_t>(place)] =
      MakeRandomBoxes(1, 90u + static_cast<unsigned>(place))[0];
    tree.Move(place, boxes[static_cast<std::size_t>(place)]);
    EXPECT_EQ(tree.Refit(), 4); // from the root to a leaf
    CheckNodes(tree, boxes, GetAll(boxes));
  }
  vtkNBufferHierarchy all;
  all.Build(MakeRandomBoxes(64, 3), 8);
  MoveAll(all, boxes);
  ExpectSameBoxes(tree, all);
}

TEST(NBufferHierarchy, NothingIsTestedBelowASkippedNode)
{
  const std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(100, 3);
  vtkNBufferHierarchy tree;
  tree.Build(boxes, 4);
  int nodes = 0;
  int asked = 0;
  tree.Visit(0,
    [&](const Node& node)
    {
      asked += node.Left < 0 ? node.End - node.Begin : 0;
      return ++nodes != 2;
    });
  EXPECT_EQ(asked, 50); // The left half.
}

TEST(NBufferHierarchy, EqualCentresAndHugeBoxes)
{
  std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(100, 3);
  for (vtkNBufferBox& box : boxes)
  {
    box.Center = glm::dvec3(4.0);
  }
  vtkNBufferHierarchy tree;
  tree.Build(boxes);
  EXPECT_LT(tree.GetNodes().size(), 40u);
  CheckNodes(tree, boxes, GetAll(boxes));

  boxes = MakeRandomBoxes(100, 3);
  const double bounds[6] = { -9e29, 9e29, -1e12, 9e29, 0.0, 1.0 };
  boxes[5] = boxes[50] = vtkNBufferBox::FromBounds(bounds);
  tree.Build(boxes);
  CheckNodes(tree, boxes, GetAll(boxes));
}

// Boxes that are not finite have no order and no union. The rest of the tree must be right
// nevertheless.
TEST(NBufferHierarchy, BoxesThatAreNotFiniteAreUnknownToTheRoot)
{
  for (double bad : { NaN, Infinity, -Infinity, std::numeric_limits<double>::max() })
  {
    for (int part = 0; part < 4; ++part)
    {
      std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(200, 3);
      vtkNBufferBox& box = boxes[77];
      (part == 0      ? box.Center
          : part == 1 ? box.HalfSize
          : part == 2 ? box.Magnitude
                      : box.Origin)[1] = bad;
      if (part == 1 && std::isfinite(bad))
      {
        box.HalfSize[1] = Infinity;
      }
      vtkNBufferHierarchy tree;
      tree.Build(boxes);
      int unknown = 0;
      for (const Node& node : tree.GetNodes())
      {
        const auto begin = tree.GetOrder().begin();
        const bool above = std::find(begin + node.Begin, begin + node.End, 77) != begin + node.End;
        if (above && !std::isfinite(node.Box.HalfSize[1] + node.Box.Magnitude[1]))
        {
          CheckUnknown(node.Box);
          ++unknown;
        }
        else if (above)
        {
          EXPECT_TRUE(Contains(node.Box, boxes[77]));
        }
      }
      EXPECT_TRUE(unknown == 6 || std::isfinite(bad)) << unknown; // 200 in leaves of up to 8
      // And back to where something is known.
      const std::vector<vtkNBufferBox> good = MakeRandomBoxes(200, 3);
      tree.Move(77, good[77]);
      tree.Refit();
      CheckNodes(tree, good, GetAll(good));
    }
  }
}

TEST(NBufferHierarchy, GrowthTellsThatBoxesHaveLeftTheirLeaves)
{
  std::vector<vtkNBufferBox> boxes = MakeRandomBoxes(1000, 3);
  vtkNBufferHierarchy tree;
  EXPECT_EQ(tree.GetGrowth(), 1.0);
  tree.Build(boxes);
  EXPECT_EQ(tree.GetGrowth(), 1.0);
  std::shuffle(boxes.begin(), boxes.end(), std::mt19937(4));
  MoveAll(tree, boxes);
  EXPECT_GT(tree.GetGrowth(), 2.0);
}
