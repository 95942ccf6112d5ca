// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Depths of other formats and encodings, as they are drawn.
#include "DepthMeasures.h"
#include "WindowFixture.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace NBufferStudy;
using NBufferPeers::DepthMeasures;
using NBufferPeers::DepthPainter;
using NBufferPeers::DepthVertex;
using NBufferPeers::DepthView;

constexpr DepthPlanes Planes = { 0.5, 20000.0 };
constexpr int Size = 64;

class StudyDepth : public OffscreenFixtureWithParam<DepthFormat, WindowFixture>
{
protected:
  void SetUp() override
  {
    WindowFixture::SetUp();
    if (this->IsSkipped())
    {
      return;
    }
    const std::string why = DepthMeasures(this->Window, GetParam(), Planes).WhyNot();
    if (!why.empty())
    {
      GTEST_SKIP() << why;
    }
  }

  DepthMeasures Measure() { return DepthMeasures(this->Window, GetParam(), Planes); }

  bool IsByShader() const
  {
    return GetParam().Encoding == DepthEncoding::Linear ||
      GetParam().Encoding == DepthEncoding::Logarithmic;
  }
};

TEST_P(StudyDepth, NoSurfaceIsFartherThanItsDepthSays)
{
  // Triangles that face the eye, one in each pixel.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> power(std::log(0.6), std::log(15000.0));
  std::vector<DepthVertex> vertices;
  std::vector<double> distances;
  for (int i = 0; i < Size * Size; ++i)
  {
    const auto distance = static_cast<float>(std::exp(power(random)));
    distances.push_back(distance);
    const float x = static_cast<float>(2 * (i % Size) + 1) / Size - 1.0f;
    const float y = static_cast<float>(2 * (i / Size) + 1) / Size - 1.0f;
    const float side = 0.9f / Size;
    for (const auto& [u, v] :
      { std::pair(-side, -side), std::pair(side, -side), std::pair(0.0f, side) })
    {
      vertices.push_back(
        { { (x + u) * distance, (y + v) * distance, -distance }, static_cast<float>(i + 1) });
    }
  }
  const DepthView view = { Size, Size, Planes, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.0, 0.0, -1.0 } };
  const int function = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC);
  DepthPainter painter(this->Window);
  std::string why;
  painter.SetTriangles(vertices);
  ASSERT_TRUE(painter.SetView(GetParam(), view, why)) << why;
  painter.Draw(0, static_cast<int>(vertices.size()));
  const std::vector<float> numbers = painter.ReadNumbers();
  const std::vector<double> depth = painter.ReadDepth();
  EXPECT_EQ(vtkNBufferGL::GetInteger(GL_DEPTH_FUNC), function);
  for (int i = 0; i < Size * Size; ++i)
  {
    ASSERT_EQ(numbers[i], static_cast<float>(i + 1));
    const double exact = GetParam().GetDepth(Planes, distances[i]);
    // The device computes in floats; far from the eye, Forward has depths near 1.
    const double error = GetParam().GetQuantum(exact) + 8.0 * 0x1p-24;
    EXPECT_NEAR(depth[i], exact, error) << "at " << distances[i];
    if (this->IsByShader())
    {
      // What culling relies on; the roundings of w itself belong to the slack of the box.
      EXPECT_GE(GetParam().GetFarthest(Planes, depth[i]) * (1.0 + 6.0 * 0x1p-24), distances[i]);
    }
  }
}

TEST_P(StudyDepth, ResolutionIsThatOfTheFormulaWhereFloatsAreFiner)
{
  for (const double distance : { 2.0, 50.0 })
  {
    const DepthMeasures::Resolution found = this->Measure().MeasureResolution(distance);
    const double formula = GetParam().GetResolution(Planes, distance);
    EXPECT_GE(found.Median, 0.4 * formula);
    if (GetParam().Bits == 16)
    {
      EXPECT_NEAR(found.Worst / formula, 1.0, 0.15) << "at " << distance;
      EXPECT_NEAR(found.Median / formula, 0.5, 0.15) << "at " << distance;
    }
  }
}

TEST_P(StudyDepth, WrongPixelsAreThoseOfGapsBelowTheResolution)
{
  DepthMeasures measures = this->Measure();
  for (const double slope : { 0.02, 1.0 })
  {
    const double distance = 50.0;
    const double step = GetParam().GetResolution(Planes, 1.4 * distance);
    const DepthMeasures::Fight wide =
      measures.CountWrongPixels(slope, distance, std::max(4.0 * step, 0.1));
    EXPECT_GT(wide.Pixels, 20000);
    EXPECT_EQ(wide.Wrong, 0) << "slope " << slope;
    // Of equal depths the last one wins, which is farther.
    const DepthMeasures::Fight narrow =
      measures.CountWrongPixels(slope, distance, std::max(0.02 * step, 1e-5));
    EXPECT_GT(narrow.Wrong, GetParam().Bits == 16 ? narrow.Pixels / 2 : -1) << "slope " << slope;
  }
}

TEST_P(StudyDepth, OffsetsMoveOnlyDepthsOfTheMatrix)
{
  DepthMeasures measures = this->Measure();
  for (const double slope : { 0.0, 0.7 })
  {
    const DepthMeasures::Offset offset = measures.MeasureOffset(slope, 1.0, 1.0);
    if (this->IsByShader())
    {
      EXPECT_EQ(offset.Unit, 0.0);
      EXPECT_EQ(offset.Slope, 0.0);
      EXPECT_EQ(offset.MovedByOne, 0.0);
      continue;
    }
    // r is up to the implementation; the slope may be approximated by the larger one of two.
    EXPECT_GT(offset.Unit, 0.9 * offset.ExpectedUnit);
    EXPECT_LT(offset.Unit, 3.0 * offset.ExpectedUnit);
    EXPECT_GT(offset.Slope, 0.99 * offset.LargerSlope);
    EXPECT_LT(offset.Slope, 1.01 * offset.SteepestSlope);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, StudyDepth, testing::ValuesIn(GetDepthFormats()),
  [](const auto& info)
  {
    std::string name = info.param.GetName();
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });
}
