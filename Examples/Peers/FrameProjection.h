// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FrameProjection.h
 * @brief The projection of a renderer's frame into the depth buffer that is being drawn.
 */
#ifndef FrameProjection_h
#define FrameProjection_h

#include "vtkNBufferCamera.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferProjection.h"

namespace NBufferPeers
{

inline void SetFrameProjection(
  vtkRenderer* renderer, const vtkNBufferDepthSource& source, vtkNBufferProjection& projection)
{
  const int* viewport = source.Viewport;
  projection.Set(vtkNBufferGLM::ToRows(vtkNBufferCamera(renderer).WorldToClip).data(), viewport[2],
    viewport[3], vtkNBufferDepthFormat::FromQuantum(source.GetStep()),
    glm::ivec2(viewport[0], viewport[1]));
}

} // namespace NBufferPeers

#endif
