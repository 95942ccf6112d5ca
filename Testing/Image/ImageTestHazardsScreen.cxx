// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Rectangles of pixels: rounding, tiny and huge boxes, windows and viewports of every shape. Most
// scenes are given in pixels, so that the tests know which props are covered.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkTransform.h"

#include <algorithm>
#include <utility>
#include <vector>

using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;
using Scenes::AddQuad;
using Scenes::Wall;

namespace
{
/// A rectangle whose side falls between pixels in every way, and one behind it.
struct RoundingCase
{
  double Phase; ///< Of the covering rectangle's corners, in pixels.
  int Side;     ///< Left, right, lower, upper.
  double Out;   ///< By how many pixels the one behind sticks out there.
};

std::vector<RoundingCase> MakeRoundingCases()
{
  std::vector<RoundingCase> cases;
  for (double phase :
    { 0.0, 0.25, 0.4375, 0.5, 0.5 - 1e-5, 0.5 + 1e-5, 0.5 - 1.0 / 512, 0.5 + 1.0 / 512, 0.75 })
  {
    for (int side = 0; side < 4; ++side)
    {
      for (double out : { -1.25, -0.5, 0.0, 0.25, 0.5, 1.0 })
      {
        cases.push_back({ phase, side, out });
      }
    }
  }
  return cases;
}

void MoveWallCamera(Comparison& comparison, double shift)
{
  comparison.Both([shift](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), shift); });
}
}

// Hazard: a side at x.5 pixels covers a pixel centre or does not; a rectangle rounded inward loses
// the row of pixels in which its box shows.
TEST(CullerHazards, RectanglesAtHalfPixels)
{
  constexpr int Width = 403;
  constexpr int Height = 299;
  const std::vector<RoundingCase> cases = MakeRoundingCases();
  for (int factor : { 1, 4, 8 })
  {
    SCOPED_TRACE(factor);
    Comparison comparison(
      [&cases](Stage& stage)
      {
        for (std::size_t i = 0; i < cases.size(); ++i)
        {
          const RoundingCase& c = cases[i];
          const double x = 24.0 * static_cast<double>(i % 16) + 6.0 + c.Phase;
          const double y = 20.0 * static_cast<double>(i / 16) + 5.0 + c.Phase;
          AddQuad(stage, x, y, x + 14.0, y + 10.0, 50.0);
          double out[4] = { -3.0, -3.0, -3.0, -3.0 };
          out[c.Side] = c.Out;
          AddQuad(stage, x - out[0], y - out[2], x + 14.0 + out[1], y + 10.0 + out[3], 20.0);
        }
        Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height);
      },
      Scenes::MakeExactOptions(Width, Height, factor));
    Scenes::Settle(comparison);
    for (double shift : { 0.0, 0.125, 0.25, 0.5, 0.5 - 1e-6, 0.5 + 1e-6, 0.75 })
    {
      comparison.Both([shift](Stage& stage)
        { Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height, shift, -shift); });
      comparison.Frame("shifted by " + std::to_string(shift));
      for (std::size_t i = 0; i < cases.size(); ++i)
      {
        const Verdict verdict = comparison.GetVerdict(static_cast<int>(2 * i + 1));
        // In a strip of one pixel there is a centre; what lies 1.25 pixels inside needs none of
        // the pixels that the side cuts.
        EXPECT_FALSE(cases[i].Out >= 1.0 && verdict == Verdict::Hidden) << i;
        EXPECT_TRUE(factor > 1 || cases[i].Out > -1.25 || verdict == Verdict::Hidden) << i;
      }
    }
  }
}

// Hazard: a box that reaches far beyond the window on all sides has a rectangle to be cut, after
// rounding; one row or column of pixels at the border decides.
TEST(CullerHazards, BoxesLargerThanTheWindow)
{
  constexpr int Width = 253;
  constexpr int Height = 131;
  constexpr int Count = 40;
  for (int factor : { 1, 4, 8 })
  {
    SCOPED_TRACE(factor);
    Comparison comparison(
      [](Stage& stage)
      {
        Scenes::AddBox(stage, 0.5 * Width, 0.5 * Height, 60.0, 9e3, 9e3, 1.0);
        for (int i = 0; i < Count; ++i)
        {
          Scenes::AddBox(stage, 40.0 * i - 500.0, 90.0 - 7.0 * i, 40.0 - 3.0 * i, 3e3, 2e3, 0.5);
        }
        Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height);
      },
      Scenes::MakeExactOptions(Width, Height, factor));
    Scenes::Settle(comparison);
    EXPECT_EQ(comparison.GetHidden(), Count);
    // Moved so that it leaves a column or a row of pixels to the next.
    const double gaps[4][2] = { { 4500.0 - 0.5 * Width + 1.0, 0.0 },
      { -4500.0 + 0.5 * Width - 1.0, 0.0 }, { 0.0, 4500.0 - 0.5 * Height + 1.0 },
      { 0.0, -4500.0 + 0.5 * Height - 1.0 } };
    for (const auto& gap : gaps)
    {
      comparison.Both(
        [&gap](Stage& stage) { stage.GetActor(0)->SetPosition(gap[0], gap[1], 0.0); });
      Scenes::Settle(comparison);
      EXPECT_EQ(comparison.GetVerdict(1), Verdict::Visible) << gap[0] << ", " << gap[1];
      EXPECT_EQ(comparison.GetHidden(), Count - 1) << "the others are behind that one";
    }
  }
  // Seen in perspective, from so near that they go round the eye.
  Comparison perspective([](Stage& stage) { Scenes::BuildWall(stage); });
  for (double distance : { 6.0, 1.0, 0.3, 0.26 })
  {
    perspective.Both(
      [distance](Stage& stage)
      {
        stage.GetRenderer()->GetActiveCamera()->SetPosition(0.0, 0.0, distance);
        stage.GetRenderer()->GetActiveCamera()->SetClippingRange(0.005, 40.0);
      });
    perspective.Frame("distance " + std::to_string(distance));
    perspective.Frame("the same again");
    EXPECT_GE(perspective.GetHidden() + perspective.GetStatistics().GetCount(Verdict::Outside),
      Wall::Hidden);
  }
}

//------------------------------------------------------------------------------------------------
namespace
{
class CullerHazardWindows : public testing::TestWithParam<std::pair<int, int>>
{
};
}

// Hazard: windows of a single texel, row or column, and such whose sides leave cut texels.
TEST_P(CullerHazardWindows, Wall)
{
  const auto [width, height] = this->GetParam();
  for (int factor : { 1, 8 })
  {
    SCOPED_TRACE(factor);
    Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); },
      Scenes::MakeExactOptions(width, height, factor));
    for (int i = 0; i < 4; ++i)
    {
      MoveWallCamera(comparison, 0.02 * i);
      comparison.Frame();
    }
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    const int notDrawn =
      comparison.GetHidden() + comparison.GetStatistics().GetCount(Verdict::Outside);
    EXPECT_TRUE(factor > 1 || notDrawn >= Wall::Hidden) << notDrawn;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, CullerHazardWindows,
  testing::Values(std::pair<int, int>(1, 1), std::pair<int, int>(2, 2), std::pair<int, int>(3, 1),
    std::pair<int, int>(1, 97), std::pair<int, int>(97, 1), std::pair<int, int>(8, 8),
    std::pair<int, int>(9, 7), std::pair<int, int>(1, 1000), std::pair<int, int>(1500, 1),
    std::pair<int, int>(1021, 17), std::pair<int, int>(19, 1023)),
  [](const testing::TestParamInfo<std::pair<int, int>>& info)
  { return std::to_string(info.param.first) + "x" + std::to_string(info.param.second); });

// Hazard: a viewport begins and ends at fractions that round up on one side and down on the other;
// depth is then read a pixel beside where it was drawn.
TEST(CullerHazards, ViewportsThatStartAnywhere)
{
  constexpr int Width = 203;
  constexpr int Height = 151;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 1; i < 4; ++i)
      {
        Scenes::BuildWall(stage, stage.AddRenderer(0.0, 0.0, 1.0, 1.0));
      }
    },
    Scenes::MakeExactOptions(Width, Height));
  const double splits[][2] = { { 0.5, 0.5 }, { 100.5 / Width, 70.5 / Height },
    { 100.5 / Width + 1e-9, 70.5 / Height - 1e-9 }, { 33.5 / Width - 1e-9, 90.5 / Height + 1e-9 },
    { 1.0 / 3.0, 0.618 }, { 0.25, 0.75 }, { 61.25 / Width, 61.75 / Height } };
  for (const auto& split : splits)
  {
    comparison.Both(
      [&split](Stage& stage)
      {
        const double x = split[0];
        const double y = split[1];
        stage.Renderers[0]->SetViewport(0.0, 0.0, x, y);
        stage.Renderers[1]->SetViewport(x, 0.0, 1.0, y);
        stage.Renderers[2]->SetViewport(0.0, y, x, 1.0);
        stage.Renderers[3]->SetViewport(x, y, 1.0, 1.0);
      });
    for (int i = 0; i < 3; ++i)
    {
      comparison.Frame(std::to_string(split[0]) + ", " + std::to_string(split[1]));
    }
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(comparison.GetDecision(i), Decision::Culled) << i;
      const int outside = comparison.GetStatistics(i).GetCount(Verdict::Outside);
      EXPECT_GE(comparison.GetHidden(i) + outside, Wall::Hidden) << i;
      EXPECT_GE(comparison.GetHidden(i), Wall::Behind / 4) << i;
    }
  }
}

// Hazard: viewports of a pixel and less, and such that reach over the border of the window.
TEST(CullerHazards, ViewportsOfAPixel)
{
  constexpr int Width = 41;
  constexpr int Height = 31;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      Scenes::BuildWall(stage, stage.AddRenderer(0.0, 0.0, 0.5, 0.5));
    },
    Scenes::MakeExactOptions(Width, Height));
  const double viewports[][4] = { { 20.0, 15.0, 21.0, 16.0 }, { 20.5, 15.5, 21.5, 16.5 },
    { 40.0, 30.0, 41.0, 31.0 }, { 0.0, 0.0, 1.0, 31.0 }, { 0.5, 0.5, 40.5, 1.5 },
    { 39.5, 0.0, 41.0, 31.0 } };
  for (const auto& v : viewports)
  {
    comparison.Both(
      [&v](Stage& stage) {
        stage.GetRenderer()->SetViewport(v[0] / Width, v[1] / Height, v[2] / Width, v[3] / Height);
      });
    for (int i = 0; i < 3; ++i)
    {
      comparison.Frame(std::to_string(v[0]) + ", " + std::to_string(v[1]));
    }
    EXPECT_GE(
      comparison.GetHidden() + comparison.GetStatistics().GetCount(Verdict::Outside), Wall::Hidden);
    EXPECT_GE(comparison.GetHidden(1), Wall::Behind / 2);
  }
}

// Hazard: a view mirrored in x, y or both turns faces and the order of a box's corners round.
TEST(CullerHazards, MirroredViews)
{
  for (bool parallel : { false, true })
  {
    for (int mirror = 1; mirror < 4; ++mirror)
    {
      SCOPED_TRACE(std::to_string(mirror) + (parallel ? " parallel" : " perspective"));
      Comparison comparison(
        [mirror, parallel](Stage& stage)
        {
          Scenes::BuildWall(stage);
          vtkNew<vtkTransform> transform;
          transform->Scale(mirror & 1 ? -1.0 : 1.0, mirror & 2 ? -1.0 : 1.0, 1.0);
          vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
          camera->SetUserTransform(transform);
          camera->SetParallelProjection(parallel);
          camera->SetParallelScale(5.0);
        });
      for (int i = 0; i < 4; ++i)
      {
        MoveWallCamera(comparison, 0.1 * i);
        comparison.Frame();
      }
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    }
  }
}

//------------------------------------------------------------------------------------------------
// Hazard: an occluder moves on and uncovers what it hid; that has to show in the same frame.
TEST(CullerHazards, AMovingOccluderUncoversWhatItHid)
{
  constexpr int Width = 301;
  constexpr int Height = 199;
  constexpr int Columns = 20;
  constexpr int Rows = 12;
  constexpr double Panel = 110.0; // its width
  Comparison comparison(
    [](Stage& stage)
    {
      AddQuad(stage, 0.0, 0.0, Panel, Height, 60.0);
      for (int i = 0; i < Columns * Rows; ++i)
      {
        Scenes::AddBox(
          stage, 14.0 * (i % Columns) + 10.0, 16.0 * (i / Columns) + 10.0, 20.0, 9.0, 9.0, 9.0);
      }
      Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height);
    },
    Scenes::MakeExactOptions(Width, Height));
  std::vector<bool> wasCovered(Columns * Rows, false);
  int hidden = 0;
  const double places[] = { 0.0, 0.0, 0.0, 17.3, 40.0, 40.5, 90.0, 190.0, 190.0, 3.0, 3.0, 150.0,
    20.25, 150.0, 20.25, 400.0, 20.25, 20.25 };
  for (double place : places)
  {
    comparison.Both([place](Stage& stage) { stage.GetActor(0)->SetPosition(place, 0.0, 0.0); });
    comparison.Frame("panel at " + std::to_string(place));
    for (int i = 0; i < Columns * Rows; ++i)
    {
      const double left = 14.0 * (i % Columns) + 5.5;
      const bool covered = left > place + 1.25 && left + 9.0 < place + Panel - 1.25;
      const bool uncovered = left < place - 1.0 || left + 9.0 > place + Panel + 1.0;
      const Verdict verdict = comparison.GetVerdict(i + 1);
      EXPECT_TRUE(!uncovered || verdict == Verdict::Visible) << i;
      // What was visible in the last frame is drawn before the test.
      EXPECT_TRUE(!covered || !wasCovered[i] || verdict == Verdict::Hidden) << i;
      wasCovered[i] = covered && verdict == Verdict::Hidden;
      hidden += verdict == Verdict::Hidden;
    }
  }
  EXPECT_GT(hidden, 500) << "in all frames together";
}
