// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Report.h
 * @brief The figures of a walk as JSON and as a table.
 *
 *     renderer, window, vtk   GL_RENDERER, class of the window, version of VTK
 *     scene, path, size, samples, frames, seed, props, block
 *     modes.NAME              median_ms, p10_ms, p90_ms, drawn (median), frames_ms (each),
 *                             differing_bytes and differing_frames when verified
 *     modes.nbuffer           also backend and statistics: the members of vtkNBufferStatistics,
 *                             each the median over all frames; decisions: frames by decision;
 *                             when_tested: medians over the frames with a test alone, per stage
 *     modes.NAME.queries      of modes that ask the hardware, medians (see QueryStatistics):
 *                             in_view, queries, waits, wait_ms, nodes, visits, drawn, hidden,
 *                             redrawn
 *     ratios.A/B              median over the frames of (ms of mode A) / (ms of mode B)
 *     verified_frames         frames compared with mode none byte for byte
 *     differing_bytes         see GetDifferingBytes
 */
#ifndef Report_h
#define Report_h

#include "Walk.h"

#include "vtk_jsoncpp.h"

#include <ostream>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Of sorted or unsorted values, linear between neighbours; share in [0, 1]. 0 for no values.
double GetQuantile(std::vector<double> values, double share);

/// Numbers as they are read, not to seventeen digits.
Json::Value Round(double value);

/// Throws std::runtime_error if the text is no JSON.
Json::Value Parse(const std::string& text);

/// Member by member the median over values of the same shape, at least one; of text the most
/// frequent.
Json::Value GetMedian(const std::vector<Json::Value>& values);

/// Median over the frames of (ms of mode a) / (ms of mode b).
double GetMedianRatio(const ModeResult& a, const ModeResult& b);

/// median_ms, p10_ms, p90_ms and frames_ms of a mode.
Json::Value SummarizeTimes(const ModeResult& mode);

/// modes, ratios, verified_frames, differing_bytes, frames and props of a walk.
Json::Value MakeReport(const WalkResult& result);

void PrintTable(const Json::Value& report, std::ostream& out);

/// Bytes for which the walk fails: of all modes but oracle, which only is a bound.
long long GetDifferingBytes(const WalkResult& result);

/// Throws std::runtime_error when the file cannot be written.
void WriteJSON(const Json::Value& value, const std::string& fileName);

} // namespace NBufferBench

#endif
