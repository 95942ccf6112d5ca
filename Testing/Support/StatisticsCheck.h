// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsCheck.h
 * @brief What has to be true of the statistics of every frame.
 */
#ifndef StatisticsCheck_h
#define StatisticsCheck_h

#include "vtkNBufferStatistics.h"
#include "vtkShadowStatistics.h"

#include <string>

/// Empty, or what contradicts what. `maximumNumberOfRounds` is that of the culler;
/// `mayReadPixels`: the culler may have compared single pixels, whose lookups count, too.
std::string FindInconsistency(
  const vtkNBufferStatistics& statistics, int maximumNumberOfRounds, bool mayReadPixels);

/// Empty, or what is wrong: verdicts add up, and nothing is counted twice.
std::string FindInconsistency(const vtkShadowStatistics& statistics);

#endif
