// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCostModel.h
 * @brief What drawing whole volumes takes, and whether litmaps would save more than they cost. No
 * OpenGL.
 *
 * Litmaps leave out at least about two thirds of what is drawn (nbuffer-bench shadow, scene simple,
 * 20 casters: 73 % of the fragments), more where there are many casters. They cost the read-back of
 * the receivers' depth, the lexels and their levels, and the projection of each sample that sees
 * something, the last two six times for a point light. So they pay if
 *
 *     2/3 (fragments * cost + triangles * cost)
 *       >  samples * cost + faces * (lexels * cost + seen * cost)
 *
 * How many samples see something only the depth itself says. Where it matters, the number that was
 * found last is taken (vtkShadowMaskMaker::CountSeen).
 *
 * Costs in nanoseconds:
 *
 *     |                            | software renderers | devices |
 *     | a fragment in the stencil  |         5          |   0.05  |
 *     | a triangle, made and drawn |       250          |    45   |
 *     | a sample, read             |         5          |     5   |
 *     | a lexel, for each face     |        75          |    75   |
 *     | one seen, for each face    |        26          |    26   |
 *
 * The left column was fitted to llvmpipe on two cores, and so was what the host does (lexels,
 * samples, and 40 of a triangle); what devices do is assumed, no measurement stands behind it. A
 * wrong guess costs time, never a shadow.
 */
#ifndef vtkShadowFill_h
#define vtkShadowFill_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkShadowSilhouette;
class vtkShadowVolume;

namespace vtkShadowCostModel
{
/// About the triangles of a caster's whole volume, before it is made.
VTKNBUFFER_EXPORT long long CountTriangles(const vtkShadowSilhouette& silhouette, bool positional);

/**
 * About the fragments of a volume: the area of its triangles in the view, in pixels. Taken from
 * 4096 of the triangles, spread evenly, if there are more. `volumeToClip`: row-major, from vertices
 * to clip coordinates. `width`, `height`: pixels of the viewport. About 0.2 us for a triangle.
 */
VTKNBUFFER_EXPORT double EstimateFragments(
  const vtkShadowVolume& volume, const double volumeToClip[16], int width, int height);

/// The rule above. `samples`: of the receivers' depth; `seen`: those that are not background.
/// `lexels`: of a litmap; `faces`: litmaps of the light, 1 or 6.
VTKNBUFFER_EXPORT bool IsLitmapWorthIt(double fragments, long long triangles, long long samples,
  long long seen, long long lexels, int faces, bool softwareRenderer);
}

VTK_ABI_NAMESPACE_END
#endif
