// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contest.h
 * @brief Every contender on the same frames, taking turns, with what each keeps and what it costs.
 */
#ifndef Contest_h
#define Contest_h

#include "Contender.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferStudy
{

struct ContestResult
{
  std::string Name;
  ///@{
  /// Milliseconds of a frame, one for each frame and repetition, repetition by repetition.
  std::vector<double> BuildTimes;
  std::vector<double> QueryTimes;
  ///@}
  ///@{
  /// Over all frames.
  long long Boxes = 0;
  long long Hidden = 0;       ///< Boxes of props that own no pixel.
  long long FalseVisible = 0; ///< Those of them that are kept.
  long long FalseHidden = 0;  ///< Visible ones that are not: has to be 0.
  ContestCounts Counts;
  double Area = 0.0;        ///< Of all rectangles, pixels.
  double CoveredArea = 0.0; ///< What they are answered by; 0: has no meaning.
  ///@}
  std::size_t Texels = 0;
  std::size_t Memory = 0;

  double GetFalseVisibleShare() const
  {
    return this->Hidden > 0 ? static_cast<double>(this->FalseVisible) / this->Hidden : 0.0;
  }
  double GetOverCoverage() const
  {
    return this->CoveredArea > 0.0 ? this->CoveredArea / this->Area - 1.0 : 0.0;
  }
  /// Build and query of a frame.
  std::vector<double> GetTimes() const;
};

/// `progress` is called with the number of the turn and of all turns.
std::vector<ContestResult> RunContest(const std::vector<DepthFrame>& frames,
  const std::vector<ContenderPointer>& contenders, int repetitions,
  const std::function<void(int, int)>& progress);

} // namespace NBufferStudy

#endif
