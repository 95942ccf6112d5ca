// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferSampleSquares.h
 * @brief Where in each pixel a device takes its samples. No OpenGL.
 */
#ifndef vtkNBufferSampleSquares_h
#define vtkNBufferSampleSquares_h

#include "vtkNBufferGLM.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
/// Each sample lies in one of these squares, with its sides. By default it may be anywhere in its
/// pixel. All lengths are in pixels.
struct vtkNBufferSampleSquares
{
  /// The middles of the squares, relative to the middle of the pixel.
  std::vector<glm::dvec2> Middles = { glm::dvec2(0.0) };
  /// Half the side of a square; 0 if the places of all samples are known.
  double HalfSide = 0.5;

  /// How far a sample may be from the middle of its pixel in x and in y.
  double GetDistance() const
  {
    double distance = 0.0;
    for (const glm::dvec2& middle : this->Middles)
    {
      distance = std::max({ distance, std::abs(middle.x), std::abs(middle.y) });
    }
    return distance + this->HalfSide;
  }
};

VTK_ABI_NAMESPACE_END
#endif
