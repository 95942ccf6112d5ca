// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contest.h
 * @brief Runs all contenders by turns on the same frames, and measures what each keeps and costs.
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
  /// The milliseconds of each frame, repetition by repetition.
  std::vector<double> BuildTimes;
  std::vector<double> QueryTimes;
  ///@}
  ///@{
  /// The sums over all frames.
  long long Boxes = 0;
  long long Hidden = 0;       ///< Boxes whose props own no pixel.
  long long FalseVisible = 0; ///< Hidden boxes that the contender does not find hidden.
  long long FalseHidden = 0;  ///< Visible boxes that it finds hidden: this must be 0.
  ContestCounts Counts;
  double Area = 0.0;        ///< The area of all rectangles in pixels.
  double CoveredArea = 0.0; ///< The pixels that were tested for them; 0 if that has no meaning.
  ///@}
  std::size_t Texels = 0;
  std::size_t Memory = 0;

  double GetOverCoverage() const
  {
    return this->CoveredArea > 0.0 ? this->CoveredArea / this->Area - 1.0 : 0.0;
  }
  /// Returns the milliseconds of build and queries together.
  std::vector<double> GetTimes() const;
};

/// Runs the contest. `progress`, if given, is called with the number of the turn and of all turns.
std::vector<ContestResult> RunContest(const std::vector<DepthFrame>& frames,
  const std::vector<ContenderPointer>& contenders, int repetitions,
  const std::function<void(int, int)>& progress);

} // namespace NBufferStudy

#endif
