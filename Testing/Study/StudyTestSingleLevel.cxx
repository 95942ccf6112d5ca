// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// One level by the device equals the double loop, bit for bit.
#include "Messages.h"
#include "SingleLevel.h"
#include "StudyImage.h"
#include "WindowFixture.h"

#include "vtkOpenGLRenderWindow.h"

#include <cmath>
#include <utility>

namespace
{
using NBufferPeers::ReduceMethod;
using NBufferPeers::SingleLevel;
using StudyTest::Image;

constexpr std::pair<int, int> LevelSizes[] = { { 1, 1 }, { 1, 37 }, { 41, 1 }, { 7, 3 }, { 16, 16 },
  { 17, 33 }, { 61, 45 }, { 64, 64 }, { 301, 173 }, { 511, 129 } };

class StudySingleLevel : public OffscreenFixtureWithParam<ReduceMethod, WindowFixture>
{
protected:
  void SetUp() override
  {
    WindowFixture::SetUp();
    if (!this->IsSkipped())
    {
      const std::string why = SingleLevel::WhyNot(GetParam());
      if (!why.empty())
      {
        GTEST_SKIP() << why;
      }
    }
  }

  void Compare(const Image& image)
  {
    this->Level.SetDepth(this->Window, image.Depth, image.Width, image.Height);
    for (int factor : { 4, 8, 16 })
    {
      std::vector<float> level;
      this->Level.Reduce(GetParam(), factor);
      this->Level.Download(level);
      const int width = (image.Width + factor - 1) / factor;
      const int height = (image.Height + factor - 1) / factor;
      ASSERT_EQ(this->Level.GetWidth(), width);
      ASSERT_EQ(this->Level.GetHeight(), height);
      StudyTest::ExpectLevel(image, level, width, height, "factor " + std::to_string(factor),
        [factor](int size, int texel) {
          return StudyTest::Interval{ factor * texel, std::min(factor * (texel + 1), size) };
        });
    }
  }

  SingleLevel Level;
};

TEST_P(StudySingleLevel, IsTheDoubleLoop)
{
  for (const auto& [width, height] : LevelSizes)
  {
    this->Compare(Image(width, height, 7));
  }
}

TEST_P(StudySingleLevel, EndsOfTheRangeAndNeighbouringFloats)
{
  Image image(50, 38, 1);
  const float values[] = { 0.0f, 1.0f, 0.5f, std::nextafter(0.5f, 1.0f), std::nextafter(1.0f, 0.0f),
    1e-30f };
  for (std::size_t i = 0; i < image.Depth.size(); ++i)
  {
    // Whole cells of zeros too.
    image.Depth[i] = i % 50 < 20 ? 0.0f : values[(i * 2654435761u >> 7) % 6];
  }
  this->Compare(image);
}

TEST_P(StudySingleLevel, OtherFactorsAreRefused)
{
  const auto reduce = [this](int factor)
  { return GetThrownMessage([&] { this->Level.Reduce(GetParam(), factor); }); };
  EXPECT_NE(reduce(4).find("SetDepth"), std::string::npos);
  const Image image(5, 5, 1);
  this->Level.SetDepth(this->Window, image.Depth, 5, 5);
  EXPECT_NE(reduce(5).find("4, 8 or 16"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Methods, StudySingleLevel,
  testing::Values(ReduceMethod::OnePass, ReduceMethod::Passes, ReduceMethod::Compute),
  [](const auto& info)
  {
    return std::string(info.param == ReduceMethod::Compute ? "Compute"
        : info.param == ReduceMethod::Passes               ? "Passes"
                                                           : "OnePass");
  });
}
