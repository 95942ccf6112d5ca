// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScenes.h"

#include "Fill.h"
#include "SceneProps.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"

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

/// What happens in the second frame. Props have the places in the renderer that they have in the
/// scenario: there are no assemblies in such scenes.
void ChangeProps(vtkRenderer* renderer, const TestScene::Scenario& scenario)
{
  for (const TestScene::Change& change : scenario.Changes)
  {
    if (change.Frame == 1)
    {
      vtkObject* prop = renderer->GetViewProps()->GetItemAsObject(change.Target);
      TestScene::ChangeProp(vtkProp::SafeDownCast(prop), scenario.Props.at(change.Target), change);
    }
  }
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
  NamedScene scene = { named.Name, build, window.Width, window.Height, window.MultiSamples };
  if (named.Scenario.Frames > 1)
  {
    scene.Change = [named](vtkRenderer* renderer) { ChangeProps(renderer, named.Scenario); };
  }
  return scene;
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
  return MakeScenes(TestScene::GetMeshScenarios());
}

std::vector<NamedScene> GetLargeScenes()
{
  return MakeScenes(TestScene::GetLargeScenarios());
}
}
