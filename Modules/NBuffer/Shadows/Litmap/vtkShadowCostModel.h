// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCostModel.h
 * @brief What drawing whole volumes costs, and whether litmaps would save more than they cost. No
 * OpenGL.
 *
 * Litmaps leave out at least about two thirds of what is drawn (nbuffer-bench shadow, scene simple,
 * 20 casters: 73 % of the fragments, commit e218509), and more where there are many casters. They
 * cost the read-back of the receivers' depth, the lexels and their levels, and the projection of
 * each sample that is not background; the last two six times for a point light. So a litmap is
 * worth it if
 *
 *     2/3 (fragments * cost + triangles * cost)
 *       >  samples * cost + faces * (lexels * cost + covered * cost)
 *
 * How many samples are not background is known only after the depth was read. Where it matters, the
 * number that was found last is used (vtkShadowMaskMaker::EstimateCovered).
 *
 * Costs in nanoseconds:
 *
 *     |                                       | software renderers | devices |
 *     | a fragment in the stencil             |         5          |   0.05  |
 *     | a triangle, made and drawn            |       250          |    45   |
 *     | a sample, read                        |         5          |     5   |
 *     | a lexel, for each face                |        75          |    75   |
 *     | a sample with depth, for each face    |        26          |    26   |
 *
 * The left column was fitted to llvmpipe on two cores (commits cf31101 and e218509), and so was
 * what the host does (lexels, samples, and 40 of a triangle). The costs of devices are assumed, no
 * measurement stands behind them. A wrong guess costs time, never a shadow.
 */
#ifndef vtkShadowCostModel_h
#define vtkShadowCostModel_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowSilhouette;
class vtkShadowVolume;

namespace vtkShadowCostModel
{
/// Estimates the number of triangles of a caster's whole volume before it is made.
VTKNBUFFER_EXPORT long long CountTriangles(const vtkShadowSilhouette& silhouette, bool positional);

/**
 * Estimates the fragments of a volume: the area of its triangles in the view, in pixels. Of more
 * than 4096 triangles 4096 are looked at, spread evenly. `volumeToClip` goes from vertices to clip
 * coordinates, `width` and `height` are the pixels of the viewport.
 */
VTKNBUFFER_EXPORT double EstimateFragments(
  const vtkShadowVolume& volume, const glm::dmat4& volumeToClip, int width, int height);

/**
 * The rule above. `samples` is the number of samples of the receivers' depth, `covered` the number
 * of those that are not background, `lexels` the number of lexels of a litmap, and `faces` the
 * number of litmaps of the light, 1 or 6.
 */
VTKNBUFFER_EXPORT bool IsLitmapWorthIt(double fragments, long long triangles, long long samples,
  long long covered, long long lexels, int faces, bool softwareRenderer);
}

VTK_ABI_NAMESPACE_END
#endif
