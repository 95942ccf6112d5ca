// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferBox
 * @brief An axis-aligned box in world coordinates, and what bounds the rounding of the vertices in
 * it. No OpenGL.
 */
#ifndef vtkNBufferBox_h
#define vtkNBufferBox_h

#include "vtkNBufferGLM.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferBox
{
  glm::dvec3 Center = glm::dvec3(0.0);
  glm::dvec3 HalfSize = glm::dvec3(0.0);
  ///@{
  /// The vectors o and m of vtkNBufferBoxError.h, in world units: the point whose vertex buffer
  /// coordinates are 0, and how far from it the vertices are at most along each axis.
  glm::dvec3 Origin = glm::dvec3(0.0);
  glm::dvec3 Magnitude = glm::dvec3(0.0);
  ///@}
  /// How many pixels the fragments of lines and points may stick out of the projected box. 0 if the
  /// box contains neither.
  double Margin = 0.0;

  /// Whether all numbers are the same. An infinity equals itself here, but not with GLM's operator,
  /// which compares differences.
  bool operator==(const vtkNBufferBox& other) const
  {
    const auto same = [](const glm::dvec3& a, const glm::dvec3& b)
    { return a.x == b.x && a.y == b.y && a.z == b.z; };
    return same(this->Center, other.Center) && same(this->HalfSize, other.HalfSize) &&
      same(this->Origin, other.Origin) && same(this->Magnitude, other.Magnitude) &&
      this->Margin == other.Margin;
  }

  /// A box from VTK bounds (low x, high x, low y, ...) whose vertex buffer holds world coordinates.
  static vtkNBufferBox FromBounds(const double bounds[6])
  {
    vtkNBufferBox box;
    for (int i = 0; i < 3; ++i)
    {
      box.Center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
      // The centre, the half size and their sum are rounded. A few steps outward allow for that.
      const double half = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]);
      box.HalfSize[i] = half + (std::abs(box.Center[i]) + half) * 0x1p-50;
      box.Magnitude[i] = std::abs(box.Center[i]) + box.HalfSize[i];
    }
    return box;
  }

  /// Set Center and HalfSize to those of a box around all points between `low` and `high`, which
  /// are in coordinates that `toWorld` takes to the world. Returns, for each axis, the largest size
  /// of the numbers that are added for that.
  glm::dvec3 SetPlace(const glm::dmat4& toWorld, const glm::dvec3& low, const glm::dvec3& high)
  {
    const glm::dvec3 middle = 0.5 * (low + high);
    const glm::dvec3 half = 0.5 * (high - low);
    const glm::dvec3 largest = glm::max(vtkNBufferGLM::Abs(low), vtkNBufferGLM::Abs(high));
    this->Center = glm::dvec3(toWorld[3]);
    this->HalfSize = glm::dvec3(0.0);
    glm::dvec3 magnitude = vtkNBufferGLM::Abs(this->Center);
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3 column(toWorld[k]);
      this->Center += column * middle[k];
      this->HalfSize += vtkNBufferGLM::Abs(column) * half[k];
      magnitude += vtkNBufferGLM::Abs(column) * largest[k];
    }
    // Some ten operations are rounded on numbers that are at most as large as this.
    this->HalfSize += magnitude * 0x1p-48;
    return magnitude;
  }

  /// Set Origin and Magnitude from `origin` and `magnitude`, which are in coordinates that
  /// `toWorld` takes to the world.
  void SetRounding(const glm::dmat4& toWorld, const glm::dvec3& origin, const glm::dvec3& magnitude)
  {
    this->Origin = glm::dvec3(toWorld[3]);
    this->Magnitude = glm::dvec3(0.0);
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3 column(toWorld[k]);
      this->Origin += column * origin[k];
      this->Magnitude += vtkNBufferGLM::Abs(column) * magnitude[k];
    }
  }
};

VTK_ABI_NAMESPACE_END
#endif
