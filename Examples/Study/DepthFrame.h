// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFrame.h
 * @brief The input of all contenders of the study: a finished depth image and boxes.
 */
#ifndef DepthFrame_h
#define DepthFrame_h

#include "vtkNBufferProjection.h"

#include <vector>

namespace NBufferStudy
{

/// The box of a prop in view that may be culled and reaches neither the eye nor the near plane.
struct DepthBox
{
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen;
  bool Visible = false; ///< Whether the prop owns a pixel of the finished image.
  int Prop = 0;         ///< The place of the prop in the scene's list.
};

struct DepthFrame
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Depth; ///< Row 0 is at the bottom; larger depths are farther.
  vtkNBufferProjection Projection;
  std::vector<DepthBox> Boxes;
  ///@{
  /// The numbers of props that are not among the boxes.
  int Outside = 0;
  int Crossing = 0;
  int NotCandidates = 0;
  ///@}
};

} // namespace NBufferStudy

#endif
