// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsCheck.h
 * @brief Checks what has to be true of the statistics of every frame.
 */
#ifndef StatisticsCheck_h
#define StatisticsCheck_h

#include "vtkNBufferStatistics.h"
#include "vtkShadowStatistics.h"

#include <string>

/// @name Conditions
/// Return the conditions that the statistics violate, one a line, and the statistics as JSON; "" if
/// there are none.
///@{
/// `maximumNumberOfRounds` is that of the culler's tuning. If `mayReadPixels` is true, the culler
/// may have compared single pixels, which count as lookups.
std::string FindInconsistency(
  const vtkNBufferStatistics& statistics, int maximumNumberOfRounds, bool mayReadPixels);
std::string FindInconsistency(const vtkShadowStatistics& statistics);
///@}

#endif
