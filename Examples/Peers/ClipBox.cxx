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
using Rows = double[4][4];

double Dot(const double* a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Clip coordinates of corner i of the box grown by `pad` along each axis.
void GetCorner(const Rows& rows, const vtkNBufferBox& box, double pad, int i, double clip[4])
{
  double p[3];
  for (int j = 0; j < 3; ++j)
  {
    const double half = box.HalfSize[j] + pad;
    p[j] = box.Center[j] + ((i >> j & 1) != 0 ? half : -half);
  }
  for (int row = 0; row < 4; ++row)
  {
    clip[row] = Dot(rows[row], p) + rows[row][3];
  }
}

/**
 * The least clip movement (dx, dy) that a step of length 1 along the image plane, across the axis
 * of depth, makes in any direction: the smaller singular value of rows 0 and 1 without their parts
 * along that axis.
 */
double GetLeastMovement(const Rows& rows)
{
  const double* axis = Dot(rows[3], rows[3]) > 0.0 ? rows[3] : rows[2];
  double across[2][3];
  for (int row = 0; row < 2; ++row)
  {
    const double along = Dot(rows[row], axis) / Dot(axis, axis);
    for (int j = 0; j < 3; ++j)
    {
      across[row][j] = rows[row][j] - along * axis[j];
    }
  }
  const double a = Dot(across[0], across[0]);
  const double b = Dot(across[0], across[1]);
  const double c = Dot(across[1], across[1]);
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
  const auto& rows = *reinterpret_cast<const Rows*>(projection.GetWorldToClip());
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
    double clip[4];
    GetCorner(rows, box, 0.0, i, clip);
    if (!(clip[3] > 0.0))
    {
      return false;
    }
    nearest = std::min(nearest, 0.5 + 0.5 * clip[2] / clip[3]);
  }
  // Twice, and a window depth of 1 is 2 in NDC.
  const double nearer = 2.0 * 2.0 * std::max(nearest - screen.Nearest, 0.0);
  for (int i = 0; i < 8; ++i)
  {
    double clip[4];
    GetCorner(rows, box, pad, i, clip);
    clip[2] -= nearer * clip[3];
    // NaN is no "greater" either.
    if (!(clip[3] > 0.0 && clip[2] > -clip[3]))
    {
      return false;
    }
    std::copy(clip, clip + 4, result.Corners[i]);
  }
  return true;
}

} // namespace NBufferPeers
