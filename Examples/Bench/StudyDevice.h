// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyDevice.h
 * @brief What runs on the graphics device, by size of the image: drawing, reading depth back,
 * building all levels or one, and reading those back.
 *
 *     []             width, height; draw_ms, draw_device_ms: the frame, with VTK's default culler;
 *                    read_ms: all depth to the host; rows[]
 *     []..rows[]     name; factor; levels; texels: of all of them; build_ms: until it is finished;
 *                    device_ms: by a timer query, absent without one; read_ms: the levels to the
 *                    host, absent on the host; skipped: why it does not run here, instead of times
 *
 * Each time is median, p10 and p90. Rows "module" begin with the depth buffer as it is, "pass",
 * "passes" and "compute" (SingleLevel.h) with a texture of it.
 */
#ifndef StudyDevice_h
#define StudyDevice_h

#include "CameraPath.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>

namespace NBufferBench
{

/// Leaves the window at another size. `mostPixels`: larger images are left out.
Json::Value MeasureDevice(Session& session, const NBufferExamples::CameraPose& pose,
  int repetitions, int mostPixels, const std::function<void(const std::string&)>& progress);

} // namespace NBufferBench

#endif
