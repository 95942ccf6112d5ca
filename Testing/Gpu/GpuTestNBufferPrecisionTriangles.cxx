// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuTestNBufferPrecisionTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
/// Twice the signed area, in pixels.
double GetArea(const ScreenVertex v[3])
{
  return (v[1].X - v[0].X) * (v[2].Y - v[0].Y) - (v[2].X - v[0].X) * (v[1].Y - v[0].Y);
}
}

double GetHeight(const ScreenVertex v[3])
{
  double longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const ScreenVertex& next = v[(i + 1) % 3];
    longest = std::max(longest, std::hypot(next.X - v[i].X, next.Y - v[i].Y));
  }
  return std::abs(GetArea(v)) / longest;
}

Triangle Sampler::Make(Kind kind)
{
  if (kind == Kind::Behind)
  {
    return this->MakeGround();
  }
  if (kind == Kind::Steep)
  {
    return this->MakeSteep();
  }
  if (kind == Kind::Sliver)
  {
    return this->MakeSliver();
  }
  // A middle depth anywhere between the planes, and crowded at both of them.
  const double fromPlane = this->Logarithmic(1e-6, 1.0);
  const double z = std::copysign(1.0 - fromPlane, this->Uniform(-1.0, 1.0));
  const double reach = kind == Kind::Facing ? 0.0 : 0.99 * fromPlane * this->Logarithmic(1e-3, 1);
  double x = this->Uniform(0.0, Width);
  double y = this->Uniform(0.0, Height);
  double size = this->Logarithmic(2.0, 200.0);
  if (kind == Kind::SubPixel)
  {
    x = std::floor(x) + 0.5;
    y = std::floor(y) + 0.5;
    size = this->Uniform(0.3, 1.0);
  }
  Triangle triangle;
  for (Point& point : triangle)
  {
    point = this->ToWorld(x + this->Uniform(-size, size), y + this->Uniform(-size, size),
      z + this->Uniform(-reach, reach));
  }
  return triangle;
}

Triangle Sampler::MakeSteep()
{
  const double reach = this->Logarithmic(1e-3, 0.99);
  const double z = this->Uniform(reach - 1.0, 1.0 - reach);
  const double away = this->Uniform(-1.0, 1.0) < 0.0 ? reach : -reach;
  constexpr double step = 1.0 / 512;
  const double x = std::floor(this->Uniform(0.0, Width)) + 0.5 + this->Uniform(-step, step);
  const double y = std::floor(this->Uniform(0.0, Height)) + 0.5 + this->Uniform(-step, step);
  static const double directions[4][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, -1 } };
  const double* direction = directions[std::uniform_int_distribution<int>(0, 3)(this->Random)];
  const double length = std::floor(this->Logarithmic(2.0, 200.0));
  const double height = (this->Uniform(-1.0, 1.0) < 0.0 ? 1.0 : -1.0) *
    this->Logarithmic(LowestHeight, 4.0 * LowestHeight);
  const double middle = length * this->Uniform(0.0, 1.0);
  const double norm = std::hypot(direction[0], direction[1]);
  return { this->ToWorld(x, y, z + away),
    this->ToWorld(x + length * direction[0], y + length * direction[1], z + away),
    this->ToWorld(x + middle * direction[0] - height * direction[1] / norm,
      y + middle * direction[1] + height * direction[0] / norm, z - away) };
}

Triangle Sampler::MakeSliver()
{
  Triangle triangle = this->MakeSteep();
  double depth[3];
  double screen[3][2];
  for (int i = 0; i < 3; ++i)
  {
    const ScreenVertex vertex = ToScreen(this->WorldToClip.data(), triangle[i].data());
    screen[i][0] = vertex.X;
    screen[i][1] = vertex.Y;
    depth[i] = 2.0 * vertex.Z - 1.0;
  }
  // The third corner towards the side below, and the depths anywhere between the two there were.
  const double dx = screen[1][0] - screen[0][0];
  const double dy = screen[1][1] - screen[0][1];
  const double foot =
    ((screen[2][0] - screen[0][0]) * dx + (screen[2][1] - screen[0][1]) * dy) / (dx * dx + dy * dy);
  const double lower = this->Logarithmic(1e-6, 1.0);
  screen[2][0] += (1.0 - lower) * (screen[0][0] + foot * dx - screen[2][0]);
  screen[2][1] += (1.0 - lower) * (screen[0][1] + foot * dy - screen[2][1]);
  depth[1] += this->Uniform(0.0, 1.0) * (depth[2] - depth[1]);
  depth[2] = depth[0] + foot * (depth[1] - depth[0]) +
    this->Logarithmic(1e-4, 1.0) * (depth[2] - depth[0]) * 0.5;
  for (int i = 0; i < 3; ++i)
  {
    triangle[i] = this->ToWorld(screen[i][0], screen[i][1], std::clamp(depth[i], -0.999, 0.999));
  }
  return triangle;
}

Triangle Sampler::MakeGround()
{
  const double aside = this->Case.Near * this->Logarithmic(2.0, 50.0);
  const int axis = this->Uniform(0.0, 1.0) < 0.5 ? 0 : 1;
  const double sign = this->Uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
  {
    Point& point = triangle[i];
    point[axis] = this->Case.Offset + sign * aside * this->Uniform(1.0, 2.0);
    point[1 - axis] = this->Case.Offset + aside * this->Uniform(-5.0, 5.0);
    point[2] = aside * (i == 0 ? this->Uniform(0.0, 5.0) : -this->Uniform(2.0, 20.0));
  }
  return triangle;
}

Judge::Judge(const double* worldToClip, const Triangle& triangle, bool isBehind)
  : IsBehind(isBehind)
{
  for (int i = 0; i < 3; ++i)
  {
    this->Vertices[i] = ToScreen(worldToClip, triangle[i].data());
    this->Nearest = std::min(this->Nearest, this->Vertices[i].Z);
    this->Farthest = std::max(this->Farthest, this->Vertices[i].Z);
  }
  const ScreenVertex* v = this->Vertices;
  const double area = GetArea(v);
  const double dz[2] = { v[1].Z - v[0].Z, v[2].Z - v[0].Z };
  this->SlopeX = (dz[0] * (v[2].Y - v[0].Y) - dz[1] * (v[1].Y - v[0].Y)) / area;
  this->SlopeY = (dz[1] * (v[1].X - v[0].X) - dz[0] * (v[2].X - v[0].X)) / area;
}

void Judge::Compare(const vtkNBufferScreenBox& screen, int x0, int y0, int width,
  const std::vector<float>& depth, Finding& finding) const
{
  const vtkNBufferRectangle& r = screen.Pixels;
  const double slack = 0.5 * screen.Slack[2];
  const double planeSlack = slack + std::abs(this->SlopeX) * 0.5 * Width * screen.Slack[0] +
    std::abs(this->SlopeY) * 0.5 * Height * screen.Slack[1];
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    const int x = x0 + static_cast<int>(i) % width;
    const int y = y0 + static_cast<int>(i) / width;
    const double z = depth[i];
    if (z == 1.0)
    {
      continue;
    }
    ++finding.Fragments;
    ASSERT_TRUE(x >= r.X0 && x < r.X1 && y >= r.Y0 && y < r.Y1) << x << " " << y;
    ASSERT_GE(z, screen.Nearest);
    ASSERT_LE(z, screen.Farthest);
    const double plane = this->Vertices[0].Z + this->SlopeX * (x + 0.5 - this->Vertices[0].X) +
      this->SlopeY * (y + 0.5 - this->Vertices[0].Y);
    ASSERT_LE(std::abs(z - plane), planeSlack);
    finding.OfPlane = std::max(finding.OfPlane, std::abs(z - plane) / planeSlack);
    // Vertices behind the eye have no depth that bounds what is drawn.
    if (!this->IsBehind)
    {
      const double outside = std::max(this->Nearest - z, z - this->Farthest);
      ASSERT_LE(outside, slack);
      finding.AddOutside(outside, slack);
      finding.Nearer += z < this->Nearest;
    }
  }
}

vtkNBufferBox BoundTriangle(const Triangle& triangle, const Sampler& sampler)
{
  double bounds[6];
  for (int j = 0; j < 3; ++j)
  {
    bounds[2 * j] = std::min({ triangle[0][j], triangle[1][j], triangle[2][j] });
    bounds[2 * j + 1] = std::max({ triangle[0][j], triangle[1][j], triangle[2][j] });
  }
  vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
  for (int j = 0; j < 3; ++j)
  {
    box.Origin[j] = sampler.GetShift(j);
    box.Magnitude[j] = std::abs(box.Center[j] - box.Origin[j]) + box.HalfSize[j];
  }
  return box;
}
