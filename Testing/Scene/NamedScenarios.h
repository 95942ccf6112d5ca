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
/// What a test demands of a frame in addition to equal images: that culling takes place where it
/// should.
struct Expectation
{
  int Frame = 0;    ///< The number of the frame, from 0 on.
  int Renderer = 0; ///< The number of the renderer, from 0 on.
  ///@{
  /// Limits for the number of hidden props.
  int MinimumHidden = 0;
  int MaximumHidden = 1000000;
  ///@}
  /// The least number of props that are hidden or outside.
  int MinimumCulled = 0;
  /// The culler's decision about the frame; not checked if it is not set.
  std::optional<vtkNBufferDecision> Decision;
  /// The indices of props each of which must have one of the verdicts `Allowed`.
  std::vector<int> Props;
  std::vector<vtkNBufferVerdict> Allowed;
  /// The least number of hidden props among `Props`.
  int MinimumHiddenOfProps = 0;
  /// The indices of props that must be hidden if the last frame found them hidden.
  std::vector<int> StayHidden;
  ///@{
  /// The image must have at least MinimumPixels pixels of exactly this colour (from 0 to 1).
  glm::dvec3 Color = { 0.0, 0.0, 0.0 };
  int MinimumPixels = 0;
  ///@}
  /// Must return true for the frame's statistics, if it is set.
  std::function<bool(const vtkNBufferStatistics&)> Statistics = {};
  /// Whether nothing is expected of a window without multisampling, which some drivers lack.
  bool NeedsSamples = false;
  /// Whether nothing is expected of a back-end that does not test all pixels (TestedBackend.h).
  bool NeedsPixels = false;
};

struct NamedScenario
{
  /// A name of letters and digits. A case of another suite of tests than CullerHazards has a name
  /// of the form SUITE.CASE.
  std::string Name;
  TestScene::Scenario Scenario;
  std::vector<Expectation> Expectations = {};
  /// Adds to the renderer what a scenario cannot describe; empty for most scenarios.
  std::function<void(vtkRenderer*)> Finish = {};
};

class SceneBuilder;

/// Makes a scenario of one frame. The points of all props are stored as doubles.
NamedScenario MakeShadowScenario(const std::string& name,
  const std::function<void(SceneBuilder&)>& build, int width = 200, int height = 150,
  int multiSamples = 0);

/// @name Hazards of culling
///@{
std::vector<NamedScenario> GetCullingHazards();
///@}

/// @name Hazards of shadows
/// All have one renderer and one or two frames. They name no pass: who plays them chooses it.
///@{
std::vector<NamedScenario> GetLightScenarios(); ///< Where the light is.
std::vector<NamedScenario> GetViewScenarios();  ///< Where the camera is, and what window it has.
std::vector<NamedScenario> GetMeshScenarios();  ///< What the casters are made of.
std::vector<NamedScenario> GetLargeScenarios(); ///< Many casters, or very large ones.
///@}
}

#endif
