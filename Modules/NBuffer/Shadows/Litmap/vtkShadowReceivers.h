// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowReceivers.h
 * @brief Fills a litmap and its tiles from a depth image. No OpenGL.
 *
 * A sample of the depth image is a receiver if both of these hold:
 *
 *  - Its depth is nearer than the background (vtkNBufferDepthConvention.h). Geometry so close to
 *    the far plane that its depth is rounded to that of the background counts as background.
 *  - The light may reach it, or VTK's shader may light it. A directional light reaches everything,
 *    a spot what lies in its cone (vtkShadowLight::GetConeCosine). A light space of a point light
 *    covers one face of a cube around the light, |p| <= 1 and |q| <= 1, a little widened; six light
 *    spaces cover all directions. Positional lights have receivers at s > 0 only.
 *
 * vtkShadowReceiverProjector.h derives where a receiver may lie, given the rounding errors of what
 * was drawn and stored. A receiver whose rays are not known is put into all lexels.
 *
 * A tile is divided into its two layers (vtkShadowTiles.h) halfway between its nearest and its
 * farthest sample that is not background, where distance is measured along the camera's axis.
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
 * Returns roughly the range of p, q and s of the receivers of a depth image. It looks at every
 * fourth row and column, or at all of them if these have no receiver. The range is empty if there
 * is no receiver at all. `depth` is as for Scatter().
 */
VTKNBUFFER_EXPORT vtkShadowBlock GetRange(const float* depth, const vtkShadowView& view,
  const vtkShadowLight& light, const vtkShadowLightSpace& space);

/**
 * Fills `litmap` and its tiles with the receivers of a depth image, in the coordinates of `space`
 * and over the range of GetRange(). Returns the number of receivers. The caller calls
 * vtkShadowLitmap::Build() afterwards. `resolution` is as for vtkShadowLitmap::Begin().
 *
 * `depth` holds window depths in [0, 1]: one image of view.Width x view.Height for each of
 * view.Samples, one after the other, each with row 0 at the bottom.
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
