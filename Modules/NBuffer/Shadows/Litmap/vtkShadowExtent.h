// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowExtent
 * @brief The extent of some receivers: depths, box of pixels, occupied bins. No OpenGL.
 */
#ifndef vtkShadowExtent_h
#define vtkShadowExtent_h

#include "vtkNBufferVTKVersion.h"

#include <cstdint>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

/**
 * The extent of the receivers in a part of a litmap, in 32 bytes. It is empty as constructed.
 */
struct vtkShadowExtent
{
  double Near = std::numeric_limits<double>::infinity(); ///< The least depth s.
  double Far = -std::numeric_limits<double>::infinity(); ///< The largest depth s.
  std::uint16_t X0 = 0xffff;                             ///< The first column of the box of pixels.
  std::uint16_t Y0 = 0xffff;                             ///< The first row of the box of pixels.
  std::uint16_t X1 = 0;                                  ///< The column after the last one.
  std::uint16_t Y1 = 0;                                  ///< The row after the last one.
  std::uint64_t Bins = 0; ///< Bit i is set if a receiver may lie in bin i of the depths.

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
// VTK-HeaderTest-Exclude: vtkShadowExtent.h
