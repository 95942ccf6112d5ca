// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSliverTest.h"

#include "vtkNBufferSurface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The area of the parallelogram that two vectors span, with its sign.
double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

constexpr double GridStep = vtkNBufferBoxError::GridStep;
}

/// A sliver. Its longest side runs from `From` to `To`.
struct vtkNBufferSliverTest::Sliver
{
  glm::dvec3 From;
  glm::dvec3 To;
  glm::dvec3 Third;
  double Length;    ///< The length of the longest side, in pixels.
  double Height;    ///< The height over the longest side, in pixels.
  double Across;    ///< The depth of the third corner less that of the foot of the height.
  glm::dvec2 Error; ///< How far a corner may be from its exact place before it is snapped.
  double Beside;    ///< The same in the direction across the longest side.
  double Steepness; ///< The slope of the longest side as a device may draw it.
  double Rounding;  ///< How much nearer than its plane a sample may be, for the slopes' rounding.
  bool HasPlane;    ///< If false, its samples may have any depth.

  ///@{
  /// Where the device snaps the corners to, and the errors of that in x and in y.
  std::array<glm::dvec2, 3> Snapped;
  std::array<glm::dvec2, 3> SnapError;
  void Snap(bool isSnappedToGrid);
  ///@}

  /// Whether a sample, at most `reach` from a place in x and in y, may lie in the triangle as
  /// snapped.
  bool MayOwn(const glm::dvec2& place, double reach) const;

  /// The nearest depth that a sample of the triangle may have which is at most `reach` from a place
  /// in x and in y.
  double GetNearest(const glm::dvec2& place, double reach, const Errors& errors) const;
};

void vtkNBufferSliverTest::Sliver::Snap(bool isSnappedToGrid)
{
  const std::array<glm::dvec2, 3> corners = { glm::dvec2(this->From), glm::dvec2(this->To),
    glm::dvec2(this->Third) };
  for (int i = 0; i < 3; ++i)
  {
    this->Snapped[i] = corners[i];
    this->SnapError[i] = this->Error + 0.5 * GridStep;
    if (isSnappedToGrid)
    {
      // The first and the last step of the grid at which the corner may be.
      const glm::dvec2 first = glm::floor((corners[i] - this->Error) / GridStep + 0.5);
      const glm::dvec2 last = glm::floor((corners[i] + this->Error) / GridStep + 0.5);
      this->Snapped[i] = 0.5 * GridStep * (first + last);
      this->SnapError[i] = 0.5 * GridStep * (last - first);
    }
  }
}

bool vtkNBufferSliverTest::Sliver::MayOwn(const glm::dvec2& place, double reach) const
{
  glm::dvec2 low = this->Snapped[0] - this->SnapError[0];
  glm::dvec2 high = this->Snapped[0] + this->SnapError[0];
  bool left = true;
  bool right = true;
  bool isCertain = reach == 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    const glm::dvec2 side = this->Snapped[next] - this->Snapped[i];
    const glm::dvec2 toPlace = place - this->Snapped[i];
    const double area = Cross(side, toPlace);
    // A side and a distance from a corner err by no more than the sum of the errors of both ends.
    const glm::dvec2 ofSide = this->SnapError[i] + this->SnapError[next];
    const glm::dvec2 ofPlace = this->SnapError[i] + reach;
    const double tolerance = ofSide.x * (std::abs(toPlace.y) + ofPlace.y) +
      ofSide.y * (std::abs(toPlace.x) + ofPlace.x) + ofPlace.x * std::abs(side.y) +
      ofPlace.y * std::abs(side.x);
    left = left && area >= -tolerance;
    right = right && area <= tolerance;
    isCertain = isCertain && tolerance == 0.0;
    low = glm::min(low, this->Snapped[i] - this->SnapError[i]);
    high = glm::max(high, this->Snapped[i] + this->SnapError[i]);
  }
  if (glm::any(glm::lessThan(place + reach, low)) ||
    glm::any(glm::greaterThan(place - reach, high)))
  {
    return false;
  }
  // A triangle without area owns no sample. Snapped places are exact in double precision.
  return (left || right) && !(isCertain && left && right);
}

double vtkNBufferSliverTest::Sliver::GetNearest(
  const glm::dvec2& place, double reach, const Errors& errors) const
{
  if (!this->HasPlane)
  {
    return -std::numeric_limits<double>::infinity();
  }
  const glm::dvec2 side = glm::dvec2(this->To - this->From) / this->Length;
  const glm::dvec2 toThird(this->Third - this->From);
  const glm::dvec2 toPlace = place - glm::dvec2(this->From);
  const double middle = (Cross(side, toThird) < 0.0 ? -1.0 : 1.0) * Cross(side, toPlace);
  // No sample is farther outside of the triangle than this. 1.5 allows for diagonals (sqrt(2)).
  const double outside = errors.Overshoot + this->Beside;
  const double low = std::max(middle - 1.5 * reach, -outside) - this->Beside;
  const double high = std::min(middle + 1.5 * reach, this->Height + outside) + this->Beside;
  // The weights that the third corner may have.
  const double lowest = this->Height - 2.0 * this->Beside;
  const double highest = this->Height + 2.0 * this->Beside;
  const double least = low / (low < 0.0 ? lowest : highest);
  const double most = high / (high < 0.0 ? highest : lowest);
  const double largest = std::max({ std::abs(least), std::abs(most), 1.0 });

  const double slope = (this->To.z - this->From.z) / this->Length;
  const double along = glm::dot(side, toPlace);
  const double ofPlaces = this->Error.x + this->Error.y;
  return this->From.z + slope * along + std::min(least * this->Across, most * this->Across) -
    this->Steepness * (1.5 * reach + 2.0 * ofPlaces * (1.0 + largest)) -
    errors.DepthError * (1.0 + 2.0 * largest) - this->Rounding;
}

vtkNBufferSliverTest::vtkNBufferSliverTest(const vtkNBufferProjection& projection,
  const vtkNBufferLevels& levels, const float* depth, vtkNBufferSamples samples)
  : Projection(projection)
  , Levels(levels)
  , Depth(depth)
  , Samples(std::move(samples))
{
}

vtkNBufferSliverTest::Point vtkNBufferSliverTest::Project(
  const glm::dvec3& place, const vtkNBufferProjection::Rows& toWindow, double reach) const
{
  const glm::dvec2 size(this->Levels.GetPixelWidth(), this->Levels.GetPixelHeight());
  const auto samples = static_cast<int>(this->Samples.Places.size());
  // How many columns and rows, of the pixels from -1 on, are before a place, by this comparison.
  const auto count = [&](const glm::dvec2& corner, const auto& isBefore)
  {
    const glm::dvec2 up = glm::clamp(corner, glm::dvec2(-1.0), size) + 1.0;
    const glm::ivec2 pixel(up); // rounds down, because no number is negative
    glm::ivec2 columns = samples * pixel;
    for (const glm::dvec2& sample : this->Samples.Places)
    {
      columns += glm::ivec2(isBefore(sample, up - glm::dvec2(pixel)));
    }
    return columns;
  };
  const auto evaluate = [&](int row) { return vtkNBufferBoxError::Evaluate(toWindow[row], place); };
  Point point;
  point.W = evaluate(3);
  point.Place = point.W > 0.0 ? glm::dvec2(evaluate(0), evaluate(1)) / point.W : glm::dvec2(0.0);
  point.First = count(point.Place - reach, [](auto a, auto b) { return glm::lessThan(a, b); });
  point.Last =
    count(point.Place + reach, [](auto a, auto b) { return glm::lessThanEqual(a, b); }) - 1;
  return point;
}

bool vtkNBufferSliverTest::MayBeSeen(const vtkNBufferMesh& mesh, std::size_t begin, std::size_t end,
  const double toWorld[16], const vtkNBufferBox& box, const vtkNBufferScreenBox& screen) const
{
  const vtkNBufferProjection::Rows toWindow =
    this->Projection.GetWindowMatrix(vtkNBufferGLM::ToMatrix(toWorld));
  const Errors errors = this->Projection.GetTriangleErrors(screen);
  const double reach = 0.5 * GridStep + errors.PositionError + this->Samples.Distance;

  // The errors of clip coordinates, x and y times the size of a pixel.
  const glm::dvec2 half = { 0.5 * this->Projection.GetWidth(), 0.5 * this->Projection.GetHeight() };
  const auto& toClip = this->Projection.GetWorldToClip();
  const auto getError = [&](int row)
  { return vtkNBufferBoxError::GetVertexError(toClip[row], box); };
  const glm::dvec2 ofPlace = half * glm::dvec2(getError(0), getError(1));
  const double ofW = getError(3);
  // Two corners may err by the diagonal of PositionError each, and 2 sqrt(2) is less than 3.
  const double covered = 3.0 * errors.PositionError + screen.DepthRange / errors.CoveredSlope;

  // Triangles share most of their points with those next to them in the mesh, so that the last
  // points are kept.
  std::array<Point, 64> points;
  std::array<unsigned int, 64> numbers;
  numbers.fill(std::numeric_limits<unsigned int>::max());
  const auto getPoint = [&](unsigned int number) -> Point
  {
    Point& point = points[number % points.size()];
    if (std::exchange(numbers[number % points.size()], number) != number)
    {
      point = this->Project(mesh.Points[number], toWindow, reach);
    }
    return point;
  };

  for (std::size_t i = begin; i < std::min(end, mesh.Triangles.size()); ++i)
  {
    const std::array<unsigned int, 3>& triangle = mesh.Triangles[i];
    const Point a = getPoint(triangle[0]);
    const Point b = getPoint(triangle[1]);
    const Point c = getPoint(triangle[2]);
    const glm::ivec2 first = glm::min(glm::min(a.First, b.First), c.First);
    const glm::ivec2 last = glm::max(glm::max(a.Last, b.Last), c.Last);
    if (first.x > last.x || first.y > last.y)
    {
      continue;
    }
    const glm::dvec2 low = glm::min(glm::min(a.Place, b.Place), c.Place);
    const glm::dvec2 high = glm::max(glm::max(a.Place, b.Place), c.Place);
    // This is not less than the longest side, so that the height is never overestimated.
    const double length = high.x - low.x + high.y - low.y;
    const double area = std::abs(Cross(b.Place - a.Place, c.Place - a.Place));
    const double w = std::min({ a.W, b.W, c.W });
    // Triangles that reach behind the eye are not covered.
    if (area >= length * (covered + errors.LowestRelativeHeight * length) || !(w > 0.0))
    {
      continue;
    }
    // How far corners are from the middle of the view.
    const glm::dvec2 aside = glm::max(half - low, high - half);
    glm::dvec2 error(errors.PositionError);
    if (w > ofW)
    {
      error = glm::min(error, errors.GetPlaceError(ofPlace, ofW, 1.0 / (w - ofW), aside, half));
    }
    const auto getCorner = [&](const Point& point, unsigned int i)
    {
      return glm::dvec3(
        point.Place, vtkNBufferBoxError::Evaluate(toWindow[2], mesh.Points[i]) / point.W);
    };
    if (this->MayBeSeen(
          { getCorner(a, triangle[0]), getCorner(b, triangle[1]), getCorner(c, triangle[2]) },
          error, errors))
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferSliverTest::MayBeSeen(
  const Corners& corners, const glm::dvec2& error, const Errors& errors) const
{
  const auto getLength = [](const glm::dvec3& a, const glm::dvec3& b)
  { return glm::distance(glm::dvec2(a), glm::dvec2(b)); };
  Sliver sliver;
  int first = 0;
  sliver.Length = getLength(corners[0], corners[1]);
  for (int i = 1; i < 3; ++i)
  {
    const double other = getLength(corners[i], corners[(i + 1) % 3]);
    if (other > sliver.Length)
    {
      sliver.Length = other;
      first = i;
    }
  }
  sliver.From = corners[first];
  sliver.To = corners[(first + 1) % 3];
  sliver.Third = corners[(first + 2) % 3];
  const double length = sliver.Length;
  // No device draws a triangle with two corners in one place.
  if (!std::isfinite(length + sliver.Third.x + sliver.Third.y) ||
    getLength(sliver.From, sliver.Third) == 0.0 || getLength(sliver.To, sliver.Third) == 0.0)
  {
    return false;
  }
  const glm::dvec3 side = sliver.To - sliver.From;
  const glm::dvec3 toThird = sliver.Third - sliver.From;
  const double along = side.z / length;
  const double foot = glm::dot(glm::dvec2(side), glm::dvec2(toThird)) / length;
  sliver.Height = std::abs(Cross(glm::dvec2(side), glm::dvec2(toThird))) / length;
  sliver.Across = toThird.z - along * foot;
  sliver.Error = error;
  sliver.Beside = (error.x * std::abs(side.y) + error.y * std::abs(side.x)) / length;
  // The triangle that the device draws has displaced vertices, which may make it steeper.
  const double twice = 2.0 * (error.x + error.y);
  sliver.Steepness = std::abs(along) * (1.0 + twice / length);
  const double height = sliver.Height - 2.0 * sliver.Beside;
  sliver.HasPlane = height > 0.0 && height >= errors.LowestRelativeHeight * length;
  if (sliver.HasPlane)
  {
    const auto [low, high] = std::minmax({ corners[0].z, corners[1].z, corners[2].z });
    const double slope = sliver.Steepness +
      (std::abs(sliver.Across) + twice * sliver.Steepness + 2.0 * errors.DepthError) / height;
    const double ofSlopes = std::min(errors.SlopeRounding, errors.SlopeRoundingPerLength * length) *
      (high - low + 2.0 * errors.DepthError) / height;
    if (slope * errors.DepthErrorPerSlope + ofSlopes <= errors.BoxSlack)
    {
      return false;
    }
    sliver.Rounding = slope * (errors.DepthErrorPerSlope - errors.Overshoot) + ofSlopes;
  }
  sliver.Snap(errors.IsSnappedToGrid);
  return this->HasVisibleSample(sliver, errors);
}

bool vtkNBufferSliverTest::HasVisibleSample(const Sliver& sliver, const Errors& errors) const
{
  // Pixel by pixel along the axis on which the longest side is longer: u is along that axis, v
  // across it.
  const glm::dvec3& from = sliver.From;
  const glm::dvec3& to = sliver.To;
  const bool alongX = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
  const int along = alongX ? 0 : 1;
  const int other = 1 - along;
  const double u0 = from[along];
  const double v0 = from[other];
  const double du = to[along] - from[along];
  const double dv = to[other] - from[other];
  const double slope = du != 0.0 ? dv / du : 0.0;
  // No point of the triangle is farther from its longest side. 1.5 allows for diagonals (sqrt(2)).
  const double distance = sliver.Height + errors.Overshoot +
    1.5 * (std::max(sliver.Error.x, sliver.Error.y) + this->Samples.GetDistanceFromMiddle());
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
    const int lastV = getLast(v + across, sizeV);
    for (int w = getFirst(v - across, sizeV); w <= lastV; ++w)
    {
      const glm::ivec2 pixel = alongX ? glm::ivec2(u, w) : glm::ivec2(w, u);
      double farthest = this->Levels.GetTexel(0, pixel.x / factor, pixel.y / factor);
      if (this->Depth)
      {
        const std::ptrdiff_t place = std::ptrdiff_t{ pixel.y } * pixels.x + pixel.x;
        farthest = std::min<double>(farthest, this->Depth[place]);
      }
      for (const glm::dvec2& sample : this->Samples.Places)
      {
        const glm::dvec2 place = glm::dvec2(pixel) + sample;
        if (sliver.MayOwn(place, this->Samples.Distance) &&
          !(sliver.GetNearest(place, this->Samples.Distance, errors) > farthest))
        {
          return true;
        }
      }
    }
  }
  return false;
}
VTK_ABI_NAMESPACE_END
