// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScene.h
 * @brief Scenes whose shadows are measured.
 *
 *     city-sun   the city at 9 in the morning on 21 June, solar time: the sun in the south-east
 *     city-spot  the city under one spotlight of 40 degrees, 60 m above the street
 *     birds      400 spheres, synthetic and seeded, floating above ground and 12 towers; the sun
 *     simple     20 large parts that touch and cross each other above a floor, seeded; the sun
 *
 * and whatever LoadScene knows, under the sun.
 */
#ifndef ShadowScene_h
#define ShadowScene_h

#include "CameraPath.h"
#include "Command.h"
#include "Scene.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkSmartPointer.h"

#include <string>

namespace NBufferBench
{

NBufferExamples::Scene LoadShadowScene(ViewOptions view);

/// Replace the lights of the renderer by the one of the scene. A spot shines on the place before
/// the middle of the path.
vtkLight* LightScene(const std::string& name, const NBufferExamples::Scene& scene,
  const NBufferExamples::CameraPath& path, vtkRenderer* renderer);

/// Give all actors a property key but the ground and what lies on it; returns it, so that these
/// only receive shadows. nullptr for scenes of files, whose parts are not told apart.
vtkSmartPointer<vtkInformation> MarkCasters(
  const std::string& name, const NBufferExamples::Scene& scene);

} // namespace NBufferBench

#endif
