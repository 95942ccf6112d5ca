// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What the parts of the culler cost on the host, without OpenGL and without a scene.
//
// Held constant: the depth image (seed 1, a city-like mix of far plane and near rectangles), the
// boxes (seed 2, inside the view), the camera (60 degrees, near 0.1, far 1000, 960 x 720 unless
// the size is a parameter), 24-bit depth, one thread for queries and tests and VTK's default of
// threads for builds. Google Benchmark repeats until a case has run for half a second; sums over
// the results are kept from being optimised away. Compare medians of several repetitions:
//
//     nbuffer-benchmark-micro --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
#include "../Support/Pixels.h"
#include "../Support/ProjectedBox.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

namespace
{
constexpr int Width = 960;
constexpr int Height = 720;

std::vector<float> MakeDepth(int width, int height)
{
  std::vector<float> depth(static_cast<std::size_t>(width) * height, 1.0f);
  std::mt19937 random(1);
  for (int n = 0; n < 60; ++n)
  {
    const int x0 = static_cast<int>(random() % width);
    const int y1 = static_cast<int>(height / 4 + random() % (height / 2));
    const int x1 = std::min<int>(width, x0 + 20 + static_cast<int>(random() % 200));
    const auto value = static_cast<float>(0.95 + 0.0004 * static_cast<double>(random() % 100));
    for (const auto& [x, y] : Pixels({ x0, 0, x1, y1 }))
    {
      float& pixel = depth[static_cast<std::size_t>(y) * width + x];
      pixel = std::min(pixel, value);
    }
  }
  return depth;
}

/// A view, buildings at all distances that lie wholly in it, and a depth image with levels.
struct Street
{
  Street()
  {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(0.0, 0.0, 1.7);
    camera->SetFocalPoint(0.0, 1.0, 1.7);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(60.0);
    camera->SetClippingRange(0.1, 1000.0);
    const double aspect = static_cast<double>(Width) / Height;
    this->Projection.Set(
      camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->GetData(), Width, Height,
      vtkNBufferDepthFormat::FromQuantum(0x1p-24));
    std::mt19937 random(2);
    const auto uniform = [&random](double a, double b)
    { return a + (b - a) * static_cast<double>(random() % 100000) / 100000.0; };
    while (this->Boxes.size() < 4096)
    {
      const double y = uniform(10.0, 900.0);
      const double x = uniform(-0.6, 0.6) * y;
      const double side = uniform(4.0, 25.0);
      const ProjectedBox box(
        this->Projection, { x, x + side, y, y + side, 0.0, uniform(3.0, 20.0) });
      if (box.IsInside())
      {
        this->Boxes.push_back(box);
      }
    }
    this->Levels.BuildBase(this->Depth.data(), Width, Height, 4, vtkNBufferExtremum::Maximum);
    this->Levels.BuildLevels(20);
  }

  /// Calls function(box) for one box after the other; the sum of what it returns, for each call,
  /// becomes the counter `hidden`.
  template <typename Function>
  void Run(benchmark::State& state, const std::vector<ProjectedBox>& boxes, Function function) const
  {
    std::size_t n = 0;
    std::int64_t hidden = 0;
    for (auto _ : state)
    {
      hidden += function(boxes[n++ % boxes.size()]);
    }
    state.counters["hidden"] =
      static_cast<double>(hidden) / static_cast<double>(state.iterations());
  }

  vtkNBufferProjection Projection;
  std::vector<ProjectedBox> Boxes;
  std::vector<float> Depth = MakeDepth(Width, Height);
  vtkNBufferLevels Levels;
};

void BuildBase(benchmark::State& state)
{
  const int width = static_cast<int>(state.range(0));
  const int height = static_cast<int>(state.range(1));
  const int factor = static_cast<int>(state.range(2));
  const std::vector<float> depth = MakeDepth(width, height);
  vtkNBufferLevels levels;
  for (auto _ : state)
  {
    levels.BuildBase(depth.data(), width, height, factor, vtkNBufferExtremum::Maximum);
    benchmark::DoNotOptimize(levels.GetLevelData(0)[0]);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(depth.size()) * 4);
}

void BuildLevels(benchmark::State& state)
{
  const int width = static_cast<int>(state.range(0));
  const int height = static_cast<int>(state.range(1));
  const int factor = static_cast<int>(state.range(2));
  const std::vector<float> depth = MakeDepth(width, height);
  vtkNBufferLevels levels;
  const int count = vtkNBufferMath::GetNumberOfLevels(
    vtkNBufferMath::GetBaseSize(width, factor), vtkNBufferMath::GetBaseSize(height, factor));
  for (auto _ : state)
  {
    state.PauseTiming();
    levels.BuildBase(depth.data(), width, height, factor, vtkNBufferExtremum::Maximum);
    state.ResumeTiming();
    levels.BuildLevels(count);
    benchmark::DoNotOptimize(levels.GetLevelData(count - 1)[0]);
  }
  state.counters["levels"] = count;
}

void SizesAndFactors(benchmark::internal::Benchmark* benchmark)
{
  for (int factor : { 1, 2, 4, 8 })
  {
    benchmark->Args({ 301, 173, factor });
    benchmark->Args({ Width, Height, factor });
    benchmark->Args({ 1920, 1080, factor });
  }
  benchmark->Unit(benchmark::kMicrosecond);
}

/// Squares of one size at random places: the cost must not grow with the size.
void Query(benchmark::State& state, bool four)
{
  const int side = static_cast<int>(state.range(0));
  const std::vector<float> depth = MakeDepth(Width, Height);
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), Width, Height, 1, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(20);
  std::mt19937 random(3);
  std::vector<vtkNBufferRectangle> rectangles;
  for (int n = 0; n < 4096; ++n)
  {
    const int x = static_cast<int>(random() % (Width - side));
    const int y = static_cast<int>(random() % (Height - side));
    rectangles.push_back({ x, y, x + side, y + side });
  }
  std::size_t n = 0;
  for (auto _ : state)
  {
    const vtkNBufferRectangle& r = rectangles[n++ % rectangles.size()];
    benchmark::DoNotOptimize(
      levels.Query(four ? vtkNBufferMath::GetCoverOfFour(r) : vtkNBufferMath::GetCoverOfOne(r)));
  }
}

void FrustumTest(benchmark::State& state)
{
  const Street street;
  street.Run(state, street.Boxes,
    [&](const ProjectedBox& box) { return street.Projection.IsOutside(box.Box); });
}

void Project(benchmark::State& state)
{
  const Street street;
  vtkNBufferScreenBox screen;
  street.Run(state, street.Boxes,
    [&](const ProjectedBox& box)
    {
      const vtkNBufferPlacement placement = street.Projection.Project(box.Box, screen);
      benchmark::DoNotOptimize(screen.Nearest);
      return placement == vtkNBufferPlacement::Outside;
    });
}

/// One prop tested against the levels: rectangle, cover, lookups.
void TestProp(benchmark::State& state)
{
  const Street street;
  vtkNBufferOcclusionTest test(street.Levels);
  street.Run(
    state, street.Boxes, [&](const ProjectedBox& box) { return test.IsHidden(box.Screen); });
}

/// The second opinion, asked only of those that the levels do not hide.
void TestPixels(benchmark::State& state)
{
  const Street street;
  vtkNBufferOcclusionTest test(street.Levels);
  std::vector<ProjectedBox> doubtful;
  std::copy_if(street.Boxes.begin(), street.Boxes.end(), std::back_inserter(doubtful),
    [&](const ProjectedBox& box) { return !test.IsHidden(box.Screen); });
  vtkNBufferPixelTest pixels(street.Projection, street.Levels, street.Depth.data(), 0.5);
  street.Run(
    state, doubtful, [&](const ProjectedBox& box) { return pixels.IsHidden(box.Box, box.Screen); });
}
}

BENCHMARK(BuildBase)->Apply(SizesAndFactors);
BENCHMARK(BuildLevels)->Apply(SizesAndFactors);
BENCHMARK_CAPTURE(Query, One, false)->Arg(1)->Arg(16)->Arg(64)->Arg(256)->Arg(700);
BENCHMARK_CAPTURE(Query, Four, true)->Arg(1)->Arg(16)->Arg(64)->Arg(256)->Arg(700);
BENCHMARK(FrustumTest);
BENCHMARK(Project);
BENCHMARK(TestProp);
BENCHMARK(TestPixels);
BENCHMARK_MAIN();
