// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPixelTest.h"

#include "vtkNBufferSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int Side = 8; // The side of a square, in pixels.

/// Twice the area of the triangle o, a, b; positive if it is counter-clockwise.
double GetTwiceArea(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 p = a - o;
  const glm::dvec2 q = b - o;
  return p.x * q.y - p.y * q.x;
}

/// Compute the convex hull of eight points, counter-clockwise (A. M. Andrew, 1979). Sorts the
/// points. Returns the number of corners of the hull.
int GetHull(std::array<glm::dvec2, 8>& points, std::array<glm::dvec2, 16>& hull)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  int count = 0;
  const auto add = [&](const glm::dvec2& point, int floor)
  {
    while (count >= floor + 2 && GetTwiceArea(hull[count - 2], hull[count - 1], point) <= 0.0)
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

glm::dvec2 vtkNBufferPixelTest::GetSlack(const vtkNBufferScreenBox& screen) const
{
  return { 0.5 * this->Projection.GetWidth() * screen.Slack.x,
    0.5 * this->Projection.GetHeight() * screen.Slack.y };
}

template <typename Points>
void vtkNBufferPixelTest::AddEdge(
  const glm::dvec2& normal, const Points& points, const glm::dvec2& slack)
{
  // The edge passes the farthest corner, and not just one of its ends: where two corners differ
  // only by rounding (in boxes without thickness) the normal may have any direction.
  double reach = -std::numeric_limits<double>::infinity();
  for (const auto& point : points)
  {
    reach = std::max(reach, glm::dot(normal, glm::dvec2(point)));
  }
  this->Edges[this->NumberOfEdges++] = { normal,
    -reach - std::abs(normal.x) * slack.x - std::abs(normal.y) * slack.y };
}

void vtkNBufferPixelTest::SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  this->NumberOfEdges = 0;
  if (!screen.Clipped)
  {
    std::array<glm::dvec2, 8> points = this->Projection.GetCorners(box);
    std::array<glm::dvec2, 16> hull;
    const int count = GetHull(points, hull);
    const glm::dvec2 slack = this->GetSlack(screen);
    for (int i = 0; i < count && count <= 8; ++i)
    {
      const glm::dvec2& from = hull[i];
      const glm::dvec2& to = hull[(i + 1) % count];
      // The outward normal of an edge that has the hull on its left.
      this->AddEdge({ to.y - from.y, from.x - to.x }, points, slack);
    }
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

void vtkNBufferPixelTest::SetOutline(
  const Corners& corners, const Errors& errors, const glm::dvec2& slack)
{
  const auto& [a, b, c] = corners;
  const double area = GetTwiceArea(a, b, c);
  double length = 0.0;
  this->NumberOfEdges = 0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec2 side = corners[(i + 1) % 3] - corners[i];
    length = std::max(length, glm::length(side));
    this->AddEdge(
      area < 0.0 ? glm::dvec2(-side.y, side.x) : glm::dvec2(side.y, -side.x), corners, slack);
  }

  const double nearest = std::min({ a.z, b.z, c.z });
  const double range = std::max({ a.z, b.z, c.z }) - nearest;
  const double height = length > 0.0 ? std::abs(area) / length - 3.0 * errors.PositionError : 0.0;
  this->Nearest = nearest - errors.DepthError - errors.BoxSlack;
  this->NumberOfPlanes = 0;
  if (height >= vtkNBufferBoxError::LowestHeight)
  {
    const double error =
      errors.DepthError + (errors.DepthErrorPerSlope + errors.SlopeRounding) * range / height;
    const glm::dvec3 p = b - a;
    const glm::dvec3 q = c - a;
    const glm::dvec2 slope = { (p.z * q.y - q.z * p.y) / area, (q.z * p.x - p.z * q.x) / area };
    const double depth = a.z - glm::dot(slope, glm::dvec2(a));
    this->Nearest = std::max(this->Nearest, nearest - error);
    this->Planes[this->NumberOfPlanes++] = { depth - glm::dot(glm::abs(slope), slack) - error,
      slope.x, slope.y };
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
  const int factor = this->Levels.GetFactor();
  if (this->SquareLevel < this->Levels.GetNumberOfLevels())
  {
    const float farthest = this->Levels.GetTexel(this->SquareLevel, x / factor, y / factor);
    ++this->Lookups;
    if (this->GetNearest(x + half, y + half, half) > farthest)
    {
      return true;
    }
  }
  for (int row = std::min(y + Side, pixels.Y1) - 1; row >= std::max(y, pixels.Y0); --row)
  {
    for (int column = std::max(x, pixels.X0); column < std::min(x + Side, pixels.X1); ++column)
    {
      if (!this->IsPixelHidden(column, row))
      {
        return false;
      }
    }
  }
  return true;
}

bool vtkNBufferPixelTest::IsPixelHidden(int column, int row)
{
  ++this->Lookups;
  const std::size_t width = this->Levels.GetPixelWidth();
  const double depth = this->Depth[row * width + column];
  const double x = column + 0.5;
  const double y = row + 0.5;
  if (this->Nearest > depth || this->IsOutsideOutline(x, y, this->SampleDistance))
  {
    return true;
  }
  const int factor = this->Levels.GetFactor();
  const double nearest = this->GetNearest(x, y, this->SampleDistance);
  return nearest > depth || nearest > this->Levels.GetTexel(0, column / factor, row / factor);
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
  return this->IsHidden(pixels);
}

bool vtkNBufferPixelTest::IsHidden(const vtkNBufferRectangle& pixels)
{
  // Most of what is visible is visible in the middle of its rectangle.
  if (!this->IsPixelHidden((pixels.X0 + pixels.X1) / 2, (pixels.Y0 + pixels.Y1) / 2))
  {
    return false;
  }
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

bool vtkNBufferPixelTest::MayBeSeen(const vtkNBufferMesh& mesh, const double toWorld[16],
  const vtkNBufferScreenBox& screen, std::size_t& first, std::size_t count)
{
  const Errors errors = this->Projection.GetTriangleErrors(screen);
  const glm::dvec2 slack = this->GetSlack(screen);
  const vtkNBufferRectangle& sampled = screen.GetSampled(this->SampleDistance);
  const vtkNBufferProjection::Rows rows =
    this->Projection.GetWindowMatrix(vtkNBufferGLM::ToMatrix(toWorld));
  const auto project = [&rows](const glm::dvec3& point)
  {
    const auto evaluate = [&](int row) { return vtkNBufferBoxError::Evaluate(rows[row], point); };
    const double w = evaluate(3);
    return glm::dvec3(evaluate(0), evaluate(1), evaluate(2)) /
      (w > 0.0 ? w : std::numeric_limits<double>::quiet_NaN());
  };
  const std::size_t size = mesh.Triangles.size();
  for (std::size_t n = 0; n < std::min(size, count); ++n)
  {
    const std::size_t triangle = (first + n) % size;
    if (n == 1)
    {
      // Points are shared by triangles.
      this->OnScreen.resize(mesh.Points.size());
      std::transform(mesh.Points.begin(), mesh.Points.end(), this->OnScreen.begin(), project);
    }
    Corners corners;
    for (int i = 0; i < 3; ++i)
    {
      const auto point = mesh.Triangles[triangle][i];
      corners[i] = n == 0 ? project(mesh.Points[point]) : this->OnScreen[point];
      if (!vtkNBufferGLM::IsFinite(corners[i]))
      {
        first = triangle;
        return true; // A device draws the part of it before the eye, which is not known here.
      }
    }
    const auto& [a, b, c] = corners;
    const glm::dvec2 low = glm::dvec2(glm::min(glm::min(a, b), c)) - slack;
    const glm::dvec2 high = glm::dvec2(glm::max(glm::max(a, b), c)) + slack;
    // Only avoids an overflow of int: the intersection is with the rectangle of the box.
    const auto clamp = [&](double value) { return std::clamp(value, -1.0, 1e6); };
    const double half = 0.5 - this->SampleDistance;
    const vtkNBufferRectangle pixels =
      sampled.GetIntersection({ static_cast<int>(std::ceil(clamp(low.x) - 1.0 + half)),
        static_cast<int>(std::ceil(clamp(low.y) - 1.0 + half)),
        static_cast<int>(std::floor(clamp(high.x) - half)) + 1,
        static_cast<int>(std::floor(clamp(high.y) - half)) + 1 });
    if (pixels.IsEmpty())
    {
      continue;
    }
    this->SetOutline(corners, errors, slack);
    if (!this->IsHidden(pixels))
    {
      first = triangle;
      return true;
    }
  }
  return false;
}
VTK_ABI_NAMESPACE_END
