// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCostModel.h
 * @brief Estimates the cost of whole volumes, and whether litmaps save more than they cost. No
 * OpenGL.
 *
 * Litmaps leave out at least about two thirds of what is drawn (nbuffer-bench shadow, scene simple,
 * 20 casters: 73 % of the fragments, commit e218509), and more where there are many casters. Three
 * things cost time: to read the depth of the receivers back; to clear the lexels and build their
 * levels; and to project each sample that is not background. The last two are done six times for a
 * point light. So litmaps are worth their cost if
 *
 *     2/3 (fragments * cost + triangles * cost)
 *       >  samples * cost + faces * (lexels * cost + covered * cost)
 *
 * Each `cost` is the one that the table below has for this term. `samples` are all samples of the
 * viewport, `covered` those that are not background. The number of the latter is known only after
 * the depth was read. If the decision depends on it, the number of an earlier frame may be used
 * (vtkShadowMaskMaker::EstimateCovered).
 *
 * Costs in nanoseconds, fitted to llvmpipe on two cores (commits cf31101 and e218509):
 *
 *     |  5   | a fragment in the stencil          |
 *     |  250 | a triangle, made (40) and drawn    |
 *     |  5   | a sample, read                     |
 *     |  75  | a lexel, for each face             |
 *     |  26  | a sample with depth, for each face |
 *
 * These numbers say how the terms compare with each other. How much time they stand for on a device
 * is measured once for each pass and context (vtkShadowCostTrials.h): each side of the rule is
 * multiplied by the ratio of a measured time to its estimate. A wrong cost costs time, but changes
 * no shadow.
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

/// Estimates the milliseconds of drawing all whole volumes of a light.
VTKNBUFFER_EXPORT double EstimateWhole(double fragments, long long triangles);

/// Estimates the milliseconds of making the litmaps of a light. `lexels` is the number of lexels of
/// a litmap, and `faces` the number of litmaps of the light, 1 or 6.
VTKNBUFFER_EXPORT double EstimateLitmap(
  long long samples, long long covered, long long lexels, int faces);

/// Returns true if the rule above says that litmaps are worth their cost.
VTKNBUFFER_EXPORT bool IsLitmapWorthIt(double whole, double litmap);
}

VTK_ABI_NAMESPACE_END
#endif
