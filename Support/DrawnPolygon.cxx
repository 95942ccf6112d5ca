// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnPolygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr double U = 1.0 / (1 << 24);
/// Pixels: half a step of the subpixel grid in both directions.
const double Snap = std::sqrt(2.0) / 512.0;
}

DrawnPolygon::Corner DrawnPolygon::Transform(const double matrix[4][4], const double x[3], double w)
{
  Corner corner;
  for (int i = 0; i < 4; ++i)
  {
    const double* m = matrix[i];
    const double terms[4] = { m[0] * x[0], m[1] * x[1], m[2] * x[2], m[3] * w };
    corner.Clip[i] = terms[0] + terms[1] + terms[2] + terms[3];
    corner.Errors[i] =
      5.0 * U * (std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]) + std::abs(terms[3]));
  }
  return corner;
}

DrawnPolygon::DrawnPolygon(std::vector<Corner> corners, Planes planes, int width, int height)
  : Largest(std::max(width, height))
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Clip(corners, axis, 1.0);
    if (axis < 2 || planes == Planes::NearAndFar)
    {
      this->Clip(corners, axis, -1.0);
    }
  }
  // After cutting at all four sides w is positive, except for a polygon through the eye.
  this->Visible = corners.size() >= 3 &&
    std::all_of(corners.begin(), corners.end(), [](const Corner& c) { return c.Clip[3] > 0.0; });
  if (!this->Visible)
  {
    return;
  }
  const double scale[3] = { 0.5 * width, 0.5 * height, 0.5 };
  for (const Corner& corner : corners)
  {
    const double w = corner.Clip[3];
    this->Corners.push_back({ scale[0] * (corner.Clip[0] / w + 1.0),
      scale[1] * (corner.Clip[1] / w + 1.0), scale[2] * (corner.Clip[2] / w + 1.0), 0.0 });
  }
  this->Visible = this->SetPlane();
  this->EdgeOn = !this->Visible;
  for (std::size_t i = 0; this->Visible && i < corners.size(); ++i)
  {
    const Corner& corner = corners[i];
    const double weights[3] = { std::abs(this->Slope[0]), std::abs(this->Slope[1]), 1.0 };
    const double w = corner.Clip[3];
    for (int k = 0; k < 3; ++k)
    {
      this->Corners[i].Error += weights[k] * scale[k] *
        (corner.Errors[k] + std::abs(corner.Clip[k] / w) * corner.Errors[3]) / w;
    }
  }
  const std::size_t n = this->Visible ? this->Corners.size() : 0;
  for (std::size_t a = 0; a < n; ++a)
  {
    for (std::size_t b = a + 1; b < n; ++b)
    {
      for (std::size_t c = b + 1; c < n; ++c)
      {
        const WindowCorner* v[3] = { &this->Corners[a], &this->Corners[b], &this->Corners[c] };
        this->LargestBound = std::max(this->LargestBound,
          this->GetRounding(*v[0], *v[1], *v[2]) +
            std::max({ v[0]->Error, v[1]->Error, v[2]->Error }));
      }
    }
  }
}

void DrawnPolygon::Clip(std::vector<Corner>& corners, int axis, double sign)
{
  const auto getSide = [&](const Corner& corner)
  { return corner.Clip[3] + sign * corner.Clip[axis]; };
  std::vector<Corner> result;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    const double sideA = getSide(a);
    const double sideB = getSide(b);
    if (sideA >= 0.0)
    {
      result.push_back(a);
    }
    if ((sideA >= 0.0) != (sideB >= 0.0))
    {
      const double t = sideA / (sideA - sideB);
      Corner cut;
      for (int k = 0; k < 4; ++k)
      {
        cut.Clip[k] = a.Clip[k] + t * (b.Clip[k] - a.Clip[k]);
        cut.Errors[k] = std::max(a.Errors[k], b.Errors[k]) +
          U * (2.0 * std::abs(b.Clip[k] - a.Clip[k]) + std::abs(cut.Clip[k]));
      }
      result.push_back(cut);
    }
  }
  corners = std::move(result);
}

bool DrawnPolygon::SetPlane()
{
  this->BoundsY = { HUGE_VAL, -HUGE_VAL };
  for (const WindowCorner& corner : this->Corners)
  {
    this->BoundsY = { std::min(this->BoundsY[0], corner.Y), std::max(this->BoundsY[1], corner.Y) };
  }
  // By the largest triangle that has the first corner.
  const WindowCorner& a = this->Corners[0];
  double largest = 0.0;
  for (std::size_t i = 1; i < this->Corners.size(); ++i)
  {
    for (std::size_t k = i + 1; k < this->Corners.size(); ++k)
    {
      const WindowCorner& b = this->Corners[i];
      const WindowCorner& c = this->Corners[k];
      const double area = GetArea(a, b, c.X, c.Y);
      if (std::abs(area) > largest)
      {
        largest = std::abs(area);
        const double ab = b.Depth - a.Depth;
        const double ac = c.Depth - a.Depth;
        this->Slope[0] = (ab * (c.Y - a.Y) - ac * (b.Y - a.Y)) / area;
        this->Slope[1] = (ac * (b.X - a.X) - ab * (c.X - a.X)) / area;
      }
    }
  }
  return largest > 0.0;
}

double DrawnPolygon::GetArea(const WindowCorner& a, const WindowCorner& b, double x, double y)
{
  return (b.X - a.X) * (y - a.Y) - (b.Y - a.Y) * (x - a.X);
}

double DrawnPolygon::GetRounding(
  const WindowCorner& a, const WindowCorner& b, const WindowCorner& c) const
{
  const double longest = std::max({ std::hypot(a.X - b.X, a.Y - b.Y),
    std::hypot(b.X - c.X, b.Y - c.Y), std::hypot(c.X - a.X, c.Y - a.Y) });
  const double height = std::abs(GetArea(a, b, c.X, c.Y)) / longest;
  const double range =
    std::max({ a.Depth, b.Depth, c.Depth }) - std::min({ a.Depth, b.Depth, c.Depth });
  return Snap * std::hypot(this->Slope[0], this->Slope[1]) +
    (height > 0.0 ? 8.0 * U * this->Largest * range / height : 0.0);
}

double DrawnPolygon::GetThickness() const
{
  double area = 0.0;
  double longest = 0.0;
  for (std::size_t i = 1; i < this->Corners.size(); ++i)
  {
    const WindowCorner& a = this->Corners[i - 1];
    const WindowCorner& b = this->Corners[i];
    area += GetArea(a, b, this->Corners[0].X, this->Corners[0].Y);
    for (std::size_t k = 0; k < i; ++k)
    {
      longest = std::max(longest, std::hypot(b.X - this->Corners[k].X, b.Y - this->Corners[k].Y));
    }
  }
  return longest > 0.0 ? std::abs(area) / longest : 0.0;
}

bool DrawnPolygon::GetRow(double y, double margin, double& x0, double& x1) const
{
  x0 = HUGE_VAL;
  x1 = -HUGE_VAL;
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const WindowCorner& a = this->Corners[i];
    const WindowCorner& b = this->Corners[(i + 1) % this->Corners.size()];
    const double low = std::max(y - margin, std::min(a.Y, b.Y));
    const double high = std::min(y + margin, std::max(a.Y, b.Y));
    if (low > high)
    {
      continue;
    }
    for (const double at : { low, high })
    {
      const double x = a.Y == b.Y ? a.X : a.X + (at - a.Y) / (b.Y - a.Y) * (b.X - a.X);
      x0 = std::min(x0, x - margin);
      x1 = std::max(x1, x + margin);
    }
  }
  return x0 <= x1;
}

double DrawnPolygon::GetDepth(double x, double y) const
{
  const WindowCorner& a = this->Corners[0];
  return a.Depth + this->Slope[0] * (x - a.X) + this->Slope[1] * (y - a.Y);
}

double DrawnPolygon::GetBound(double x, double y) const
{
  double bound = -1.0;
  const std::size_t n = this->Corners.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const WindowCorner& a = this->Corners[i];
        const WindowCorner& b = this->Corners[j];
        const WindowCorner& c = this->Corners[k];
        const double area = GetArea(a, b, c.X, c.Y);
        const double la = GetArea(b, c, x, y) / area;
        const double lb = GetArea(c, a, x, y) / area;
        const double lc = GetArea(a, b, x, y) / area;
        if (area != 0.0 && la >= 0.0 && lb >= 0.0 && lc >= 0.0)
        {
          bound = std::max(
            bound, la * a.Error + lb * b.Error + lc * c.Error + this->GetRounding(a, b, c));
        }
      }
    }
  }
  return bound >= 0.0 ? bound : this->LargestBound;
}
