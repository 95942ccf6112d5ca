// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CameraPath.h
 * @brief The camera in every frame of a walk.
 */
#ifndef CameraPath_h
#define CameraPath_h

#include "Scene.h"

#include <cstdint>
#include <string>

class vtkRenderer;

namespace NBufferExamples
{

/// Sets up the active camera of a renderer. Near and far plane are fitted to `bounds`, those of the
/// scene, if the pose has none.
void ApplyPose(const CameraPose& pose, const double bounds[6], vtkRenderer* renderer);

/**
 * Makes a path of `frames` frames, at least 1. The same scene, name, frames and seed give the same
 * path.
 *
 *     street    along the streets of a city at 1.7 m, 0.5 m per frame, looking ahead
 *     rooftop   the same way at 25 m, 1 m per frame, looking a little down
 *     drone     straight over a city at 120 m, 2 m per frame, looking down obliquely
 *     cuts      in every frame another eye point, in a city at 1.7 m in a street, elsewhere around
 *               the scene, and another direction
 *     aside     at the edge of the scene, all around it, looking away from it: at most five props
 *               are in view
 *     orbit     once around the scene, looking at its centre
 *     inside, around, walk, between ...   paths that only this scene has (Scene::Paths)
 *
 * Throws std::runtime_error for a path that the scene does not have.
 */
CameraPath MakePath(const Scene& scene, const std::string& name, int frames, std::uint64_t seed);

/// Returns the name of the path that suits a scene best: street in a city, the first one that only
/// this scene has, or orbit.
std::string GetUsualPath(const Scene& scene);

} // namespace NBufferExamples

#endif
