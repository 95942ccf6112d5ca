// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkShadowTarget and vtkShadowCounter: exact counts and masks, within the viewport and nowhere
// else, whatever the state before.
#include "vtkShadowCounter.h"
#include "vtkShadowTarget.h"

#include "GLStateSnapshot.h"
#include "WindowFixture.h"
#include "vtkShadowSilhouette.h"
#include "vtkShadowTopology.h"
#include "vtkShadowVolume.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr int Width = 40;
constexpr int Height = 30;
constexpr int Viewport[4] = { 7, 5, 21, 15 };
constexpr unsigned char Sentinel = 0x55;
const vtkShadowTarget::SamplePlaces Centre = { { { 0.5, 0.5 } } };

/// A volume over x in (-0.5, 0.5), y in (-0.3, 0.3), z in (-0.2, 0.2) that goes from left to right,
/// so many times.
vtkShadowVolume MakeVolume(int copies)
{
  std::vector<glm::dvec3> points;
  for (double x : { -0.9, -0.7 })
  {
    for (double y : { -0.3, 0.3 })
    {
      for (double z : { -0.2, 0.2 })
      {
        points.emplace_back(x, y, z);
      }
    }
  }
  const std::vector<vtkIdType> triangles = { 0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
    2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3 };
  vtkShadowTopology topology;
  topology.Build(points, triangles);
  vtkShadowLight light;
  light.Direction[0] = 1.0;
  light.Direction[2] = 0.0;
  vtkShadowSilhouette silhouette;
  silhouette.Compute(topology, topology.GetPoints(), light, vtkShadowCounting::Away);
  vtkShadowVolume volume;
  volume.Begin(glm::dvec3(0.0));
  for (int i = 0; i < copies; ++i)
  {
    volume.AddClamped(
      silhouette, topology.GetPoints(), vtkShadowLightSpace(light), { -0.5, 0.5 }, -0.7);
  }
  return volume;
}

/// Pixels of the viewport whose centres are in the volume's rectangle, and its three columns: the
/// receivers lie before it, in it and behind it.
bool IsInVolume(int x, int y)
{
  const double u = 2.0 * (x + 0.5) / Viewport[2] - 1.0;
  const double v = 2.0 * (y + 0.5) / Viewport[3] - 1.0;
  return u > -0.5 && u < 0.5 && v > -0.3 && v < 0.3;
}
constexpr float Depths[] = { 0.2f, 0.5f, 0.8f };
int GetColumn(int x)
{
  return 3 * x / Viewport[2];
}
}

class GpuTestShadowCounter : public WindowFixture
{
protected:
  void SetUp() override
  {
    WindowFixture::SetUp();
    if (!this->Window)
    {
      return;
    }
    std::string why;
    ASSERT_TRUE(this->Target.Reserve(this->Window, Width, Height, 2, Centre, why)) << why;
    this->Fill();
  }

  void TearDown() override
  {
    if (this->Window)
    {
      this->Counter.Release();
      this->Target.Release();
    }
  }

  /// Sentinels everywhere, and the receivers' depths in the viewport.
  void Fill() const
  {
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glStencilMask(0xff);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const float color[4] = { Sentinel / 255.0f, Sentinel / 255.0f, Sentinel / 255.0f,
      Sentinel / 255.0f };
    for (int mask = 0; mask < this->Target.GetNumberOfMasks(); ++mask)
    {
      glBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetMaskFramebuffer(mask));
      glClearBufferfv(GL_COLOR, 0, color);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetDepthFramebuffer());
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.3f, Sentinel);
    glEnable(GL_SCISSOR_TEST);
    for (int column = 0; column < 3; ++column)
    {
      glScissor(Viewport[0] + 7 * column, Viewport[1], 7, Viewport[3]);
      glClearBufferfv(GL_DEPTH, 0, &Depths[column]);
    }
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  template <typename T>
  static std::vector<T> Read(unsigned int framebuffer, GLenum format, GLenum type, int channels)
  {
    std::vector<T> result(static_cast<std::size_t>(Width) * Height * channels);
    UnspoilGLState();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, Width, Height, format, type, result.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return result;
  }

  /// Each pixel of the viewport has what `expected` says, each other one the sentinel.
  void ExpectStencil(const std::function<int(int, int)>& expected) const
  {
    const auto stencil = Read<unsigned char>(
      this->Target.GetDepthFramebuffer(), GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
    this->ExpectPixels(stencil, 1, 0, expected, "stencil");
  }
  void ExpectMask(int mask, int channel, const std::function<int(int, int)>& expected) const
  {
    const auto pixels =
      Read<unsigned char>(this->Target.GetMaskFramebuffer(mask), GL_RGBA, GL_UNSIGNED_BYTE, 4);
    this->ExpectPixels(pixels, 4, channel, expected,
      "mask " + std::to_string(mask) + ", channel " + std::to_string(channel));
  }

  static void ExpectPixels(const std::vector<unsigned char>& pixels, int channels, int channel,
    const std::function<int(int, int)>& expected, const std::string& what)
  {
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const int inX = x - Viewport[0];
        const int inY = y - Viewport[1];
        const bool inside = inX >= 0 && inX < Viewport[2] && inY >= 0 && inY < Viewport[3];
        ASSERT_EQ(static_cast<int>(pixels[channels * (y * Width + x) + channel]),
          inside ? expected(inX, inY) : Sentinel)
          << what << " at (" << x << ", " << y << ")";
      }
    }
  }

  /// All of a volume as one draw.
  static vtkShadowDraw MakeDraw(const vtkShadowVolume& volume, bool zPass)
  {
    vtkShadowDraw draw;
    draw.NumberOfIndices = static_cast<int>(volume.GetIndices().size());
    draw.ZPass = zPass;
    std::copy_n(Viewport, 4, draw.Box);
    return draw;
  }

  void Count(const vtkShadowVolume& volume, const std::vector<vtkShadowDraw>& draws, int start = 0,
    long long* fragments = nullptr)
  {
    // The eye looks along -z.
    const double volumeToClip[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1 };
    std::string why;
    ASSERT_TRUE(this->Counter.Upload(volume, why)) << why;
    const vtkShadowCounter::Scope scope(this->Window, Viewport);
    this->Counter.ClearStencil(this->Target, Viewport, start);
    ASSERT_TRUE(this->Counter.Count(this->Window, this->Target, volumeToClip, draws.data(),
      draws.data() + draws.size(), fragments, why))
      << why;
  }

  vtkShadowTarget Target;
  vtkShadowCounter Counter;
};

TEST_F(GpuTestShadowCounter, TargetsGrowAndKeepBindings)
{
  const int allocations = this->Target.GetNumberOfAllocations();
  std::string why;
  ASSERT_TRUE(this->Target.Reserve(this->Window, Width, 1, 1, Centre, why));
  EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations);
  EXPECT_EQ(this->Target.GetHeight(), Height);
  EXPECT_EQ(this->Target.GetNumberOfMasks(), 2);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  ASSERT_TRUE(this->Target.Reserve(this->Window, Width, Height, 3, Centre, why));
  EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations + 1);
  ASSERT_TRUE(this->Target.Reserve(this->Window, 1, Height + 5, 1, Centre, why));
  EXPECT_EQ(this->Target.GetWidth(), Width);
  EXPECT_EQ(this->Target.GetHeight(), Height + 5);
  EXPECT_EQ(this->Target.GetNumberOfMasks(), 3);
  EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations + 5) << "depth and three masks";
  // VTK's own textures stay bound to the unit in which they were allocated.
  std::istringstream lines(before.GetDifference(GLStateSnapshot::Capture(this->Window)));
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_EQ(line.find("GL_TEXTURE_BINDING_2D of unit 0"), 0u) << line;
  }
  this->Target.Release();
  EXPECT_EQ(this->Target.GetDepthFramebuffer(), 0u);
  EXPECT_EQ(this->Target.GetNumberOfMasks(), 0);
  EXPECT_EQ(this->Target.GetWidth(), 0);
}

// Hazard: what OpenGL refuses must not leave half a target.
TEST_F(GpuTestShadowCounter, TooLargeTargetsAreRefused)
{
  int maximum = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maximum);
  std::string why;
#ifdef GL_DEBUG_OUTPUT
  glDisable(GL_DEBUG_OUTPUT);
#endif
  EXPECT_FALSE(this->Target.Reserve(this->Window, 2 * maximum, 1, 1, Centre, why));
  EXPECT_NE(why, "");
  EXPECT_EQ(this->Target.GetDepthFramebuffer(), 0u);
  ASSERT_TRUE(this->Target.Reserve(this->Window, Width, Height, 1, Centre, why)) << why;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(GpuTestShadowCounter, ClearsTheViewportOnly)
{
  {
    const vtkShadowCounter::Scope scope(this->Window, Viewport);
    this->Counter.ClearMask(this->Target, 1, Viewport);
    this->Counter.ClearStencil(this->Target, Viewport, 258);
  }
  this->ExpectStencil([](int, int) { return 2; });
  for (int channel = 0; channel < 4; ++channel)
  {
    this->ExpectMask(0, channel, [](int, int) { return Sentinel; });
    this->ExpectMask(1, channel, [](int, int) { return 0; });
  }
}

// Only receivers in the volume are counted, on the way to them as well as behind them.
TEST_F(GpuTestShadowCounter, CountsReceiversInTheVolume)
{
  const vtkShadowVolume volume = MakeVolume(1);
  for (const bool zPass : { false, true })
  {
    SCOPED_TRACE(zPass ? "z-pass" : "z-fail");
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, zPass) }));
    this->ExpectStencil([](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 1 : 0; });
  }
}

// Counts are modulo 256 in both directions, on top of what they begin with.
TEST_F(GpuTestShadowCounter, CountsWrap)
{
  for (const int copies : { 255, 256, 300 })
  {
    const vtkShadowVolume volume = MakeVolume(copies);
    for (const bool zPass : { false, true })
    {
      SCOPED_TRACE(std::to_string(copies) + (zPass ? " z-pass" : " z-fail"));
      ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, zPass) }, 7));
      this->ExpectStencil([&](int x, int y)
        { return (7 + (IsInVolume(x, y) && GetColumn(x) == 1 ? copies : 0)) % 256; });
    }
  }
}

// Draws keep to their boxes, and both ways of counting add up.
TEST_F(GpuTestShadowCounter, DrawsKeepToTheirBoxes)
{
  const vtkShadowVolume volume = MakeVolume(2);
  const int half = static_cast<int>(volume.GetIndices().size()) / 2;
  std::vector<vtkShadowDraw> draws(2, MakeDraw(volume, true));
  draws[0].NumberOfIndices = draws[1].NumberOfIndices = draws[1].FirstIndex = half;
  draws[1].ZPass = false;
  draws[1].Box[0] += 10;
  draws[1].Box[1] += 6;
  draws[1].Box[2] = 2;
  draws[1].Box[3] = 2;
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, draws));
  this->ExpectStencil(
    [](int x, int y)
    {
      const bool inBox = x >= 10 && x < 12 && y >= 6 && y < 8;
      return IsInVolume(x, y) && GetColumn(x) == 1 ? 1 + inBox : 0;
    });
}

TEST_F(GpuTestShadowCounter, FragmentsAreThoseOfAllFaces)
{
  const vtkShadowVolume volume = MakeVolume(1);
  long long fragments = 5;
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }, 0, &fragments));
  int covered = 0;
  for (int y = 0; y < Viewport[3]; ++y)
  {
    for (int x = 0; x < Viewport[2]; ++x)
    {
      covered += IsInVolume(x, y);
    }
  }
  // The front and the back; all others are seen edge-on.
  EXPECT_EQ(fragments, 5 + 2 * covered);
  this->ExpectStencil([](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 1 : 0; });
}

// A channel is darkened where the count is not 0; the others, other masks and the stencil stay.
TEST_F(GpuTestShadowCounter, ResolvesOneChannel)
{
  const vtkShadowVolume volume = MakeVolume(3);
  for (int channel = 0; channel < 4; ++channel)
  {
    SCOPED_TRACE(channel);
    this->Fill();
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, true) }));
    std::string why;
    {
      const vtkShadowCounter::Scope scope(this->Window, Viewport);
      ASSERT_TRUE(this->Counter.Resolve(this->Window, this->Target, 1, channel, Viewport, why))
        << why;
    }
    for (int other = 0; other < 4; ++other)
    {
      this->ExpectMask(0, other, [](int, int) { return Sentinel; });
      this->ExpectMask(1, other,
        [&](int x, int y) {
          return other == channel && IsInVolume(x, y) && GetColumn(x) == 1 ? 255 : int(Sentinel);
        });
    }
    this->ExpectStencil([](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 3 : 0; });
  }
}

// Whatever the state was, counts are right and the state is as it was.
TEST_F(GpuTestShadowCounter, StateIsSetAndRestored)
{
  const vtkShadowVolume volume = MakeVolume(1);
  // Objects are made in the first use.
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }));
  std::string why;
  {
    const vtkShadowCounter::Scope scope(this->Window, Viewport);
    ASSERT_TRUE(this->Counter.Resolve(this->Window, this->Target, 0, 0, Viewport, why)) << why;
  }
  for (const bool spoiled : { false, true })
  {
    SCOPED_TRACE(spoiled ? "spoiled" : "plain");
    this->Fill();
    if (spoiled)
    {
      SpoilGLState();
      glDisable(GL_RASTERIZER_DISCARD);
      glEnable(GL_POLYGON_OFFSET_FILL);
      glPolygonOffset(3.0f, 5.0f);
      glStencilFuncSeparate(GL_BACK, GL_LESS, 9, 0x0f);
      glStencilMaskSeparate(GL_BACK, 0x3c);
      glClearStencil(77);
    }
    const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
    {
      const vtkShadowCounter::Scope scope(this->Window, Viewport);
      this->Counter.ClearMask(this->Target, 0, Viewport);
    }
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }));
    {
      const vtkShadowCounter::Scope scope(this->Window, Viewport);
      ASSERT_TRUE(this->Counter.Resolve(this->Window, this->Target, 0, 2, Viewport, why)) << why;
    }
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, 0.0f);
    glStencilMask(0xff);
    glClearStencil(0);
    this->ExpectStencil([](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 1 : 0; });
    this->ExpectMask(
      0, 2, [](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 255 : 0; });
  }
}

// Hazard: names of a context that is gone, or of another one, are used again.
TEST_F(GpuTestShadowCounter, WorksAgainAfterRelease)
{
  const vtkShadowVolume volume = MakeVolume(1);
  for (int round = 0; round < 2; ++round)
  {
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, true) }));
    this->ExpectStencil([](int x, int y) { return IsInVolume(x, y) && GetColumn(x) == 1 ? 1 : 0; });
    this->Counter.Release();
    this->Target.Release();
    this->Counter.Release();
    this->Target.Release();
    this->Window = nullptr;
    this->Window = NewWindow(16, 16);
    std::string why;
    ASSERT_TRUE(this->Target.Reserve(this->Window, Width, Height, 2, Centre, why)) << why;
    this->Fill();
  }
}
