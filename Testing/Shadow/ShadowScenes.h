// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScenes.h
 * @brief Scenes in which shadows have gone wrong somewhere, one for each hazard, and larger ones.
 *
 * They are named scenarios (NamedScenarios.h), which the fuzzer mutates as well. A scene fills a
 * renderer that is in a window already: props, scene lights, camera and clipping range. Random ones
 * are seeded.
 *
 *     class ShadowSceneTest : public OffscreenFixture,
 *                             public ::testing::WithParamInterface<NamedScene> {};
 *     INSTANTIATE_TEST_SUITE_P(Scenes, ShadowSceneTest, ::testing::ValuesIn(GetScenes()),
 *       [](const auto& info) { return info.param.Name; });
 */
#ifndef ShadowScenes_h
#define ShadowScenes_h

#include "NamedScenarios.h"

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

/// Of a scenario with one renderer.
NamedScene MakeScene(const TestScene::NamedScenario& named);

/// By name; throws std::out_of_range.
NamedScene GetScene(const std::string& name);

namespace ShadowScenes
{
/// @name Parts of GetScenes()
///@{
std::vector<NamedScene> GetLightScenes(); ///< Where the light is.
std::vector<NamedScene> GetMeshScenes();  ///< What the casters are made of.
std::vector<NamedScene> GetLargeScenes();
///@}
}

#endif
