// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowBlock.h
 * @brief Ranges of light coordinates: a box in p, q and s, a slab in s alone, and the extent of
 * receivers. No OpenGL.
 */
#ifndef vtkShadowBlock_h
#define vtkShadowBlock_h

#include "vtkNBufferGLM.h"

#include <cstdint>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

/**
 * An axis-aligned box in light coordinates (p, q, s) or, where a comment says so, in world
 * coordinates. It is empty when constructed.
 */
struct vtkShadowBlock
{
  glm::dvec3 Low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 High = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool IsEmpty() const { return !(this->Low[2] <= this->High[2]); }

  /// Returns true if the two boxes have a point in common. Boxes that only touch do.
  bool Meets(const vtkShadowBlock& other) const
  {
    return glm::all(glm::lessThanEqual(this->Low, other.High)) &&
      glm::all(glm::lessThanEqual(other.Low, this->High));
  }

  /// Widens the box to hold another box, given by its lowest and highest corner.
  void Add(const glm::dvec3& low, const glm::dvec3& high)
  {
    this->Low = glm::min(this->Low, low);
    this->High = glm::max(this->High, high);
  }

  /// Widens the box to hold a point.
  void Add(const glm::dvec3& x) { this->Add(x, x); }

  /// Widens the box to hold the segment from a to b and a margin of radius[i] around it in
  /// coordinate i.
  void AddSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& radius)
  {
    this->Add(glm::min(a, b) - radius, glm::max(a, b) + radius);
  }
};

/// A range of depths s, in world units along the axis of a vtkShadowLightSpace.
struct vtkShadowSlab
{
  double Near = 0.0; ///< The depth nearer to the light.
  double Far = 0.0;  ///< The depth farther from the light.
};

/**
 * The extent of the receivers in a part of a litmap, in 32 bytes. It is empty when constructed.
 */
struct vtkShadowExtent
{
  double Near = std::numeric_limits<double>::infinity(); ///< The least depth s.
  double Far = -std::numeric_limits<double>::infinity(); ///< The largest depth s.
  std::uint16_t X0 = 0xffff;                             ///< The first column of the box of pixels.
  std::uint16_t Y0 = 0xffff;                             ///< The first row of the box of pixels.
  std::uint16_t X1 = 0;                                  ///< The column after the last one.
  std::uint16_t Y1 = 0;                                  ///< The row after the last one.
  std::uint64_t Bins = 0; ///< Bit i is set if a receiver may lie in bin i of the litmap's depths.

  bool IsEmpty() const { return this->X1 <= this->X0; }

  void Merge(const vtkShadowExtent& other)
  {
    this->Near = other.Near < this->Near ? other.Near : this->Near;
    this->Far = other.Far > this->Far ? other.Far : this->Far;
    this->X0 = other.X0 < this->X0 ? other.X0 : this->X0;
    this->Y0 = other.Y0 < this->Y0 ? other.Y0 : this->Y0;
    this->X1 = other.X1 > this->X1 ? other.X1 : this->X1;
    this->Y1 = other.Y1 > this->Y1 ? other.Y1 : this->Y1;
    this->Bins |= other.Bins;
  }
};

VTK_ABI_NAMESPACE_END
#endif
