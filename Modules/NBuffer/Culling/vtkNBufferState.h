// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferState.h
 * @brief What a view knows of a prop in one frame.
 */
#ifndef vtkNBufferState_h
#define vtkNBufferState_h

#include "vtkNBufferProjection.h"
#include "vtkNBufferStatistics.h"

VTK_ABI_NAMESPACE_BEGIN

/// The state of one prop. It is kept apart from the caches and small, because every frame walks the
/// states of all props several times.
struct vtkNBufferState
{
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Crossing;

  /// Whether the last depth test that included the prop found it visible.
  bool WasVisible = false;

  /// Whether a depth test has included the prop since it was outside the frustum the last time.
  bool WasTested = false;

  /// Whether the prop is Inside, but its rectangle has not been computed in this frame yet.
  bool RectangleIsStale = false;

  /// Whether the rectangle is stale and the prop lies below a node of the hierarchy that this
  /// frame's depth test has hidden.
  bool Behind = false;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferState.h
