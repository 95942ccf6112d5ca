// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSliverTest.h"

#include "vtkNBufferSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The area of the parallelogram that two vectors span in x and y, with its sign.
double Cross(const glm::dvec3& a, const glm::dvec3& b)
{
  return a.x * b.y - a.y * b.x;
}

/// The least and the greatest of each coordinate.
std::pair<glm::dvec3, glm::dvec3> GetRange(const std::array<glm::dvec3, 3>& corners)
{
  const auto& [a, b, c] = corners;
  return { glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c) };
}
}

vtkNBufferSliverTest::vtkNBufferSliverTest(
  const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, double sampleDistance)
  : Projection(projection)
  , Levels(levels)
  , SampleDistance(sampleDistance)
{
}

void vtkNBufferSliverTest::Project(const vtkNBufferMesh& mesh, const double toWorld[16])
{
  const vtkNBufferProjection::Rows rows =
    this->Projection.GetWindowMatrix(vtkNBufferGLM::ToMatrix(toWorld));
  this->Points.resize(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const glm::dvec3& point = mesh.Points[i];
    const auto evaluate = [&](int row) { return vtkNBufferBoxError::Evaluate(rows[row], point); };
    const double w = evaluate(3);
    const double inverse = w > 0.0 ? 1.0 / w : std::numeric_limits<double>::quiet_NaN();
    this->Points[i] = inverse * glm::dvec3(evaluate(0), evaluate(1), evaluate(2));
  }
}

bool vtkNBufferSliverTest::MayBeSeen(
  const vtkNBufferMesh& mesh, const double toWorld[16], const vtkNBufferScreenBox& screen)
{
  const Errors errors = this->Projection.GetTriangleErrors(screen);
  const double inverseSlope = 1.0 / errors.CoveredSlope;
  // Two corners may err by the diagonal of PositionError each, and 2 sqrt(2) is less than 3.
  const double heightError = 3.0 * errors.PositionError;
  this->Project(mesh, toWorld);
  for (const std::array<unsigned int, 3>& triangle : mesh.Triangles)
  {
    const Corners corners = { this->Points[triangle[0]], this->Points[triangle[1]],
      this->Points[triangle[2]] };
    const auto& [a, b, c] = corners;
    const auto [low, high] = GetRange(corners);
    // This is not less than the longest side, so that the height is never overestimated.
    const double length = high.x - low.x + high.y - low.y;
    const double area = std::abs(Cross(b - a, c - a));
    const double range = high.z - low.z;
    if (area >=
      length * (heightError + errors.LowestRelativeHeight * length + range * inverseSlope))
    {
      continue;
    }
    if (this->MayBeSeen(corners, heightError, errors))
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferSliverTest::MayBeSeen(
  const Corners& corners, double heightError, const Errors& errors) const
{
  // The longest side runs from `from` to `to`.
  const auto getLength = [](const glm::dvec3& a, const glm::dvec3& b)
  { return glm::distance(glm::dvec2(a), glm::dvec2(b)); };
  int first = 0;
  double length = getLength(corners[0], corners[1]);
  for (int i = 1; i < 3; ++i)
  {
    const double other = getLength(corners[i], corners[(i + 1) % 3]);
    if (other > length)
    {
      length = other;
      first = i;
    }
  }
  const glm::dvec3& from = corners[first];
  const glm::dvec3& to = corners[(first + 1) % 3];
  const glm::dvec3& third = corners[(first + 2) % 3];
  // Triangles that reach behind the eye are not covered. No device draws a triangle with two
  // corners in one place.
  if (!std::isfinite(length + third.x + third.y) || getLength(from, third) == 0.0 ||
    getLength(to, third) == 0.0)
  {
    return false;
  }
  const glm::dvec3 side = to - from;
  const glm::dvec3 toThird = third - from;
  const double own = length > 0.0 ? std::abs(Cross(side, toThird)) / length : 0.0;
  // No point of the triangle is farther from its longest side. 1.5 allows for diagonals (sqrt(2)).
  const double distance =
    own + errors.Overshoot + 1.5 * (errors.PositionError + this->SampleDistance);
  const double height = own - heightError;
  double allowance = std::numeric_limits<double>::infinity();
  if (height > 0.0 && height >= errors.LowestRelativeHeight * length)
  {
    const double along = side.z / length;
    const double foot = glm::dot(glm::dvec2(side), glm::dvec2(toThird)) / length;
    const double across = toThird.z - along * foot;
    const auto [low, high] = GetRange(corners);
    // The triangle that the device draws has displaced vertices, which may make it steeper.
    const double steepness = std::abs(along) * (1.0 + 3.0 * errors.PositionError / length);
    const double slope = steepness +
      (std::abs(across) + 3.0 * errors.PositionError * steepness + 2.0 * errors.DepthError) /
        height;
    const double rounding = std::min(errors.SlopeRounding, errors.SlopeRoundingPerLength * length) *
      (high.z - low.z + 2.0 * errors.DepthError) / height;
    const double stray = slope * errors.DepthErrorPerSlope + rounding;
    if (stray <= errors.BoxSlack)
    {
      return false;
    }
    allowance = errors.DepthError + std::max(-across, 0.0) + 2.0 * distance * steepness + stray;
  }
  return this->MayBeSeen(from, to, distance, allowance);
}

bool vtkNBufferSliverTest::MayBeSeen(
  const glm::dvec3& from, const glm::dvec3& to, double distance, double allowance) const
{
  // Pixel by pixel along the axis on which the line is longer: u is along that axis, v across it.
  const bool alongX = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
  const int along = alongX ? 0 : 1;
  const int other = 1 - along;
  const double u0 = from[along];
  const double v0 = from[other];
  const double du = to[along] - from[along];
  const double dv = to[other] - from[other];
  const double slope = du != 0.0 ? dv / du : 0.0;
  const double across = distance * std::hypot(1.0, slope);
  const glm::ivec2 pixels = { this->Levels.GetPixelWidth(), this->Levels.GetPixelHeight() };
  const int sizeU = pixels[along];
  const int sizeV = pixels[other];
  const int factor = this->Levels.GetFactor();
  // The first and the last pixel whose middle is in an interval.
  const auto getFirst = [](double x, int size)
  { return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(size))); };
  const auto getLast = [](double x, int size)
  { return static_cast<int>(std::clamp(std::floor(x - 0.5), -1.0, size - 1.0)); };

  const int lastU = getLast(std::max(u0, u0 + du) + distance, sizeU);
  for (int u = getFirst(std::min(u0, u0 + du) - distance, sizeU); u <= lastU; ++u)
  {
    const double v = v0 + slope * (u + 0.5 - u0);
    const double part = du != 0.0 ? std::clamp((u + 0.5 - u0) / du, 0.0, 1.0) : 0.0;
    const double nearest = from.z + part * (to.z - from.z) - allowance;
    const int lastV = getLast(v + across, sizeV);
    for (int w = getFirst(v - across, sizeV); w <= lastV; ++w)
    {
      const float farthest =
        this->Levels.GetTexel(0, (alongX ? u : w) / factor, (alongX ? w : u) / factor);
      if (!(nearest > vtkNBufferDepthConvention::GetOrder(farthest)))
      {
        return true;
      }
    }
  }
  return false;
}
VTK_ABI_NAMESPACE_END
