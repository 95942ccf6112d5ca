// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCostModel.h"

#include "vtkNBufferPolygonClip.h"
#include "vtkShadowSilhouette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A difference of two times says little if it stands for a smaller share of the samples.
constexpr double LeastShare = 1.0 / 16;

/// The share of the time of whole volumes that litmaps are assumed to save.
constexpr double Saving = 2.0 / 3.0;

constexpr double MillisecondsPerNanosecond = 1e-6;

/// The largest number of triangles that the estimate measures.
constexpr std::size_t Budget = 4096;

/// The fractional parts of this number's multiples are spread evenly and have no period.
constexpr double GoldenRatio = 0.6180339887498949;

using Polygon = std::vector<glm::dvec4>;

/// The planes of the view as (a, b, c, d), a x + b y + c z + d w >= 0 inside. The far plane is
/// missing because volumes are drawn with depths clamped.
const glm::dvec4 Planes[5] = { { 1, 0, 0, 1 }, { -1, 0, 0, 1 }, { 0, 1, 0, 1 }, { 0, -1, 0, 1 },
  { 0, 0, 1, 1 } };

/// What one of `count` things costs, in nanoseconds, if all take `time` milliseconds.
double GetCost(double time, double count)
{
  return std::max(time, 0.0) / (MillisecondsPerNanosecond * count);
}

double GetAreaInNdc(const Polygon& polygon)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec4& a = polygon[i];
    const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
    const double w = a[3] * b[3];
    sum += w > 0.0 ? (a[0] * b[1] - a[1] * b[0]) / w : 0.0;
  }
  return 0.5 * std::abs(sum);
}
}

namespace vtkShadowCostModel
{
long long CountTriangles(const vtkShadowSilhouette& silhouette, bool positional)
{
  const std::size_t half = silhouette.GetTriangles().size() / 3 + silhouette.GetEdges().size();
  return static_cast<long long>(positional ? 2 * half : half);
}

double EstimateFragments(const vtkShadowVolume& volume, const std::vector<vtkShadowDraw>& draws,
  const vtkShadowDrawList::View& view)
{
  std::vector<std::size_t> ends; // Of each draw among the triangles of all.
  std::size_t triangles = 0;
  for (const vtkShadowDraw& draw : draws)
  {
    triangles += static_cast<std::size_t>(draw.NumberOfIndices) / 3;
    ends.push_back(triangles);
  }
  const std::size_t sampled = std::min(triangles, Budget);
  double area = 0.0;
  Polygon polygon;
  Polygon rest;
  for (std::size_t k = 0; k < sampled; ++k)
  {
    // Taking every n-th triangle would be biased, because the volumes of similar casters have
    // similar triangles at equal distances.
    const double place = static_cast<double>(k) * GoldenRatio;
    const std::size_t t = sampled < triangles
      ? static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(triangles))
      : k;
    // Which draw has it, and where: counted from the end of the draw.
    const auto end = std::upper_bound(ends.begin(), ends.end(), t);
    const vtkShadowDraw& draw = draws[static_cast<std::size_t>(end - ends.begin())];
    const std::size_t first = static_cast<std::size_t>(draw.FirstIndex) +
      static_cast<std::size_t>(draw.NumberOfIndices) - 3 * (*end - t);
    polygon.clear();
    for (std::size_t i = first; i < first + 3; ++i)
    {
      const glm::dvec4& vertex = volume.GetVertices()[volume.GetIndices()[i]];
      polygon.push_back(vtkNBufferGLM::Multiply(view.EyeToClip, view.ToEye(vertex)));
    }
    for (const glm::dvec4& plane : Planes)
    {
      const auto getDistance = [&plane](const glm::dvec4& x)
      { return x[0] * plane[0] + x[1] * plane[1] + x[2] * plane[2] + x[3] * plane[3]; };
      vtkNBufferPolygonClip::Clip(polygon, getDistance, rest);
      polygon.swap(rest);
    }
    area += GetAreaInNdc(polygon);
  }
  return sampled > 0 ? area * 0.25 * view.Viewport[2] * view.Viewport[3] *
      static_cast<double>(triangles) / static_cast<double>(sampled)
                     : 0.0;
}

double Costs::Estimate(const Volumes& volumes) const
{
  return MillisecondsPerNanosecond *
    (this->Fragment * volumes.Fragments + this->Triangle * static_cast<double>(volumes.Triangles));
}

double Costs::Estimate(const Litmaps& litmaps) const
{
  return MillisecondsPerNanosecond *
    (this->Sample * static_cast<double>(litmaps.Samples) +
      litmaps.Faces *
        (this->Lexel * static_cast<double>(litmaps.Lexels) +
          this->Covered * static_cast<double>(litmaps.Covered)));
}

void Costs::SetFromVolumes(const Volumes& volumes, long long samples, double time, double pixelTime)
{
  const double before = this->Triangle;
  this->Triangle = GetCost(pixelTime, static_cast<double>(volumes.Triangles));
  this->Fragment = volumes.Fragments < LeastShare * static_cast<double>(samples)
    ? this->Fragment * this->Triangle / before
    : GetCost(time - pixelTime, volumes.Fragments);
}

void Costs::SetFromLitmaps(const Litmaps& litmaps, double readTime, double time, double emptyTime)
{
  const double before = this->Lexel;
  const auto samples = static_cast<double>(litmaps.Samples);
  const auto covered = static_cast<double>(litmaps.Covered);
  this->Sample = GetCost(readTime, samples);
  this->Lexel = GetCost(emptyTime / litmaps.Faces, static_cast<double>(litmaps.Lexels));
  this->Covered = covered < LeastShare * samples
    ? this->Covered * this->Lexel / before
    : GetCost((time - emptyTime) / litmaps.Faces, covered);
}

bool IsLitmapWorthIt(double whole, double litmap)
{
  return Saving * whole > litmap;
}
}
VTK_ABI_NAMESPACE_END
