// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScene.h
 * @brief Scenes whose shadows are measured.
 *
 *     city-sun   the city at 9 in the morning on 21 June, solar time: the sun in the south-east
 *     city-spot  the city under one spotlight, of 20 degrees and 120 m above the street unless a
 *                SpotLamp says otherwise
 *     birds      400 spheres, synthetic and seeded, floating above ground and 12 towers; the sun
 *     towers     hills of half a million triangles with 40 towers, and 300 birds over them,
 *                synthetic and seeded; the sun. The paths are those of the scene "terrain"
 *     swarm      10,000 small cubes (ViewOptions::Instances says otherwise), instances of one glyph
 *                mapper in any direction, floating above ground; seeded; the sun
 *     simple     20 large parts that touch and cross each other above a floor, seeded; the sun
 *
 * and every scene of LoadScene(), under the sun.
 */
#ifndef ShadowScene_h
#define ShadowScene_h

#include "CameraPath.h"
#include "Command.h"
#include "Scene.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Loads the scene that the options name.
NBufferExamples::Scene LoadShadowScene(ViewOptions view);

/// The spot of city-spot. It shines on the place on the street 20 m ahead of the path's middle
/// pose.
struct SpotLamp
{
  /// The position of the lamp relative to that place, in metres: east, north, up.
  glm::dvec3 Offset = { 25.0, -25.0, 120.0 };
  /// The angle from the axis to the edge in degrees, as in vtkLight; between 0 and 90.
  double ConeAngle = 20.0;
};

/// Makes a lamp of x, y, z and the cone angle. Throws std::runtime_error if the scene has no spot,
/// the lamp is not above the street, or the angle out of range.
SpotLamp ReadLamp(const std::string& name, const std::vector<double>& numbers);

/// Replaces the lights of the renderer by the light of the scene.
vtkLight* LightScene(const std::string& name, const NBufferExamples::Scene& scene,
  const NBufferExamples::CameraPath& path, vtkRenderer* renderer, const SpotLamp& lamp = {});

/// Gives a property key to all actors except the ground and the streets, and returns the key: as
/// caster keys of the pass it makes the ground only receive shadows. Returns nullptr for scenes of
/// files, whose parts cannot be distinguished.
vtkSmartPointer<vtkInformation> MarkCasters(const NBufferExamples::Scene& scene);

} // namespace NBufferBench

#endif
