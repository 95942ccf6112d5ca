// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyFormats.h
 * @brief What the format of depth costs, by the ratio of far to near plane.
 *
 *     ratio, format                        see DepthFormats.h
 *     false_visible_percent, false_hidden  of full-resolution squares, boxes in 8 pieces
 *     slack                                median and p90 over the boxes, units of the scene
 *     total_ms                             of that structure
 */
#ifndef StudyFormats_h
#define StudyFormats_h

#include "DepthFrame.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>

namespace NBufferBench
{

/// The planes of `frame` are at `near` and `far`, of which the ratio is the first one measured.
Json::Value MeasureFormats(const NBufferStudy::DepthFrame& frame, double near, double far,
  int repetitions, const std::function<void(const std::string&)>& progress);

void WriteFormatsChart(
  const Json::Value& entries, const std::string& title, const std::string& fileStem);

} // namespace NBufferBench

#endif
