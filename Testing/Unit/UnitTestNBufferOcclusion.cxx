// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Boxes against depth images: hidden only if no sampled point of the box would pass the test.
#include "Pixels.h"
#include "SampledViews.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferSurface.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

namespace
{
using Convention = DepthConvention;
using NBufferStudy::DepthConventionNames;
using NBufferStudy::DepthConventions;

struct Scene
{
  Convention Depths = Convention::Forward;
  View Eye;
  vtkNBufferProjection Projection;
  std::vector<float> Depth; ///< Orders of distance, as the depth of VTK is.
  vtkNBufferLevels Levels;

  std::size_t GetIndex(int x, int y) const
  {
    return static_cast<std::size_t>(y) * this->Eye.Width + x;
  }
  /// The depth of the pixel that a point falls on.
  float& GetPixel(const glm::dvec3& point)
  {
    return this->Depth[this->GetIndex(std::min(static_cast<int>(point.x), this->Eye.Width - 1),
      std::min(static_cast<int>(point.y), this->Eye.Height - 1))];
  }
  void Build(int factor, int levels = 20)
  {
    this->Levels.BuildBase(
      this->Depth.data(), this->Eye.Width, this->Eye.Height, factor, vtkNBufferExtremum::Maximum);
    this->Levels.BuildLevels(levels);
  }
  /// The same depth everywhere.
  void Fill(double depth, int factor = 4)
  {
    std::fill(this->Depth.begin(), this->Depth.end(), static_cast<float>(depth));
    this->Build(factor);
  }
  bool IsHidden(const ProjectedBox& box, double sampleDistance = 0.5) const
  {
    return vtkNBufferOcclusionTest(this->Levels, sampleDistance).IsHidden(box.Screen);
  }
  bool IsHiddenByPixels(const ProjectedBox& box, double sampleDistance = 0.5) const
  {
    return vtkNBufferPixelTest(this->Projection, this->Levels, this->Depth.data(), sampleDistance)
      .IsHidden(box.Box, box.Screen);
  }
};

/// Background with rectangles of nearer depth in it: walls with edges and gaps.
void MakeScene(ViewSampler& sampler, double offset, int factor, Convention convention, Scene& scene)
{
  scene.Depths = convention;
  do
  {
    scene.Eye = sampler.MakeView(offset, false);
  } while (scene.Eye.Width > 700 || scene.Eye.Width * scene.Eye.Height < 2 ||
    (scene.Eye.Parallel && convention == Convention::InverseW));
  scene.Projection = MakeProjection(scene.Eye, convention);
  scene.Depth.assign(static_cast<std::size_t>(scene.Eye.Width) * scene.Eye.Height,
    NBufferStudy::GetBackgroundOrder(convention));
  const int walls = sampler.Integer(1, 12);
  for (int n = 0; n < walls; ++n)
  {
    const int x0 = sampler.Integer(-50, scene.Eye.Width - 1);
    const int y0 = sampler.Integer(-50, scene.Eye.Height - 1);
    const int x1 = x0 + sampler.Integer(1, scene.Eye.Width);
    const int y1 = y0 + sampler.Integer(1, scene.Eye.Height);
    const auto depth = static_cast<float>(scene.Eye.ToOrder(sampler.Uniform(0.3, 1.0), convention));
    for (const auto& [x, y] : Pixels({ std::max(x0, 0), std::max(y0, 0),
           std::min(x1, scene.Eye.Width), std::min(y1, scene.Eye.Height) }))
    {
      float& pixel = scene.Depth[scene.GetIndex(x, y)];
      pixel = std::min(pixel, depth);
    }
  }
  scene.Build(factor, 1);
}

/// Random triangles between float points in bounds, and their box.
struct SampledMesh
{
  SampledMesh(ViewSampler& sampler, const Scene& scene, const std::array<double, 6>& bounds)
  {
    const unsigned int triangles = static_cast<unsigned int>(sampler.Integer(1, 4));
    for (unsigned int t = 0; t < triangles; ++t)
    {
      this->Mesh.Triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
      for (int corner = 0; corner < 3; ++corner)
      {
        glm::dvec3 point;
        for (int i = 0; i < 3; ++i)
        {
          point[i] = static_cast<float>(sampler.Uniform(bounds[2 * i], bounds[2 * i + 1]));
        }
        this->Mesh.Points.push_back(point);
      }
    }
    std::array<double, 6> own;
    for (int i = 0; i < 3; ++i)
    {
      const auto range = std::minmax_element(this->Mesh.Points.begin(), this->Mesh.Points.end(),
        [i](const glm::dvec3& a, const glm::dvec3& b) { return a[i] < b[i]; });
      own[2 * i] = (*range.first)[i];
      own[2 * i + 1] = (*range.second)[i];
    }
    this->Box.emplace(scene.Projection, own);
  }

  /// The corners of all triangles, and `count` points of each, on edges and inside.
  std::vector<glm::dvec3> MakePoints(ViewSampler& sampler, int count) const
  {
    std::vector<glm::dvec3> points = this->Mesh.Points;
    for (const auto& triangle : this->Mesh.Triangles)
    {
      for (int n = 0; n < count; ++n)
      {
        glm::dvec3 weights(sampler.Uniform(0.0, 1.0), sampler.Uniform(0.0, 1.0),
          n % 3 == 0 ? 0.0 : sampler.Uniform(0.0, 1.0));
        weights /= weights.x + weights.y + weights.z;
        points.push_back(weights.x * this->Mesh.Points[triangle[0]] +
          weights.y * this->Mesh.Points[triangle[1]] + weights.z * this->Mesh.Points[triangle[2]]);
      }
    }
    return points;
  }

  bool MayBeSeen(const Scene& scene, double sampleDistance = 0.5, std::size_t count = 1000)
  {
    const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    vtkNBufferPixelTest test(scene.Projection, scene.Levels, scene.Depth.data(), sampleDistance);
    return test.MayBeSeen(this->Mesh, identity, this->Box->Screen, this->First, count);
  }

  vtkNBufferMesh Mesh;
  std::optional<ProjectedBox> Box;
  std::size_t First = 0;
};

/// No such point may pass LEQUAL in the pixel that it falls on.
void CheckHidden(Scene& scene, const std::vector<glm::dvec3>& points)
{
  for (const auto& point : points)
  {
    for (int permutation = -1; permutation < 4; ++permutation)
    {
      const auto drawn = permutation < 0
        ? ProjectExactly(scene.Eye, point, scene.Depths)
        : ProjectAsDevice(scene.Eye, point, permutation, scene.Depths);
      if (drawn)
      {
        ASSERT_GT(drawn->z, scene.GetPixel(*drawn)) << testing::PrintToString(*drawn);
      }
    }
  }
}

/// The farthest depth in a rectangle, pixel by pixel, in order of distance.
double GetFarthestInLoop(const Scene& scene, const vtkNBufferRectangle& pixels)
{
  double farthest = -2.0;
  for (const auto& [x, y] : Pixels(pixels))
  {
    farthest = std::max<double>(farthest, scene.Depth[scene.GetIndex(x, y)]);
  }
  return farthest;
}

/// Calls function(sampler, scene, box) for a box in each of `count` scenes, where it lies in the
/// view. Returns how many there were.
template <typename Function>
int ForEachBoxOfViews(unsigned int seed, int count, Convention convention, Function function)
{
  ViewSampler sampler(seed);
  int boxes = 0;
  for (int s = 0; s < count; ++s)
  {
    Scene scene;
    MakeScene(sampler, 0.0, 4, convention, scene);
    const ProjectedBox box(scene.Projection, sampler.MakeBounds(scene.Eye));
    if (box.IsInside())
    {
      SCOPED_TRACE(GetText(scene.Eye, box.Bounds));
      function(sampler, scene, box);
      ++boxes;
    }
  }
  return boxes;
}

/// Calls function(sampler, scene, mesh) for a mesh in each of `count` scenes, where its box lies in
/// the view.
template <typename Function>
void ForEachMesh(unsigned int seed, int count, Convention convention, Function function)
{
  ForEachBoxOfViews(seed, count, convention,
    [&](ViewSampler& sampler, Scene& scene, const ProjectedBox& box)
    {
      SampledMesh mesh(sampler, scene, box.Bounds);
      if (mesh.Box->IsInside())
      {
        function(sampler, scene, mesh);
      }
    });
}

using NBufferOcclusion = testing::TestWithParam<std::tuple<int, Convention>>;
using NBufferOcclusionOfDepths = testing::TestWithParam<Convention>;
}

// Hazard: one pixel or one level is not read, and a visible prop is found hidden.
TEST_P(NBufferOcclusion, HiddenBoxesAreHidden)
{
  const auto [factor, convention] = this->GetParam();
  ViewSampler sampler(static_cast<unsigned int>(20 + factor));
  int hidden[2] = { 0, 0 };
  int hiddenInLoop = 0;
  int tested = 0;
  for (int s = 0; s < 250; ++s)
  {
    Scene scene;
    MakeScene(sampler, s % 3 == 0 ? 1000.0 : 0.0, factor, convention, scene);
    for (int b = 0; b < 40; ++b)
    {
      const ProjectedBox box(scene.Projection, sampler.MakeBounds(scene.Eye));
      if (!box.IsInside())
      {
        continue;
      }
      ++tested;
      SCOPED_TRACE(GetText(scene.Eye, box.Bounds));
      // Just the levels that the box is said to need: a query beyond them would show.
      scene.Levels.BuildLevels(vtkNBufferOcclusionTest::GetLevelsNeeded(box.Screen.Pixels, factor));
      vtkNBufferOcclusionTest test(scene.Levels);
      const bool verdicts[2] = { test.IsHidden(box.Screen), scene.IsHiddenByPixels(box) };
      const bool inLoop = box.Screen.Nearest > GetFarthestInLoop(scene, box.Screen.Pixels);
      ASSERT_TRUE(inLoop || !verdicts[0]) << "hidden, but not in each pixel";
      hiddenInLoop += inLoop;
      for (int i = 0; i < 2; ++i)
      {
        hidden[i] += verdicts[i];
        if (verdicts[i])
        {
          SCOPED_TRACE(i == 0 ? "levels" : "pixels");
          ASSERT_NO_FATAL_FAILURE(CheckHidden(scene, sampler.MakePoints(box.Bounds, 150)));
        }
      }
      ASSERT_EQ(test.GetQueries(), 1);
      const vtkNBufferCover cover =
        vtkNBufferMath::GetCoverOfFour(vtkNBufferMath::GetBaseRectangle(box.Screen.Pixels, factor));
      ASSERT_EQ(test.GetLookups(), cover.Count);
    }
  }
  EXPECT_GT(tested, 1000);
  for (const int count : hidden)
  {
    EXPECT_GT(count, tested / 20) << "the test would show nothing";
  }
  EXPECT_GE(hidden[1], hidden[0] * 9 / 10) << "pixels are meant to be sharper";
  // At least nine in ten of those that a loop over all pixels finds, with texels of one pixel.
  EXPECT_GE(hidden[0], hiddenInLoop * (factor == 1 ? 9 : 7) / 10);
}

INSTANTIATE_TEST_SUITE_P(BaseFactor, NBufferOcclusion,
  testing::Combine(testing::Values(1, 2, 4, 8), testing::ValuesIn(DepthConventions)),
  [](const auto& info)
  {
    return std::to_string(std::get<0>(info.param)) +
      DepthConventionNames[static_cast<int>(std::get<1>(info.param))];
  });

// Hazard: equal depth counts as hidden, although in VTK the prop that is drawn last is seen.
TEST_P(NBufferOcclusionOfDepths, EqualDepthIsVisible)
{
  int nearlyFlush = 0;
  ForEachBoxOfViews(31, 400, this->GetParam(),
    [&](ViewSampler& sampler, Scene& scene, const ProjectedBox& box)
    {
      double nearest = 2.0;
      for (const auto& corner : sampler.MakePoints(box.Bounds, 0))
      {
        const auto point = ProjectExactly(scene.Eye, corner, scene.Depths);
        nearest = std::min(nearest, point ? point->z : 2.0);
      }
      if (nearest <= 1.0)
      {
        ++nearlyFlush;
        // The box's own surface in every pixel, at exactly its nearest depth. (The pixels of the
        // nearest corner alone decide; they may lie beside the window.)
        scene.Fill(nearest);
        EXPECT_FALSE(scene.IsHidden(box));
        EXPECT_GT(box.Screen.Pixels.GetWidth(), 0);
      }
    });
  EXPECT_GT(nearlyFlush, 50);
}

// Hazard: > is replaced by >=. In images the slack moves boxes nearer than their surfaces, so that
// only the numbers themselves show this error.
TEST_P(NBufferOcclusionOfDepths, EqualNumbersAreVisible)
{
  const double order = this->GetParam() == Convention::Forward ? 0.5 : -0.5;
  const int tested = ForEachBoxOfViews(33, 300, this->GetParam(),
    [&](ViewSampler&, Scene& scene, ProjectedBox box)
    {
      scene.Fill(order);
      box.Screen.Nearest = order;
      EXPECT_FALSE(scene.IsHidden(box));
      box.Screen.Nearest = std::nextafter(order, 2.0);
      EXPECT_TRUE(scene.IsHidden(box));
    });
  EXPECT_GT(tested, 20);
}

// Hazard: a wall in front of everything hides nothing.
TEST_P(NBufferOcclusionOfDepths, ANearWallHidesAllBehindIt)
{
  int tested = 0;
  ForEachBoxOfViews(32, 300, this->GetParam(),
    [&](ViewSampler&, Scene& scene, const ProjectedBox& box)
    {
      if (box.Screen.Nearest > scene.Eye.ToOrder(0.002, scene.Depths))
      {
        ++tested;
        scene.Fill(scene.Eye.ToOrder(0.001, scene.Depths));
        EXPECT_TRUE(scene.IsHidden(box));
        EXPECT_TRUE(scene.IsHiddenByPixels(box));
      }
    });
  EXPECT_GT(tested, 50);
}

// Hazard: a visible pixel anywhere in the outline must keep the box. Texels may be nearer (ranks).
TEST_P(NBufferOcclusionOfDepths, OneOpenPixelKeepsTheBox)
{
  int opened = 0;
  ForEachBoxOfViews(33, 400, this->GetParam(),
    [&](ViewSampler& sampler, Scene& scene, const ProjectedBox& box)
    {
      scene.Fill(scene.Eye.ToOrder(0.001, scene.Depths));
      for (const auto& point : sampler.MakePoints(box.Bounds, 20))
      {
        if (const auto drawn = ProjectExactly(scene.Eye, point, scene.Depths))
        {
          // Just open enough for this point.
          scene.GetPixel(*drawn) = std::nextafter(static_cast<float>(drawn->z), 2.0f);
          scene.Build(4);
          EXPECT_FALSE(scene.IsHidden(box));
          EXPECT_FALSE(scene.IsHiddenByPixels(box));
          std::fill(scene.Depth.begin(), scene.Depth.end(), 2.0f);
          EXPECT_FALSE(scene.IsHiddenByPixels(box));
          vtkNBufferLevels& levels = scene.Levels;
          std::fill_n(levels.GetLevelData(0), levels.GetWidth() * levels.GetHeight(), -9.0f);
          EXPECT_TRUE(scene.IsHiddenByPixels(box));
          ++opened;
          return;
        }
      }
    });
  EXPECT_GT(opened, 50);
}

// Hazard: without multisampling a box is kept because of pixels whose middles it cannot cover, or
// is found hidden although it covers the middle of a pixel.
TEST_P(NBufferOcclusionOfDepths, OnlyMiddlesCountWithoutMultisampling)
{
  int opened = 0;
  int keptForTouching = 0;
  int keptForTouchingTexels = 0;
  ForEachBoxOfViews(36, 600, this->GetParam(),
    [&](ViewSampler& sampler, Scene& scene, const ProjectedBox& box)
    {
      const double wall = scene.Eye.ToOrder(0.001, scene.Depths);
      for (const auto& point : sampler.MakePoints(box.Bounds, 60))
      {
        if (const auto drawn = ProjectExactly(scene.Eye, point, scene.Depths))
        {
          scene.Fill(wall);
          scene.GetPixel(*drawn) = std::nextafter(static_cast<float>(drawn->z), 2.0f);
          scene.Build(4);
          // So near to the middle of its pixel that a device may snap the point to it.
          const glm::dvec2 off = glm::abs(glm::fract(glm::dvec2(*drawn)) - 0.5);
          const bool isMiddle = std::max(off.x, off.y) < 1.0 / 16.0;
          EXPECT_FALSE(scene.IsHiddenByPixels(box));
          const bool hidden = scene.IsHiddenByPixels(box, 0.0);
          EXPECT_FALSE(isMiddle && (hidden || scene.IsHidden(box, 0.0)));
          keptForTouchingTexels += scene.IsHidden(box, 0.0);
          opened += isMiddle;
          keptForTouching += hidden;
        }
      }
    });
  EXPECT_GT(opened, 50);
  EXPECT_GT(keptForTouching, 50) << "whole pixels keep more";
  EXPECT_GT(keptForTouchingTexels, 0) << "the rectangles of whole pixels keep more";
}

// Hazard: a triangle, a corner or a pixel is not tested, or a plane is expected too far away.
TEST_P(NBufferOcclusionOfDepths, HiddenTrianglesAreHidden)
{
  int hidden = 0;
  int hiddenByBox = 0;
  int tested = 0;
  ForEachMesh(37, 4000, this->GetParam(),
    [&](ViewSampler& sampler, Scene& scene, SampledMesh& mesh)
    {
      ++tested;
      const bool boxIsHidden = scene.IsHiddenByPixels(*mesh.Box);
      const bool isHidden = !mesh.MayBeSeen(scene);
      EXPECT_EQ(!mesh.MayBeSeen(scene), isHidden) << "another one to begin with";
      EXPECT_EQ(!mesh.MayBeSeen(scene, 0.5, 1), isHidden) << "the one to begin with alone";
      EXPECT_LT(mesh.First, mesh.Mesh.Triangles.size());
      hidden += isHidden || boxIsHidden;
      hiddenByBox += boxIsHidden;
      if (isHidden)
      {
        ASSERT_NO_FATAL_FAILURE(CheckHidden(scene, mesh.MakePoints(sampler, 60)));
      }
    });
  EXPECT_GT(tested, 500);
  EXPECT_GT(hiddenByBox, tested / 20);
  EXPECT_GT(hidden, hiddenByBox + hiddenByBox / 20) << "triangles are meant to be sharper";
}

// Hazard: a triangle is seen through one open pixel, or only in the middle of that pixel, and its
// mesh is found hidden.
TEST_P(NBufferOcclusionOfDepths, OneOpenPixelKeepsTheMesh)
{
  int opened = 0;
  int besideMiddles = 0;
  ForEachMesh(38, 1000, this->GetParam(),
    [&](ViewSampler& sampler, Scene& scene, SampledMesh& mesh)
    {
      for (const auto& point : mesh.MakePoints(sampler, 20))
      {
        if (const auto drawn = ProjectExactly(scene.Eye, point, scene.Depths))
        {
          scene.Fill(scene.Eye.ToOrder(0.001, scene.Depths));
          scene.GetPixel(*drawn) = std::nextafter(static_cast<float>(drawn->z), 2.0f);
          scene.Build(4);
          const glm::dvec2 off = glm::abs(glm::fract(glm::dvec2(*drawn)) - 0.5);
          const bool isMiddle = std::max(off.x, off.y) < 1.0 / 16.0;
          EXPECT_TRUE(mesh.MayBeSeen(scene));
          const bool isSeen = mesh.MayBeSeen(scene, 0.0);
          EXPECT_TRUE(isSeen || !isMiddle);
          opened += isMiddle;
          besideMiddles += !isSeen;
        }
      }
    });
  EXPECT_GT(opened, 50);
  EXPECT_GT(besideMiddles, 50) << "whole pixels keep more";
}

// Hazard: a triangle has a corner behind the eye, or a NaN coordinate, and is found hidden although
// nothing is known about it.
TEST(NBufferTriangles, UnknownPlacesMayBeSeen)
{
  ViewSampler sampler(39);
  Scene scene;
  do
  {
    MakeScene(sampler, 0.0, 4, Convention::Forward, scene);
  } while (scene.Eye.Parallel);
  const glm::dvec3 before = scene.Eye.Position + 2.0 * scene.Eye.Near * scene.Eye.Direction;
  SampledMesh mesh(sampler, scene, { before.x, before.x, before.y, before.y, before.z, before.z });
  scene.Fill(-1.0);
  EXPECT_FALSE(mesh.MayBeSeen(scene)) << "before everything that may be drawn";
  const std::size_t last = mesh.Mesh.Points.size() - 1;
  mesh.Mesh.Points[last] = scene.Eye.Position - 2.0 * scene.Eye.Near * scene.Eye.Direction;
  EXPECT_TRUE(mesh.MayBeSeen(scene));
  EXPECT_EQ(mesh.First, mesh.Mesh.Triangles.size() - 1);
  for (const double value : { std::nan(""), HUGE_VAL })
  {
    mesh.Mesh.Points[last] = { before.x, value, before.z };
    EXPECT_TRUE(mesh.MayBeSeen(scene)) << value;
  }
}

// Hazard: the corners of boxes without thickness differ only by rounding, and so do the directions
// of an outline's edges.
TEST_P(NBufferOcclusionOfDepths, NeedlesAndSheetsHaveAnOutline)
{
  ViewSampler sampler(35);
  int tested = 0;
  for (int s = 0; s < 300; ++s)
  {
    // Before them is nothing: they are hidden only if no pixel is in their outline.
    Scene scene;
    MakeScene(sampler, s % 2 == 0 ? 1000.0 : 0.0, 1, this->GetParam(), scene);
    scene.Fill(NBufferStudy::GetBackgroundOrder(this->GetParam()), 1);
    for (int b = 0; b < 60; ++b)
    {
      // A sheet across one axis or a needle along it.
      std::array<double, 6> bounds = sampler.MakeBounds(scene.Eye);
      const int axis = sampler.Integer(0, 2);
      for (int i = 0; i < 3; ++i)
      {
        const double size = bounds[2 * i + 1] - bounds[2 * i];
        bounds[2 * i + 1] = bounds[2 * i] + ((i == axis) == (b % 4 == 0) ? 0.0 : 20.0 * size);
      }
      const ProjectedBox box(scene.Projection, bounds);
      tested += box.IsInside();
      SCOPED_TRACE(GetText(scene.Eye, bounds));
      if (box.IsInside() && scene.IsHiddenByPixels(box))
      {
        ASSERT_NO_FATAL_FAILURE(CheckHidden(scene, sampler.MakePoints(box.Bounds, 150)));
      }
    }
  }
  EXPECT_GT(tested, 1000);
}

// Hazard: a box that crosses the near plane in view has no nearest depth.
TEST_P(NBufferOcclusionOfDepths, TheNearPlaneInViewIsCrossing)
{
  ViewSampler sampler(34);
  for (int n = 0; n < 500; ++n)
  {
    const View view = sampler.MakeView(0.0);
    const vtkNBufferProjection projection = MakeProjection(view, this->GetParam());
    const glm::dvec3 center = view.Position + view.Near * glm::normalize(view.Direction);
    std::array<double, 6> bounds;
    for (int i = 0; i < 3; ++i)
    {
      const double half = view.Near * sampler.Uniform(0.01, 2.0);
      bounds[2 * i] = center[i] - half;
      bounds[2 * i + 1] = center[i] + half;
    }
    const ProjectedBox box(projection, bounds);
    ASSERT_FALSE(projection.IsOutside(box.Box)) << view.Text;
    ASSERT_EQ(box.Placement, vtkNBufferPlacement::Crossing) << view.Text;
  }
}

// Hazard: in conventions whose far depths are near 0, the slack for depths near 1 would waste the
// precision of floats.
TEST_P(NBufferOcclusionOfDepths, FarBoxesAreTestedAsFinelyAsTheyAreStored)
{
  Scene scene;
  scene.Depths = this->GetParam();
  scene.Eye.Width = 64;
  scene.Eye.Height = 48;
  scene.Eye.Near = 1e-2;
  scene.Eye.Far = 1e5;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetClippingRange(scene.Eye.Near, scene.Eye.Far);
  std::copy_n(camera->GetCompositeProjectionTransformMatrix(64.0 / 48.0, -1.0, 1.0)->GetData(), 16,
    scene.Eye.WorldToClip.begin());
  scene.Projection = MakeProjection(scene.Eye, scene.Depths);
  scene.Depth.resize(64 * 48);
  // A wall at 50 km before a box at 55 km.
  const auto wall = ProjectExactly(scene.Eye, { 0.0, 0.0, -5e4 }, scene.Depths);
  ASSERT_TRUE(wall);
  scene.Fill(wall->z, 1);
  const ProjectedBox box(scene.Projection, { -1e3, 1e3, -1e3, 1e3, -5.6e4, -5.5e4 });
  ASSERT_TRUE(box.IsInside());
  // 24 bits near 1 do not tell them apart.
  EXPECT_EQ(scene.IsHidden(box), scene.Depths != Convention::Forward);
}

INSTANTIATE_TEST_SUITE_P(Each, NBufferOcclusionOfDepths, testing::ValuesIn(DepthConventions),
  [](const auto& info) { return std::string(DepthConventionNames[static_cast<int>(info.param)]); });

// In parallel projection 1 / w is the same everywhere, so that nothing is found hidden.
TEST(NBufferOcclusionOnce, InverseWSaysNothingInParallelProjection)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->ParallelProjectionOn();
  camera->SetClippingRange(1.0, 100.0);
  vtkNBufferProjection projection;
  NBufferStudy::SetProjection(projection,
    camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)->GetData(), 100, 100, 0.0,
    Convention::InverseW);
  EXPECT_EQ(ProjectedBox(projection, { -0.1, 0.1, -0.1, 0.1, -0.1, 0.1 }).Placement,
    vtkNBufferPlacement::Crossing);
}
