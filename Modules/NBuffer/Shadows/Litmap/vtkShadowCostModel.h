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
 * Each `cost` is that of its term. `samples` are all samples of the viewport, `covered` those that
 * are not background. The number of the latter is known only after the depth was read. If the
 * decision depends on it, the number of an earlier frame may be used
 * (vtkShadowMaskMaker::EstimateCovered).
 *
 * The costs are measured once for each pass and context (vtkShadowCostMeasurement.h). Those of
 * llvmpipe on two cores, which stand in Costs, only tell when this is worth while. A wrong cost
 * costs time, but changes no shadow.
 */
#ifndef vtkShadowCostModel_h
#define vtkShadowCostModel_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkShadowCostModel
{
/// What is drawn of whole volumes.
struct Volumes
{
  double Fragments = 0.0;
  long long Triangles = 0;
};

/// What the litmaps of a light are made of.
struct Litmaps
{
  long long Samples = 0; ///< All samples of the viewport.
  long long Covered = 0; ///< Those that are not background.
  long long Lexels = 0;  ///< Of one litmap.
  int Faces = 1;         ///< The number of litmaps, 1 or 6.
};

/// The costs of the terms above, in nanoseconds.
struct Costs
{
  /// Returns true if the costs are not measured yet, and whole volumes are estimated to take at
  /// least a millisecond: a smaller estimate says little, and nothing depends on it.
  bool IsMeasurementDue(double wholeEstimate) const
  {
    return !this->AreMeasured && wholeEstimate >= 1.0;
  }

  double Fragment = 5.0;   ///< A fragment of a volume.
  double Triangle = 250.0; ///< A triangle of a volume.
  double Sample = 5.0;     ///< A sample whose depth is read.
  double Lexel = 75.0;     ///< A lexel, for each face.
  double Covered = 26.0;   ///< A covered sample, for each face.
  bool AreMeasured = false;

  ///@{
  /// Estimates how long the calling thread and the device take, in milliseconds.
  VTKNBUFFER_EXPORT double Estimate(const Volumes& volumes) const;
  VTKNBUFFER_EXPORT double Estimate(const Litmaps& litmaps) const;
  ///@}

  /**
   * Sets the costs of volumes from the times of drawing them: `time` into the viewport, and
   * `pixelTime` into one pixel of it, which tells the cost of triangles. All times are in
   * milliseconds. The difference of the two times says little if there are few fragments. If there
   * are fewer than 1/16 of the samples of the viewport, the cost of a fragment is assumed to change
   * by the same factor as that of a triangle.
   */
  VTKNBUFFER_EXPORT void SetFromVolumes(
    const Volumes& volumes, long long samples, double time, double pixelTime);

  /**
   * Sets the other costs from the times of reading the depth, of making litmaps from it, and of
   * making them from a depth without receivers, which tells the cost of lexels. If less than 1/16
   * of the samples is covered, the cost of a covered sample is assumed to change by the same factor
   * as that of a lexel.
   */
  VTKNBUFFER_EXPORT void SetFromLitmaps(
    const Litmaps& litmaps, double readTime, double time, double emptyTime);
};

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

/// Returns true if the rule above says that litmaps are worth their cost. Both are times of
/// Costs::Estimate().
VTKNBUFFER_EXPORT bool IsLitmapWorthIt(double whole, double litmap);
}

VTK_ABI_NAMESPACE_END
#endif
