// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferSamples.h
 * @brief Where in a pixel a device takes samples. No OpenGL.
 */
#ifndef vtkNBufferSamples_h
#define vtkNBufferSamples_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
/// Every sample of a pixel is at most Distance from one of the places, in x and in y. Lengths are
/// in pixels, and places are relative to the lower left corner of the pixel.
struct vtkNBufferSamples
{
  std::vector<glm::dvec2> Places = { glm::dvec2(0.5) };
  double Distance = 0.0;

  /// The samples may be anywhere in the pixel.
  static vtkNBufferSamples Anywhere()
  {
    vtkNBufferSamples samples;
    samples.Distance = 0.5;
    return samples;
  }

  /// How far a sample may be from the middle of its pixel, in x and in y.
  double GetDistanceFromMiddle() const
  {
    double distance = 0.0;
    for (const glm::dvec2& place : this->Places)
    {
      const glm::dvec2 fromMiddle = glm::abs(place - 0.5);
      distance = std::max({ distance, fromMiddle.x, fromMiddle.y });
    }
    return distance + this->Distance;
  }
};

VTK_ABI_NAMESPACE_END
#endif
