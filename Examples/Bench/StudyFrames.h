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

/// Renders each pose with everything in view, and reads its depth. Leaves the renderer without
/// cullers.
std::vector<NBufferStudy::DepthFrame> CollectFrames(
  Session& session, const NBufferExamples::CameraPath& path);

/// Returns the boxes of all props that may be culled, in view or not.
std::vector<vtkNBufferBox> CollectBoxes(Session& session);

/// Renders a frame, and calls `function` with the window and the source of its depth while its
/// framebuffer is bound. Throws std::runtime_error where depth cannot be read.
void RenderAndInspect(Session& session, const NBufferExamples::CameraPose& pose,
  const std::function<void(vtkOpenGLRenderWindow*, const vtkNBufferDepthSource&)>& function);

/// Reads the depth of the whole viewport. Throws std::runtime_error if that is not possible.
void ReadDepth(
  vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source, std::vector<float>& depth);

} // namespace NBufferBench

#endif
