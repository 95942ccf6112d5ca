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
#include <string>
#include <vector>

class vtkRenderer;

namespace TestScene
{
/// What a test demands of a frame, apart from equal images: that culling takes place where it
/// should.
struct Expectation
{
  int FirstFrame = 0;
  int LastFrame = 0;
  int MinimumHidden = 0;
  int MaximumHidden = 1000000;
  /// If not empty: these props have this verdict, or do not have it.
  std::vector<int> Props;
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Hidden;
  bool HasVerdict = true;
};

struct NamedScenario
{
  std::string Name; ///< Letters and digits.
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
/// All have one renderer and one frame; its pass is for who plays them to choose.
///@{
std::vector<NamedScenario> GetLightScenarios(); ///< Where the light is.
std::vector<NamedScenario> GetViewScenarios();  ///< Where the camera is, and what window it has.
std::vector<NamedScenario> GetMeshScenarios();  ///< What the casters are made of.
std::vector<NamedScenario> GetLargeScenarios();
///@}
}

#endif
