// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The hierarchy and the outlines: what holds for a node holds for all that is below it.
#include "BoxOutline.h"
#include "BoxTree.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace
{
using NBufferStudy::BoxTree;

std::vector<vtkNBufferBox> MakeBoxes(int count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<vtkNBufferBox> boxes;
  for (int i = 0; i < count; ++i)
  {
    const double x = 60.0 * uniform(random);
    const double y = 60.0 + 70.0 * uniform(random);
    const double z = 10.0 * uniform(random);
    const double size = 1.0 + uniform(random);
    const double bounds[6] = { x, x + size, y, y + 2.0 * size, z, z + 0.5 * size };
    boxes.push_back(vtkNBufferBox::FromBounds(bounds));
  }
  return boxes;
}

/// Every box once, and none but by way of nodes that it lies in.
void CheckNodes(const BoxTree& tree, const std::vector<vtkNBufferBox>& boxes)
{
  const vtkNBufferProjection projection = StudyTest::MakeProjection(300, 200);
  // The node visited last is the leaf of the boxes asked next.
  vtkNBufferBox leaf;
  std::vector<int> asked;
  tree.Visit(
    [&](const vtkNBufferBox& box)
    {
      leaf = box;
      return BoxTree::Answer::Descend;
    },
    [&](int i)
    {
      asked.push_back(i);
      const vtkNBufferBox& box = boxes[static_cast<std::size_t>(i)];
      vtkNBufferScreenBox inner;
      vtkNBufferScreenBox outer;
      const vtkNBufferPlacement inside = projection.Project(box, inner);
      const vtkNBufferPlacement around = projection.Project(leaf, outer);
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_LE(leaf.Center[j] - leaf.HalfSize[j], box.Center[j] - box.HalfSize[j]);
        EXPECT_GE(leaf.Center[j] + leaf.HalfSize[j], box.Center[j] + box.HalfSize[j]);
      }
      if (around == vtkNBufferPlacement::Outside)
      {
        EXPECT_EQ(inside, vtkNBufferPlacement::Outside);
      }
      if (around == vtkNBufferPlacement::Inside && inside == vtkNBufferPlacement::Inside)
      {
        EXPECT_LE(outer.Nearest, inner.Nearest);
        EXPECT_LE(outer.Pixels.X0, inner.Pixels.X0);
        EXPECT_GE(outer.Pixels.Y1, inner.Pixels.Y1);
      }
    });
  std::sort(asked.begin(), asked.end());
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(asked, all);
}

TEST(StudyTree, NodesContainWhatIsBelowThem)
{
  for (int count : { 0, 1, 2, 5, 1000 })
  {
    const std::vector<vtkNBufferBox> boxes = MakeBoxes(count, 3);
    BoxTree tree;
    tree.Build(boxes, 4);
    CheckNodes(tree, boxes);
  }
}

TEST(StudyTree, RefitAfterEverythingMoved)
{
  std::vector<vtkNBufferBox> boxes = MakeBoxes(500, 3);
  BoxTree tree;
  tree.Build(boxes, 4);
  const std::size_t nodes = tree.GetNumberOfNodes();
  boxes = MakeBoxes(500, 9);
  tree.Refit(boxes);
  EXPECT_EQ(tree.GetNumberOfNodes(), nodes);
  CheckNodes(tree, boxes);
}

TEST(StudyTree, NothingIsAskedBelowASkippedNode)
{
  const std::vector<vtkNBufferBox> boxes = MakeBoxes(100, 3);
  BoxTree tree;
  tree.Build(boxes, 4);
  int nodes = 0;
  int asked = 0;
  tree.Visit([&](const vtkNBufferBox&)
    { return ++nodes == 2 ? BoxTree::Answer::Skip : BoxTree::Answer::Descend; },
    [&](int) { ++asked; });
  EXPECT_EQ(asked, 50); // The left half.
}

TEST(StudyOutline, IsThatOfTheDoubleLoopOverPixelCentres)
{
  const vtkNBufferProjection projection = StudyTest::MakeProjection(300, 200);
  int boxesSeen = 0;
  for (const vtkNBufferBox& box : MakeBoxes(400, 5))
  {
    vtkNBufferScreenBox screen;
    if (projection.Project(box, screen) != vtkNBufferPlacement::Inside || screen.Clipped)
    {
      continue;
    }
    ++boxesSeen;
    double corners[16];
    projection.GetCorners(box, corners);
    long long count = 0;
    for (int y = screen.Pixels.Y0; y < screen.Pixels.Y1; ++y)
    {
      for (int x = screen.Pixels.X0; x < screen.Pixels.X1; ++x)
      {
        count += StudyTest::IsInHull(corners, x + 0.5, y + 0.5) ? 1 : 0;
      }
    }
    EXPECT_EQ(NBufferStudy::CountOutlinePixels(projection, box, screen), count);
  }
  EXPECT_GT(boxesSeen, 100);
}
}
