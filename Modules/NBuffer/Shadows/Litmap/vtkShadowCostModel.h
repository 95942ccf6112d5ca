// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCostModel.h
 * @brief Estimates the cost of whole volumes, and whether litmaps save more than they cost. No
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
 * `samples` are all samples of the viewport, `covered` those that are not background. The latter
 * are known only after the depth was read. If the decision depends on them, the number that was
 * found last is used (vtkShadowMaskMaker::EstimateCovered).
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
 * the host's work in both columns (lexels, samples, and 40 ns of a triangle). The costs of devices
 * are assumptions that no measurement supports. A wrong one costs time, but changes no shadow.
 */
#ifndef vtkShadowCostModel_h
#define vtkShadowCostModel_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkShadowCostModel
{
/// Estimates the number of triangles of a caster's whole volume before it is made. `positional` is
/// true for spot and point lights.
VTKNBUFFER_EXPORT long long CountTriangles(const vtkShadowSilhouette& silhouette, bool positional);

/**
 * Estimates the number of fragments of a volume's draws into the whole viewport: the area of their
 * triangles in the view, in pixels. If there are more than 4096 triangles, it measures 4096 of
 * them, spread evenly.
 */
VTKNBUFFER_EXPORT double EstimateFragments(const vtkShadowVolume& volume,
  const std::vector<vtkShadowDraw>& draws, const vtkShadowDrawList::View& view);

/**
 * Returns true if the rule above says that litmaps are worth their cost. `fragments` and
 * `triangles` are those of all whole volumes of the light, `lexels` is the number of lexels of a
 * litmap, and `faces` the number of litmaps of the light, 1 or 6.
 */
VTKNBUFFER_EXPORT bool IsLitmapWorthIt(double fragments, long long triangles, long long samples,
  long long covered, long long lexels, int faces, bool softwareRenderer);
}

VTK_ABI_NAMESPACE_END
#endif
