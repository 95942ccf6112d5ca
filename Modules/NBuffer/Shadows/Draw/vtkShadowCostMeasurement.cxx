// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCostMeasurement.h"

#include "vtkShadowCounter.h"
#include "vtkShadowTarget.h"
#include "vtkShadowVolumeBuffer.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGL.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowReceivers.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The number of triangles that are drawn, about, and the most of one caster.
constexpr long long Budget = 16384;

/// Repeats some work, and returns the shortest time, in milliseconds.
template <typename Functor>
double MeasureTime(Functor&& work)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < vtkShadowCostMeasurement::Repetitions; ++i)
  {
    glFinish();
    const vtkNBufferClock clock;
    work();
    glFinish();
    shortest = std::min(shortest, clock.GetMilliseconds());
  }
  return shortest;
}

/// Measures the costs of samples and lexels. Returns false, with the cause in `why`, if the depth
/// cannot be read.
bool MeasureLitmaps(const vtkShadowCostMeasurement::Subject& subject,
  vtkShadowCostModel::Costs& costs, std::string& why)
{
  std::vector<float> depth;
  bool done = true;
  const double readTime = MeasureTime(
    [&] { done &= subject.Target.ReadDepth(subject.Window, subject.View.Viewport, depth, why); });
  if (!done)
  {
    return false;
  }
  vtkShadowCostModel::Litmaps litmaps;
  litmaps.Samples = static_cast<long long>(depth.size());
  litmaps.Covered = std::count_if(depth.begin(), depth.end(), vtkNBufferDepthConvention::IsDrawn);
  litmaps.Lexels = static_cast<long long>(subject.Resolution) * subject.Resolution;
  litmaps.Faces = static_cast<int>(subject.Spaces.size());
  vtkShadowLitmap litmap;
  const auto make = [&]
  {
    for (const vtkShadowLightSpace& space : subject.Spaces)
    {
      vtkShadowReceivers::Scatter(
        depth.data(), subject.Receivers, subject.Light, space, subject.Resolution, litmap);
      litmap.Build();
    }
  };
  const double time = MeasureTime(make);
  std::fill(depth.begin(), depth.end(), vtkNBufferDepthConvention::Background);
  const double emptyTime = MeasureTime(make);
  costs.SetFromLitmaps(litmaps, readTime, time, emptyTime);
  return true;
}

/// Plans to draw about as many triangles of whole volumes as the budget allows: those of casters
/// that are spread evenly over all triangles.
vtkShadowPlan PlanSomeVolumes(
  const vtkShadowCostMeasurement::Subject& subject, vtkShadowVolumeStore& store)
{
  vtkShadowPlan plan(subject.Light, subject.View, vtkShadowMode::Unclamped, {}, {});
  const auto count = [&](const vtkShadowPart& part)
  {
    return plan.Decide(part).IsDrawn()
      ? vtkShadowCostModel::CountTriangles(part.Silhouette, subject.Light.IsPositional())
      : 0;
  };
  const long long all = std::accumulate(subject.Parts.begin(), subject.Parts.end(), 0LL,
    [&](long long sum, const vtkShadowPart* part) { return sum + count(*part); });
  long long seen = 0;
  long long planned = 0;
  for (const vtkShadowPart* part : subject.Parts)
  {
    const long long triangles = count(*part);
    seen += triangles;
    if (planned * all < Budget * seen)
    {
      plan.Draw(plan.Decide(*part), *part, store);
      planned += std::min(triangles, Budget);
    }
  }
  return plan;
}

/// Measures the costs of triangles and fragments. Returns false, with the cause in `why`, if an
/// OpenGL call fails.
bool MeasureVolumes(const vtkShadowCostMeasurement::Subject& subject,
  vtkShadowCostModel::Costs& costs, std::string& why)
{
  vtkShadowVolumeStore store;
  std::vector<vtkShadowDraw> draws = PlanSomeVolumes(subject, store).GetDraws();
  vtkShadowCostModel::Volumes volumes;
  for (vtkShadowDraw& draw : draws)
  {
    draw.NumberOfIndices = std::min(draw.NumberOfIndices, static_cast<int>(3 * Budget));
    volumes.Triangles += draw.NumberOfIndices / 3;
  }
  if (volumes.Triangles == 0)
  {
    return true;
  }
  volumes.Fragments = vtkShadowCostModel::EstimateFragments(store.GetVolume(), draws, subject.View);
  vtkShadowVolumeBuffer buffer;
  vtkShadowPlan::View view = subject.View;
  bool done = buffer.Upload(store, why);
  const auto draw = [&]
  {
    done = done &&
      subject.Counter.Count(subject.Window, subject.Target, buffer, view, draws.data(),
        draws.data() + draws.size(), nullptr, why);
  };
  const double time = MeasureTime(draw);
  view.Viewport[2] = view.Viewport[3] = 1; // The transformation to the viewport stays the same.
  for (vtkShadowDraw& single : draws)
  {
    single.Box = { 0, 0, 1, 1 };
  }
  const double pixelTime = MeasureTime(draw);
  if (done)
  {
    const auto samples = static_cast<long long>(subject.Target.GetSamples().size()) *
      subject.View.Viewport[2] * subject.View.Viewport[3];
    costs.SetFromVolumes(volumes, samples, time, pixelTime);
  }
  return done;
}
}

bool vtkShadowCostMeasurement::Measure(
  const Subject& subject, vtkShadowCostModel::Costs& costs, std::string& why)
{
  return MeasureLitmaps(subject, costs, why) && MeasureVolumes(subject, costs, why);
}
VTK_ABI_NAMESPACE_END
