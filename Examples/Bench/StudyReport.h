// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyReport.h
 * @brief The figures of the study as JSON and CSV.
 *
 *     scenes[]           scene, path, size, frames, props, in_view, hidden, crossing, points[]
 *     points[]           name, group, is_default, pareto; false_visible_percent: of the hidden
 *                        props, those kept; false_hidden: has to be 0; over_covered_percent: pixels
 *                        looked at beyond the rectangles, -1 where that has no meaning; build_ms,
 *                        query_ms, total_ms of a frame, each median, p10 and p90; queries and
 *                        lookups of a frame; texels; bytes
 *     points[].loss_ms   median of total_ms, and kept props a frame times draw_us
 *     frames_by_mode, latent   of a scene, see StudyPeers.h; fragments: StudyFragments.h
 *     hierarchy[]        scene, path, entries[]: see StudyHierarchy.h
 *     formats            scene, path, entries[]: see StudyFormats.h; of a city alone
 *     scenes[].table  of maps, see StudyKnown.h
 *     shadows[]       see StudyShadows.h
 *     settings        see StudySettings.h
 *     left_out[]      scenes that were not there
 *     table1, table2, figure4   see StudyPaper.h
 *     device[]           see StudyDevice.h
 */
#ifndef StudyReport_h
#define StudyReport_h

#include "Contest.h"
#include "DepthFrame.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

/// median, p10 and p90.
Json::Value Summarize(const std::vector<double>& values);

/// pareto of every point: whether nothing is both faster and less in error.
void MarkPareto(Json::Value& points, const std::function<double(const Json::Value&)>& time,
  const std::function<double(const Json::Value&)>& error);

/// One scene of the report, but for its name, path and size.
Json::Value ReportContest(const std::vector<NBufferStudy::DepthFrame>& frames,
  const std::vector<NBufferStudy::ContestResult>& results);

/// loss_ms of every point: its median time, and what drawing the hidden props costs that it keeps.
void AddLosses(Json::Value& scene, double microsecondsPerProp);

/// Every point of every scene, one a line. Throws std::runtime_error when it cannot be written.
void WriteStudyCSV(const Json::Value& report, const std::string& fileName);

} // namespace NBufferBench

#endif
