// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Debug views change what they show and nothing else; times of the device.
#include "PassTestTools.h"
#include "Tune.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkProperty.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{
constexpr int Views[] = { vtkShadowVolumeClampPass::Litmaps, vtkShadowVolumeClampPass::Extents,
  vtkShadowVolumeClampPass::Volumes, vtkShadowVolumeClampPass::Counts };

/// The image is the plain one with the view of the viewport at (x0, y0) laid over it.
::testing::AssertionResult IsLaidOver(
  const Picture& plain, const Picture& actual, vtkShadowVolumeClampPass* pass, int x0, int y0)
{
  int width = 0;
  int height = 0;
  const std::vector<unsigned char> view = pass->GetDebugImage(width, height);
  std::vector<double> expected(plain.Colors.begin(), plain.Colors.end());
  int shown = 0;
  const unsigned char* over = view.data();
  for (const auto& [x, y] : Pixels({ x0, y0, x0 + width, y0 + height }))
  {
    const std::size_t pixel = 4 * static_cast<std::size_t>(y * plain.Size[0] + x);
    const double opacity = over[3] / 255.0;
    shown += over[3] != 0;
    for (int i = 0; i < 3; ++i)
    {
      expected[pixel + i] = opacity * over[i] + (1.0 - opacity) * plain.Colors[pixel + i];
    }
    over += 4;
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    // Bytes are integers where nothing is laid over.
    const bool over = expected[i] != plain.Colors[i];
    if (std::abs(actual.Colors[i] - expected[i]) > (over ? 1.0 : 0.0))
    {
      return ::testing::AssertionFailure()
        << "byte " << i << " is " << static_cast<int>(actual.Colors[i]) << ", not " << expected[i];
    }
  }
  return (shown > 20 ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
    << shown << " pixels shown";
}
}

using PassDebugViews = OffscreenFixture;

TEST_F(PassDebugViews, AreLaidOverThePicture)
{
  for (const char* name : { "Directional", "Point", "Inset" })
  {
    SCOPED_TRACE(name);
    const Stage stage = SetNamedStage(name);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    const Picture plain = RenderPicture(stage);
    const ShadowMask mask = GetMask(stage, pass);
    const vtkNBufferRectangle viewport = GetPixels(stage.GetRenderer());
    for (const int view : Views)
    {
      SCOPED_TRACE("view " + std::to_string(view));
      pass->SetDebugView(view);
      // Made in the first frame, kept in the second.
      for (int frame = 0; frame < 2; ++frame)
      {
        stage.Window->Render();
        const vtkShadowStatistics& statistics = pass->GetStatistics();
        EXPECT_EQ(
          statistics.Decision, frame == 0 ? vtkShadowDecision::Drawn : vtkShadowDecision::Still);
        const bool draws = frame == 0 && view >= vtkShadowVolumeClampPass::Volumes;
        EXPECT_EQ(statistics.DebugDraws, draws ? 2 : 1);
        EXPECT_TRUE(IsLaidOver(plain, TakePicture(stage.Window), pass, viewport.X0, viewport.Y0));
        EXPECT_EQ(GetMask(stage, pass), mask);
      }
    }
    pass->SetDebugView(vtkShadowVolumeClampPass::NoDebugView);
    EXPECT_EQ(FindDifference(plain, RenderPicture(stage)), "");
  }
}

// A debug view that is off draws nothing, makes no objects and keeps no image.
TEST_F(PassDebugViews, OffCostsNothing)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto count = [&stage]
  {
    stage.Window->Render();
    return CountObjects(stage);
  };
  count();
  const GLObjects::Counts before = count();
  int width = -1;
  int height = -1;
  EXPECT_EQ(pass->GetStatistics().DebugDraws, 0);
  EXPECT_TRUE(pass->GetDebugImage(width, height).empty());
  EXPECT_EQ(width, 0);
  EXPECT_EQ(height, 0);
  pass->SetDebugView(vtkShadowVolumeClampPass::Counts);
  EXPECT_NE(count(), before);
  EXPECT_EQ(pass->GetStatistics().DebugDraws, 2);
  EXPECT_EQ(pass->GetDebugImage(width, height).size(), 4 * CountPixels(stage.GetRenderer()));
  pass->SetDebugView(vtkShadowVolumeClampPass::NoDebugView);
  const GLObjects::Counts after = count();
  EXPECT_EQ(pass->GetStatistics().DebugDraws, 0);
  EXPECT_TRUE(pass->GetDebugImage(width, height).empty());
  stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
  EXPECT_EQ(count(), after);
}

// The objects of debug views and timers are deleted with the pass. (Programs stay in the window's
// cache.)
TEST_F(PassDebugViews, LeaveNoObjectsBehind)
{
  const Stage stage = SetNamedStage("ManyLights");
  const auto countAfter = [&stage](int view, bool all)
  {
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    pass->SetDebugView(view);
    Tune(pass, &vtkShadowTuning::MeasureDeviceTime, all);
    stage.Window->Render();
    stage.GetRenderer()->SetPass(nullptr);
    pass = nullptr;
    stage.Window->Render();
    return CountObjectsWithoutPrograms(stage);
  };
  const GLObjects::Counts before = countAfter(vtkShadowVolumeClampPass::NoDebugView, false);
  for (const int view : Views)
  {
    EXPECT_EQ(countAfter(view, true), before) << "view " << view;
  }
}

// Each light has its own view; one that does not cast has none.
TEST_F(PassDebugViews, AreOfOneLight)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const auto getImage = [&](vtkLight* light)
  {
    pass->SetDebugView(vtkShadowVolumeClampPass::Counts, light);
    EXPECT_EQ(pass->GetDebugLight(), light);
    stage.Window->Render();
    int width = 0;
    int height = 0;
    return pass->GetDebugImage(width, height);
  };
  const auto ofNull = getImage(nullptr);
  EXPECT_EQ(getImage(stage.Lights[0]), ofNull);
  EXPECT_NE(getImage(stage.Lights[1]), ofNull);
  pass->SetLightCasts(stage.Lights[1], false);
  EXPECT_TRUE(getImage(stage.Lights[1]).empty());
  EXPECT_EQ(pass->GetStatistics().DebugDraws, 0);
}

// The view of the litmaps is also drawn if no caster has a receiver, since it shows why.
TEST_F(PassDebugViews, AreShownWithoutShadows)
{
  const Stage stage = SetNamedStage("Directional");
  // Nothing but a box is left, which shadows nothing that is seen from the light's side.
  const std::vector<vtkActor*> actors = GetActors(stage.GetRenderer());
  for (vtkActor* actor : actors)
  {
    actor->GetProperty()->SetRepresentationToWireframe();
  }
  actors.back()->GetProperty()->SetRepresentationToSurface();
  stage.GetRenderer()->GetActiveCamera()->SetFocalPoint(100.0, 100.0, 0.0);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetDebugView(vtkShadowVolumeClampPass::Litmaps);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::NoReceiver);
  EXPECT_EQ(pass->GetStatistics().DebugDraws, 1);
}

// The OpenGL state after a frame does not depend on the debug view.
TEST_F(PassDebugViews, LeaveTheStateAsItIs)
{
  const Stage stage = SetNamedStage("Inset");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  CaptureFrame(stage);
  const GLStateSnapshot plain = CaptureFrame(stage);
  for (const int view : Views)
  {
    pass->SetDebugView(view);
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(plain.GetDifference(CaptureFrame(stage)), "")
        << "view " << view << ", frame " << frame;
    }
  }
}

//------------------------------------------------------------------------------------------------
using PassDeviceTimes = OffscreenFixture;

TEST_F(PassDeviceTimes, AreMeasuredIfSwitchedOn)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().DeviceTimes, UnknownShadowStageTimes);
  const Picture plain = TakePicture(stage.Window);
  Tune(pass, &vtkShadowTuning::MeasureDeviceTime, true);
  vtkShadowStageTimes times = UnknownShadowStageTimes;
  // Reading the image waits for the device, so that the next frame knows the times of this one.
  for (int frame = 0; frame < 3; ++frame)
  {
    pass->Modified();
    EXPECT_EQ(FindDifference(plain, RenderPicture(stage)), "");
    times = pass->GetStatistics().DeviceTimes;
  }
  if (times == UnknownShadowStageTimes)
  {
    GTEST_SKIP() << "The driver has no timers.";
  }
  std::cout << "depth " << times[0] << " ms, draw " << times[1] << " ms, color " << times[2]
            << " ms\n";
  for (const double time : times)
  {
    EXPECT_GT(time, 0.0);
    EXPECT_LT(time, 60e3);
  }
  // Still frames draw neither depth nor volumes.
  for (int frame = 0; frame < 3; ++frame)
  {
    stage.Window->Render();
    TakePicture(stage.Window);
  }
  EXPECT_EQ(pass->GetStatistics().GetDeviceTime(vtkShadowStage::Depth), 0.0);
  EXPECT_EQ(pass->GetStatistics().GetDeviceTime(vtkShadowStage::Draw), 0.0);
  EXPECT_GT(pass->GetStatistics().GetDeviceTime(vtkShadowStage::Color), 0.0);
  Tune(pass, &vtkShadowTuning::MeasureDeviceTime, false);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().DeviceTimes, UnknownShadowStageTimes);
}
