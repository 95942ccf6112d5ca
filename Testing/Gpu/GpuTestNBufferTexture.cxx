// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every level that the device builds equals, bit for bit, what the host builds from the same
// reading of depth.
#include "vtkNBufferGL.h"
#include "vtkNBufferTexture.h"

#include "DepthTarget.h"
#include "LevelComparison.h"
#include "WindowFixture.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace
{
constexpr int Factors[] = { 1, 2, 4, 8 };
constexpr vtkNBufferExtremum Extrema[] = { vtkNBufferExtremum::Maximum,
  vtkNBufferExtremum::Minimum };

class LevelsFixture : public WindowFixture
{
protected:
  /// Builds from the bound framebuffer, downloads, and compares with what the host makes of
  /// `depth`.
  void Compare(const vtkNBufferDepthSource& source, int x, int y, int width, int height, int factor,
    vtkNBufferExtremum extremum, const std::vector<float>& depth)
  {
    SCOPED_TRACE(testing::Message()
      << "factor " << factor
      << (extremum == vtkNBufferExtremum::Maximum ? ", maximum" : ", minimum"));
    ASSERT_TRUE(
      this->Texture->Build(this->Window, source, x, y, width, height, factor, AllLevels, extremum))
      << this->Texture->GetError();
    vtkNBufferLevels device;
    ASSERT_TRUE(this->Texture->Download(this->Window, device)) << this->Texture->GetError();
    EXPECT_EQ(FindDifference(BuildOnHost(depth, width, height, factor, extremum), device), "");
    EXPECT_EQ(device.GetFactor(), factor);
    EXPECT_EQ(device.GetPixelWidth(), width);
    EXPECT_EQ(device.GetPixelHeight(), height);
    EXPECT_EQ(device.GetExtremum(), extremum);
    EXPECT_EQ(this->Texture->GetNumberOfDraws(), device.GetNumberOfLevels());
  }

  /// The depth of a rectangle as the device reads it: level 0 of single pixels.
  std::vector<float> ReadOnDevice(const vtkNBufferDepthSource& source, int x, int y, int width,
    int height, vtkNBufferExtremum extremum)
  {
    vtkNBufferLevels pixels;
    EXPECT_TRUE(this->Texture->Build(this->Window, source, x, y, width, height, 1, 1, extremum))
      << this->Texture->GetError();
    EXPECT_TRUE(this->Texture->Download(this->Window, pixels)) << this->Texture->GetError();
    const float* first = pixels.GetLevelData(0);
    return std::vector<float>(first, first + static_cast<std::size_t>(width) * height);
  }

  /**
   * All factors and both extrema over a rectangle of single-sample depth. Device and host may round
   * what they read differently, but by no more than vtkNBufferDepthSource::GetStep() derives. The
   * levels are therefore compared with those that the host makes of what the device read.
   */
  void CompareWithRead(int x, int y, int width, int height)
  {
    const vtkNBufferDepthSource source = this->Inspect();
    const bool isCopied = source.FloatDepth || source.ExceedsFloats();
    const double tolerance = isCopied ? 0.0 : std::ldexp(1.0, -24);
    for (const vtkNBufferExtremum extremum : Extrema)
    {
      const std::vector<float> read = this->Read(source, { x, y, x + width, y + height }, extremum);
      const std::vector<float> depth = this->ReadOnDevice(source, x, y, width, height, extremum);
      ASSERT_EQ(depth.size(), read.size());
      for (std::size_t i = 0; i < depth.size(); ++i)
      {
        ASSERT_LE(std::abs(static_cast<double>(depth[i]) - read[i]), tolerance) << i;
      }
      for (const int factor : Factors)
      {
        this->Compare(source, x, y, width, height, factor, extremum, depth);
      }
    }
  }

  vtkNew<vtkNBufferTexture> Texture;
};

template <typename Parameter>
using LevelsWithParam = OffscreenFixtureWithParam<Parameter, LevelsFixture>;
}

using GpuTestNBufferTextureSizes = LevelsWithParam<std::pair<int, int>>;

TEST_P(GpuTestNBufferTextureSizes, EqualHost)
{
  const auto [width, height] = this->GetParam();
  // As VTK's windows have it, and what is sampled where it lies.
  for (const std::size_t format : { 2u, 3u })
  {
    SCOPED_TRACE(GetTargetFormats()[format].Name);
    const DepthTarget target(GetTargetFormats()[format], width, height, true);
    ASSERT_TRUE(target.IsComplete());
    target.Fill(static_cast<unsigned int>(width));
    this->CompareWithRead(0, 0, width, height);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, GpuTestNBufferTextureSizes,
  ::testing::Values(std::pair(1, 1), std::pair(1, 6), std::pair(6, 1), std::pair(12, 19),
    std::pair(49, 2), std::pair(100, 300), std::pair(511, 1023), std::pair(960, 720)),
  [](const auto& info)
  { return std::to_string(info.param.first) + "x" + std::to_string(info.param.second); });

// Rectangles of level 0, in one read-back; the texels between them are left alone.
using GpuTestNBufferTextureRectangles = LevelsFixture;

TEST_F(GpuTestNBufferTextureRectangles, AreThoseOfTheWholeLevel)
{
  constexpr float untouched = -1.0f;
  const DepthTarget target(GetTargetFormats()[3], 90, 70, true);
  target.Fill(3);
  const vtkNBufferDepthSource source = this->Inspect();
  float texel = untouched;
  EXPECT_FALSE(this->Texture->Download(this->Window, { { 0, 0, 1, 1 } }, &texel));
  EXPECT_NE(this->Texture->GetError().find("no levels"), std::string::npos);
  for (const int factor : Factors)
  {
    SCOPED_TRACE(factor);
    ASSERT_TRUE(this->Texture->Build(
      this->Window, source, 0, 0, 90, 70, factor, 1, vtkNBufferExtremum::Maximum));
    vtkNBufferLevels whole;
    ASSERT_TRUE(this->Texture->Download(this->Window, whole));
    const int width = whole.GetWidth();
    const int height = whole.GetHeight();
    std::vector<float> parts(static_cast<std::size_t>(width) * height, untouched);
    const std::vector<vtkNBufferRectangle> rectangles = { { 0, 0, 3, 2 }, { 5, 4, 6, 8 },
      { 8, 0, width, height } };
    const int downloads = this->Texture->GetNumberOfDownloads();
    EXPECT_TRUE(this->Texture->Download(this->Window, {}, nullptr));
    EXPECT_EQ(this->Texture->GetNumberOfDownloads(), downloads) << "nothing is read for nothing";
    ASSERT_TRUE(this->Texture->Download(this->Window, rectangles, parts.data()))
      << this->Texture->GetError();
    EXPECT_EQ(this->Texture->GetNumberOfDownloads(), downloads + 1);
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const bool isRead = std::any_of(rectangles.begin(), rectangles.end(),
          [x, y](const vtkNBufferRectangle& r)
          { return x >= r.X0 && x < r.X1 && y >= r.Y0 && y < r.Y1; });
        ASSERT_EQ(parts[static_cast<std::size_t>(y) * width + x],
          isRead ? whole.GetTexel(0, x, y) : untouched)
          << x << ", " << y;
      }
    }
  }
}

// Format and kind of attachment.
using GpuTestNBufferTextureFormats = LevelsWithParam<std::tuple<int, bool>>;

TEST_P(GpuTestNBufferTextureFormats, EqualHost)
{
  const auto [number, isTexture] = this->GetParam();
  const TargetFormat& format = GetTargetFormats()[number];
  // Renderbuffers cannot be sampled; a texture with the same depth can.
  const DepthTarget twin(format, 90, 70, true);
  twin.Fill(3);
  const std::vector<float> sampled = twin.Fetch();
  const DepthTarget target(format, 90, 70, isTexture);
  ASSERT_TRUE(target.IsComplete());
  target.Fill(3);
  const vtkNBufferDepthSource source = this->Inspect();
  if (!source.ExceedsFloats())
  {
    EXPECT_EQ(this->ReadOnDevice(source, 0, 0, 90, 70, vtkNBufferExtremum::Maximum), sampled);
  }
  this->CompareWithRead(0, 0, 90, 70);
  // Rectangles inside, at odd places and of odd sizes.
  this->CompareWithRead(13, 7, 53, 41);
  this->CompareWithRead(89, 69, 1, 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, GpuTestNBufferTextureFormats,
  ::testing::Combine(::testing::Range(0, 6), ::testing::Bool()),
  [](const auto& info)
  {
    return std::string(GetTargetFormats()[std::get<0>(info.param)].Name) +
      (std::get<1>(info.param) ? "Texture" : "Renderbuffer");
  });

using GpuTestNBufferTexture = LevelsFixture;

TEST_F(GpuTestNBufferTexture, WindowInAViewportEqualsHost)
{
  this->Window->SetSize(150, 110);
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(0.2, 0.3, 0.9, 0.95);
  AddCone(renderer);
  this->Window->AddRenderer(renderer);
  WhileDrawing(this->Window, renderer,
    [&]()
    {
      const vtkNBufferDepthSource source = this->Inspect();
      const int* viewport = source.Viewport;
      EXPECT_GT(viewport[0], 0);
      EXPECT_GT(viewport[1], 0);
      this->CompareWithRead(viewport[0], viewport[1], viewport[2], viewport[3]);
    });
}

TEST_F(GpuTestNBufferTexture, FewerLevelsAreAPrefix)
{
  const DepthTarget target(GetTargetFormats()[3], 64, 40, true);
  target.Fill(5);
  const vtkNBufferDepthSource source = this->Inspect();
  const std::vector<float> depth = this->Read(source, { 0, 0, 64, 40 });
  for (const int count : { 1, 3 })
  {
    ASSERT_TRUE(this->Texture->Build(
      this->Window, source, 0, 0, 64, 40, 2, count, vtkNBufferExtremum::Maximum));
    EXPECT_EQ(this->Texture->GetNumberOfDraws(), count);
    vtkNBufferLevels device;
    ASSERT_TRUE(this->Texture->Download(this->Window, device));
    vtkNBufferLevels host;
    host.BuildBase(depth.data(), 64, 40, 2, vtkNBufferExtremum::Maximum);
    host.BuildLevels(count);
    EXPECT_EQ(FindDifference(host, device), "");
  }
}

using GpuTestNBufferTextureSamples = LevelsWithParam<int>;

TEST_P(GpuTestNBufferTextureSamples, EveryFormatTakesTheExtremumOfAllSamples)
{
  constexpr int width = 37;
  constexpr int height = 22;
  int compared = 0;
  for (const TargetFormat& format : GetTargetFormats())
  {
    SCOPED_TRACE(format.Name);
    const DepthTarget target(format, width, height, true, this->GetParam());
    // A driver may give more than requested.
    const int count = target.GetSamples();
    if (!target.IsComplete() || count < this->GetParam())
    {
      continue;
    }
    ++compared;
    target.Fill(11);
    std::vector<std::vector<float>> samples;
    for (int i = 0; i < count; ++i)
    {
      samples.push_back(target.Fetch(i));
    }
    EXPECT_NE(samples[0], samples[1]) << "the noise does not differ between samples";

    target.Bind(0, 0, width, height);
    const vtkNBufferDepthSource source = this->Inspect();
    for (const vtkNBufferExtremum extremum : Extrema)
    {
      const bool maximum = extremum == vtkNBufferExtremum::Maximum;
      std::vector<float> depth = samples[0];
      for (const std::vector<float>& sample : samples)
      {
        for (std::size_t i = 0; i < depth.size(); ++i)
        {
          depth[i] = maximum ? std::max(depth[i], sample[i]) : std::min(depth[i], sample[i]);
        }
      }
      if (source.DepthBits == 32 && !source.FloatDepth)
      {
        // Moved to the safe side by what samplers may lose.
        const float error = std::ldexp(1.0f, -23);
        for (float& value : depth)
        {
          value = maximum ? std::min(value + error, 1.0f) : std::max(value - error, 0.0f);
        }
      }
      for (const int factor : Factors)
      {
        this->Compare(source, 0, 0, width, height, factor, extremum, depth);
      }
    }
  }
  if (compared == 0)
  {
    GTEST_SKIP() << "the driver offers no depth textures of " << this->GetParam() << " samples";
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, GpuTestNBufferTextureSamples, ::testing::Values(2, 4, 8),
  [](const auto& info) { return std::to_string(info.param); });

TEST_F(GpuTestNBufferTexture, MultisampledWindowIsNeverNearerThanItsSamples)
{
  this->Window = NewWindow(80, 60, 4);
  vtkNew<vtkRenderer> renderer;
  AddCone(renderer);
  this->Window->AddRenderer(renderer);
  vtkNBufferLevels farthest;
  vtkNBufferLevels nearest;
  WhileDrawing(this->Window, renderer,
    [&]()
    {
      const vtkNBufferDepthSource source = this->Inspect();
      if (source.Samples < 2)
      {
        return;
      }
      for (const vtkNBufferExtremum extremum : Extrema)
      {
        const bool maximum = extremum == vtkNBufferExtremum::Maximum;
        ASSERT_TRUE(this->Texture->Build(this->Window, source, 0, 0, 80, 60, 1, 1, extremum))
          << this->Texture->GetError();
        ASSERT_TRUE(this->Texture->Download(this->Window, maximum ? farthest : nearest));
      }
    });
  if (farthest.GetNumberOfLevels() == 0)
  {
    GTEST_SKIP() << "the window has no multisampling";
  }
  // One sample of each pixel, as the window resolves it.
  std::vector<float> resolved(80 * 60);
  this->Window->GetZbufferData(0, 0, 79, 59, resolved.data());
  int edges = 0;
  int inside = 0;
  int background = 0;
  for (int i = 0; i < 80 * 60; ++i)
  {
    const float high = farthest.GetLevelData(0)[i];
    const float low = nearest.GetLevelData(0)[i];
    ASSERT_GE(high, resolved[i]);
    ASSERT_LE(low, resolved[i]);
    edges += high == 1.0f && low < 1.0f - 1e-6f;
    inside += high < 1.0f;
    background += low > 1.0f - 1e-6f;
  }
  EXPECT_GT(edges, 20);
  EXPECT_GT(inside, 100);
  EXPECT_GT(background, 100);
}

TEST_F(GpuTestNBufferTexture, DeviceTimeArrives)
{
  const DepthTarget target(GetTargetFormats()[3], 256, 256, true);
  target.Fill(5);
  const vtkNBufferDepthSource source = this->Inspect();
  EXPECT_EQ(this->Texture->GetDeviceTime(), 0.0);
  vtkNBufferLevels levels;
  for (int i = 0; i < 5; ++i)
  {
    ASSERT_TRUE(this->Texture->Build(
      this->Window, source, 0, 0, 256, 256, 1, AllLevels, vtkNBufferExtremum::Maximum));
    ASSERT_TRUE(this->Texture->Download(this->Window, levels));
  }
  const bool queries = vtkNBufferGL::HasFeature(3, 3, "GL_ARB_timer_query");
  EXPECT_EQ(this->Texture->GetDeviceTime() > 0.0, queries);
  EXPECT_LT(this->Texture->GetDeviceTime(), 1e6);
}
