// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Outlines of boxes, by brute force.
#include "BoxOutline.h"
#include "Pixels.h"
#include "RandomBoxes.h"
#include "StudyView.h"

#include <gtest/gtest.h>

namespace
{
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
