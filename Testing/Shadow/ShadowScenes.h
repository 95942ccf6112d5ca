// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScenes.h
 * @brief Scenes in which shadows have gone wrong somewhere, one for each hazard, and larger ones.
 *
 * A scene fills a renderer that is in a window already: props, scene lights, camera and clipping
 * range. Random ones are seeded.
 *
 *     class ShadowSceneTest : public OffscreenFixture,
 *                             public ::testing::WithParamInterface<NamedScene> {};
 *     INSTANTIATE_TEST_SUITE_P(Scenes, ShadowSceneTest, ::testing::ValuesIn(GetScenes()),
 *       [](const auto& info) { return info.param.Name; });
 */
#ifndef ShadowScenes_h
#define ShadowScenes_h

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

class vtkRenderer;

struct NamedScene
{
  std::string Name; ///< Letters and digits.
  std::function<void(vtkRenderer*)> Build;
  int Width = 200; ///< Of the window, pixels.
  int Height = 150;
  int MultiSamples = 0;
  /// What happens to the scene after its first frame; empty for most.
  std::function<void(vtkRenderer*)> Change = {};
};

/// GoogleTest prints the name.
void PrintTo(const NamedScene& scene, std::ostream* stream);

/// All of them.
std::vector<NamedScene> GetScenes();

/// By name; throws std::out_of_range.
NamedScene GetScene(const std::string& name);

namespace ShadowScenes
{
/// @name Parts of GetScenes()
///@{
std::vector<NamedScene> GetLightScenes(); ///< Where the light is.
std::vector<NamedScene> GetViewScenes();  ///< Where the camera is, and what window it has.
std::vector<NamedScene> GetMeshScenes();  ///< What the casters are made of.
std::vector<NamedScene> GetLargeScenes();
///@}

/// Camera of the scene "Orbit" on its way round and through the shadows, t from 0 to 1.
void SetOrbitCamera(vtkRenderer* renderer, double t);

enum class Lighting
{
  Directional,
  Spot,
  Point
};

/// side x side buildings in blocks of four, seen from a street.
void City(vtkRenderer* renderer, int side, Lighting lighting);

/// So many spheres floating above ground and towers.
void Birds(vtkRenderer* renderer, int count, Lighting lighting);

/// So many large parts that touch and cross each other: boxes, cylinders, cones, spheres.
void Cad(vtkRenderer* renderer, int count, Lighting lighting);

/// A cloud of so many small spheres of one mapper, an actor each.
void Glyphs(vtkRenderer* renderer, int count, Lighting lighting);
}

#endif
