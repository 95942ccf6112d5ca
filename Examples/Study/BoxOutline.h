// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxOutline.h
 * @brief How many depth tests the hardware does for a box: the pixels of its outline.
 */
#ifndef BoxOutline_h
#define BoxOutline_h

#include "vtkNBufferProjection.h"

namespace NBufferStudy
{

/// Pixels whose centres lie in the outline of a box that is Inside, so many as its front faces
/// have; of a box that was clipped, those of its rectangle.
long long CountOutlinePixels(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen);

} // namespace NBufferStudy

#endif
