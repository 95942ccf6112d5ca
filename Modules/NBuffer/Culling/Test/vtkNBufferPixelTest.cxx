// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPixelTest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int Side = 8; // of a square, in pixels

struct Point
{
  double X;
  double Y;
};

double Cross(const Point& o, const Point& a, const Point& b)
{
  return (a.X - o.X) * (b.Y - o.Y) - (a.Y - o.Y) * (b.X - o.X);
}

/// Convex hull, counter-clockwise (A. M. Andrew, 1979). Returns the number of its corners.
int GetHull(std::array<Point, 8>& points, std::array<Point, 16>& hull)
{
  std::sort(points.begin(), points.end(),
    [](const Point& a, const Point& b) { return a.X < b.X || (a.X == b.X && a.Y < b.Y); });
  int count = 0;
  const auto add = [&](const Point& point, int floor)
  {
    while (count >= floor + 2 && Cross(hull[count - 2], hull[count - 1], point) <= 0.0)
    {
      --count;
    }
    hull[count++] = point;
  };
  for (const Point& point : points)
  {
    add(point, 0);
  }
  const int lower = count - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
  {
    add(*point, lower);
  }
  return count - 1;
}
}

vtkNBufferPixelTest::vtkNBufferPixelTest(
  const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, const float* depth)
  : Projection(projection)
  , Levels(levels)
  , Depth(depth)
  , SquareLevel(vtkNBufferMath::CeilLog2(Side / levels.GetFactor()))
{
}

void vtkNBufferPixelTest::SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  this->NumberOfEdges = 0;
  if (!screen.Clipped)
  {
    this->SetEdges(box, screen);
  }

  this->Nearest = screen.Nearest;
  this->NumberOfPlanes = 0;
  for (int face = 0; face < 6 && this->NumberOfPlanes < 3; ++face)
  {
    if (this->Projection.GetFacePlane(box, screen, face, this->Planes[this->NumberOfPlanes]))
    {
      ++this->NumberOfPlanes;
    }
  }
}

void vtkNBufferPixelTest::SetEdges(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  double corners[16];
  this->Projection.GetCorners(box, corners);
  std::array<Point, 8> points;
  for (int i = 0; i < 8; ++i)
  {
    points[i] = { corners[2 * i], corners[2 * i + 1] };
  }
  std::array<Point, 16> hull;
  const int count = GetHull(points, hull);
  const double slackX = 0.5 * this->Projection.GetWidth() * screen.Slack[0];
  const double slackY = 0.5 * this->Projection.GetHeight() * screen.Slack[1];
  this->NumberOfEdges = 0;
  for (int i = 0; i < count && count <= 8; ++i)
  {
    const Point& from = hull[i];
    const Point& to = hull[(i + 1) % count];
    // The outward normal of an edge that has the hull on its left.
    Edge& edge = this->Edges[this->NumberOfEdges++];
    edge.X = to.Y - from.Y;
    edge.Y = from.X - to.X;
    // Beyond the farthest corner, not through `from`: where corners differ by rounding only (boxes
    // without thickness) an edge may point anywhere, and this holds for every direction.
    double reach = -std::numeric_limits<double>::infinity();
    for (const Point& point : points)
    {
      reach = std::max(reach, edge.X * point.X + edge.Y * point.Y);
    }
    edge.Offset = -reach - std::abs(edge.X) * slackX - std::abs(edge.Y) * slackY;
  }
}

bool vtkNBufferPixelTest::IsBeside(double x, double y, double halfSide) const
{
  return std::any_of(this->Edges, this->Edges + this->NumberOfEdges,
    [=](const Edge& edge)
    {
      return edge.X * x + edge.Y * y + edge.Offset -
        halfSide * (std::abs(edge.X) + std::abs(edge.Y)) >
        0.0;
    });
}

double vtkNBufferPixelTest::GetNearest(double x, double y, double halfSide) const
{
  double nearest = this->Nearest;
  for (int i = 0; i < this->NumberOfPlanes; ++i)
  {
    const vtkNBufferProjection::FacePlane& plane = this->Planes[i];
    nearest = std::max(nearest,
      plane.Depth + plane.SlopeX * x + plane.SlopeY * y -
        halfSide * (std::abs(plane.SlopeX) + std::abs(plane.SlopeY)));
  }
  return nearest;
}

bool vtkNBufferPixelTest::IsSquareHidden(int x, int y, const vtkNBufferRectangle& pixels)
{
  constexpr double half = 0.5 * Side;
  const double sign = this->Projection.GetDepthSign();
  if (this->IsBeside(x + half, y + half, half))
  {
    return true;
  }
  if (this->SquareLevel < this->Levels.GetNumberOfLevels())
  {
    vtkNBufferCover cover;
    cover.Level = this->SquareLevel;
    cover.Count = 1;
    cover.X[0] = x / this->Levels.GetFactor();
    cover.Y[0] = y / this->Levels.GetFactor();
    ++this->Lookups;
    if (this->GetNearest(x + half, y + half, half) > sign * this->Levels.Query(cover))
    {
      return true;
    }
  }
  const std::size_t width = this->Levels.GetPixelWidth();
  for (int row = std::min(y + Side, pixels.Y1) - 1; row >= std::max(y, pixels.Y0); --row)
  {
    for (int column = std::max(x, pixels.X0); column < std::min(x + Side, pixels.X1); ++column)
    {
      ++this->Lookups;
      const double depth = sign * this->Depth[row * width + column];
      if (!(this->Nearest > depth) && !this->IsBeside(column + 0.5, row + 0.5, 0.5) &&
        !(this->GetNearest(column + 0.5, row + 0.5, 0.5) > depth))
      {
        return false;
      }
    }
  }
  return true;
}

bool vtkNBufferPixelTest::IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  // What sticks out of its box has no outline.
  if (box.Margin > 0.0)
  {
    return false;
  }
  this->SetOutline(box, screen);
  const vtkNBufferRectangle& pixels = screen.Pixels;
  for (int y = (pixels.Y1 - 1) / Side * Side; y > pixels.Y0 - Side; y -= Side)
  {
    for (int x = pixels.X0 / Side * Side; x < pixels.X1; x += Side)
    {
      if (!this->IsSquareHidden(x, y, pixels))
      {
        return false;
      }
    }
  }
  return true;
}
VTK_ABI_NAMESPACE_END
