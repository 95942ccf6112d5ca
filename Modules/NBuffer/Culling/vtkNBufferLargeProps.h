// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferLargeProps.h
 * @brief Which props are large enough to be drawn unit by unit, and can be.
 */
#ifndef vtkNBufferLargeProps_h
#define vtkNBufferLargeProps_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidate;
class vtkProp;

namespace vtkNBufferLargeProps
{
/// Whether a prop is a plain actor with at least `minimum` cells in its surface, polygons in all of
/// its instances together, or splats.
bool IsLarge(vtkProp* prop, int minimum);

/// Whether a prop that is large may be drawn unit by unit.
bool MayBeDivided(const vtkNBufferCandidate& candidate);
}

VTK_ABI_NAMESPACE_END
#endif
