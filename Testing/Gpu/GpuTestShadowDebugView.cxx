// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkShadowDebugView: each fragment of a volume is shown, in its place; the state is as before.
#include "vtkShadowDebugView.h"

#include "GLStateSnapshot.h"
#include "WindowFixture.h"

#include "vtkNBufferGL.h"
#include "vtkShadowCounter.h"
#include "vtkShadowTimers.h"
#include "vtkShadowVolume.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
constexpr int Viewport[4] = { 7, 5, 21, 15 };
/// The eye looks along -z; x and y in [-1, 1].
constexpr double VolumeToClip[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1 };

/// A column with a square section, |x| < 0.5 and |y| < 0.3, of a light that shines along -z.
vtkShadowVolume MakeVolume()
{
  std::vector<glm::dvec3> points;
  for (const double z : { 0.4, 0.5 })
  {
    for (const double x : { -0.5, 0.5 })
    {
      for (const double y : { -0.3, 0.3 })
      {
        points.emplace_back(x, y, z);
      }
    }
  }
  const std::vector<vtkIdType> triangles = { 0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
    2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3 };
  vtkShadowTopology topology;
  topology.Build(points, triangles);
  const vtkShadowLight light;
  vtkShadowSilhouette silhouette;
  silhouette.Compute(topology, topology.GetPoints(), light, vtkShadowCounting::Away);
  vtkShadowVolume volume;
  volume.Begin(glm::dvec3(0.0));
  volume.AddClamped(
    silhouette, topology.GetPoints(), vtkShadowLightSpace(light), { -0.2, 0.2 }, -0.4);
  return volume;
}

bool IsInVolume(int x, int y)
{
  const double u = 2.0 * (x + 0.5) / Viewport[2] - 1.0;
  const double v = 2.0 * (y + 0.5) / Viewport[3] - 1.0;
  return u > -0.5 && u < 0.5 && v > -0.3 && v < 0.3;
}

constexpr vtkShadowPicture Pictures[] = { vtkShadowPicture::Litmaps, vtkShadowPicture::Extents,
  vtkShadowPicture::Volumes, vtkShadowPicture::Counts };
}

class GpuTestShadowDebugView : public WindowFixture
{
protected:
  GpuTestShadowDebugView()
    : WindowFixture(40, 30)
  {
  }

  void SetUp() override
  {
    WindowFixture::SetUp();
    if (this->Window)
    {
      const vtkShadowVolume volume = MakeVolume();
      std::string why;
      ASSERT_TRUE(this->Counter.Upload(volume, why)) << why;
      vtkShadowDraw draw;
      draw.NumberOfIndices = static_cast<int>(volume.GetIndices().size());
      std::copy_n(Viewport, 4, draw.Box);
      this->Draws = { draw };
    }
  }

  void TearDown() override
  {
    if (this->Window)
    {
      this->Counter.Release();
      this->View.Release();
    }
  }

  void Make(vtkShadowPicture picture)
  {
    const vtkShadowDebugView::Subject subject = { nullptr, 0, this->Draws, VolumeToClip, Viewport };
    std::string why;
    const vtkShadowCounter::Scope scope(this->Window, Viewport);
    ASSERT_TRUE(
      this->View.Make(this->Window, picture, subject, this->Counter, this->Statistics, why))
      << why;
  }

  vtkShadowCounter Counter;
  vtkShadowDebugView View;
  vtkShadowStatistics Statistics;
  std::vector<vtkShadowDraw> Draws;
};

// The front and the back of the column; the box cuts off its left side.
TEST_F(GpuTestShadowDebugView, CountsAreThoseOfFragments)
{
  this->Draws[0].Box[0] += 8;
  this->Draws[0].Box[2] -= 8;
  ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  ASSERT_EQ(this->View.GetWidth(), Viewport[2]);
  ASSERT_EQ(this->View.GetHeight(), Viewport[3]);
  for (int y = 0; y < Viewport[3]; ++y)
  {
    for (int x = 0; x < Viewport[2]; ++x)
    {
      vtkShadowDebugImage::Color color;
      std::copy_n(this->View.GetImage().begin() + 4 * (y * Viewport[2] + x), 4, color.begin());
      EXPECT_EQ(color, vtkShadowDebugImage::GetHeat(IsInVolume(x, y) && x >= 8 ? 2 : 0))
        << x << ", " << y;
    }
  }
}

TEST_F(GpuTestShadowDebugView, EdgesTellZPassFromZFail)
{
  for (const bool zPass : { false, true })
  {
    this->Draws[0].ZPass = zPass;
    ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Volumes));
    int edges = 0;
    for (std::size_t i = 0; i < this->View.GetImage().size(); i += 4)
    {
      const unsigned char* pixel = this->View.GetImage().data() + i;
      edges += pixel[3] != 0;
      EXPECT_TRUE(pixel[3] == 0 || (pixel[2] > pixel[0]) == zPass);
    }
    EXPECT_GT(edges, 20);
    EXPECT_LT(edges, Viewport[2] * Viewport[3] / 2);
  }
}

// In the viewport of the framebuffer that is bound, where the image is not transparent; opacity
// stays.
TEST_F(GpuTestShadowDebugView, IsShownWhereItIsNotTransparent)
{
  ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  const float grey[4] = { 0.2f, 0.2f, 0.2f, 0.2f };
  unsigned int texture = 0;
  unsigned int framebuffer = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 40, 30, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glDisable(GL_SCISSOR_TEST);
  glClearBufferfv(GL_COLOR, 0, grey);
  SpoilGLState();
  glDisable(GL_RASTERIZER_DISCARD);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  std::string why;
  ASSERT_TRUE(this->View.Show(this->Window, this->Statistics, why)) << why;
  EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
  UnspoilGLState();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  std::vector<unsigned char> pixels(4 * 40 * 30);
  glReadPixels(0, 0, 40, 30, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const vtkShadowDebugImage::Color heat = vtkShadowDebugImage::GetHeat(2);
  for (int y = 0; y < 30; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      const unsigned char* pixel = pixels.data() + 4 * (40 * y + x);
      const int inX = x - Viewport[0];
      const int inY = y - Viewport[1];
      const bool shown =
        inX >= 0 && inX < Viewport[2] && inY >= 0 && inY < Viewport[3] && IsInVolume(inX, inY);
      for (int i = 0; i < 3; ++i)
      {
        const double opacity = heat[3] / 255.0;
        const double expected = shown ? opacity * heat[i] + (1.0 - opacity) * 51.0 : 51.0;
        EXPECT_NEAR(pixel[i], expected, shown ? 1.0 : 0.0) << x << ", " << y;
      }
      EXPECT_EQ(pixel[3], 51) << x << ", " << y;
    }
  }
  EXPECT_EQ(this->Statistics.DebugDraws, 2);
  this->View.Clear();
  ASSERT_TRUE(this->View.Show(this->Window, this->Statistics, why));
  EXPECT_EQ(this->Statistics.DebugDraws, 2) << "nothing to show";
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteTextures(1, &texture);
}

TEST_F(GpuTestShadowDebugView, StateIsSetAndRestored)
{
  // Objects are made in the first use.
  ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  for (const vtkShadowPicture picture : Pictures)
  {
    SpoilGLState();
    glDisable(GL_RASTERIZER_DISCARD);
    const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
    ASSERT_NO_FATAL_FAILURE(this->Make(picture));
    EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
    UnspoilGLState();
  }
}

// Times of a frame are known later, without waiting, and only of frames that were to be measured.
TEST_F(GpuTestShadowDebugView, TimersMeasureIfAsked)
{
  vtkShadowTimers timers;
  timers.Begin(false);
  {
    const vtkShadowTimers::Scope timed(timers, vtkShadowStage::Draw);
  }
  EXPECT_EQ(timers.GetNumberOfIntervals(), 0);
  EXPECT_EQ(timers.GetTimes(), UnknownShadowStageTimes);
  timers.Begin(true);
  for (int i = 0; i < 2; ++i)
  {
    const vtkShadowTimers::Scope timed(timers, vtkShadowStage::Draw);
    ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  }
  if (timers.GetNumberOfIntervals() == 0)
  {
    GTEST_SKIP() << "The driver has no timers.";
  }
  EXPECT_EQ(timers.GetNumberOfIntervals(), 2);
  EXPECT_EQ(timers.GetTimes(), UnknownShadowStageTimes) << "nothing is known yet";
  glFinish();
  timers.Begin(true);
  EXPECT_EQ(timers.GetTimes()[0], 0.0) << "no such stage";
  EXPECT_GE(timers.GetTimes()[1], 0.0);
  EXPECT_LT(timers.GetTimes()[1], 60e3);
  timers.Begin(false);
  EXPECT_EQ(timers.GetTimes(), UnknownShadowStageTimes);
}
