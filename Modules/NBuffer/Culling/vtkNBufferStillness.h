// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferStillness
 * @brief Whether a frame of a view draws the same as the last one, so that the verdicts of the last
 * one are still valid.
 *
 * It does unless the list of props, a prop, the view, or a setting has changed. If a frame does not
 * begin by erasing color and depth, its depth also depends on what was drawn before, and it never
 * counts as the same. Neither does it where the depth of a prop may change without a newer time.
 *
 * In a parallel program this class compares the frames of one rank; vtkNBufferSharedDepth::Poll()
 * finds out about the other ranks. It also counts as a change if depth is shared in only one of the
 * two frames, or if ranks have exchanged depth since the last frame of this view that was not
 * frozen.
 */
#ifndef vtkNBufferStillness_h
#define vtkNBufferStillness_h

#include "vtkNBufferCompatibility.h"
#include "vtkNBufferDepthTest.h"
#include "vtkNBufferListTraits.h"

#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

class vtkNBufferStillness
{
public:
  /// Begin a frame. Returns whether nothing has changed since the last one. `changed`: whether the
  /// view, the list of props, or a prop has changed. `frozen`: whether the verdicts are used in
  /// spite of that (vtkNBufferCuller::SetFreeze()).
  bool BeginFrame(vtkRenderer* renderer, const vtkNBufferSettings& settings,
    const vtkNBufferListTraits& traits, bool changed, bool frozen);

  /// What BeginFrame() has returned.
  bool IsSame() const { return this->Same; }

  /// How the renderer draws in this frame.
  const vtkNBufferCompatibility::DrawingSettings& GetDrawing() const { return this->Drawing; }

  /// vtkNBufferListTraits::GetFirstBlended() for this frame.
  int GetFirstBlended() const { return this->FirstBlended; }

private:
  vtkNBufferCompatibility::DrawingSettings Drawing;
  int FirstBlended = VTK_INT_MAX;
  bool Same = false;
  bool TestSlivers = false;
  bool IsShared = false;
  /// vtkNBufferSharedDepth::GetFrameTime() of the last shared frame that was not frozen.
  vtkMTimeType SharedTime = 0;
  bool ErasesDepth = false;
  /// Whether anything has changed since the last frame that was not frozen.
  bool ChangedWhileFrozen = false;
};

VTK_ABI_NAMESPACE_END
#endif
