// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NamedScenarios.h
 * @brief Scenes in which culling or shadows have gone wrong somewhere, one for each hazard.
 *
 * The tests play them as they are; nbuffer-fuzz begins some of its scenarios from one of them and
 * mutates it.
 */
#ifndef NamedScenarios_h
#define NamedScenarios_h

#include "Scenario.h"

#include "vtkNBufferStatistics.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace TestScene
{
/// What a test demands of a frame, apart from equal images: that culling takes place where it
/// should.
struct Expectation
{
  int Frame = 0;
  int Renderer = 0;
  int MinimumHidden = 0;
  int MaximumHidden = 1000000;
  int MinimumCulled = 0; ///< Hidden or outside.
  /// If set: what the culler decided to do with the frame.
  std::optional<vtkNBufferDecision> Decision;
  /// The indices of some props, each of which has one of the verdicts `Allowed`.
  std::vector<int> Props;
  std::vector<vtkNBufferVerdict> Allowed;
  /// So many of `Props` are hidden at least.
  int MinimumHiddenOfProps = 0;
  /// The indices of props of which those that the last frame found hidden are hidden again.
  std::vector<int> StayHidden;
  /// The image shows at least so many pixels of exactly this colour.
  glm::dvec3 Color = { 0.0, 0.0, 0.0 };
  int MinimumPixels = 0;
  /// If set: what else is true of the frame's statistics.
  std::function<bool(const vtkNBufferStatistics&)> Statistics = {};
  /// Nothing is expected where the window has no samples, which a driver may not have.
  bool NeedsSamples = false;
};

struct NamedScenario
{
  /// Letters and digits. A hazard that is a case of another suite than CullerHazards has the names
  /// of both with a dot between them.
  std::string Name;
  TestScene::Scenario Scenario;
  std::vector<Expectation> Expectations = {};
  /// What the language of scenarios has no words for; null for most.
  std::function<void(vtkRenderer*)> Finish = {};
};

class SceneBuilder;

/// One frame, with all points stored as doubles.
NamedScenario MakeShadowScenario(const std::string& name,
  const std::function<void(SceneBuilder&)>& build, int width = 200, int height = 150,
  int multiSamples = 0);

/// @name Hazards of culling
///@{
std::vector<NamedScenario> GetCullingHazards();
///@}

/// @name Hazards of shadows
/// All have one renderer, whose pass is for who plays them to choose, and one frame or two.
///@{
std::vector<NamedScenario> GetLightScenarios(); ///< Where the light is.
std::vector<NamedScenario> GetViewScenarios();  ///< Where the camera is, and what window it has.
std::vector<NamedScenario> GetMeshScenarios();  ///< What the casters are made of.
std::vector<NamedScenario> GetLargeScenarios();
///@}
}

#endif
