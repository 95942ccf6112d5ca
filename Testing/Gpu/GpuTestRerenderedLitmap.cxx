// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//
// RerenderedLitmap: in each lexel what the camera sees there, and what it misses.
#include "RerenderedLitmap.h"

#include "GLStateSnapshot.h"
#include "ShadowCaster.h"
#include "WindowFixture.h"

#include "vtkShadowReceivers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
constexpr int LitmapWidth = 16;
constexpr int LitmapHeight = 12;
constexpr int Resolution = 32;
const glm::dvec3 Eye(100.0, 200.0, 300.0);

/// From the eye along -z, x and y in [-1, 1], depths 0 to 1 as window depths 0 to 1.
vtkShadowView MakeView()
{
  vtkShadowView view;
  const double clipToWorld[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.5, -0.5, 0, 0, 0, 1 };
  view.ClipToWorld = vtkNBufferGLM::ToMatrix(clipToWorld);
  view.Origin = Eye;
  view.Width = LitmapWidth;
  view.Height = LitmapHeight;
  return view;
}

/// A rectangle [x0, x1] x [-1, 1] at a depth.
std::vector<glm::dvec3> MakeRectangle(double x0, double x1, double depth)
{
  std::vector<glm::dvec3> points;
  for (const double x : { x0, x1 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      points.push_back(Eye + glm::dvec3(x, y, -depth));
    }
  }
  return points;
}
const std::vector<int> Quad = { 0, 1, 3, 0, 3, 2 };

/// The light stands 2 behind the eye and looks as the eye does.
vtkShadowLight MakeLight(vtkShadowLightKind kind)
{
  vtkShadowLight light;
  light.Kind = kind;
  light.ConeAngle = 45.0;
  light.Position = Eye + glm::dvec3(0.0, 0.0, 2.0);
  return light;
}
}

class GpuTestRerenderedLitmap : public WindowFixture
{
protected:
  void TearDown() override
  {
    if (this->Window)
    {
      this->Litmap.Release();
    }
  }

  /// On the left a rectangle at depth 0.25 before one at 0.75 that covers all; seen or not.
  void Draw(const vtkShadowLight& light, const std::vector<float>& depth, vtkShadowLitmap& result)
  {
    const vtkShadowLightSpace frame(light);
    this->Litmap.Begin(Eye);
    this->Litmap.AddReceiver(MakeRectangle(-1.0, 0.0, 0.25), Quad);
    this->Litmap.AddReceiver(MakeRectangle(-1.0, 1.0, 0.75), Quad);
    std::string why;
    ASSERT_TRUE(this->Litmap.Upload(this->Window, depth.data(), MakeView(), why)) << why;
    this->Range = vtkShadowReceivers::GetRange(depth.data(), MakeView(), light, frame);
    ASSERT_TRUE(this->Litmap.Draw(this->Window, frame, this->Range, Resolution, result, why))
      << why;
    result.Build();
  }

  /// What the camera sees: the nearer rectangle on the left, the farther one on the right.
  static std::vector<float> MakeDepth(float left, float right)
  {
    std::vector<float> depth;
    for (int i = 0; i < LitmapWidth * LitmapHeight; ++i)
    {
      depth.push_back(i % LitmapWidth < LitmapWidth / 2 ? left : right);
    }
    return depth;
  }

  /// (p, q) of the centre of a lexel.
  glm::dvec2 GetCentre(int i, int j) const
  {
    const glm::dvec2 low = this->Range.Low;
    const glm::dvec2 high = this->Range.High;
    return low + (high - low) * glm::dvec2(i + 0.5, j + 0.5) / double(Resolution);
  }

  NBufferPeers::RerenderedLitmap Litmap;
  vtkShadowBlock Range;
};

// Each lexel is compared with the ray through its centre: with the place where this ray meets a
// surface that the camera sees.
TEST_F(GpuTestRerenderedLitmap, LexelsHoldWhatIsSeenAtTheirCentres)
{
  const std::vector<float> depth = MakeDepth(0.25f, 0.75f);
  for (const vtkShadowLightKind kind :
    { vtkShadowLightKind::Directional, vtkShadowLightKind::Spot })
  {
    SCOPED_TRACE(kind == vtkShadowLightKind::Spot ? "spot" : "directional");
    const vtkShadowLight light = MakeLight(kind);
    const vtkShadowLightSpace frame(light);
    vtkShadowLitmap litmap;
    ASSERT_NO_FATAL_FAILURE(this->Draw(light, depth, litmap));
    int filled = 0;
    for (int lexel = 0; lexel < Resolution * Resolution; ++lexel)
    {
      const glm::dvec2 pq = this->GetCentre(lexel % Resolution, lexel / Resolution);
      vtkShadowExtent expected;
      bool close = false;
      for (const double z : { 0.25, 0.75 })
      {
        const glm::dvec3 pqs(pq, frame.GetDepth(Eye - glm::dvec3(0.0, 0.0, z)));
        const glm::dvec3 x = ToWorld(frame, pqs);
        const double u = x[0] - Eye[0];
        const double v = x[1] - Eye[1];
        const double column = 0.5 * (u + 1.0) * LitmapWidth;
        const double row = 0.5 * (v + 1.0) * LitmapHeight;
        // Rounding decides.
        close = close || std::abs(column - std::round(column)) < 1e-3 ||
          std::abs(row - std::round(row)) < 1e-3;
        if (std::abs(u) < 1.0 && std::abs(v) < 1.0 && (u < 0.0) == (z == 0.25))
        {
          const auto x0 = static_cast<std::uint16_t>(column);
          const auto y0 = static_cast<std::uint16_t>(row);
          expected.Merge({ pqs[2], pqs[2], x0, y0, static_cast<std::uint16_t>(x0 + 1),
            static_cast<std::uint16_t>(y0 + 1) });
        }
      }
      const vtkShadowExtent& actual = litmap.GetLevelData(0)[lexel];
      ASSERT_TRUE(close || actual.IsEmpty() == expected.IsEmpty()) << lexel;
      if (close || expected.IsEmpty())
      {
        continue;
      }
      ++filled;
      EXPECT_EQ((vtkNBufferRectangle{ actual.X0, actual.Y0, actual.X1, actual.Y1 }),
        (vtkNBufferRectangle{ expected.X0, expected.Y0, expected.X1, expected.Y1 }))
        << lexel;
      EXPECT_LE(actual.Near, expected.Near) << lexel;
      EXPECT_GE(actual.Far, expected.Far) << lexel;
      EXPECT_NEAR(actual.Near, expected.Near, 1e-5) << lexel;
      EXPECT_NEAR(actual.Far, expected.Far, 1e-5) << lexel;
    }
    EXPECT_GT(filled, Resolution * Resolution / 2);
  }
}

// The defect of the paper's method in its simplest form: a point a little behind the depth of its
// pixel counts as not seen, and a surface that covers no lexel's centre is not drawn. Scattering
// finds both.
TEST_F(GpuTestRerenderedLitmap, MissesWhatScatteringFinds)
{
  const vtkShadowLight light = MakeLight(vtkShadowLightKind::Directional);
  const vtkShadowLightSpace frame(light);
  const auto behind = static_cast<float>(2.0 * NBufferPeers::RerenderedLitmap::DepthBias);
  const std::vector<float> depth = MakeDepth(0.25f, 0.75f - behind);
  vtkShadowLitmap rerendered;
  ASSERT_NO_FATAL_FAILURE(this->Draw(light, depth, rerendered));
  vtkShadowLitmap scattered;
  vtkShadowReceivers::Scatter(depth.data(), MakeView(), light, frame, Resolution, scattered);
  scattered.Build();
  const vtkShadowExtent seen = rerendered.Query(NAN, 0.0, 0.0, 0.0);
  const vtkShadowExtent all = scattered.Query(NAN, 0.0, 0.0, 0.0);
  EXPECT_EQ(all.X1, LitmapWidth);
  EXPECT_EQ(seen.X1, LitmapWidth / 2) << "the right side lies behind the depth";
  EXPECT_NEAR(seen.Far, 0.25 - Eye[2], 1e-4);
  const double quarterOfAPixel = 0.25 * 2.0 / std::min(LitmapWidth, LitmapHeight);
  EXPECT_NEAR(all.Far, 0.75 - Eye[2] + quarterOfAPixel, 1e-3);

  // Seen edge-on by the light it has no fragment.
  this->Litmap.Begin(Eye);
  std::vector<glm::dvec3> wall = MakeRectangle(-1.0, -1.0, 0.1);
  wall[2].z -= 0.8;
  wall[3].z -= 0.8;
  this->Litmap.AddReceiver(wall, Quad);
  std::string why;
  ASSERT_TRUE(this->Litmap.Upload(this->Window, depth.data(), MakeView(), why)) << why;
  const vtkShadowBlock range = { { -300.0, -300.0, 0.0 }, { 300.0, 300.0, 1.0 } };
  ASSERT_TRUE(this->Litmap.Draw(this->Window, frame, range, Resolution, rerendered, why)) << why;
  EXPECT_EQ(rerendered.GetNumberOfReceivers(), 0);
}

TEST_F(GpuTestRerenderedLitmap, StateIsSetAndRestored)
{
  const vtkShadowLight light = MakeLight(vtkShadowLightKind::Spot);
  const std::vector<float> depth = MakeDepth(0.25f, 0.75f);
  vtkShadowLitmap expected;
  // Objects are made in the first use.
  ASSERT_NO_FATAL_FAILURE(this->Draw(light, depth, expected));
  ASSERT_GT(expected.GetNumberOfReceivers(), 0);
  SpoilGLState();
  glDisable(GL_RASTERIZER_DISCARD);
  const GLStateSnapshot before = GLStateSnapshot::Capture(this->Window);
  vtkShadowLitmap litmap;
  ASSERT_NO_FATAL_FAILURE(this->Draw(light, depth, litmap));
  EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(this->Window)), "");
  EXPECT_EQ(litmap.GetNumberOfReceivers(), expected.GetNumberOfReceivers());
  UnspoilGLState();
}

// Hazard: names of objects of a context that is gone, or of another context, are used again.
TEST_F(GpuTestRerenderedLitmap, WorksAgainAfterRelease)
{
  for (int round = 0; round < 2; ++round)
  {
    vtkShadowLitmap litmap;
    ASSERT_NO_FATAL_FAILURE(
      this->Draw(MakeLight(vtkShadowLightKind::Directional), MakeDepth(0.25f, 0.75f), litmap));
    EXPECT_GT(litmap.GetNumberOfReceivers(), 0);
    this->Litmap.Release();
    this->Litmap.Release();
    this->Window = nullptr;
    this->Window = NewWindow(16, 16);
  }
}
