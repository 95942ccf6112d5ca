// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkShadowTarget and vtkShadowSampleReader with multisampling: every sample has its own depth,
// count and mask.
#include "DepthTarget.h"
#include "GLStateSnapshot.h"
#include "ShadowFixture.h"
#include "vtkShadowTarget.h"

#include <functional>
#include <string>
#include <vector>

namespace
{
constexpr int SamplesWidth = 37;
constexpr int SamplesHeight = 29;
constexpr int SamplesViewport[4] = { 5, 3, 23, 17 };

const TargetFormat& GetFormat()
{
  const std::vector<TargetFormat>& formats = GetTargetFormats();
  return *std::find_if(formats.begin(), formats.end(),
    [](const TargetFormat& format) { return std::string(format.Name) == "Depth24Stencil8"; });
}
}

class GpuTestShadowSamples : public ShadowFixture
{
protected:
  void SetUp() override
  {
    ShadowFixture::SetUp();
    if (this->Window && vtkNBufferGL::GetInteger(GL_MAX_SAMPLES) < 2)
    {
      GTEST_SKIP() << "The renderer has no multisampling.";
    }
  }

  void TearDown() override
  {
    ShadowFixture::TearDown();
    if (this->Window)
    {
      this->Reader.Release();
      this->Target.Release();
    }
  }

  /// function(depth target, its samples) for each number of samples that the driver has.
  void ForEachCount(
    const std::function<void(const DepthTarget&, const vtkShadowTarget::SamplePlaces&)>& function)
  {
    int last = 1;
    for (const int count : { 2, 4, 8, 16 })
    {
      const DepthTarget target(GetFormat(), SamplesWidth, SamplesHeight, true, count);
      if (!target.IsComplete() || target.GetSamples() == last)
      {
        continue;
      }
      last = target.GetSamples();
      SCOPED_TRACE(std::to_string(last) + " samples");
      target.Bind(SamplesViewport[0], SamplesViewport[1], SamplesViewport[2], SamplesViewport[3]);
      const vtkShadowTarget::SamplePlaces places = vtkNBufferGL::GetSamplePlaces();
      ASSERT_EQ(static_cast<int>(places.size()), last);
      function(target, places);
    }
    EXPECT_GT(last, 1) << "no multisampling at all";
  }

  /// A channel of one sample of a multisampled texture.
  std::vector<float> ReadSample(unsigned int texture, int sample, int channel, const int box[4])
  {
    std::vector<float> values(static_cast<std::size_t>(box[2]) * box[3]);
    EXPECT_TRUE(
      this->Reader.Read(this->Window, texture, sample, channel, box, values.data(), this->Why))
      << this->Why;
    return values;
  }

  vtkShadowTarget Target;
  vtkShadowSampleReader Reader;
};

TEST_F(GpuTestShadowSamples, ReaderReadsWhatSamplersReturn)
{
  this->ForEachCount(
    [&](const DepthTarget& depth, const vtkShadowTarget::SamplePlaces& places)
    {
      depth.Fill(7);
      depth.Bind(SamplesViewport[0], SamplesViewport[1], SamplesViewport[2], SamplesViewport[3]);
      const vtkNBufferDepthSource source = this->Inspect();
      for (int sample = 0; sample < static_cast<int>(places.size()); ++sample)
      {
        const std::vector<float> read =
          this->ReadSample(source.DepthName, sample, 0, SamplesViewport);
        const std::vector<float> expected = depth.Fetch(sample);
        for (const auto& [x, y] : Pixels(SamplesViewport[2], SamplesViewport[3]))
        {
          ASSERT_EQ(read[y * SamplesViewport[2] + x],
            expected[(y + SamplesViewport[1]) * SamplesWidth + x + SamplesViewport[0]])
            << "sample " << sample << " at (" << x << ", " << y << ")";
        }
      }
    });
}

TEST_F(GpuTestShadowSamples, ReaderKeepsTheState)
{
  this->ForEachCount(
    [&](const DepthTarget& depth, const vtkShadowTarget::SamplePlaces&)
    {
      depth.Fill(3);
      depth.Bind(0, 0, SamplesWidth, SamplesHeight);
      const vtkNBufferDepthSource source = this->Inspect();
      const std::vector<float> plain = this->ReadSample(source.DepthName, 1, 0, SamplesViewport);
      SpoilGLState();
      const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
      const std::vector<float> spoiled = this->ReadSample(source.DepthName, 1, 0, SamplesViewport);
      EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
      UnspoilGLState();
      EXPECT_EQ(plain, spoiled);
    });
}

// Each sample has its own count, where the sides of a volume cross pixels, and only in the
// viewport.
TEST_F(GpuTestShadowSamples, CountsAndMasksAreBySample)
{
  // Its shadow, along x: x in (-0.51, 0.47), y in (-0.31, 0.29), z in (-0.2, 0.2).
  const ShadowMesh caster = MakeOpenRectangle().Move(
    [](const glm::dvec3& x) { return glm::dvec3(-0.9, 0.3 * x.x - 0.01, 0.2 * x.y); });
  const vtkShadowVolumeStore volume = MakeVolume(caster, { 1.0, 0.0, 0.0 }, { -0.51, 0.47 });
  vtkShadowDraw draw = MakeDraw(volume, SamplesViewport);

  this->ForEachCount(
    [&](const DepthTarget&, const vtkShadowTarget::SamplePlaces& places)
    {
      for (const bool zPass : { false, true })
      {
        SCOPED_TRACE(zPass ? "z-pass" : "z-fail");
        draw.ZPass = zPass;
        ASSERT_TRUE(
          this->Target.Reserve(this->Window, SamplesWidth, SamplesHeight, 2, places, this->Why))
          << this->Why;
        ASSERT_FALSE(this->Target.HasRefusedSamples()) << this->Why;
        EXPECT_EQ(this->Target.GetSamples(), places);
        UnspoilGLState();
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetDepthFramebuffer());
        glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.5f, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetMaskFramebuffer(1));
        const float half[4] = { 0.5f, 0.5f, 0.5f, 0.5f };
        glClearBufferfv(GL_COLOR, 0, half);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        // What keeps samples from being written.
        glEnable(GL_SAMPLE_MASK);
        glSampleMaski(0, 1);
        glDisable(GL_MULTISAMPLE);
        const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
        ASSERT_TRUE(this->Volume.Upload(volume, this->Why)) << this->Why;
        {
          const vtkShadowCounter::Scope scope(this->Window, SamplesViewport);
          this->Counter.ClearMask(this->Target, 1, SamplesViewport);
          this->Counter.ClearStencil(this->Target, SamplesViewport);
          ASSERT_TRUE(this->Counter.Count(this->Window, this->Target, this->Volume,
            MakeView(SamplesViewport), &draw, &draw + 1, nullptr, this->Why))
            << this->Why;
          ASSERT_TRUE(
            this->Counter.Resolve(this->Window, this->Target, 1, 2, SamplesViewport, this->Why))
            << this->Why;
        }
        EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
        glDisable(GL_SAMPLE_MASK);
        glSampleMaski(0, ~0u);
        glEnable(GL_MULTISAMPLE);

        const int all[4] = { 0, 0, SamplesWidth, SamplesHeight };
        const vtkNBufferRectangle viewport = { SamplesViewport[0], SamplesViewport[1],
          SamplesViewport[0] + SamplesViewport[2], SamplesViewport[1] + SamplesViewport[3] };
        int mixed = 0;
        std::vector<int> shadowed(static_cast<std::size_t>(SamplesWidth) * SamplesHeight, 0);
        for (std::size_t sample = 0; sample < places.size(); ++sample)
        {
          const std::vector<float> mask = this->ReadSample(
            this->Target.GetMask(1)->GetHandle(), static_cast<int>(sample), 2, all);
          for (const auto& [x, y] : Pixels(SamplesWidth, SamplesHeight))
          {
            const double u =
              2.0 * (x - SamplesViewport[0] + places[sample][0]) / SamplesViewport[2] - 1.0;
            const double v =
              2.0 * (y - SamplesViewport[1] + places[sample][1]) / SamplesViewport[3] - 1.0;
            const float value = mask[y * SamplesWidth + x];
            // Some samples lie on the edge of their pixel, so that u and v do not tell.
            if (!IsIn(x, y, viewport))
            {
              ASSERT_NEAR(value, 0.5f, 0.01f) << "at (" << x << ", " << y << ")";
              continue;
            }
            const bool inVolume = u > -0.51 && u < 0.47 && v > -0.31 && v < 0.29;
            ASSERT_EQ(value, inVolume ? 1.0f : 0.0f)
              << "sample " << sample << " at (" << x << ", " << y << ")";
            shadowed[y * SamplesWidth + x] += inVolume;
          }
        }
        for (const int count : shadowed)
        {
          mixed += count > 0 && count < static_cast<int>(places.size());
        }
        // Two samples of a pixel may lie on the same side of most edges.
        EXPECT_GT(mixed, places.size() > 2 ? 10 : 0);
      }
    });
}

// Textures do not have the wanted number or places of samples: there is one sample for each pixel,
// and OpenGL is not tried again for the same samples.
TEST_F(GpuTestShadowSamples, RefusedSamplesLeaveOneForEachPixel)
{
#ifdef GL_DEBUG_OUTPUT
  glDisable(GL_DEBUG_OUTPUT);
#endif
  const vtkShadowTarget::SamplePlaces centre = { { { 0.5, 0.5 } } };
  const vtkShadowTarget::SamplePlaces many(1000, { 0.5, 0.5 });
  vtkShadowTarget::SamplePlaces elsewhere;
  this->ForEachCount(
    [&](const DepthTarget&, const vtkShadowTarget::SamplePlaces& places) { elsewhere = places; });
  elsewhere[0] = { 0.0, 0.0 };
  for (const vtkShadowTarget::SamplePlaces& wanted : { many, elsewhere })
  {
    this->Why.clear();
    ASSERT_TRUE(
      this->Target.Reserve(this->Window, SamplesWidth, SamplesHeight, 1, wanted, this->Why));
    EXPECT_NE(this->Why, "");
    EXPECT_TRUE(this->Target.HasRefusedSamples());
    EXPECT_FALSE(this->Target.IsMultisampled());
    EXPECT_EQ(this->Target.GetSamples(), centre);
    EXPECT_EQ(this->Target.GetDepth(), nullptr);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    const int allocations = this->Target.GetNumberOfAllocations();
    ASSERT_TRUE(
      this->Target.Reserve(this->Window, SamplesWidth, SamplesHeight, 1, wanted, this->Why));
    EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations);
    // Larger, and still not.
    ASSERT_TRUE(
      this->Target.Reserve(this->Window, SamplesWidth + 1, SamplesHeight, 1, wanted, this->Why));
    EXPECT_TRUE(this->Target.HasRefusedSamples());
    ASSERT_TRUE(
      this->Target.Reserve(this->Window, SamplesWidth, SamplesHeight, 1, centre, this->Why));
    EXPECT_FALSE(this->Target.HasRefusedSamples());
    this->Target.Release();
  }
}
