// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes against depth images: hidden only if no sampled point of the box would pass the test.
#include "SampledViews.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
struct Scene
{
  View Eye;
  vtkNBufferProjection Projection;
  std::vector<float> Depth;
  vtkNBufferLevels Levels;
};

/// Far plane with rectangles of nearer depth in it: walls with edges and gaps.
void MakeScene(ViewSampler& sampler, double offset, int factor, Scene& scene)
{
  do
  {
    scene.Eye = sampler.MakeView(offset, false);
  } while (scene.Eye.Width > 700 || scene.Eye.Width < 2);
  scene.Projection.Set(scene.Eye.WorldToClip.data(), scene.Eye.Width, scene.Eye.Height, 0x1p-24);
  scene.Depth.assign(static_cast<std::size_t>(scene.Eye.Width) * scene.Eye.Height, 1.0f);
  const int walls = sampler.Integer(1, 12);
  for (int n = 0; n < walls; ++n)
  {
    const int x0 = sampler.Integer(-50, scene.Eye.Width - 1);
    const int y0 = sampler.Integer(-50, scene.Eye.Height - 1);
    const int x1 = x0 + sampler.Integer(1, scene.Eye.Width);
    const int y1 = y0 + sampler.Integer(1, scene.Eye.Height);
    const auto depth = static_cast<float>(sampler.Uniform(0.3, 1.0));
    for (int y = std::max(y0, 0); y < std::min(y1, scene.Eye.Height); ++y)
    {
      for (int x = std::max(x0, 0); x < std::min(x1, scene.Eye.Width); ++x)
      {
        float& pixel = scene.Depth[static_cast<std::size_t>(y) * scene.Eye.Width + x];
        pixel = std::min(pixel, depth);
      }
    }
  }
  scene.Levels.BuildBase(
    scene.Depth.data(), scene.Eye.Width, scene.Eye.Height, factor, vtkNBufferExtremum::Maximum);
}

/// No point of a hidden box may pass LEQUAL in the pixel that it falls on.
void CheckHidden(ViewSampler& sampler, const Scene& scene, const std::array<double, 6>& bounds)
{
  for (const auto& point : sampler.MakePoints(bounds, 150))
  {
    for (int permutation = -1; permutation < 4; ++permutation)
    {
      const auto drawn = permutation < 0 ? ProjectExactly(scene.Eye, point)
                                         : ProjectAsDevice(scene.Eye, point, permutation);
      if (!drawn)
      {
        continue;
      }
      const int x = std::min(static_cast<int>(drawn->X), scene.Eye.Width - 1);
      const int y = std::min(static_cast<int>(drawn->Y), scene.Eye.Height - 1);
      const float depth = scene.Depth[static_cast<std::size_t>(y) * scene.Eye.Width + x];
      ASSERT_GT(drawn->Z, depth) << "pixel (" << x << ", " << y << ")";
    }
  }
}

class NBufferOcclusion : public testing::TestWithParam<int>
{
};
}

// Hazard: one pixel, one piece or one level forgotten, and a visible prop is gone.
TEST_P(NBufferOcclusion, HiddenBoxesAreHidden)
{
  ViewSampler sampler(static_cast<unsigned int>(20 + this->GetParam()));
  int hidden[3] = { 0, 0, 0 };
  int tested = 0;
  for (int s = 0; s < 250; ++s)
  {
    Scene scene;
    MakeScene(sampler, s % 3 == 0 ? 1000.0 : 0.0, this->GetParam(), scene);
    for (int b = 0; b < 40; ++b)
    {
      const std::array<double, 6> bounds = sampler.MakeBounds(scene.Eye);
      const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
      vtkNBufferScreenBox screen;
      if (scene.Projection.Project(box, screen) != vtkNBufferPlacement::Inside)
      {
        continue;
      }
      ++tested;
      SCOPED_TRACE(scene.Eye.Text + ", " + GetText(bounds));
      // Just the levels that the box is said to need: a query beyond them would show.
      scene.Levels.BuildLevels(
        vtkNBufferOcclusionTest::GetLevelsNeeded(screen.Pixels, this->GetParam()));
      vtkNBufferOcclusionTest one(scene.Projection, scene.Levels, 1);
      vtkNBufferOcclusionTest eight(scene.Projection, scene.Levels, 8);
      vtkNBufferPixelTest pixels(scene.Projection, scene.Levels, scene.Depth.data());
      const bool verdicts[3] = { one.IsHidden(box, screen), eight.IsHidden(box, screen),
        pixels.IsHidden(box, screen) };
      ASSERT_TRUE(verdicts[1] || !verdicts[0]) << "cutting must not lose what one query found";
      for (int i = 0; i < 3; ++i)
      {
        hidden[i] += verdicts[i];
        if (verdicts[i])
        {
          SCOPED_TRACE(i == 0 ? "one piece" : i == 1 ? "eight pieces" : "pixels");
          CheckHidden(sampler, scene, bounds);
        }
        if (this->HasFatalFailure())
        {
          return;
        }
      }
      ASSERT_EQ(one.GetQueries(), 1);
      ASSERT_LE(one.GetLookups(), 4);
      ASSERT_LE(eight.GetQueries(), 9);
    }
  }
  EXPECT_GT(tested, 1000);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(hidden[i], tested / 20) << "the test would show nothing";
  }
  EXPECT_GE(hidden[2], hidden[0] * 9 / 10) << "pixels are meant to be sharper";
}

INSTANTIATE_TEST_SUITE_P(BaseFactor, NBufferOcclusion, testing::Values(1, 2, 4, 8),
  [](const auto& info) { return std::to_string(info.param); });

// Hazard: equal depth is visible: the last one drawn wins in VTK.
TEST(NBufferOcclusionOnce, EqualDepthIsVisible)
{
  ViewSampler sampler(31);
  int nearlyFlush = 0;
  for (int s = 0; s < 300; ++s)
  {
    Scene scene;
    MakeScene(sampler, 0.0, 4, scene);
    const std::array<double, 6> bounds = sampler.MakeBounds(scene.Eye);
    const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
    vtkNBufferScreenBox screen;
    if (scene.Projection.Project(box, screen) != vtkNBufferPlacement::Inside)
    {
      continue;
    }
    double nearest = 2.0;
    for (const auto& corner : sampler.MakePoints(bounds, 0))
    {
      const auto point = ProjectExactly(scene.Eye, corner);
      nearest = std::min(nearest, point ? point->Z : 2.0);
    }
    if (nearest > 1.0)
    {
      continue;
    }
    ++nearlyFlush;
    // The box's own surface in every pixel, at exactly its nearest depth.
    std::fill(scene.Depth.begin(), scene.Depth.end(), static_cast<float>(nearest));
    scene.Levels.BuildBase(
      scene.Depth.data(), scene.Eye.Width, scene.Eye.Height, 4, vtkNBufferExtremum::Maximum);
    scene.Levels.BuildLevels(20);
    vtkNBufferOcclusionTest test(scene.Projection, scene.Levels, 8);
    EXPECT_FALSE(test.IsHidden(box, screen)) << scene.Eye.Text << ", " << GetText(bounds);
    vtkNBufferPixelTest pixels(scene.Projection, scene.Levels, scene.Depth.data());
    // The pixels of the nearest corner alone decide; they may lie beside the window.
    const auto inWindow = screen.Pixels.GetWidth() > 0;
    EXPECT_TRUE(inWindow);
  }
  EXPECT_GT(nearlyFlush, 50);
}

// Hazard: a wall before everything that hides nothing.
TEST(NBufferOcclusionOnce, ANearWallHidesAllBehindIt)
{
  ViewSampler sampler(32);
  int tested = 0;
  for (int s = 0; s < 300; ++s)
  {
    Scene scene;
    MakeScene(sampler, 0.0, 4, scene);
    std::fill(scene.Depth.begin(), scene.Depth.end(), 0.001f);
    scene.Levels.BuildBase(
      scene.Depth.data(), scene.Eye.Width, scene.Eye.Height, 4, vtkNBufferExtremum::Maximum);
    scene.Levels.BuildLevels(20);
    const std::array<double, 6> bounds = sampler.MakeBounds(scene.Eye);
    const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
    vtkNBufferScreenBox screen;
    if (scene.Projection.Project(box, screen) == vtkNBufferPlacement::Inside &&
      screen.Nearest > 0.002)
    {
      ++tested;
      vtkNBufferOcclusionTest test(scene.Projection, scene.Levels, 1);
      EXPECT_TRUE(test.IsHidden(box, screen)) << scene.Eye.Text << ", " << GetText(bounds);
      vtkNBufferPixelTest pixels(scene.Projection, scene.Levels, scene.Depth.data());
      EXPECT_TRUE(pixels.IsHidden(box, screen)) << scene.Eye.Text << ", " << GetText(bounds);
    }
  }
  EXPECT_GT(tested, 50);
}

// Hazard: a visible pixel anywhere in the outline must keep the box.
TEST(NBufferOcclusionOnce, OneOpenPixelKeepsTheBox)
{
  ViewSampler sampler(33);
  int opened = 0;
  for (int s = 0; s < 400; ++s)
  {
    Scene scene;
    MakeScene(sampler, 0.0, 4, scene);
    std::fill(scene.Depth.begin(), scene.Depth.end(), 0.001f);
    const std::array<double, 6> bounds = sampler.MakeBounds(scene.Eye);
    const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
    vtkNBufferScreenBox screen;
    if (scene.Projection.Project(box, screen) != vtkNBufferPlacement::Inside)
    {
      continue;
    }
    const auto points = sampler.MakePoints(bounds, 20);
    for (const auto& point : points)
    {
      const auto drawn = ProjectExactly(scene.Eye, point);
      if (!drawn)
      {
        continue;
      }
      const std::size_t x = std::min(static_cast<int>(drawn->X), scene.Eye.Width - 1);
      const std::size_t y = std::min(static_cast<int>(drawn->Y), scene.Eye.Height - 1);
      float& pixel = scene.Depth[y * scene.Eye.Width + x];
      // Just open enough for this point.
      pixel = std::nextafter(static_cast<float>(drawn->Z), 2.0f);
      scene.Levels.BuildBase(
        scene.Depth.data(), scene.Eye.Width, scene.Eye.Height, 4, vtkNBufferExtremum::Maximum);
      scene.Levels.BuildLevels(20);
      vtkNBufferOcclusionTest test(scene.Projection, scene.Levels, 8);
      vtkNBufferPixelTest pixels(scene.Projection, scene.Levels, scene.Depth.data());
      ASSERT_FALSE(test.IsHidden(box, screen)) << scene.Eye.Text << ", " << GetText(bounds);
      ASSERT_FALSE(pixels.IsHidden(box, screen)) << scene.Eye.Text << ", " << GetText(bounds);
      pixel = 0.001f;
      ++opened;
      break;
    }
  }
  EXPECT_GT(opened, 50);
}
