// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkShadowTarget and vtkShadowCounter: exact counts and masks, within the viewport and nowhere
// else, whatever the state before.
#include "GLStateSnapshot.h"
#include "ShadowFixture.h"
#include "vtkShadowTarget.h"

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr int CounterWidth = 40;
constexpr int CounterHeight = 30;
constexpr int CounterViewport[4] = { 7, 5, 21, 15 };
constexpr unsigned char Sentinel = 0x55;
const vtkShadowTarget::SamplePlaces Centre = { { { 0.5, 0.5 } } };

/// The receivers lie in three columns of the viewport: before the volume, in it and behind it.
constexpr float Depths[] = { 0.2f, 0.5f, 0.8f };
int GetColumn(int x)
{
  return 3 * x / CounterViewport[2];
}
}

class GpuTestShadowCounter : public ShadowFixture
{
protected:
  void SetUp() override
  {
    ShadowFixture::SetUp();
    if (this->Window)
    {
      this->Reserve();
    }
  }

  void Reserve()
  {
    ASSERT_TRUE(
      this->Target.Reserve(this->Window, CounterWidth, CounterHeight, 2, Centre, this->Why))
      << this->Why;
    this->Fill();
  }

  void TearDown() override
  {
    ShadowFixture::TearDown();
    if (this->Window)
    {
      this->Target.Release();
    }
  }

  /// A volume over x in (-0.5, 0.5), y in (-0.3, 0.3), z in (-0.2, 0.2) that goes from left to
  /// right, so many times.
  static vtkShadowVolumeStore MakeVolume(int copies)
  {
    return ShadowFixture::MakeVolume(MakeBlock({ -0.9, -0.3, -0.2 }, { -0.7, 0.3, 0.2 }),
      { 1.0, 0.0, 0.0 }, { -0.5, 0.5 }, copies);
  }

  /// Adds one more.
  static void AddVolume(vtkShadowVolumeStore& store)
  {
    AddPiece(
      store, MakeBlock({ -0.9, -0.3, -0.2 }, { -0.7, 0.3, 0.2 }), { 1.0, 0.0, 0.0 }, { -0.5, 0.5 });
  }

  /// Whether the receiver of a pixel of the viewport is in the volume.
  static bool IsShadowed(int x, int y)
  {
    return IsInVolume(x, y, CounterViewport) && GetColumn(x) == 1;
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
      glScissor(CounterViewport[0] + 7 * column, CounterViewport[1], 7, CounterViewport[3]);
      glClearBufferfv(GL_DEPTH, 0, &Depths[column]);
    }
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }

  template <typename T>
  static std::vector<T> Read(unsigned int framebuffer, GLenum format, GLenum type, int channels)
  {
    std::vector<T> result(static_cast<std::size_t>(CounterWidth) * CounterHeight * channels);
    UnspoilGLState();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, CounterWidth, CounterHeight, format, type, result.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return result;
  }

  /// Each pixel of the viewport has what `expected` says, each other one the sentinel.
  void ExpectStencil(const std::function<int(int, int)>& expected) const
  {
    const auto stencil = Read<unsigned char>(
      this->Target.GetDepthFramebuffer(), GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1);
    SCOPED_TRACE("stencil");
    ExpectPixels(stencil, 1, 0, expected);
  }
  void ExpectMask(int mask, int channel, const std::function<int(int, int)>& expected) const
  {
    const auto pixels =
      Read<unsigned char>(this->Target.GetMaskFramebuffer(mask), GL_RGBA, GL_UNSIGNED_BYTE, 4);
    SCOPED_TRACE("mask " + std::to_string(mask) + ", channel " + std::to_string(channel));
    ExpectPixels(pixels, 4, channel, expected);
  }

  static void ExpectPixels(const std::vector<unsigned char>& pixels, int channels, int channel,
    const std::function<int(int, int)>& expected)
  {
    for (const auto& [x, y] : Pixels(CounterWidth, CounterHeight))
    {
      const int inX = x - CounterViewport[0];
      const int inY = y - CounterViewport[1];
      const bool inside = IsIn(inX, inY, { 0, 0, CounterViewport[2], CounterViewport[3] });
      ASSERT_EQ(static_cast<int>(pixels[channels * (y * CounterWidth + x) + channel]),
        inside ? expected(inX, inY) : Sentinel)
        << "at (" << x << ", " << y << ")";
    }
  }

  static vtkShadowDraw MakeDraw(const vtkShadowVolumeStore& volume, bool zPass)
  {
    return ShadowFixture::MakeDraw(volume, CounterViewport, zPass);
  }

  void Count(const vtkShadowVolumeStore& volume, const std::vector<vtkShadowDraw>& draws,
    long long* fragments = nullptr)
  {
    ASSERT_TRUE(this->Volume.Upload(volume, this->Why)) << this->Why;
    const vtkShadowCounter::Scope scope(this->Window, CounterViewport);
    this->Counter.ClearStencil(this->Target, CounterViewport);
    ASSERT_TRUE(this->Counter.Count(this->Window, this->Target, this->Volume,
      MakeView(CounterViewport), draws.data(), draws.data() + draws.size(), fragments, this->Why))
      << this->Why;
  }

  void Resolve(int mask, int channel)
  {
    const vtkShadowCounter::Scope scope(this->Window, CounterViewport);
    ASSERT_TRUE(
      this->Counter.Resolve(this->Window, this->Target, mask, channel, CounterViewport, this->Why))
      << this->Why;
  }

  vtkShadowTarget Target;
};

TEST_F(GpuTestShadowCounter, TargetsGrowAndKeepBindings)
{
  const int allocations = this->Target.GetNumberOfAllocations();
  ASSERT_TRUE(this->Target.Reserve(this->Window, CounterWidth, 1, 1, Centre, this->Why));
  EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations);
  EXPECT_EQ(this->Target.GetHeight(), CounterHeight);
  EXPECT_EQ(this->Target.GetNumberOfMasks(), 2);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  ASSERT_TRUE(
    this->Target.Reserve(this->Window, CounterWidth, CounterHeight, 3, Centre, this->Why));
  EXPECT_EQ(this->Target.GetNumberOfAllocations(), allocations + 1);
  ASSERT_TRUE(this->Target.Reserve(this->Window, 1, CounterHeight + 5, 1, Centre, this->Why));
  EXPECT_EQ(this->Target.GetWidth(), CounterWidth);
  EXPECT_EQ(this->Target.GetHeight(), CounterHeight + 5);
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

// Hazard: OpenGL refuses a target, and a part of it remains.
TEST_F(GpuTestShadowCounter, TooLargeTargetsAreRefused)
{
  int maximum = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maximum);
#ifdef GL_DEBUG_OUTPUT
  glDisable(GL_DEBUG_OUTPUT);
#endif
  EXPECT_FALSE(this->Target.Reserve(this->Window, 2 * maximum, 1, 1, Centre, this->Why));
  EXPECT_NE(this->Why, "");
  EXPECT_EQ(this->Target.GetDepthFramebuffer(), 0u);
  ASSERT_TRUE(this->Target.Reserve(this->Window, CounterWidth, CounterHeight, 1, Centre, this->Why))
    << this->Why;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(GpuTestShadowCounter, ClearsTheViewportOnly)
{
  {
    const vtkShadowCounter::Scope scope(this->Window, CounterViewport);
    this->Counter.ClearMask(this->Target, 1, CounterViewport);
    this->Counter.ClearStencil(this->Target, CounterViewport);
  }
  this->ExpectStencil([](int, int) { return 0; });
  for (int channel = 0; channel < 4; ++channel)
  {
    this->ExpectMask(0, channel, [](int, int) { return Sentinel; });
    this->ExpectMask(1, channel, [](int, int) { return 0; });
  }
}

// Only receivers in the volume are counted, by z-pass and by z-fail. Counts are modulo 256 in both
// directions.
TEST_F(GpuTestShadowCounter, CountsReceiversInTheVolumeAndWraps)
{
  for (const int copies : { 1, 255, 256, 300 })
  {
    const vtkShadowVolumeStore volume = MakeVolume(copies);
    for (const bool zPass : { false, true })
    {
      SCOPED_TRACE(std::to_string(copies) + (zPass ? " z-pass" : " z-fail"));
      ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, zPass) }));
      this->ExpectStencil([&](int x, int y) { return IsShadowed(x, y) ? copies % 256 : 0; });
    }
  }
}

// Draws change only pixels in their boxes, and draws by z-pass and by z-fail add up.
TEST_F(GpuTestShadowCounter, DrawsKeepToTheirBoxes)
{
  const vtkShadowVolumeStore volume = MakeVolume(2);
  const int half = static_cast<int>(volume.GetVolume().GetIndices().size()) / 2;
  std::vector<vtkShadowDraw> draws(2, MakeDraw(volume, true));
  draws[0].NumberOfIndices = draws[1].NumberOfIndices = draws[1].FirstIndex = half;
  draws[1].ZPass = false;
  draws[1].Box = { 10, 6, 12, 8 };
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, draws));
  this->ExpectStencil(
    [](int x, int y)
    {
      const bool inBox = x >= 10 && x < 12 && y >= 6 && y < 8;
      return IsShadowed(x, y) ? 1 + inBox : 0;
    });
}

TEST_F(GpuTestShadowCounter, FragmentsAreThoseOfAllFaces)
{
  const vtkShadowVolumeStore volume = MakeVolume(1);
  long long fragments = 5;
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }, &fragments));
  int covered = 0;
  for (const auto& [x, y] : Pixels(CounterViewport[2], CounterViewport[3]))
  {
    covered += IsInVolume(x, y, CounterViewport);
  }
  // The front and the back; all others are seen edge-on.
  EXPECT_EQ(fragments, 5 + 2 * covered);
  this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 1 : 0; });
}

// A channel of the mask is set where the count is not 0. The other channels, other masks and the
// stencil do not change.
TEST_F(GpuTestShadowCounter, ResolvesOneChannel)
{
  const vtkShadowVolumeStore volume = MakeVolume(3);
  for (int channel = 0; channel < 4; ++channel)
  {
    SCOPED_TRACE(channel);
    this->Fill();
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, true) }));
    ASSERT_NO_FATAL_FAILURE(this->Resolve(1, channel));
    for (int other = 0; other < 4; ++other)
    {
      this->ExpectMask(0, other, [](int, int) { return Sentinel; });
      this->ExpectMask(1, other,
        [&](int x, int y) { return other == channel && IsShadowed(x, y) ? 255 : int(Sentinel); });
    }
    this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 3 : 0; });
  }
}

// Counts are right in any OpenGL state, and the state is restored.
TEST_F(GpuTestShadowCounter, StateIsSetAndRestored)
{
  const vtkShadowVolumeStore volume = MakeVolume(1);
  // Objects are made in the first use.
  ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }));
  ASSERT_NO_FATAL_FAILURE(this->Resolve(0, 0));
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
      const vtkShadowCounter::Scope scope(this->Window, CounterViewport);
      this->Counter.ClearMask(this->Target, 0, CounterViewport);
    }
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, false) }));
    ASSERT_NO_FATAL_FAILURE(this->Resolve(0, 2));
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, 0.0f);
    glStencilMask(0xff);
    glClearStencil(0);
    this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 1 : 0; });
    this->ExpectMask(0, 2, [](int x, int y) { return IsShadowed(x, y) ? 255 : 0; });
  }
}

// Vertices that are on the device are not sent again, and new ones are in the right place.
TEST_F(GpuTestShadowCounter, OnlyWhatIsAddedIsSent)
{
  vtkShadowVolumeStore store = MakeVolume(1);
  ASSERT_NO_FATAL_FAILURE(this->Count(store, { MakeDraw(store, true) }));
  const std::size_t one = this->Volume.GetUploadedBytes();
  EXPECT_GT(one, 0u);
  ASSERT_TRUE(this->Volume.Upload(store, this->Why));
  EXPECT_EQ(this->Volume.GetUploadedBytes(), one);
  // There is room for half as much again at first, so that memory is allocated on the way.
  std::size_t expected = one;
  for (int copies = 2; copies < 9; ++copies)
  {
    AddVolume(store);
    ASSERT_NO_FATAL_FAILURE(this->Count(store, { MakeDraw(store, true) }));
    this->ExpectStencil([copies](int x, int y) { return IsShadowed(x, y) ? copies : 0; });
    const bool isAllocated = copies == 2 || copies == 4 || copies == 7;
    expected += isAllocated ? copies * one : one;
    EXPECT_EQ(this->Volume.GetUploadedBytes(), expected) << copies << " copies";
  }
  // Another store has nothing in common with the first.
  store = MakeVolume(2);
  ASSERT_NO_FATAL_FAILURE(this->Count(store, { MakeDraw(store, true) }));
  this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 2 : 0; });
  EXPECT_EQ(this->Volume.GetUploadedBytes(), expected + 2 * one);
}

// Hazard: coordinates far from the origin of the world lose the digits that matter near the eye.
TEST_F(GpuTestShadowCounter, VolumesAreExactFarFromTheOrigin)
{
  for (const glm::dvec3& eye :
    { glm::dvec3(5.0e5, 4.0e6, 304.0), glm::dvec3(-1.0e7 / 3.0, 0.1, 1.0e7) })
  {
    // The view is a thousandth of a unit wide: single precision is a hundred times as coarse.
    constexpr double size = 1e-3;
    const vtkShadowVolumeStore store = ShadowFixture::MakeVolume(
      MakeBlock(eye + size * glm::dvec3(-0.9, -0.3, -0.2), eye + size * glm::dvec3(-0.7, 0.3, 0.2)),
      { 1.0, 0.0, 0.0 }, { eye.x - 0.5 * size, eye.x + 0.5 * size });
    ASSERT_TRUE(this->Volume.Upload(store, this->Why)) << this->Why;
    vtkShadowDrawList::View view = MakeView(CounterViewport);
    view.Eye = eye;
    view.EyeToClip = glm::scale(view.EyeToClip, glm::dvec3(1.0 / size));
    const vtkShadowDraw draw = MakeDraw(store, true);
    const vtkShadowCounter::Scope scope(this->Window, CounterViewport);
    this->Counter.ClearStencil(this->Target, CounterViewport);
    ASSERT_TRUE(this->Counter.Count(
      this->Window, this->Target, this->Volume, view, &draw, &draw + 1, nullptr, this->Why));
    this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 1 : 0; });
  }
}

// Hazard: names of objects of a context that is gone, or of another context, are used again.
TEST_F(GpuTestShadowCounter, WorksAgainAfterRelease)
{
  const vtkShadowVolumeStore volume = MakeVolume(1);
  for (int round = 0; round < 2; ++round)
  {
    ASSERT_NO_FATAL_FAILURE(this->Count(volume, { MakeDraw(volume, true) }));
    this->ExpectStencil([](int x, int y) { return IsShadowed(x, y) ? 1 : 0; });
    for (int i = 0; i < 2; ++i)
    {
      this->Counter.Release();
      this->Target.Release();
      this->Volume = vtkShadowVolumeBuffer();
    }
    this->Window = nullptr;
    this->Window = NewWindow(16, 16);
    ASSERT_NO_FATAL_FAILURE(this->Reserve());
  }
}
