// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyFragments.h
 * @brief Fragments that the draws of a frame leave in the framebuffer, and how many are wasted.
 *
 * Counted are samples that pass the depth test when their prop is drawn (GL_SAMPLES_PASSED around
 * each draw of a prop, in the order and as often as the mode draws them, the least of three counts;
 * boxes of queries apart). A pixel shows one of them: *wasted* are all others, those that a later
 * draw covers and those that a prop drawn again leaves once more.
 *
 *     MODE    passed: fragments a frame; shown: pixels with a prop; wasted: passed - shown;
 *             of_hidden: passed by props that own no pixel; again: by draws of a prop that has
 *             been drawn; draws. Means over the frames.
 */
#ifndef StudyFragments_h
#define StudyFragments_h

#include "CameraPath.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Why fragments cannot be told by prop; empty if they can: draws are told by events of the
/// mappers, which props must not share.
std::string GetFragmentsObstacle(vtkRenderer* renderer);

/// Of `frames` frames spread over the path, each after the one before it on the path. Throws
/// std::runtime_error where there is an obstacle.
Json::Value MeasureFragments(Session& session, const NBufferExamples::CameraPath& path,
  const std::vector<std::string>& modes, int frames,
  const std::function<void(const std::string&)>& progress);

} // namespace NBufferBench

#endif
