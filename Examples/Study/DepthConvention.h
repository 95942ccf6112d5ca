// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthConvention.h
 * @brief Other conventions of depth, for comparison with the one that VTK uses.
 *
 * With the clip coordinates (x, y, z, w) of vtkCamera, where z is in [-w, w]:
 *
 *     convention  stored depth         near plane  far plane  hides     background
 *     Forward     (z / w + 1) / 2      0           1          maximum   1
 *     Reversed    (1 - z / w) / 2      1           0          minimum   0
 *     InverseW    near / w             1           near / far minimum   0
 *
 * VTK draws Forward, and an application may let it draw Reversed (vtkNBufferStoredDepth): the
 * matrix then computes (w - z) / 2 as z, with glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE). The
 * module supports nothing else. InverseW is useless in parallel projection, where w is constant:
 * every box is then Crossing.
 *
 * The study uses the order of a depth, sign * stored depth, with a sign of 1 for Forward and -1 for
 * the others. The order grows with distance in every convention, so that levels of maxima
 * and all tests of the module can be used as they are.
 *
 * vtkNBufferBoxError.h derives the slack of both; InverseW has that of Reversed.
 */
#ifndef DepthConvention_h
#define DepthConvention_h

#include "vtkNBufferProjection.h"

#include <algorithm>
#include <array>

namespace NBufferStudy
{

enum class DepthConvention
{
  Forward,
  Reversed,
  InverseW
};

constexpr std::array<DepthConvention, 3> DepthConventions = { DepthConvention::Forward,
  DepthConvention::Reversed, DepthConvention::InverseW };
constexpr std::array<const char*, 3> DepthConventionNames = { "Forward", "Reversed", "InverseW" };

/// Returns the order where nothing has been drawn.
inline float GetBackgroundOrder(DepthConvention convention)
{
  return convention == DepthConvention::Forward ? 1.0f : 0.0f;
}

/// Does the same as vtkNBufferProjection::Set(), for any convention. `depthQuantum` is 0 for floats
/// unless the convention is Forward.
inline void SetProjection(vtkNBufferProjection& projection, const double worldToClip[16], int width,
  int height, double depthQuantum, DepthConvention convention)
{
  if (convention == DepthConvention::Forward)
  {
    projection.Set(worldToClip, width, height, vtkNBufferDepthFormat::FromQuantum(depthQuantum));
    return;
  }
  // Row 2 gives the order times w, which is -w on the near plane.
  double matrix[16];
  std::copy_n(worldToClip, 16, matrix);
  if (convention == DepthConvention::Reversed)
  {
    for (int j = 0; j < 4; ++j)
    {
      matrix[8 + j] = 0.5 * (worldToClip[8 + j] - worldToClip[12 + j]);
    }
  }
  else
  {
    // w of the near plane, in the middle of the view.
    const glm::dmat4 clipToWorld = vtkNBufferGLM::Invert(vtkNBufferGLM::ToMatrix(worldToClip));
    std::fill_n(matrix + 8, 3, 0.0);
    matrix[11] = -1.0 / (clipToWorld[3][3] - clipToWorld[2][3]);
  }
  projection.Set(matrix, width, height,
    vtkNBufferDepthFormat::FromQuantum(depthQuantum, vtkNBufferStoredDepth::Reversed));
}

} // namespace NBufferStudy

#endif
