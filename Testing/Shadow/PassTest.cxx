// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The masks of vtkShadowVolumeClampPass against rays, and against each other.
#include "PassTestTools.h"

#include "vtkNew.h"

using ShadowPass = OffscreenFixtureWithParam<NamedScenario>;

TEST_P(ShadowPass, IsExact)
{
  const NamedScenario& scene = this->GetParam();
  Stage stage = SetStage(scene);
  vtkNew<vtkShadowVolumeClampPass> pass;
  stage.GetRenderer()->SetPass(pass);
  ExpectAllModesMatchOracle(stage, pass);
  if (ChangeStage(stage, scene))
  {
    SCOPED_TRACE("after the change");
    ExpectAllModesMatchOracle(stage, pass);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadowPass, ::testing::ValuesIn(GetScenarios()),
  [](const auto& info) { return info.param.Name; });
