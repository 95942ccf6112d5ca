// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCoverage
 * @brief Remembers how many samples of the viewport were not background. No OpenGL.
 *
 * Only reading the depth back tells this number, which takes long. What a litmap is likely to cost
 * (vtkShadowCostModel.h) depends on it, but changes little from frame to frame.
 */
#ifndef vtkShadowCoverage_h
#define vtkShadowCoverage_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkNBufferDepthConvention.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowCoverage
{
public:
  /// The number of frames for which what was estimated is used again.
  static constexpr int Frames = 30;

  void BeginFrame() { ++this->Age; }

  /// Remembers that so many of these samples are covered.
  void Set(std::size_t covered, std::size_t samples)
  {
    this->Share = static_cast<double>(covered) / static_cast<double>(samples);
    this->Samples = samples;
    this->Age = 0;
  }

  /// Remembers how many of the samples with these depths are covered.
  void Count(const std::vector<float>& depths)
  {
    const auto covered =
      std::count_if(depths.begin(), depths.end(), vtkNBufferDepthConvention::IsDrawn);
    this->Set(static_cast<std::size_t>(covered), depths.size());
  }

  /// Returns true if the number is known for so many samples, and not too old.
  bool IsKnown(std::size_t samples) const { return this->Samples == samples && this->Age < Frames; }

  /// The number of covered samples among so many.
  long long Get(std::size_t samples) const
  {
    return std::llround(this->Share * static_cast<double>(samples));
  }

private:
  double Share = 1.0;      ///< The share of the samples that were covered, in [0, 1].
  std::size_t Samples = 0; ///< The number of samples then.
  int Age = 0;             ///< The number of frames since then.
};

VTK_ABI_NAMESPACE_END
#endif
