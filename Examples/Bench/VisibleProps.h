// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibleProps.h
 * @brief Which props own a pixel, found by drawing every prop in a colour of its own.
 */
#ifndef VisibleProps_h
#define VisibleProps_h

#include "Session.h"

#include <functional>
#include <vector>

class vtkProp;

namespace NBufferBench
{

/**
 * For every pose the props that own at least one pixel (without multisampling), in the order of
 * the renderer's list. vtkHardwareSelector draws them by the mappers of the props themselves, so
 * that every pixel is covered as in the image.
 *
 * It leaves all shaders ready for selection, so that the next frame rebuilds them: to be called
 * before anything is timed, and something rendered in between.
 */
std::vector<std::vector<vtkProp*>> FindVisibleProps(Session& session,
  const NBufferExamples::CameraPath& path, const std::function<void(std::size_t)>& progress);

/// Of every pixel, row 0 at the bottom, the prop that owns it: its place in the renderer's list, or
/// -1. With the same consequences.
std::vector<int> FindPixelOwners(Session& session, const NBufferExamples::CameraPose& pose);

} // namespace NBufferBench

#endif
