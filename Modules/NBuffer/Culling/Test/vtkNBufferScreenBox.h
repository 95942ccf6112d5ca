// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferScreenBox.h
 * @brief Where a box lies on the screen. vtkNBufferProjection computes it. No OpenGL.
 */
#ifndef vtkNBufferScreenBox_h
#define vtkNBufferScreenBox_h

#include "vtkNBufferBox.h"
#include "vtkNBufferGLM.h"
#include "vtkNBufferMath.h"

VTK_ABI_NAMESPACE_BEGIN

/// Where a box is with respect to the view, see vtkNBufferProjection.h.
enum class vtkNBufferPlacement
{
  Outside,  ///< Nothing of it can be drawn.
  Crossing, ///< It reaches the near plane or the eye: its pixels are not known.
  Inside    ///< It has a vtkNBufferScreenBox.
};

/// What a box covers on the screen. It has a meaning only for boxes that are Inside.
struct vtkNBufferScreenBox
{
  /// The pixels of the viewport that the box may cover, (0, 0) the lower left one; never empty.
  vtkNBufferRectangle Pixels;
  /// The pixels whose middles the box may cover. Empty if the box lies between such middles.
  vtkNBufferRectangle Middles;
  ///@{
  /// Bounds of the depths of the box, as orders of distance: larger is farther. Nearest is less and
  /// Farthest is greater than the computed depths by the slack.
  double Nearest = 0.0;
  double Farthest = 1.0;
  ///@}
  /// The range R of the box's depths from which that slack was computed (vtkNBufferBoxError.h).
  double DepthRange = 1.0;
  /// How far a drawn point may be from its exact place along x, y and z, in normalised device
  /// coordinates.
  glm::dvec3 Slack = glm::dvec3(0.0);
  /// The border, in pixels, that is a part of Slack in x and y (vtkNBufferBoxError.h).
  double Border = 0.0;
  /// The largest clip coordinate w of the corners.
  double MaximumW = 0.0;
  /// Whether a corner may be before the near plane or behind the eye. In this case all members
  /// describe only the part of the box between the four sides of the view.
  bool Clipped = false;

  /// The pixels in which the box may own a sample, given how far a sample may be from the middle of
  /// its pixel in x and in y.
  const vtkNBufferRectangle& GetSampled(double sampleDistance) const
  {
    return sampleDistance > 0.0 ? this->Pixels : this->Middles;
  }
};

/// Where two boxes may have fragments of equal depth in one sample. There are none if
/// Screen.Pixels is empty.
struct vtkNBufferContact
{
  vtkNBufferBox Box;          ///< Contains the places of these fragments of the first box.
  vtkNBufferScreenBox Screen; ///< Where they are drawn.
};

VTK_ABI_NAMESPACE_END
#endif
