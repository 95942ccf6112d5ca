// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxOutline.h
 * @brief The number of depth tests that the hardware does for a box: the pixels of its outline.
 */
#ifndef BoxOutline_h
#define BoxOutline_h

#include "vtkNBufferProjection.h"

namespace NBufferStudy
{

/// Returns the number of pixels whose centres lie in the outline of a box that is Inside, which is
/// the number of pixels of its front faces. For a box that was clipped it is that of its rectangle.
long long CountOutlinePixels(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen);

} // namespace NBufferStudy

#endif
