// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClipBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace NBufferPeers
{
namespace
{
using Rows = vtkNBufferProjection::Rows;

/// Clip coordinates of corner i of the box grown by `pad` along each axis.
glm::dvec4 GetCorner(const Rows& rows, const vtkNBufferBox& box, double pad, int i)
{
  const glm::dvec3 side(
    (i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
  const glm::dvec3 p = box.Center + side * (box.HalfSize + pad);
  glm::dvec4 clip;
  for (int row = 0; row < 4; ++row)
  {
    clip[row] = vtkNBufferBoxError::Evaluate(rows[row], p);
  }
  return clip;
}

/**
 * The least clip movement (dx, dy) that a step of length 1 along the image plane, across the axis
 * of depth, makes in any direction: the smaller singular value of rows 0 and 1 without their parts
 * along that axis.
 */
double GetLeastMovement(const Rows& rows)
{
  const glm::dvec3 last(rows[3]);
  const glm::dvec3 axis = glm::dot(last, last) > 0.0 ? last : glm::dvec3(rows[2]);
  const auto getAcross = [&axis](const glm::dvec3& row)
  { return row - glm::dot(row, axis) / glm::dot(axis, axis) * axis; };
  const glm::dvec3 across[2] = { getAcross(rows[0]), getAcross(rows[1]) };
  const double a = glm::dot(across[0], across[0]);
  const double b = glm::dot(across[0], across[1]);
  const double c = glm::dot(across[1], across[1]);
  const double square = 0.5 * (a + c) - std::hypot(0.5 * (a - c), b);
  return std::sqrt(std::max(square, 0.0));
}

/// Pixels beyond the outline for snapping to the grid of subpixels, of the prop and of the box.
constexpr double OutlinePixels = 2.0 / 16.0;
}

bool MakeClipBox(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, ClipBox& result)
{
  if (screen.Clipped)
  {
    return false;
  }
  const Rows& rows = projection.GetWorldToClip();
  const double pixels = 2.0 * (box.Margin + OutlinePixels);
  const double ndc = std::hypot(2.0 * screen.Slack[0] + pixels / projection.GetWidth(),
    2.0 * screen.Slack[1] + pixels / projection.GetHeight());
  // The padded box reaches farther, to a w that is larger by pad |row 3|_1.
  const double growth = std::abs(rows[3][0]) + std::abs(rows[3][1]) + std::abs(rows[3][2]);
  const double movement = GetLeastMovement(rows) - ndc * growth;
  const double pad = ndc * screen.MaximumW / movement;
  if (!(movement > 0.0) || !std::isfinite(pad))
  {
    return false;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 clip = GetCorner(rows, box, 0.0, i);
    if (!(clip.w > 0.0))
    {
      return false;
    }
    nearest = std::min(nearest, 0.5 + 0.5 * clip.z / clip.w);
  }
  // Twice, and a window depth of 1 is 2 in NDC.
  const double nearer = 2.0 * 2.0 * std::max(nearest - screen.Nearest, 0.0);
  for (int i = 0; i < 8; ++i)
  {
    glm::dvec4 clip = GetCorner(rows, box, pad, i);
    clip.z -= nearer * clip.w;
    // NaN is no "greater" either.
    if (!(clip.w > 0.0 && clip.z > -clip.w))
    {
      return false;
    }
    std::copy_n(glm::value_ptr(clip), 4, result.Corners[i]);
  }
  return true;
}

} // namespace NBufferPeers
