// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowReceivers.h
 * @brief From a depth image to a litmap and its tiles. No OpenGL.
 *
 * A sample of the depth image is a receiver if both of these hold:
 *
 *  - Its depth is nearer than the background (vtkNBufferDepthConvention.h). Geometry so close to
 *    the far plane that its depth is rounded to that of the background counts as background.
 *  - The light can reach it, or VTK's shader may take it to be reached. A directional light reaches
 *    everything, a spot what lies in its cone (vtkShadowLight::GetConeCosine). For a point light,
 *    the light space takes in one face of a cube around the light, |p| <= 1 and |q| <= 1, a little
 *    widened: six light spaces make up all directions. Positional lights have receivers at s > 0
 *    only.
 *
 * vtkShadowReceiverProjector.h derives where a receiver may lie, given the rounding of what was
 * drawn and stored. A receiver whose rays are not known is put into all lexels.
 *
 * The layers of a tile (vtkShadowTiles.h) are divided halfway, in distances from the eye, between
 * the tile's nearest and farthest receiver.
 */
#ifndef vtkShadowReceivers_h
#define vtkShadowReceivers_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"
#include "vtkShadowReceiverProjector.h"

VTK_ABI_NAMESPACE_BEGIN

namespace vtkShadowReceivers
{
/**
 * Roughly the range of p, q and s that the receivers of a depth image take up. It is measured at
 * every fourth row and column, or from all of them if these have no receiver. If there is no
 * receiver at all it is empty.
 */
VTKNBUFFER_EXPORT vtkShadowBlock GetRange(const float* depth, const vtkShadowView& view,
  const vtkShadowLight& light, const vtkShadowLightSpace& space);

/**
 * Fills `litmap` and its tiles with the receivers of a depth image as `space` sees them, over
 * GetRange(), and returns their number. The caller calls vtkShadowLitmap::Build() afterwards.
 *
 * `depth` holds window depths in [0, 1], one image of Width x Height for each sample of a pixel,
 * with row 0 at the bottom.
 *
 * The cost is linear in the number of samples and is shared by the threads of vtkSMPTools. The
 * litmap is the same with any number of threads.
 */
VTKNBUFFER_EXPORT vtkIdType Scatter(const float* depth, const vtkShadowView& view,
  const vtkShadowLight& light, const vtkShadowLightSpace& space, int resolution,
  vtkShadowLitmap& litmap);
}

VTK_ABI_NAMESPACE_END
#endif
