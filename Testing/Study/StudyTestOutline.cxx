// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of boxes, by brute force.
#include "BoxOutline.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{
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
