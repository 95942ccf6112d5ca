// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferListTraits
 * @brief What some prop of a list is, so that it matters to the frame as a whole.
 *
 * See the functions of vtkNBufferCandidate for the terms.
 */
#ifndef vtkNBufferListTraits_h
#define vtkNBufferListTraits_h

#include "vtkNBufferCandidate.h"
#include "vtkType.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferListTraits
{
  bool UntrackedDepth = false; ///< The depth of some prop may change without a newer time.
  /// The same, stages after the opaque one included: 2-D props and volumes may write depth there.
  bool UntrackedPicture = false;
  bool DepthOffset = false;   ///< The depth of some prop is offset.
  bool Translucent = false;   ///< Some prop is translucent and may be tested.
  bool LackOfNormals = false; ///< Some prop may lack normals.
  ///@{
  /// The place of the first prop that is blended (vtkNBufferCandidate::IsBlended()), of the first
  /// one with such a part, and of the first one that may draw lines. VTK_INT_MAX if there is none.
  int FirstBlended = VTK_INT_MAX;
  int FirstBlendedPart = VTK_INT_MAX;
  int FirstLines = VTK_INT_MAX;
  ///@}

  /// Add the prop at place `i`. Props have to be added in the order of the list.
  void Add(int i, const vtkNBufferCandidate& candidate)
  {
    this->UntrackedDepth |= candidate.WritesDepth() && !candidate.IsTracked();
    this->UntrackedPicture |= !candidate.IsTracked();
    this->DepthOffset |= candidate.HasOffset();
    this->Translucent |= candidate.IsTranslucent();
    this->LackOfNormals |= candidate.MayLackNormals();
    this->FirstBlended = std::min(this->FirstBlended, candidate.IsBlended() ? i : VTK_INT_MAX);
    this->FirstLines = std::min(this->FirstLines, candidate.MayDrawLines() ? i : VTK_INT_MAX);
  }

  /// The place of the first prop that may be blended in the opaque stage, so that it and all props
  /// after it have to be drawn in their order, after all props before it. VTK_INT_MAX if there is
  /// none. `smoothLines` is that of vtkNBufferCompatibility::DrawingSettings.
  int GetFirstBlended(bool smoothLines) const
  {
    return std::min(
      { this->FirstBlended, this->FirstBlendedPart, smoothLines ? this->FirstLines : VTK_INT_MAX });
  }
};

VTK_ABI_NAMESPACE_END
#endif
