// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkShadowDebugView: each fragment of a volume is shown, in its place; the state is as before.
#include "ColorTarget.h"
#include "GLStateSnapshot.h"
#include "ShadowFixture.h"
#include "vtkShadowDebugView.h"
#include "vtkShadowTimers.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace
{
constexpr int DebugViewport[4] = { 7, 5, 21, 15 };
constexpr vtkShadowPicture Pictures[] = { vtkShadowPicture::Litmaps, vtkShadowPicture::Extents,
  vtkShadowPicture::Volumes, vtkShadowPicture::Counts };
}

class GpuTestShadowDebugView : public ShadowFixture
{
protected:
  GpuTestShadowDebugView()
    : ShadowFixture(40, 30)
  {
  }

  /// A column with a square section, |x| < 0.5 and |y| < 0.3, of a light that shines along -z.
  void SetUp() override
  {
    ShadowFixture::SetUp();
    if (this->Window)
    {
      const vtkShadowVolumeStore volume = MakeVolume(
        MakeBlock({ -0.5, -0.3, 0.4 }, { 0.5, 0.3, 0.5 }), { 0.0, 0.0, -1.0 }, { -0.2, 0.2 });
      ASSERT_TRUE(this->Volume.Upload(volume, this->Why)) << this->Why;
      this->Draws = { MakeDraw(volume, DebugViewport) };
    }
  }

  void TearDown() override
  {
    ShadowFixture::TearDown();
    if (this->Window)
    {
      this->View.Release();
    }
  }

  void Make(vtkShadowPicture picture)
  {
    const vtkShadowDrawList::View view = MakeView(DebugViewport);
    const vtkShadowDebugView::Subject subject = { nullptr, 0, this->Volume, this->Draws, view };
    const vtkShadowCounter::Scope scope(this->Window, DebugViewport);
    ASSERT_TRUE(
      this->View.Make(this->Window, picture, subject, this->Counter, this->Statistics, this->Why))
      << this->Why;
  }

  vtkShadowDebugView View;
  vtkShadowStatistics Statistics;
  std::vector<vtkShadowDraw> Draws;
};

// The view counts the fragments of the front and of the back of the column, whose left side the box
// cuts off.
TEST_F(GpuTestShadowDebugView, CountsAreThoseOfFragments)
{
  this->Draws[0].Box.X0 = 8;
  ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  ASSERT_EQ(this->View.GetWidth(), DebugViewport[2]);
  ASSERT_EQ(this->View.GetHeight(), DebugViewport[3]);
  for (const auto& [x, y] : Pixels(DebugViewport[2], DebugViewport[3]))
  {
    vtkShadowDebugImage::Color color;
    std::copy_n(this->View.GetImage().begin() + 4 * (y * DebugViewport[2] + x), 4, color.begin());
    const bool counted = IsInVolume(x, y, DebugViewport) && x >= 8;
    EXPECT_EQ(color, vtkShadowDebugImage::GetHeat(counted ? 2 : 0)) << x << ", " << y;
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
    EXPECT_LT(edges, DebugViewport[2] * DebugViewport[3] / 2);
  }
}

// The view is drawn into the viewport of the bound framebuffer, where its image is not transparent.
// Alpha does not change.
TEST_F(GpuTestShadowDebugView, IsShownWhereItIsNotTransparent)
{
  ASSERT_NO_FATAL_FAILURE(this->Make(vtkShadowPicture::Counts));
  const float grey[4] = { 0.2f, 0.2f, 0.2f, 0.2f };
  const ColorTarget target(40, 30);
  glDisable(GL_SCISSOR_TEST);
  glClearBufferfv(GL_COLOR, 0, grey);
  SpoilGLState();
  glDisable(GL_RASTERIZER_DISCARD);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  ASSERT_TRUE(this->View.Show(this->Window, this->Statistics, this->Why)) << this->Why;
  EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
  UnspoilGLState();
  const std::vector<unsigned char> pixels = target.Read();
  const vtkShadowDebugImage::Color heat = vtkShadowDebugImage::GetHeat(2);
  for (const auto& [x, y] : Pixels(40, 30))
  {
    const unsigned char* pixel = pixels.data() + 4 * (40 * y + x);
    const int inX = x - DebugViewport[0];
    const int inY = y - DebugViewport[1];
    const bool shown = IsIn(inX, inY, { 0, 0, DebugViewport[2], DebugViewport[3] }) &&
      IsInVolume(inX, inY, DebugViewport);
    for (int i = 0; i < 3; ++i)
    {
      const double opacity = heat[3] / 255.0;
      const double expected = shown ? opacity * heat[i] + (1.0 - opacity) * 51.0 : 51.0;
      EXPECT_NEAR(pixel[i], expected, shown ? 1.0 : 0.0) << x << ", " << y;
    }
    EXPECT_EQ(pixel[3], 51) << x << ", " << y;
  }
  EXPECT_EQ(this->Statistics.DebugDraws, 2);
  this->View.Clear();
  ASSERT_TRUE(this->View.Show(this->Window, this->Statistics, this->Why));
  EXPECT_EQ(this->Statistics.DebugDraws, 2) << "nothing to show";
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

// The times of a frame arrive in a later frame, without waiting, and only for frames that were to
// be measured.
TEST_F(GpuTestShadowDebugView, TimersMeasureIfSwitchedOn)
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
  // Mesa's zink has the results only some time after glFinish().
  for (int i = 0; i < 100 && timers.GetTimes() == UnknownShadowStageTimes; ++i)
  {
    glFinish();
    std::this_thread::sleep_for(std::chrono::milliseconds(i));
    timers.Begin(true);
  }
  EXPECT_EQ(timers.GetTimes()[0], 0.0) << "no such stage";
  EXPECT_GE(timers.GetTimes()[1], 0.0);
  EXPECT_LT(timers.GetTimes()[1], 60e3);
  timers.Begin(false);
  EXPECT_EQ(timers.GetTimes(), UnknownShadowStageTimes);
}
