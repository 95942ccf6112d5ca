// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyPaper.h
 * @brief Tables 1 and 2 and figure 4 of the paper (Decoret 2005), measured here.
 *
 *     table1[]    width, height, levels, cpu_ms, opengl_ms (median, p10, p90), paper_levels,
 *                 paper_ms
 *     table2      boxes, visible, and of a frame at 512 x 512: tests.oq, oq_hierarchy, nb,
 *                 nb_hierarchy (depth comparisons), nodes.oq and nodes.nb (boxes of the hierarchy
 *                 asked); paper.* the same four of the paper; false_hidden: visible props
 *                 that a hierarchy leaves out, has to be 0
 *     figure4[]   name, caption; mean_percent, median_percent and most_percent over all sizes;
 *                 area_percent: all that is covered too much by all that was asked for
 */
#ifndef StudyPaper_h
#define StudyPaper_h

#include "StudyFrames.h"

#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

namespace NBufferBench
{

/// Resizes the session's window. Images wider than `largest` are left out.
Json::Value MakeTable1(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int largest);

Json::Value MakeTable2(const std::vector<NBufferStudy::DepthFrame>& frames);

/// Rectangles up to size x size; pictures go to `folder`, side by side in figure-4.png.
Json::Value MakeFigure4(int size, const std::string& folder);

} // namespace NBufferBench

#endif
