// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Chart.h
 * @brief A chart of the frame times of a walk.
 */
#ifndef Chart_h
#define Chart_h

#include "Walk.h"

#include <string>

namespace NBufferBench
{

/// Write `fileStem`.png and `fileStem`.svg: milliseconds by frame, logarithmic, one line a mode.
void WriteChart(const WalkResult& result, const std::string& title, const std::string& fileStem);

} // namespace NBufferBench

#endif
