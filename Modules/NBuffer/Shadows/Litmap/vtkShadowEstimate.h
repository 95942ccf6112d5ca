// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowEstimate
 * @brief How much is drawn of the whole volumes of a light, kept for some frames. No OpenGL.
 *
 * To count triangles and to measure fragments (vtkShadowCostModel.h) takes 1 to 4 ms where there
 * are thousands of casters, and both change little from frame to frame.
 */
#ifndef vtkShadowEstimate_h
#define vtkShadowEstimate_h

#include "vtkShadowCostModel.h"
#include "vtkShadowPlan.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// How many samples of the viewport were not background. Only reading the depth back tells this
/// number, which takes long. What a litmap is likely to cost (vtkShadowCostModel.h) depends on it,
/// but changes little from frame to frame.
struct vtkShadowCoverage
{
  /// The number of frames for which what was estimated is used again.
  static constexpr int Frames = 30;

  /// Returns true if the number is known for so many samples, and not too old.
  bool IsKnown(std::size_t samples) const { return this->Samples == samples && this->Age < Frames; }

  std::size_t Covered = 0;
  std::size_t Samples = 0; ///< The number of samples then.
  int Age = 0;             ///< The number of frames since then.
};

class vtkShadowEstimate
{
public:
  /**
   * Begins a frame with these parts of casters and so many samples in the viewport. Returns true if
   * the last estimate is used again. Otherwise makes one from the number of triangles alone.
   * `coneReach` is vtkShadowPlan::View::ConeReach.
   */
  bool BeginFrame(const std::vector<const vtkShadowPart*>& parts, const vtkShadowLight& light,
    const vtkShadowConeReach& coneReach, std::size_t samples)
  {
    if (this->Parts == parts.size() && this->Samples == samples &&
      ++this->Age < vtkShadowCoverage::Frames)
    {
      return true;
    }
    *this = vtkShadowEstimate();
    this->Parts = parts.size();
    this->Samples = samples;
    const vtkShadowLitmapSet cone(light, {});
    for (const vtkShadowPart* part : parts)
    {
      if (!cone.IsBeyondReach(part->Footprint, coneReach))
      {
        this->Volumes.Triangles +=
          vtkShadowCostModel::CountTriangles(part->Silhouette, light.IsPositional());
      }
    }
    return false;
  }

  /// Makes an estimate from the triangles and fragments of a plan that draws all volumes whole.
  void Measure(
    const vtkShadowVolume& volume, const vtkShadowPlan& plan, const vtkShadowPlan::View& view)
  {
    this->Volumes = { vtkShadowCostModel::EstimateFragments(volume, plan.GetDraws(), view),
      plan.GetNumberOfTriangles() };
  }

  /// What is drawn, without fragments until they are measured.
  const vtkShadowCostModel::Volumes& GetVolumes() const { return this->Volumes; }

private:
  vtkShadowCostModel::Volumes Volumes;
  std::size_t Parts = 0;   ///< The number of parts of casters then.
  std::size_t Samples = 0; ///< The number of samples of the viewport then.
  int Age = 0;             ///< The number of frames since then.
};

VTK_ABI_NAMESPACE_END
#endif
