// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCullingPolicy.h
 * @brief Whether a frame in which props could be held back is worth a test against depth. No
 * OpenGL, no renderer.
 */
#ifndef vtkNBufferCullingPolicy_h
#define vtkNBufferCullingPolicy_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferStatistics.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferBackOff;

/**
 * How many props of a frame are of which kind, before any of them is drawn.
 */
struct vtkNBufferFrustumCounts
{
  int Candidates = 0;  ///< All opaque and translucent candidates, in the frustum or not.
  int Inside = 0;      ///< Opaque candidates that reach into the frustum.
  int Kept = 0;        ///< Those of Inside that can be tested and that the last test found visible.
  int HeldBack = 0;    ///< Those of Inside that can be tested and that are not Kept.
  int Translucent = 0; ///< Translucent candidates that can be tested.
  bool Blending = false; ///< A prop blends in the opaque stage, so that the order of drawing shows.
};

namespace vtkNBufferCullingPolicy
{
/**
 * Choose what to do with a frame. The result is vtkNBufferDecision::Culled if the frame is to be
 * tested, otherwise the reason why not. If it is Culled and no prop is held back, there are kept
 * props, and the caller has to hold back one of them, so that there is a test.
 *
 * `backOff` counts the frame. With nullptr every frame is tested that can be.
 */
VTKNBUFFER_EXPORT vtkNBufferDecision ChooseDecision(
  const vtkNBufferFrustumCounts& counts, int minimumNumberOfCandidates, vtkNBufferBackOff* backOff);
}

VTK_ABI_NAMESPACE_END
#endif
