// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSliverTest.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferSliverTest::vtkNBufferSliverTest(
  const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, double sampleReach)
  : Projection(projection)
  , Levels(levels)
  , SampleReach(sampleReach)
{
}

void vtkNBufferSliverTest::Project(const vtkNBufferMesh& mesh, const double toWorld[16])
{
  double m[4][4];
  this->Projection.GetWindowMatrix(toWorld, m);
  this->Points.resize(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const std::array<double, 3>& p = mesh.Points[i];
    const double w = m[3][0] * p[0] + m[3][1] * p[1] + m[3][2] * p[2] + m[3][3];
    const double inverse = w > 0.0 ? 1.0 / w : std::numeric_limits<double>::quiet_NaN();
    this->Points[i] = { inverse * (m[0][0] * p[0] + m[0][1] * p[1] + m[0][2] * p[2] + m[0][3]),
      inverse * (m[1][0] * p[0] + m[1][1] * p[1] + m[1][2] * p[2] + m[1][3]),
      inverse * (m[2][0] * p[0] + m[2][1] * p[1] + m[2][2] * p[2] + m[2][3]) };
  }
}

bool vtkNBufferSliverTest::MayBeSeen(const vtkNBufferMesh& mesh, const double toWorld[16],
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  const Errors errors = this->Projection.GetTriangleErrors(box, screen);
  const double inverseSlope = 1.0 / errors.LargestSlope;
  // Every vertex may be elsewhere by the diagonal of its error.
  const double heightError = 3.0 * errors.Position;
  this->Project(mesh, toWorld);
  for (const std::array<unsigned int, 3>& triangle : mesh.Triangles)
  {
    const WindowPoint& a = this->Points[triangle[0]];
    const WindowPoint& b = this->Points[triangle[1]];
    const WindowPoint& c = this->Points[triangle[2]];
    // At least as long as the longest side, which makes the height at most too small.
    const double length = std::max({ a.X, b.X, c.X }) - std::min({ a.X, b.X, c.X }) +
      std::max({ a.Y, b.Y, c.Y }) - std::min({ a.Y, b.Y, c.Y });
    const double area = std::abs((b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X));
    const double range =
      std::max({ a.Order, b.Order, c.Order }) - std::min({ a.Order, b.Order, c.Order });
    if (area >= length * (heightError + errors.LowestHeight * length + range * inverseSlope))
    {
      continue;
    }
    const WindowPoint* const corners[3] = { &a, &b, &c };
    if (this->MayBeSeen(corners, heightError, errors))
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferSliverTest::MayBeSeen(
  const WindowPoint* const corners[3], double heightError, const Errors& errors) const
{
  const WindowPoint* from = corners[0];
  const WindowPoint* to = corners[1];
  const WindowPoint* third = corners[2];
  const auto getLength = [](const WindowPoint& a, const WindowPoint& b)
  { return std::sqrt((b.X - a.X) * (b.X - a.X) + (b.Y - a.Y) * (b.Y - a.Y)); };
  double length = getLength(*from, *to);
  for (int i = 1; i < 3; ++i)
  {
    const double other = getLength(*corners[i], *corners[(i + 1) % 3]);
    if (other > length)
    {
      length = other;
      from = corners[i];
      to = corners[(i + 1) % 3];
      third = corners[(i + 2) % 3];
    }
  }
  // Behind the eye: not covered. Two corners in one place: no device draws that.
  if (!std::isfinite(length + third->X + third->Y) || getLength(*from, *third) == 0.0 ||
    getLength(*to, *third) == 0.0)
  {
    return false;
  }
  const double x = to->X - from->X;
  const double y = to->Y - from->Y;
  const double thirdX = third->X - from->X;
  const double thirdY = third->Y - from->Y;
  const double own = length > 0.0 ? std::abs(x * thirdY - y * thirdX) / length : 0.0;
  // All of the triangle is that near its longest side. 1.5: diagonals.
  const double reach = own + errors.Overshoot + 1.5 * (errors.Position + this->SampleReach);
  const double height = own - heightError;
  double allowance = std::numeric_limits<double>::infinity();
  if (height > 0.0 && height >= errors.LowestHeight * length)
  {
    const double along = (to->Order - from->Order) / length;
    const double foot = (x * thirdX + y * thirdY) / length;
    const double across = third->Order - from->Order - along * foot;
    const auto [low, high] = std::minmax({ from->Order, to->Order, third->Order });
    // Of the device's triangle, whose vertices are elsewhere.
    const double steepness = std::abs(along) * (1.0 + 3.0 * errors.Position / length);
    const double slope = steepness +
      (std::abs(across) + 3.0 * errors.Position * steepness + 2.0 * errors.Depth) / height;
    const double rounding = std::min(errors.OfRounding, errors.OfLength * length) *
      (high - low + 2.0 * errors.Depth) / height;
    const double stray = slope * errors.OfSlope + rounding;
    if (stray <= errors.Granted)
    {
      return false;
    }
    allowance = errors.Depth + std::max(-across, 0.0) + 2.0 * reach * steepness + stray;
  }
  return this->MayBeSeen(*from, *to, reach, allowance);
}

bool vtkNBufferSliverTest::MayBeSeen(
  const WindowPoint& from, const WindowPoint& to, double reach, double allowance) const
{
  // Line by line across the axis along which it is longer: u along, v across.
  const bool alongX = std::abs(to.X - from.X) >= std::abs(to.Y - from.Y);
  const double u0 = alongX ? from.X : from.Y;
  const double v0 = alongX ? from.Y : from.X;
  const double du = alongX ? to.X - from.X : to.Y - from.Y;
  const double dv = alongX ? to.Y - from.Y : to.X - from.X;
  const double slope = du != 0.0 ? dv / du : 0.0;
  const double across = reach * std::hypot(1.0, slope);
  const int pixels[2] = { this->Levels.GetPixelWidth(), this->Levels.GetPixelHeight() };
  const int sizeU = pixels[alongX ? 0 : 1];
  const int sizeV = pixels[alongX ? 1 : 0];
  // Pixels whose middle is in an interval.
  const auto getFirst = [](double x, int size)
  { return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(size))); };
  const auto getLast = [](double x, int size)
  { return static_cast<int>(std::clamp(std::floor(x - 0.5), -1.0, size - 1.0)); };

  const double sign = this->Projection.GetDepthSign();
  const int lastU = getLast(std::max(u0, u0 + du) + reach, sizeU);
  for (int u = getFirst(std::min(u0, u0 + du) - reach, sizeU); u <= lastU; ++u)
  {
    const double v = v0 + slope * (u + 0.5 - u0);
    const double part = du != 0.0 ? std::clamp((u + 0.5 - u0) / du, 0.0, 1.0) : 0.0;
    const double nearest = from.Order + part * (to.Order - from.Order) - allowance;
    const int lastV = getLast(v + across, sizeV);
    for (int w = getFirst(v - across, sizeV); w <= lastV; ++w)
    {
      vtkNBufferCover cover;
      cover.Level = 0;
      cover.Count = 1;
      cover.X[0] = (alongX ? u : w) / this->Levels.GetFactor();
      cover.Y[0] = (alongX ? w : u) / this->Levels.GetFactor();
      if (!(nearest > sign * this->Levels.Query(cover)))
      {
        return true;
      }
    }
  }
  return false;
}
VTK_ABI_NAMESPACE_END
