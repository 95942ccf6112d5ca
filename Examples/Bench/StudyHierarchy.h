// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyHierarchy.h
 * @brief Testing props one by one, and over a hierarchy, by their number.
 *
 *     props               boxes tested: those nearest to the eye, and beyond the scene's own number
 *                         copies of the scene side by side
 *     flat, tree          ms (median, p10, p90), tests: boxes projected, lookups, kept: props not
 *                         found outside or hidden; of the tree also nodes
 *     build_ms, refit_ms  of the tree
 *
 * Copies are tested and not drawn: those that the scene does not hide count as visible.
 */
#ifndef StudyHierarchy_h
#define StudyHierarchy_h

#include "DepthFrame.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

/// `boxes`: all props of the scene. One entry for each number up to `most`.
Json::Value MeasureHierarchy(const NBufferStudy::DepthFrame& frame,
  const std::vector<vtkNBufferBox>& boxes, const double eye[3], int most, int repetitions,
  const std::function<void(int)>& progress);

/// `fileStem`.png and .svg.
void WriteHierarchyChart(
  const Json::Value& entries, const std::string& title, const std::string& fileStem);

} // namespace NBufferBench

#endif
