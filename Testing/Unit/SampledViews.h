// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledViews.h
 * @brief Random cameras and boxes, to test by brute force what a projection says about a box.
 *
 * Points are sampled in a box and projected twice: exactly (long double), and as a device may do
 * it, with vertices, matrix and sums rounded to float. What the projection says about a box must be
 * true of each of these points. Other conventions of depth than VTK's are tested as well
 * (DepthConvention.h), so that the mathematics does not rely on how VTK's depth is rounded.
 */
#ifndef SampledViews_h
#define SampledViews_h

#include "DepthConvention.h"
#include "ProjectedBox.h"

#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

using NBufferStudy::DepthConvention;

struct View
{
  std::array<double, 16> WorldToClip{};
  int Width = 0;
  int Height = 0;
  double Near = 0.0;
  double Far = 0.0;
  glm::dvec3 Position = glm::dvec3(0.0);
  glm::dvec3 Direction = glm::dvec3(0.0);
  bool Parallel = false;

  /// Returns the order (DepthConvention.h), in another convention, of a point with this window
  /// depth in VTK.
  double ToOrder(double windowDepth, DepthConvention convention) const;

  std::string Text; ///< A description, for messages of failures.
};

/// Returns the projection of a view with a depth buffer of floats.
vtkNBufferProjection MakeProjection(
  const View& view, DepthConvention convention = DepthConvention::Forward);

class ViewSampler
{
public:
  explicit ViewSampler(unsigned int seed)
    : Random(seed)
  {
  }

  double Uniform(double a, double b);
  int Integer(int a, int b);

  /// Returns a view, perspective or parallel, whose eye is within 5 of `offset` in x, y and z. With
  /// `extremeRange` the near plane is at 1e-3 to 10 and the far plane up to 1e7 times farther;
  /// otherwise they are at 1 and 100.
  View MakeView(double offset, bool extremeRange = true);

  /// Returns bounds near the view: small or large, flat or thin, before, around or behind the eye.
  /// All coordinates are floats, as the points of data sets are.
  std::array<double, 6> MakeBounds(const View& view);

  /// Puts a matrix before that of the view, as a user matrix does, which leaves the middle of the
  /// bounds in place and flattens what is there to a plane, exactly or nearly.
  void Flatten(View& view, const std::array<double, 6>& bounds);

  /// Returns the corners of a box, and `count` points on its surface and inside.
  std::vector<glm::dvec3> MakePoints(const std::array<double, 6>& bounds, int count);

private:
  std::mt19937 Random;
};

/// Projects a point exactly: x and y in pixels of the viewport, and the order of the stored depth
/// as z. Returns nothing if the point is outside of the view volume.
std::optional<glm::dvec3> ProjectExactly(
  const View& view, const glm::dvec3& point, DepthConvention convention = DepthConvention::Forward);

/// Projects a point in single precision. Each clip coordinate is a sum of four products, from left
/// to right; `permutation`, from 0 to 3, is the product that changes places with the first one.
std::optional<glm::dvec3> ProjectAsDevice(const View& view, const glm::dvec3& point,
  int permutation, DepthConvention convention = DepthConvention::Forward);

/// Returns VTK's window depths at which the ray through the pixel position (x, y) enters and leaves
/// a box between the clipping planes, or nothing if it misses the box.
std::optional<std::array<double, 2>> GetDepthsAlongRay(
  const View& view, const std::array<double, 6>& bounds, double x, double y);

/// Returns whether a projected point of a box is in the rectangle and between the depths that the
/// projection gives for this box.
bool IsWithin(const glm::dvec3& point, const vtkNBufferScreenBox& screen);

/// Returns the view and the bounds with all digits, for messages of failures.
std::string GetText(const View& view, const std::array<double, 6>& bounds);

#endif
