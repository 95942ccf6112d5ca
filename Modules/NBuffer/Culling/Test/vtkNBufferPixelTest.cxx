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

/// Twice the area of the triangle o, a, b; positive if it is counter-clockwise.
double Cross(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 p = a - o;
  const glm::dvec2 q = b - o;
  return p.x * q.y - p.y * q.x;
}

/// The convex hull of eight points, which it sorts, counter-clockwise (A. M. Andrew, 1979). Returns
/// the number of its corners.
int GetHull(std::array<glm::dvec2, 8>& points, std::array<glm::dvec2, 16>& hull)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  int count = 0;
  const auto add = [&](const glm::dvec2& point, int floor)
  {
    while (count >= floor + 2 && Cross(hull[count - 2], hull[count - 1], point) <= 0.0)
    {
      --count;
    }
    hull[count++] = point;
  };
  for (const glm::dvec2& point : points)
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

vtkNBufferPixelTest::vtkNBufferPixelTest(const vtkNBufferProjection& projection,
  const vtkNBufferLevels& levels, const float* depth, double sampleDistance)
  : Projection(projection)
  , Levels(levels)
  , Depth(depth)
  , SampleDistance(sampleDistance)
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
    if (const auto plane = this->Projection.GetFacePlane(box, screen, face))
    {
      this->Planes[this->NumberOfPlanes++] = *plane;
    }
  }
}

void vtkNBufferPixelTest::SetEdges(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  std::array<glm::dvec2, 8> points = this->Projection.GetCorners(box);
  std::array<glm::dvec2, 16> hull;
  const int count = GetHull(points, hull);
  const glm::dvec2 slack = { 0.5 * this->Projection.GetWidth() * screen.Slack.x,
    0.5 * this->Projection.GetHeight() * screen.Slack.y };
  this->NumberOfEdges = 0;
  for (int i = 0; i < count && count <= 8; ++i)
  {
    const glm::dvec2& from = hull[i];
    const glm::dvec2& to = hull[(i + 1) % count];
    // The outward normal of an edge that has the hull on its left.
    Edge& edge = this->Edges[this->NumberOfEdges++];
    edge.Normal = { to.y - from.y, from.x - to.x };
    // Beyond the farthest corner, not through `from`: where corners differ by rounding only (boxes
    // without thickness) an edge may point anywhere, and this holds for every direction.
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& point : points)
    {
      reach = std::max(reach, glm::dot(edge.Normal, point));
    }
    edge.Offset = -reach - std::abs(edge.Normal.x) * slack.x - std::abs(edge.Normal.y) * slack.y;
  }
}

bool vtkNBufferPixelTest::IsOutsideOutline(double x, double y, double halfSide) const
{
  return std::any_of(this->Edges.begin(), this->Edges.begin() + this->NumberOfEdges,
    [=](const Edge& edge)
    {
      return edge.Normal.x * x + edge.Normal.y * y + edge.Offset -
        halfSide * (std::abs(edge.Normal.x) + std::abs(edge.Normal.y)) >
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
  if (this->IsOutsideOutline(x + half, y + half, half))
  {
    return true;
  }
  if (this->SquareLevel < this->Levels.GetNumberOfLevels())
  {
    const int factor = this->Levels.GetFactor();
    const float farthest = this->Levels.GetTexel(this->SquareLevel, x / factor, y / factor);
    ++this->Lookups;
    if (this->GetNearest(x + half, y + half, half) > vtkNBufferDepthConvention::GetOrder(farthest))
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
      const double depth = vtkNBufferDepthConvention::GetOrder(this->Depth[row * width + column]);
      const double x = column + 0.5;
      const double y = row + 0.5;
      if (!(this->Nearest > depth) && !this->IsOutsideOutline(x, y, this->SampleDistance) &&
        !(this->GetNearest(x, y, this->SampleDistance) > depth))
      {
        return false;
      }
    }
  }
  return true;
}

bool vtkNBufferPixelTest::IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  // The outline of a box says nothing of wide lines and points that stick out of the box.
  if (box.Margin > 0.0)
  {
    return false;
  }
  const vtkNBufferRectangle& pixels = screen.GetSampled(this->SampleDistance);
  if (pixels.IsEmpty())
  {
    return true;
  }
  this->SetOutline(box, screen);
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
