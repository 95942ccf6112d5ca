// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCostModel.h"

#include "vtkShadowSilhouette.h"
#include "vtkShadowVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Nanoseconds, see above.
struct Costs
{
  double Fragment;
  double Triangle;
};
constexpr Costs SoftwareCosts = { 5.0, 250.0 };
constexpr Costs DeviceCosts = { 0.05, 45.0 };
constexpr double ReadCost = 5.0;
constexpr double LexelCost = 75.0;
constexpr double SeenCost = 26.0;
constexpr double Saving = 2.0 / 3.0;

/// Triangles that the estimate looks at.
constexpr std::size_t Budget = 4096;

/// Its multiples, without their integers, are spread evenly and in no period.
constexpr double GoldenRatio = 0.6180339887498949;

using Corner = std::array<double, 4>;

/// Planes of the view, all but the far one: volumes are drawn with depths clamped.
constexpr double Planes[5][4] = { { 1, 0, 0, 1 }, { -1, 0, 0, 1 }, { 0, 1, 0, 1 }, { 0, -1, 0, 1 },
  { 0, 0, 1, 1 } };

/// A triangle cut by all planes has at most eight corners.
class Polygon
{
public:
  void Add(const Corner& corner) { this->Corners[this->Size++] = corner; }

  void Cut(const double plane[4])
  {
    const Polygon old = *this;
    this->Size = 0;
    for (std::size_t i = 0; i < old.Size; ++i)
    {
      const Corner& a = old.Corners[i];
      const Corner& b = old.Corners[(i + 1) % old.Size];
      const double distanceA = GetDistance(a, plane);
      const double distanceB = GetDistance(b, plane);
      if (distanceA >= 0.0)
      {
        this->Add(a);
      }
      if ((distanceA >= 0.0) != (distanceB >= 0.0))
      {
        const double t = distanceA / (distanceA - distanceB);
        Corner cut;
        for (std::size_t k = 0; k < 4; ++k)
        {
          cut[k] = a[k] + t * (b[k] - a[k]);
        }
        this->Add(cut);
      }
    }
  }

  double GetAreaInNdc() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      const Corner& a = this->Corners[i];
      const Corner& b = this->Corners[(i + 1) % this->Size];
      const double w = a[3] * b[3];
      sum += w > 0.0 ? (a[0] * b[1] - a[1] * b[0]) / w : 0.0;
    }
    return 0.5 * std::abs(sum);
  }

private:
  static double GetDistance(const Corner& corner, const double plane[4])
  {
    return corner[0] * plane[0] + corner[1] * plane[1] + corner[2] * plane[2] +
      corner[3] * plane[3];
  }

  std::array<Corner, 8> Corners;
  std::size_t Size = 0;
};
}

namespace vtkShadowCostModel
{
long long CountTriangles(const vtkShadowSilhouette& silhouette, bool positional)
{
  const std::size_t half = silhouette.GetTriangles().size() / 3 + silhouette.GetEdges().size();
  return static_cast<long long>(positional ? 2 * half : half);
}

double EstimateFragments(
  const vtkShadowVolume& volume, const double volumeToClip[16], int width, int height)
{
  const float* vertices = volume.GetVertices().data();
  const std::vector<unsigned int>& indices = volume.GetIndices();
  const std::size_t triangles = indices.size() / 3;
  const std::size_t seen = std::min(triangles, Budget);
  double area = 0.0;
  for (std::size_t k = 0; k < seen; ++k)
  {
    // Not at equal distances: volumes of like casters have like triangles at equal distances.
    const double place = static_cast<double>(k) * GoldenRatio;
    const std::size_t t = seen < triangles
      ? static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(triangles))
      : k;
    Polygon polygon;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i)
    {
      const float* v = vertices + 4 * std::size_t(indices[i]);
      Corner corner;
      for (std::size_t row = 0; row < 4; ++row)
      {
        const double* m = volumeToClip + 4 * row;
        corner[row] = m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3] * v[3];
      }
      polygon.Add(corner);
    }
    for (const double* plane : Planes)
    {
      polygon.Cut(plane);
    }
    area += polygon.GetAreaInNdc();
  }
  return seen > 0
    ? area * 0.25 * width * height * static_cast<double>(triangles) / static_cast<double>(seen)
    : 0.0;
}

bool IsLitmapWorthIt(double fragments, long long triangles, long long samples, long long seen,
  long long lexels, int faces, bool softwareRenderer)
{
  const Costs& costs = softwareRenderer ? SoftwareCosts : DeviceCosts;
  const double drawing =
    costs.Fragment * fragments + costs.Triangle * static_cast<double>(triangles);
  return Saving * drawing > ReadCost * static_cast<double>(samples) +
    faces * (LexelCost * static_cast<double>(lexels) + SeenCost * static_cast<double>(seen));
}
}
VTK_ABI_NAMESPACE_END
