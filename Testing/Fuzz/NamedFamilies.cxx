// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "NamedScenarios.h"

namespace TestScene
{
namespace
{
const std::vector<NamedScenario>& GetNamedScenarios(bool withShadows)
{
  static const std::vector<NamedScenario> hazards = GetCullingHazards();
  static const std::vector<NamedScenario> shadows = []
  {
    std::vector<NamedScenario> result = GetLightScenarios();
    for (const auto& more : { GetViewScenarios(), GetMeshScenarios() })
    {
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }();
  return withShadows ? shadows : hazards;
}
}

void BuildNamed(Writer& writer, bool shadows)
{
  const std::vector<NamedScenario>& all = GetNamedScenarios(shadows);
  const NamedScenario& named = all[writer.Random.Index(all.size())];
  writer.Scene.Family = "named " + named.Name;
  writer.Scene.Props = named.Scenario.Props;
  writer.Scene.Views = named.Scenario.Views;
  writer.Scene.Changes = named.Scenario.Changes;
  writer.Scene.Lights = named.Scenario.Lights;
  writer.Occluders = { named.Scenario.Props.front().Id };
}
}
