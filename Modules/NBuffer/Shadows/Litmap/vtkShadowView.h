// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowView.h
 * @brief The camera and the image that a depth image of receivers belongs to. No OpenGL.
 */
#ifndef vtkShadowView_h
#define vtkShadowView_h

#include "vtkNBufferGLM.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowView
{
  /// The inverse of vtkCamera's world-to-clip matrix for z in [-w, w]. World coordinates are
  /// relative to Origin.
  glm::dmat4 ClipToWorld = glm::dmat4(1.0);

  glm::dvec3 Origin = { 0.0, 0.0, 0.0 }; ///< The world position of the eye.
  int Width = 0;                         ///< The number of columns, at most 65535.
  int Height = 0;                        ///< The number of rows, at most 65535.
  double DepthQuantum = 0x1p-24;         ///< The step of the depth format near 1.

  /// The places of the samples in a pixel, in [0, 1] from its lower left corner.
  std::vector<std::array<double, 2>> Samples = { { { 0.5, 0.5 } } };
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowView.h
