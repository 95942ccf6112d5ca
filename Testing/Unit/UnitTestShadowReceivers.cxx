// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// From depth images to litmaps: points whose places are known are projected, their depths rounded,
// and every one must be found where it is.
#include "SameLitmaps.h"
#include "ShadowCaster.h"

#include "vtkShadowReceiverProjector.h"
#include "vtkShadowReceivers.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Kind = vtkShadowLightKind;

/// An image of known points.
struct ReceiverImage
{
  vtkShadowView View;
  std::vector<float> Depth;
  std::vector<Point> World; ///< Exact; of the background anything.
};

struct Camera
{
  bool Parallel = false;
  double Near = 0.1;
  double Far = 1000.0;
  Point Origin = { 0.0, 0.0, 0.0 };
  double Angle = 60.0;
  /// 16 or 24: normalised; 32: float.
  int DepthBits = 24;
};

void PrintTo(const Camera& c, std::ostream* os)
{
  *os << (c.Parallel ? "parallel" : "perspective") << ", near " << c.Near << ", far " << c.Far
      << ", origin " << c.Origin[0] << ", angle " << c.Angle << ", bits " << c.DepthBits;
}

class Maker
{
public:
  Maker(const Camera& camera, int width, int height, unsigned int seed)
    : Setup(camera)
    , Random(seed)
  {
    this->Made.View.Width = width;
    this->Made.View.Height = height;
    this->Made.View.DepthQuantum = camera.DepthBits == 16 ? 0x1p-16 : 0x1p-24;
    this->Made.View.Origin = camera.Origin;
    this->Aspect = static_cast<double>(width) / height;
    // At the origin: the matrix is relative to the eye.
    const Point focus = MakePoint(this->Random, 1.0);
    const Point up = MakePoint(this->Random, 1.0);
    this->Eye->SetPosition(0.0, 0.0, 0.0);
    this->Eye->SetFocalPoint(glm::value_ptr(focus));
    this->Eye->SetViewUp(glm::value_ptr(up));
    this->Eye->OrthogonalizeViewUp();
    this->Eye->SetViewAngle(camera.Angle);
    this->Eye->SetParallelProjection(camera.Parallel);
    this->Eye->SetParallelScale(0.3 * camera.Far);
    this->Eye->SetClippingRange(camera.Near, camera.Far);
    this->WorldToClip = vtkNBufferGLM::ToMatrix(
      this->Eye->GetCompositeProjectionTransformMatrix(this->Aspect, -1.0, 1.0)->GetData());
    this->Made.View.ClipToWorld = vtkNBufferGLM::Invert(this->WorldToClip);
  }

  /// Uniform in [-size, size].
  double Number(double size) { return MakeUniform(this->Random, -size, size); }

  /// A point for the next sample: at distance z, seen at (x, y) in pixels.
  void Add(double x, double y, double z)
  {
    const Point forward = glm::make_vec3(this->Eye->GetDirectionOfProjection());
    const Point up = glm::make_vec3(this->Eye->GetViewUp());
    const Point right = glm::cross(forward, up);
    const double size = this->Setup.Parallel
      ? this->Eye->GetParallelScale()
      : z * std::tan(vtkMath::RadiansFromDegrees(0.5 * this->Setup.Angle));
    const double across = size * this->Aspect * (2.0 * x / this->Made.View.Width - 1.0);
    const double upwards = size * (2.0 * y / this->Made.View.Height - 1.0);
    const Point point = z * forward + across * right + upwards * up;
    this->Made.World.push_back(this->Setup.Origin + point);
    // As a graphics device does it: everything rounded to float, in the clip coordinates too.
    const glm::vec4 rounded(point, 1.0);
    float clip[2] = { 0.0f, 0.0f };
    for (int i = 0; i < 4; ++i)
    {
      clip[0] += static_cast<float>(this->WorldToClip[i][2]) * rounded[i];
      clip[1] += static_cast<float>(this->WorldToClip[i][3]) * rounded[i];
    }
    this->Made.Depth.push_back(this->Round(0.5f * (clip[0] / clip[1]) + 0.5f));
  }

  /// All samples, at distances of all magnitudes; one in eight is background.
  void AddAll()
  {
    for (const std::array<double, 2>& sample : this->Made.View.Samples)
    {
      for (const auto& [x, y] : Pixels(this->Made.View.Width, this->Made.View.Height))
      {
        const double t = 0.5 + this->Number(0.4999);
        this->Add(x + sample[0], y + sample[1],
          this->Setup.Near * std::pow(this->Setup.Far / this->Setup.Near, t));
        if (this->Random() % 8 == 0)
        {
          this->Made.Depth.back() = 1.0f;
        }
      }
    }
  }

  /// Positional ones are near one of the points.
  vtkShadowLight MakeLight(Kind kind)
  {
    vtkShadowLight light;
    light.Kind = kind;
    const Point& near = this->Made.World[this->Random() % this->Made.World.size()];
    const Point offset = glm::abs(near - this->Setup.Origin);
    const double distance = offset[0] + offset[1] + offset[2];
    light.Direction = vtkNBufferGLM::Normalize(MakePoint(this->Random, 1.0));
    light.Position = near + MakePoint(this->Random, distance);
    light.ConeAngle = 45.0 + this->Number(44.0);
    return light;
  }

  /// The width of a pixel at a point.
  double GetPixel(const Point& world) const
  {
    const Point forward = glm::make_vec3(this->Eye->GetDirectionOfProjection());
    return 2.0 * glm::dot(world - this->Setup.Origin, forward) *
      std::tan(vtkMath::RadiansFromDegrees(0.5 * this->Setup.Angle)) / this->Made.View.Height;
  }

  /// The image's receivers in a litmap; their number.
  vtkIdType Scatter(const vtkShadowLight& light, int resolution, vtkShadowLitmap& litmap) const
  {
    return vtkShadowReceivers::Scatter(this->Made.Depth.data(), this->Made.View, light,
      vtkShadowLightSpace(light), resolution, litmap);
  }

  ReceiverImage Made;

private:
  /// As it would be stored, one step off now and then.
  float Round(float depth)
  {
    depth = std::clamp(depth, 0.0f, 1.0f);
    if (this->Setup.DepthBits == 32)
    {
      return std::nextafter(depth, this->Random() % 2 ? 0.0f : 1.0f);
    }
    const double steps = std::ldexp(1.0, this->Setup.DepthBits) - 1.0;
    return static_cast<float>(
      std::clamp(std::round(depth * steps + this->Number(1.0)), 0.0, steps) / steps);
  }

  Camera Setup;
  double Aspect;
  std::mt19937 Random;
  vtkNew<vtkCamera> Eye;
  glm::dmat4 WorldToClip;
};

bool IsInside(const vtkShadowBlock& block, const Point& pqs)
{
  return glm::all(glm::lessThanEqual(block.Low, pqs)) &&
    glm::all(glm::lessThanEqual(pqs, block.High));
}

/// Scatter the image and look for every point that the light reaches; returns how many there are.
int CheckAll(
  const ReceiverImage& image, const vtkShadowLight& light, int resolution, vtkShadowLitmap& litmap)
{
  const vtkShadowView& view = image.View;
  int found = 0;
  for (const vtkShadowLightSpace& frame : MakeFrames(light))
  {
    vtkShadowReceivers::Scatter(image.Depth.data(), view, light, frame, resolution, litmap);
    litmap.Build();
    for (std::size_t i = 0; i < image.Depth.size(); ++i)
    {
      const Point pqs = frame.ToLight(image.World[i]);
      const bool inFrame = light.Kind == Kind::Directional ||
        (pqs[2] > 0.0 && IsReached(light, image.World[i]) &&
          (light.Kind == Kind::Spot || std::max(std::abs(pqs[0]), std::abs(pqs[1])) <= 1.0));
      if (image.Depth[i] >= 1.0f || !inFrame)
      {
        continue;
      }
      const int x = static_cast<int>(i % view.Width);
      const int y = static_cast<int>(i / view.Width) % view.Height;
      const vtkNBufferRectangle lexels = litmap.GetLexels(pqs[0], pqs[1], pqs[0], pqs[1]);
      // Without the guard, where it is not cut at the border.
      const bool whole = lexels.GetWidth() == 3 && lexels.GetHeight() == 3;
      const vtkShadowExtent extent = whole
        ? litmap.GetLevelData(0)[(lexels.Y0 + 1) * resolution + lexels.X0 + 1]
        : litmap.Query(pqs[0], pqs[1], pqs[0], pqs[1]);
      SCOPED_TRACE(testing::Message()
        << std::setprecision(17) << "sample " << i << ", depth " << image.Depth[i] << ", p, q, s "
        << testing::PrintToString(pqs) << ", extent " << extent.Near << " to " << extent.Far
        << ", kind " << static_cast<int>(light.Kind));
      EXPECT_TRUE(extent.X0 <= x && x < extent.X1 && extent.Y0 <= y && y < extent.Y1);
      EXPECT_TRUE(extent.Near <= pqs[2] && pqs[2] <= extent.Far);
      const auto slabs = litmap.GetSlabs(extent, 1);
      EXPECT_TRUE(std::any_of(slabs.begin(), slabs.end(),
        [&](const auto& slab) { return slab.Near <= pqs[2] && pqs[2] <= slab.Far; }));
      const vtkShadowTiles::Layers& tile =
        litmap.GetTiles().Get(x / vtkShadowTiles::Size, y / vtkShadowTiles::Size);
      EXPECT_TRUE(IsInside(tile[0], pqs) || IsInside(tile[1], pqs));
      ++found;
      if (testing::Test::HasFailure())
      {
        return found;
      }
    }
  }
  return found;
}

using ShadowReceivers = testing::TestWithParam<Camera>;
}

// Hazard: a receiver is in a lexel that no query reads, or outside of the lexel's extent, and loses
// its shadow.
TEST_P(ShadowReceivers, NoneIsMissed)
{
  vtkShadowLitmap litmap;
  const int sizes[][2] = { { 37, 23 }, { 1, 50 }, { 50, 1 }, { 16, 16 }, { 3, 5 }, { 1, 1 } };
  const int resolutions[] = { 64, 1, 17, 256 };
  int found = 0;
  for (unsigned int n = 0; n < 24; ++n)
  {
    const Kind kind = static_cast<Kind>(n % 3);
    SCOPED_TRACE("case " + std::to_string(n));
    Maker maker(this->GetParam(), sizes[n % 6][0], sizes[n % 6][1], 100 + n);
    maker.AddAll();
    found += CheckAll(maker.Made, maker.MakeLight(kind), resolutions[n / 3 % 4], litmap);
    if (this->HasFailure())
    {
      return;
    }
  }
  EXPECT_GT(found, 1000);
}

INSTANTIATE_TEST_SUITE_P(Cameras, ShadowReceivers,
  testing::Values(Camera(), Camera{ false, 0.1, 1000.0, { 0, 0, 0 }, 60.0, 16 },
    Camera{ false, 0.1, 1000.0, { 0, 0, 0 }, 60.0, 32 },
    Camera{ false, 1e-3, 1e5, { 0, 0, 0 }, 100.0, 24 },
    Camera{ false, 1e-3, 1e5, { 0, 0, 0 }, 40.0, 16 },
    Camera{ false, 1e-3, 1e5, { 5e6, -4e6, 300 }, 60.0, 32 },
    Camera{ false, 1e-4, 1.0, { 5e6, 5e6, -5e6 }, 60.0, 32 },
    Camera{ false, 1.0, 3.0, { 5e6, 5e6, 5e6 }, 1.0, 24 },
    Camera{ false, 1e5, 1.0001e5, { -5e6, 0, 1 }, 0.01, 24 },
    Camera{ true, 0.1, 1000.0, { 0, 0, 0 }, 60.0, 24 },
    Camera{ true, 1.0, 20.0, { 5e6, -5e6, 5e6 }, 60.0, 16 },
    Camera{ true, 1e-3, 1e5, { 5e6, 0, 0 }, 60.0, 32 }));

// Hazard: a receiver between two faces of the cube around a point light belongs to neither.
TEST(ShadowReceiversOnce, EdgesOfTheCube)
{
  vtkShadowLitmap litmap;
  for (unsigned int n = 0; n < 300; ++n)
  {
    Maker maker(Camera(), 1, 1, 200 + n);
    maker.Add(0.5, 0.5, 20.0);
    vtkShadowLight light;
    light.Kind = Kind::Point;
    const double s = 20.0 + maker.Number(19.0);
    const double edge = s * (1.0 + maker.Number(1.0) * (n % 2 ? 1e-3 : 1e-7));
    const Point offset = { s, edge, maker.Number(s) };
    for (int i = 0; i < 3; ++i)
    {
      light.Position[i] =
        maker.Made.World[0][i] + offset[(i + static_cast<int>(n)) % 3] * (n % 4 < 2 ? 1.0 : -1.0);
    }
    EXPECT_GE(CheckAll(maker.Made, light, 64, litmap), 1) << "case " << n;
  }
}

// All samples of a multisampled pixel are receivers, each at its own place.
TEST(ShadowReceiversOnce, Multisampling)
{
  Maker maker(Camera(), 21, 13, 7);
  maker.Made.View.Samples = { { { 0.375, 0.125 } }, { { 0.875, 0.375 } }, { { 0.125, 0.625 } },
    { { 0.625, 0.875 } } };
  maker.AddAll();
  ASSERT_EQ(maker.Made.Depth.size(), 4u * 21u * 13u);
  vtkShadowLitmap litmap;
  const int found = CheckAll(maker.Made, maker.MakeLight(Kind::Directional), 100, litmap);
  EXPECT_EQ(found, litmap.GetNumberOfReceivers());
}

// With any number of threads, even more than rows, the litmap equals that of one thread, to the
// bit.
TEST(ShadowReceiversOnce, ThreadsDoNotMatter)
{
  for (const auto& [width, height] : { std::pair(61, 43), std::pair(700, 2) })
  {
    Maker maker(Camera(), width, height, 11);
    maker.Made.View.Samples = { { { 0.25, 0.75 } }, { { 0.75, 0.25 } } };
    maker.AddAll();
    const vtkShadowLight light = maker.MakeLight(Kind::Spot);
    const vtkShadowLightSpace frame(light);
    const auto scatter = [&](int threads, vtkShadowLitmap& litmap)
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        [&]() { maker.Scatter(light, 16, litmap); });
      litmap.Build();
    };
    vtkShadowLitmap one;
    scatter(1, one);
    EXPECT_GT(one.GetNumberOfReceivers(), 50);
    for (const int threads : { 2, 3, 5 })
    {
      SCOPED_TRACE("threads: " + std::to_string(threads));
      vtkShadowLitmap litmap;
      scatter(threads, litmap);
      ExpectSameLitmaps(one, litmap);
    }
  }
}

// Receivers are the samples with depth that the light reaches; their number is exact.
TEST(ShadowReceiversOnce, WhichSamplesAreReceivers)
{
  Maker maker(Camera(), 40, 30, 8);
  maker.AddAll();
  const vtkShadowLight light = maker.MakeLight(Kind::Directional);
  const vtkShadowLightSpace frame(light);
  vtkShadowLitmap litmap;
  const std::vector<float>& depth = maker.Made.Depth;
  const auto expected = std::count_if(depth.begin(), depth.end(), [](float z) { return z < 1.0f; });
  const auto count = [&](const std::vector<float>& image)
  { return vtkShadowReceivers::Scatter(image.data(), maker.Made.View, light, frame, 32, litmap); };
  EXPECT_EQ(count(depth), expected);
  EXPECT_EQ(CheckAll(maker.Made, light, 32, litmap), expected);
  EXPECT_EQ(count(std::vector<float>(depth.size(), 1.0f)), 0);
  litmap.Build();
  EXPECT_TRUE(litmap.Query(-1e9, -1e9, 1e9, 1e9).IsEmpty());
  EXPECT_EQ(count(std::vector<float>(depth.size(), std::nanf(""))), 0);
}

// It is not enough to be conservative: what a spot does not reach is left out, except for a margin.
TEST(ShadowReceiversOnce, OutsideOfTheConeIsLeftOut)
{
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    Maker maker(Camera{ false, 1.0, 100.0 }, 40, 30, 30 + seed);
    maker.AddAll();
    vtkShadowLight light = maker.MakeLight(Kind::Spot);
    vtkShadowLight wider = light;
    wider.ConeAngle += 0.2;
    int reached = 0;
    int atMost = 0;
    for (std::size_t i = 0; i < maker.Made.Depth.size(); ++i)
    {
      if (maker.Made.Depth[i] < 1.0f)
      {
        reached += IsReached(light, maker.Made.World[i]);
        atMost += IsReached(wider, maker.Made.World[i]);
      }
    }
    vtkShadowLitmap litmap;
    const vtkIdType count = maker.Scatter(light, 32, litmap);
    EXPECT_GE(count, reached) << "seed " << seed;
    // Far away, where a quantum of depth is longer than the margin, and next to the apex.
    EXPECT_LE(count, atMost + 12) << "seed " << seed;
  }
}

// Lines and points are lit as their middle is, which may be some pixels away from their samples:
// receivers within that margin of the cone are added, and no others.
TEST(ShadowReceiversOnce, OnlyWhatMayBeLitBesideItsSampleIsAdded)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    for (const double margin : { 0.0, 1.5, 20.0, infinity })
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", margin " << margin);
      Maker maker(Camera{ false, 1.0, 100.0 }, 40, 30, 30 + seed);
      maker.AddAll();
      const vtkShadowLight light = maker.MakeLight(Kind::Spot);
      maker.Made.View.LightingMargin = margin;
      int reached = 0;
      int atMost = 0;
      for (std::size_t i = 0; i < maker.Made.Depth.size(); ++i)
      {
        const Point fromLight = maker.Made.World[i] - light.Position;
        const double beside = std::acos(glm::dot(glm::normalize(fromLight), light.Direction)) -
          vtkMath::RadiansFromDegrees(light.ConeAngle);
        // From the point to the cone; from behind the cone, to its apex.
        const double away =
          glm::length(fromLight) * std::sin(std::clamp(beside, 0.0, 0.5 * vtkMath::Pi()));
        const double pixels = away / maker.GetPixel(maker.Made.World[i]);
        reached += maker.Made.Depth[i] < 1.0f && pixels <= margin;
        atMost += maker.Made.Depth[i] < 1.0f && (pixels <= 1.1 * margin || beside < 0.004);
      }
      vtkShadowLitmap litmap;
      const vtkIdType count = maker.Scatter(light, 32, litmap);
      EXPECT_GE(count, reached);
      EXPECT_LE(count, atMost + 12);
    }
  }
}

// Far from the origin, VTK's shader may see the edge of the cone whole units away from its place:
// receivers there are added, too.
TEST(ShadowReceiversOnce, WhatRoundingBringsIntoTheConeIsNotLeftOut)
{
  constexpr double far = 1e6;
  // A shader's place, in each coordinate: a few steps of floats as large as this.
  const double rounding = 4.0 * far * 0x1p-24;
  vtkIdType more = 0;
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    Maker maker(Camera{ false, 1.0, 100.0 }, 40, 30, 30 + seed);
    maker.AddAll();
    vtkShadowLight light = maker.MakeLight(Kind::Spot);
    vtkShadowLitmap litmap;
    const vtkIdType near = maker.Scatter(light, 32, litmap);
    int reached = 0;
    for (std::size_t i = 0; i < maker.Made.Depth.size(); ++i)
    {
      bool any = false;
      for (int k = 0; k < 6; ++k)
      {
        Point x = maker.Made.World[i];
        x[k / 2] += k % 2 ? rounding : -rounding;
        any = any || IsReached(light, x);
      }
      reached += maker.Made.Depth[i] < 1.0f && any;
    }
    maker.Made.View.Origin += far;
    light.Position += far;
    const vtkIdType found = maker.Scatter(light, 32, litmap);
    EXPECT_GE(found, reached) << "seed " << seed;
    EXPECT_GE(found, near) << "seed " << seed;
    EXPECT_TRUE(found == near || litmap.GetWidestAngle() > 0.0) << "seed " << seed;
    more += found - near;
  }
  EXPECT_GT(more, 20);
}

// A volume that is pushed away from the eye covers receivers as if they were nearer to the eye,
// also before the near plane. The interval of the receiver begins where such a volume may be.
TEST(ShadowReceiversOnce, PushedVolumesMeetNearerReceivers)
{
  int beforeNearPlane = 0;
  for (const bool parallel : { false, true })
  {
    Maker maker(Camera{ parallel, 10.0, 100.0, { 5.0, -7.0, 3.0 } }, 40, 30, 70);
    vtkShadowView& view = maker.Made.View;
    view.Push = parallel ? 0.5 : 8.0; // in clip coordinates; 0.5 are 22.5 units
    vtkShadowLight light;
    light.Direction = glm::normalize(Point(1.0, 2.0, -3.0));
    const vtkShadowLightSpace space(light);
    vtkShadowReceiverProjector projector(view, light, space);
    const glm::dmat4 worldToClip = glm::inverse(view.ClipToWorld);
    for (int i = 0; i < 2000; ++i)
    {
      // A point of the volume, in front of the eye.
      const double z = maker.Number(1.0) * (parallel ? 2.0 : 1.0);
      glm::dvec4 point =
        view.ClipToWorld * glm::dvec4(maker.Number(1.0), maker.Number(1.0), z, 1.0);
      point /= point.w;
      glm::dvec3 relative(point);
      relative *= parallel ? 1.0 : 0.3 + 0.7 * std::abs(maker.Number(1.0));
      const glm::dvec4 clip = worldToClip * glm::dvec4(relative, 1.0);
      const double depth = 0.5 * (clip.z + view.Push) / clip.w + 0.5;
      if (depth < 1e-3 || depth > 0.999)
      {
        continue;
      }
      beforeNearPlane += clip.z < -clip.w;
      const double x = 0.5 * (clip.x / clip.w + 1.0) * view.Width;
      const double y = 0.5 * (clip.y / clip.w + 1.0) * view.Height;
      projector.SetRow({ x - std::floor(x), y - std::floor(y) }, static_cast<int>(y));
      const auto receiver = projector.Project(static_cast<int>(x), depth);
      ASSERT_TRUE(receiver);
      const glm::dvec3 pqs = space.ToLight(view.Origin + relative);
      const vtkShadowBlock interval = { glm::min(receiver->A, receiver->B) - receiver->GetRadii(),
        glm::max(receiver->A, receiver->B) + receiver->GetRadii() };
      EXPECT_TRUE(IsInside(interval, pqs));
      // A quarter of a pixel, and rounding.
      EXPECT_LT(glm::distance(receiver->A, pqs), parallel ? 0.51 : 0.02 * clip.w);
    }
  }
  EXPECT_GT(beforeNearPlane, 100);
}

// It is not enough to be conservative: the extent around a single receiver is tight.
TEST(ShadowReceiversOnce, ExtentsAreTight)
{
  for (unsigned int seed = 0; seed < 50; ++seed)
  {
    Camera camera;
    camera.Parallel = seed % 2 != 0;
    Maker maker(camera, 30, 20, 60 + seed);
    maker.AddAll();
    std::vector<float> depth(maker.Made.Depth.size(), 1.0f);
    const std::size_t i = seed * 7;
    const double z = camera.Parallel ? 300.0 : 5.0;
    maker.Made.Depth.clear();
    maker.Made.World.clear();
    maker.Add(i % 30 + 0.5, i / 30 + 0.5, z);
    depth[i] = maker.Made.Depth[0];
    const vtkShadowLight light = maker.MakeLight(Kind::Directional);
    const vtkShadowLightSpace frame(light);
    vtkShadowLitmap litmap;
    ASSERT_EQ(
      vtkShadowReceivers::Scatter(depth.data(), maker.Made.View, light, frame, 64, litmap), 1);
    litmap.Build();
    const Point pqs = frame.ToLight(maker.Made.World[0]);
    const vtkShadowExtent extent = litmap.Query(pqs[0], pqs[1], pqs[0], pqs[1]);
    const int x = static_cast<int>(i) % 30;
    const int y = static_cast<int>(i) / 30;
    EXPECT_EQ((vtkNBufferRectangle{ extent.X0, extent.Y0, extent.X1, extent.Y1 }),
      (vtkNBufferRectangle{ x, y, x + 1, y + 1 }));
    // A quarter of a pixel on both sides: of 2 * 300 or 2 * 5 tan(30) in 20 pixels. Then 10 quanta,
    // 5 * 5 / 0.1 * 2^-24 * 20 or 1000 * 2^-24 * 20, twice that aslant, and the rounding, 300 *
    // 2^-20 * 4.
    const double half = camera.Parallel ? 0.5 * 30.0 : 0.5 * 0.28868;
    EXPECT_LE(extent.Far - extent.Near, half + (camera.Parallel ? 4e-3 : 6e-4)) << "seed " << seed;
    EXPECT_GE(extent.Far - extent.Near, half) << "seed " << seed;
    EXPECT_TRUE(litmap.Query(pqs[0] + 2.0 * half, pqs[1], pqs[0] + 3.0 * half, pqs[1]).IsEmpty());
  }
}

// A small object is in front of a distant one: each has its own block, and neither block contains
// what is between them.
TEST(ShadowReceiversOnce, LayersAreWhatLiesApart)
{
  for (const bool parallel : { false, true })
  {
    SCOPED_TRACE(parallel ? "parallel" : "perspective");
    Camera camera;
    camera.Parallel = parallel;
    Maker maker(camera, 9, 6, 81);
    const double distances[] = { 10.0, 200.0 };
    for (int i = 0; i < 9 * 6; ++i)
    {
      maker.Add(i % 9 + 0.5, i / 9 + 0.5, distances[i % 2]);
    }
    const vtkShadowView& view = maker.Made.View;
    const vtkShadowLight light; // straight down
    const vtkShadowLightSpace frame(light);
    vtkShadowLitmap litmap;
    ASSERT_EQ(
      vtkShadowReceivers::Scatter(maker.Made.Depth.data(), view, light, frame, 16, litmap), 9 * 6);
    const vtkShadowTiles& tiles = litmap.GetTiles();
    ASSERT_EQ(tiles.GetNumberOfColumns(), (9 + vtkShadowTiles::Size - 1) / vtkShadowTiles::Size);
    ASSERT_EQ(tiles.GetNumberOfRows(), (6 + vtkShadowTiles::Size - 1) / vtkShadowTiles::Size);
    for (int i = 0; i < 9 * 6; ++i)
    {
      const Point pqs = frame.ToLight(maker.Made.World[static_cast<std::size_t>(i)]);
      const vtkShadowTiles::Layers& tile =
        tiles.Get(i % 9 / vtkShadowTiles::Size, i / 9 / vtkShadowTiles::Size);
      EXPECT_TRUE(IsInside(tile[i % 2], pqs)) << i;
      // (A tile of this parallel view is wider than the way from the near ones to the far ones.)
      EXPECT_TRUE(parallel || !IsInside(tile[1 - i % 2], pqs)) << i;
    }
  }
}
