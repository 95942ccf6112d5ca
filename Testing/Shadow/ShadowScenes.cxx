// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScenes.h"

#include "Fill.h"

#include <algorithm>
#include <iterator>
#include <ostream>
#include <stdexcept>

namespace
{
std::vector<NamedScene> MakeScenes(const std::vector<TestScene::NamedScenario>& scenarios)
{
  std::vector<NamedScene> scenes;
  std::transform(scenarios.begin(), scenarios.end(), std::back_inserter(scenes), MakeScene);
  return scenes;
}
}

NamedScene MakeScene(const TestScene::NamedScenario& named)
{
  const TestScene::Window& window = named.Scenario.Window;
  const auto build = [named](vtkRenderer* renderer)
  {
    TestScene::Fill(renderer, named.Scenario);
    if (named.Finish)
    {
      named.Finish(renderer);
    }
  };
  return { named.Name, build, window.Width, window.Height, window.MultiSamples };
}

void PrintTo(const NamedScene& scene, std::ostream* stream)
{
  *stream << scene.Name;
}

std::vector<NamedScene> GetScenes()
{
  std::vector<NamedScene> result;
  for (const auto& part :
    { ShadowScenes::GetLightScenes(), MakeScenes(TestScene::GetViewScenarios()),
      ShadowScenes::GetMeshScenes(), ShadowScenes::GetLargeScenes() })
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

NamedScene GetScene(const std::string& name)
{
  for (const NamedScene& scene : GetScenes())
  {
    if (scene.Name == name)
    {
      return scene;
    }
  }
  throw std::out_of_range("There is no scene " + name + ".");
}

namespace ShadowScenes
{
std::vector<NamedScene> GetLightScenes()
{
  return MakeScenes(TestScene::GetLightScenarios());
}

std::vector<NamedScene> GetMeshScenes()
{
  std::vector<NamedScene> scenes = MakeScenes(TestScene::GetMeshScenarios());
  for (const NamedScene& scene : GetHandmadeScenes())
  {
    scenes.push_back(scene);
  }
  return scenes;
}

std::vector<NamedScene> GetLargeScenes()
{
  return MakeScenes(TestScene::GetLargeScenarios());
}
}
