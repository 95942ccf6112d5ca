// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VerdictPicture.h
 * @brief A scene from above: what a view draws, what it culls, and what lies outside the view.
 */
#ifndef VerdictPicture_h
#define VerdictPicture_h

#include "CameraPath.h"
#include "Scene.h"
#include "Session.h"

#include "vtkImageData.h"
#include "vtkNBufferStatistics.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace NBufferBench
{

/// Returns how many nodes of the hierarchy were visited in a frame, for how many props, or an empty
/// text if no hierarchy was used.
std::string DescribeHierarchy(const vtkNBufferStatistics& statistics);

/**
 * Draws the picture from the verdicts of the scene's actors and the statistics of a frame that was
 * seen from `pose`. The actors keep the colours of this picture: drawn blue, culled red, outside
 * the view pale. `reach` is the distance from the eye that the picture shows.
 */
vtkSmartPointer<vtkImageData> MakeVerdictPicture(Session& session,
  const NBufferExamples::Scene& scene, const std::vector<vtkNBufferVerdict>& verdicts,
  const vtkNBufferStatistics& statistics, const NBufferExamples::CameraPose& pose, double reach);

} // namespace NBufferBench

#endif
