// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClipBox.h
 * @brief A bounding box as an occlusion query draws it: never smaller or farther than the prop.
 *
 * A query answers for the samples of the box that it draws, a prop is drawn by other triangles with
 * other rounding: a flat prop fills its box, and the depths of both differ in the last bits. The
 * box is therefore
 *
 *  - wider by a pad in the world that moves its outline on the screen by twice the prop's slack
 *    (vtkNBufferProjection.h) and an eighth of a pixel in every direction: along the image plane,
 * so that what is behind a point of the padded outline is behind the point that it comes from;
 *  - nearer in window depth by twice the difference between the nearest corner and
 *    vtkNBufferScreenBox::Nearest: once for the prop, once for the box, which is drawn too.
 *
 * With GL_LEQUAL a sample of the prop that passes the depth test then has a sample of the box that
 * does. What reaches the near plane or the eye cannot be queried: the device would cut it open.
 */
#ifndef ClipBox_h
#define ClipBox_h

#include "vtkNBufferProjection.h"

namespace NBufferPeers
{

struct ClipBox
{
  /// Corner i: low or high x, y, z by bits 0, 1, 2 of i.
  float Corners[8][4];
};

/// False for what may reach the near plane or the eye, padded: it counts as visible. `screen` is
/// what Project() made of the box, which must be Inside.
bool MakeClipBox(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, ClipBox& result);

} // namespace NBufferPeers

#endif
