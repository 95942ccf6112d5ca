// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CameraPath.h
 * @brief Where the camera is in every frame of a walk.
 *
 * ## Camera files
 *
 * Text, one frame per line, numbers separated by spaces:
 *
 *     eye x y z   target x y z   up x y z   [view angle in degrees   [near far]]
 *
 * The view angle is 30 where it is missing; near and far are fitted to the scene. Empty lines and
 * what follows a # are skipped.
 */
#ifndef CameraPath_h
#define CameraPath_h

#include "CameraPose.h"

#include <cstdint>
#include <string>

class vtkRenderer;

namespace NBufferExamples
{
struct Scene;

/// Set up the active camera. `bounds` is that of the scene, for near and far.
void ApplyPose(const CameraPose& pose, const double bounds[6], vtkRenderer* renderer);

/**
 * Make a path of `frames` frames. The same scene, name, frames and seed give the same path.
 *
 *     street    along the streets of a city at 1.7 m, 0.5 m per frame, looking ahead
 *     rooftop   the same way at 25 m, 1 m per frame, looking a little down
 *     drone     straight over a city at 120 m, 2 m per frame, looking down obliquely
 *     cuts      in every frame another eye point, in a city at 1.7 m in a street, elsewhere around
 *               the scene, and another direction
 *     orbit     once around the scene, looking at its centre
 *     inside, around, walk, between ...   those that the scene has of its own (Scene::Paths)
 *     a file    a camera file; with `frames` 0 all of it, else its first frames
 *
 * Throws std::runtime_error for a path that the scene does not have.
 */
CameraPath MakePath(const Scene& scene, const std::string& name, int frames, std::uint64_t seed);

/// Throws std::runtime_error that names the file and line.
CameraPath ReadCameraFile(const std::string& fileName);
void WriteCameraFile(const CameraPath& path, const std::string& fileName);

} // namespace NBufferExamples

#endif
