// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorTarget.h"
#include "DepthTarget.h"
#include "GLStateSnapshot.h"
#include "WindowFixture.h"

#include "vtkNBufferGL.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

class GpuTestNBufferDepthSource : public WindowFixture
{
protected:
  GpuTestNBufferDepthSource()
    : WindowFixture(64, 48)
  {
  }

  std::string Why;
};

namespace
{
/// What OpenGL itself reads as floats.
std::vector<float> ReadFloats(int x, int y, int width, int height)
{
  std::vector<float> depth(static_cast<std::size_t>(width) * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(x, y, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  return depth;
}

/// All formats in textures and in renderbuffers.
template <typename Function>
void ForEachTarget(int width, int height, Function&& function)
{
  for (const TargetFormat& format : GetTargetFormats())
  {
    for (const bool texture : { true, false })
    {
      SCOPED_TRACE(std::string(format.Name) + (texture ? " texture" : " renderbuffer"));
      const DepthTarget target(format, width, height, texture);
      ASSERT_TRUE(target.IsComplete());
      function(format, target, texture);
    }
  }
}
}

TEST_F(GpuTestNBufferDepthSource, WindowIsInspectedAndRead)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(0.25, 0.5, 1.0, 1.0);
  AddCone(renderer);
  this->Window->AddRenderer(renderer);

  vtkNBufferDepthSource source;
  std::vector<float> depth;
  std::vector<float> floats;
  WhileDrawing(this->Window, renderer,
    [&]()
    {
      source = this->Inspect();
      depth = this->Read(source, { 16, 24, 64, 48 });
      floats = ReadFloats(16, 24, 48, 24);
    });
  ASSERT_EQ(depth.size(), floats.size());
  EXPECT_EQ(
    std::vector<int>(source.Viewport, source.Viewport + 4), (std::vector<int>{ 16, 24, 48, 24 }));
  EXPECT_EQ(source.Width, 64);
  EXPECT_EQ(source.Height, 48);
  EXPECT_LE(source.Samples, 1);
  EXPECT_GE(source.DepthBits, 16);
  EXPECT_EQ(source.Stored, vtkNBufferStoredDepth::Ordinary);

  int drawn = 0;
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    EXPECT_GE(depth[i], std::nextafter(floats[i], 0.0f));
    EXPECT_LE(depth[i] - floats[i], std::ldexp(1.0, -23));
    drawn += depth[i] < 1.0f;
  }
  EXPECT_GT(drawn, 50);
  EXPECT_LT(drawn, 48 * 24);
}

TEST_F(GpuTestNBufferDepthSource, EveryFormatIsInspected)
{
  ForEachTarget(21, 13,
    [this](const TargetFormat& format, const DepthTarget& target, bool texture)
    {
      target.Bind(3, 4, 10, 9);
      const vtkNBufferDepthSource source = this->Inspect();
      const std::string name = format.Name;
      EXPECT_EQ(source.FloatDepth, name.find("32F") != std::string::npos);
      // OpenGL does not require normalised depth of more than 24 bits (4.6, section 9.2.5).
      const int bits = std::stoi(name.substr(5, 2));
      EXPECT_GE(source.DepthBits, source.FloatDepth ? bits : std::min(bits, 24));
      EXPECT_EQ(source.Texture, texture);
      EXPECT_EQ(source.Width, 21);
      EXPECT_EQ(source.Height, 13);
      EXPECT_EQ(source.Viewport[0], 3);
      EXPECT_EQ(source.Viewport[3], 9);
      EXPECT_EQ(source.Places.GetDistanceFromMiddle(), 0.0);
      EXPECT_NE(source.Framebuffer, 0u);
      EXPECT_NE(source.DepthName, 0u);
    });
}

TEST_F(GpuTestNBufferDepthSource, EveryFormatIsReadAndRoundedAsPromised)
{
  ForEachTarget(61, 47,
    [this](const TargetFormat&, const DepthTarget& target, bool)
    {
      target.Fill(7);
      const vtkNBufferDepthSource source = this->Inspect();
      const vtkNBufferRectangle r = { 5, 3, 55, 43 };
      const std::vector<float> up = this->Read(source, r);
      const std::vector<float> down = this->Read(source, r, vtkNBufferExtremum::Minimum);
      const std::vector<float> floats = ReadFloats(5, 3, 50, 40);
      const double step = source.FloatDepth || source.DepthBits <= 16 ? 0.0 : std::ldexp(1.0, -24);
      for (std::size_t i = 0; i < up.size(); ++i)
      {
        ASSERT_GE(up[i], floats[i]) << i;
        ASSERT_LE(up[i] - floats[i], step) << i;
        ASSERT_LE(std::abs(static_cast<double>(down[i]) - floats[i]), step) << i;
        ASSERT_TRUE(down[i] <= floats[i] || source.DepthBits != 32) << i;
        // The float itself may be rounded from 1 - 2^-32.
        ASSERT_TRUE(up[i] == floats[i] || (floats[i] != 0.0f && floats[i] != 1.0f)) << i;
      }
    });
}

TEST_F(GpuTestNBufferDepthSource, KnownIntegersAreReadWithinTheDerivedError)
{
  constexpr int side = 50;
  for (const int bits : { 16, 24 })
  {
    SCOPED_TRACE(bits);
    const DepthTarget target(GetTargetFormats()[bits == 16 ? 0 : 1], side, side, true);
    target.Bind(0, 0, side, side);
    const vtkNBufferDepthSource source = this->Inspect();
    if (source.DepthBits != bits)
    {
      continue; // The driver gives more bits than requested.
    }
    const std::int64_t largest = (std::int64_t(1) << bits) - 1;
    std::vector<double> exact;
    // The same fractions of 2^32 - 1, rounded up because some drivers cut the lower bits off.
    std::vector<GLuint> words;
    for (int i = 0; i < side * side; ++i)
    {
      const std::int64_t value = largest * i / (side * side - 1);
      exact.push_back(static_cast<double>(value) / largest);
      words.push_back(static_cast<GLuint>(std::ceil(exact.back() * 4294967295.0)));
    }
    glBindTexture(GL_TEXTURE_2D, source.DepthName);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, side, side, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    const std::vector<float> read = this->Read(source, { 0, 0, side, side });
    const std::vector<float> sampled = target.Fetch();
    const double step = std::ldexp(1.0, -24);
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      ASSERT_GE(read[i], exact[i] - (bits == 24 ? 0.0 : step)) << i;
      ASSERT_LE(read[i], exact[i] + 1.25 * step) << i;
      ASSERT_GE(sampled[i], exact[i] - step) << i;
      ASSERT_LE(sampled[i], exact[i] + 1.25 * step) << i;
    }
  }
}

TEST_F(GpuTestNBufferDepthSource, ReadsWhatSamplersReturn)
{
  for (const TargetFormat& format : GetTargetFormats())
  {
    SCOPED_TRACE(format.Name);
    const DepthTarget target(format, 61, 47, true);
    target.Fill(8);
    const vtkNBufferDepthSource source = this->Inspect();
    const std::vector<float> depth = this->Read(source, { 0, 0, 61, 47 });
    const std::vector<float> sampled = target.Fetch();
    // Either rounds what does not fit a float as it likes, but samplers keep only 23 of 32 bits.
    const double tolerance =
      source.FloatDepth ? 0.0 : std::ldexp(1.0, source.DepthBits <= 24 ? -24 : -23);
    for (std::size_t i = 0; i < depth.size(); ++i)
    {
      ASSERT_LE(std::abs(static_cast<double>(depth[i]) - sampled[i]), tolerance) << i;
    }
  }
}

TEST_F(GpuTestNBufferDepthSource, ChangesNoState)
{
  const DepthTarget target(GetTargetFormats()[2], 20, 10, true);
  target.Fill(1);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  SpoilGLState();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  this->Read(this->Inspect(), { 2, 2, 7, 7 });
  EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

// Hazard: depth is taken for VTK's, or for reversed depth, although a part of the state says
// otherwise. Only two of all combinations are known.
TEST_F(GpuTestNBufferDepthSource, SaysWhatIsStored)
{
  using Stored = vtkNBufferStoredDepth;
  const DepthTarget target(GetTargetFormats()[0], 4, 4, true);
  target.Bind(0, 0, 4, 4);
  const bool hasClipControl = vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control");
  const int before = vtkNBufferGL::GetInteger(GL_DEPTH_FUNC);
  for (const GLenum passes :
    { GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS })
  {
    for (const GLenum mode : { GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE })
    {
      for (const GLenum origin : { GL_LOWER_LEFT, GL_UPPER_LEFT })
      {
        const bool isChanged = mode != GL_NEGATIVE_ONE_TO_ONE || origin != GL_LOWER_LEFT;
        if (isChanged && !hasClipControl)
        {
          continue;
        }
        for (const double far : { 0.5, 1.0 })
        {
          glDepthFunc(passes);
          glDepthRange(0.0, far);
          if (hasClipControl)
          {
            glClipControl(origin, mode);
          }
          const bool isWhole = far == 1.0 && origin == GL_LOWER_LEFT;
          const bool isOrdinary =
            mode == GL_NEGATIVE_ONE_TO_ONE && (passes == GL_LEQUAL || passes == GL_LESS);
          const bool isReversed = mode == GL_ZERO_TO_ONE && passes == GL_GEQUAL;
          EXPECT_EQ(this->Inspect().Stored,
            !isWhole       ? Stored::Other
              : isOrdinary ? Stored::Ordinary
              : isReversed ? Stored::Reversed
                           : Stored::Other)
            << passes << " " << mode << " " << origin << " " << far;
        }
      }
    }
  }
  if (hasClipControl)
  {
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  glDepthRange(0.0, 1.0);
  glDepthFunc(before);
}

TEST_F(GpuTestNBufferDepthSource, RefusesRectanglesOutside)
{
  const DepthTarget target(GetTargetFormats()[0], 10, 8, true);
  target.Bind(0, 0, 10, 8);
  const vtkNBufferDepthSource source = this->Inspect();
  std::vector<float> depth;
  EXPECT_TRUE(source.Read(this->Window, 0, 0, 10, 8, depth, this->Why));
  for (const auto& r : { vtkNBufferRectangle{ -1, 0, 4, 4 }, vtkNBufferRectangle{ 0, -1, 4, 4 },
         vtkNBufferRectangle{ 7, 0, 4, 4 }, vtkNBufferRectangle{ 0, 5, 4, 4 },
         vtkNBufferRectangle{ 0, 0, 0, 4 }, vtkNBufferRectangle{ 0, 0, 4, -2 } })
  {
    this->Why.clear();
    EXPECT_FALSE(source.Read(this->Window, r.X0, r.Y0, r.X1, r.Y1, depth, this->Why));
    EXPECT_NE(this->Why.find("outside"), std::string::npos);
  }
}

TEST_F(GpuTestNBufferDepthSource, TellsWhetherItHoldsTheViewport)
{
  const DepthTarget target(GetTargetFormats()[0], 10, 7, true);
  const auto holds = [&](int x, int y, int width, int height)
  {
    target.Bind(x, y, width, height);
    return this->Inspect().HoldsViewport();
  };
  EXPECT_TRUE(holds(0, 0, 10, 7));
  EXPECT_TRUE(holds(9, 6, 1, 1));
  EXPECT_TRUE(holds(3, 2, 7, 5));
  EXPECT_FALSE(holds(-1, 0, 4, 4));
  EXPECT_FALSE(holds(0, -1, 4, 4));
  EXPECT_FALSE(holds(3, 2, 8, 5));
  EXPECT_FALSE(holds(3, 2, 7, 6));
  EXPECT_FALSE(holds(10, 0, 1, 1));
}

TEST_F(GpuTestNBufferDepthSource, SamplesArePlacedAndNotRead)
{
  const DepthTarget target(GetTargetFormats()[1], 10, 8, true, 4);
  if (target.GetSamples() < 2)
  {
    GTEST_SKIP() << "the driver offers no multisampled depth textures";
  }
  target.Bind(0, 0, 10, 8);
  const vtkNBufferDepthSource source = this->Inspect();
  EXPECT_EQ(source.Samples, target.GetSamples());
  double distance = 0.0;
  for (int i = 0; i < source.Samples; ++i)
  {
    float place[2];
    glGetMultisamplefv(GL_SAMPLE_POSITION, i, place);
    distance = std::max({ distance, std::abs(place[0] - 0.5), std::abs(place[1] - 0.5) });
  }
  EXPECT_GT(distance, 0.0);
  EXPECT_EQ(source.Places.GetDistanceFromMiddle(), distance) << "the target's samples are fixed";
  std::vector<float> depth;
  EXPECT_FALSE(source.Read(this->Window, 0, 0, 10, 8, depth, this->Why));
  EXPECT_NE(this->Why.find("ultisampled"), std::string::npos);
}

TEST_F(GpuTestNBufferDepthSource, RefusesWhatHasNoDepth)
{
  const ColorTarget target(4, 4);

  vtkNBufferDepthSource source;
  source.DepthBits = 24;
  EXPECT_FALSE(source.Inspect(this->Window, this->Why));
  EXPECT_NE(this->Why.find("no depth buffer"), std::string::npos);
  EXPECT_EQ(source.DepthBits, 0);
  std::vector<float> depth;
  EXPECT_FALSE(source.Read(this->Window, 0, 0, 1, 1, depth, this->Why));

  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
  EXPECT_FALSE(source.Inspect(this->Window, this->Why));
  EXPECT_NE(this->Why.find("incomplete"), std::string::npos);
}

TEST_F(GpuTestNBufferDepthSource, RefusesLayersOfTextures)
{
  GLuint texture = 0;
  GLuint framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, 4, 4, 3, 0, GL_DEPTH_COMPONENT,
    GL_FLOAT, nullptr);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, 2);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  vtkNBufferDepthSource source;
  EXPECT_FALSE(source.Inspect(this->Window, this->Why));
  EXPECT_NE(this->Why.find("layered"), std::string::npos);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
}

TEST_F(GpuTestNBufferDepthSource, RefusesWindowsWithoutContext)
{
  vtkNBufferDepthSource source;
  EXPECT_FALSE(source.Inspect(nullptr, this->Why));
  auto base = vtkSmartPointer<vtkRenderWindow>::New();
  EXPECT_FALSE(source.Inspect(vtkOpenGLRenderWindow::SafeDownCast(base), this->Why));
  EXPECT_NE(this->Why.find("context"), std::string::npos);
}
