// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferPolygonClip.h
 * @brief Clips a convex polygon by a half space (I. Sutherland, G. Hodgman, "Reentrant polygon
 * clipping", Communications of the ACM 17(1), 1974).
 *
 *        A-----X-----B         The corners A, B, C, D become A, X, Y, D.
 *        |      \    |
 *        |       \   |         Corners with a distance >= 0 (here: left of the line X Y) are kept.
 *        |        \  |         Each edge whose ends lie on different sides gets one new corner.
 *        D---------Y-C
 */
#ifndef vtkNBufferPolygonClip_h
#define vtkNBufferPolygonClip_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferPolygonClip
{
/**
 * Clips `polygon` and stores what is left in `result`, which must be another container of the same
 * type (its memory is kept). `result` is empty if the whole polygon is cut off.
 *
 * Corners may be points or indices of points. `getDistance(corner)` returns a number that is linear
 * along edges; corners with a number below 0 are cut off. `cut(from, to, t)` returns the new corner
 * on an edge, at from + t (to - from) with 0 <= t <= 1. It is called once for each edge that is
 * cut; `from` precedes `to` in the polygon.
 */
template <typename Polygon, typename Distance, typename Cut>
void Clip(const Polygon& polygon, Distance&& getDistance, Cut&& cut, Polygon& result)
{
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto& from = polygon[i];
    const auto& to = polygon[(i + 1) % polygon.size()];
    const double distance = getDistance(from);
    const double next = getDistance(to);
    if (distance >= 0.0)
    {
      result.push_back(from);
    }
    if ((distance >= 0.0) != (next >= 0.0))
    {
      result.push_back(cut(from, to, distance / (distance - next)));
    }
  }
}

/// Clips a polygon whose corners are vectors, such as glm::dvec4.
template <typename Polygon, typename Distance>
void Clip(const Polygon& polygon, Distance&& getDistance, Polygon& result)
{
  Clip(
    polygon, getDistance,
    [](const auto& from, const auto& to, double t) { return from + t * (to - from); }, result);
}
}
VTK_ABI_NAMESPACE_END
#endif
