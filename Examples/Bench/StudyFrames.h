// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyFrames.h
 * @brief The true depth image of each frame of a path, the boxes in it, and which of them are seen.
 */
#ifndef StudyFrames_h
#define StudyFrames_h

#include "CameraPath.h"
#include "Session.h"

#include "DepthFrame.h"

#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProp;
struct vtkNBufferDepthSource;

namespace NBufferBench
{

/// Everything in view is drawn. Leaves the renderer without cullers.
std::vector<NBufferStudy::DepthFrame> CollectFrames(Session& session,
  const NBufferExamples::CameraPath& path, const std::function<void(std::size_t)>& progress);

/// Of all props that may be culled, in view or not.
std::vector<vtkNBufferBox> CollectBoxes(Session& session);

/// Renders a frame; `function` gets the window and the source of its depth while its framebuffer is
/// bound. Throws std::runtime_error where depth cannot be read.
void RenderAndInspect(Session& session, const NBufferExamples::CameraPose& pose,
  const std::function<void(vtkOpenGLRenderWindow*, const vtkNBufferDepthSource&)>& function);

struct DeviceBuild
{
  int Width = 0;
  int Height = 0;
  int Levels = 0;
  /// Milliseconds of all levels by OpenGL until they are finished, one for each repetition.
  std::vector<double> Milliseconds;
  /// The depth that they were built from.
  std::vector<float> Depth;
};

/// Levels by OpenGL of the depth of a frame in a window of this size.
DeviceBuild MeasureDeviceBuild(Session& session, const NBufferExamples::CameraPose& pose, int width,
  int height, int factor, int repetitions);

} // namespace NBufferBench

#endif
