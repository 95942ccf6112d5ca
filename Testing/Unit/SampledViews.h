// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampledViews.h
 * @brief Random cameras and boxes, and brute force to judge what is said about them.
 *
 * Points are sampled in a box and projected twice: exactly (long double), and as a device may do
 * it, with vertices, matrix and sums rounded to float. Whatever is claimed of a box must hold for
 * every one of these points. That is tested for other depths than VTK's as well
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

  /// The order in another convention of a point with a window depth of VTK's.
  double ToOrder(double windowDepth, DepthConvention convention) const;

  std::string Text; ///< For failures.
};

/// The projection of a view with a depth buffer of floats.
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

  /// Perspective and parallel, at `offset` from the origin, near and far from 1e-3 to 1e7.
  View MakeView(double offset, bool extremeRange = true);

  /// Bounds near the view: small and large, flat and thin, before, around and behind the eye. All
  /// coordinates are floats, as points of datasets are.
  std::array<double, 6> MakeBounds(const View& view);

  /// The corners and `count` points on the surface and inside.
  std::vector<glm::dvec3> MakePoints(const std::array<double, 6>& bounds, int count);

private:
  std::mt19937 Random;
};

/// Exact projection, if the point is before the eye and inside all six planes: x and y in pixels of
/// the viewport, z the stored depth as order of distance.
std::optional<glm::dvec3> ProjectExactly(
  const View& view, const glm::dvec3& point, DepthConvention convention = DepthConvention::Forward);

/// The same in single precision, products added in the order of `permutation` (0 to 3 first).
std::optional<glm::dvec3> ProjectAsDevice(const View& view, const glm::dvec3& point,
  int permutation, DepthConvention convention = DepthConvention::Forward);

/// Where the ray through pixel position (x, y) enters and leaves a box, in window depth.
std::optional<std::array<double, 2>> GetDepthsAlongRay(
  const View& view, const std::array<double, 6>& bounds, double x, double y);

/// Whether a point of a box, drawn there, is where the projection says that the box is.
bool IsWithin(const glm::dvec3& point, const vtkNBufferScreenBox& screen);

/// For failures: the view, and the bounds with all digits.
std::string GetText(const View& view, const std::array<double, 6>& bounds);

#endif
