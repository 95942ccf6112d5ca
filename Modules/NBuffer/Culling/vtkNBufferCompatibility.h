// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferCompatibility.h
 * @brief When the culler must step aside: the one place that knows VTK's ways of drawing a frame.
 *
 * Holding props back is right only if the renderer draws its opaque props once, from its active
 * camera, into a framebuffer with depth, and nothing needs the props that the camera does not see.
 */
#ifndef vtkNBufferCompatibility_h
#define vtkNBufferCompatibility_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferStatistics.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

namespace vtkNBufferCompatibility
{
/// Why this frame of `renderer` cannot be culled; None if it can.
VTKNBUFFER_EXPORT vtkNBufferDecision WhyNot(vtkRenderer* renderer);

/// Whether the renderer changes the picture beyond what its props draw (FXAA, SSAO), also that of
/// layers below. It does so only if there is a prop left in its list, be it one that draws nothing.
VTKNBUFFER_EXPORT bool ProcessesImage(vtkRenderer* renderer);

/**
 * Whether a pass (vtkShadowVolumeClampPass) may draw the same opaque props twice, first the depth
 * alone, then everything: what is hidden in the first drawing is hidden in the second.
 */
VTKNBUFFER_EXPORT bool DrawsOpaquePropsTwice(vtkRenderer* renderer);

///@{
/// Blending in the opaque stage, where it shows what has been drawn below and in which order:
/// screen-space ambient occlusion takes positions and normals of what lies below from props that
/// have none of their own (unlit ones), smooth lines and points are mixed with it at their edges.
VTKNBUFFER_EXPORT bool HasAmbientOcclusion(vtkRenderer* renderer);
VTKNBUFFER_EXPORT bool SmoothesLines(vtkRenderer* renderer);
///@}
}

VTK_ABI_NAMESPACE_END
#endif
