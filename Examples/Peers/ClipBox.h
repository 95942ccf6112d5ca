// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClipBox.h
 * @brief A bounding box as an occlusion query draws it: never smaller or farther than the prop.
 *
 * A query answers for the samples of the box that it draws. The prop is drawn by other triangles
 * with other rounding: a flat prop fills its box, and the depths of both differ in the last bits.
 * The box is therefore
 *
 *  - wider by a pad in the world that moves its outline on the screen by twice the prop's slack
 *    (vtkNBufferProjection.h) and an eighth of a pixel in every direction. The pad is parallel to
 *    the image plane, so that whatever is behind a point of the padded outline is also behind the
 *    point from which it was moved;
 *  - nearer in window depth by twice the difference between the nearest corner and
 *    vtkNBufferScreenBox::Nearest: once for the prop, and once for the box, which is drawn too.
 *
 * With GL_LEQUAL, whenever a sample of the prop passes the depth test, a sample of the box passes,
 * too. A box that reaches the near plane or the eye gets no query: the device would cut it open.
 */
#ifndef ClipBox_h
#define ClipBox_h

#include "vtkNBufferProjection.h"

namespace NBufferPeers
{

struct ClipBox
{
  /// The corners in clip coordinates. Bits 0, 1 and 2 of a corner's number say whether its x, y and
  /// z are the high ones.
  float Corners[8][4];
};

/// Makes the box of a query. Returns false if the padded box may reach the near plane or the eye;
/// it counts as visible then. `screen` is the result of Project() for the box, which must be
/// Inside.
bool MakeClipBox(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, ClipBox& result);

} // namespace NBufferPeers

#endif
