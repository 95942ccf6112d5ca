// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The masks of vtkShadowVolumeClampPass against rays, and against each other.
#include "OffscreenFixture.h"
#include "PassTestTools.h"
#include "ShadowTest.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkLight.h"
#include "vtkNew.h"

#include <map>

namespace
{
constexpr int Modes[] = { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Scissored,
  vtkShadowVolumeClampPass::Clamped };

class ShadowPass
  : public OffscreenFixture
  , public ::testing::WithParamInterface<NamedScene>
{
};

ShadowMask GetMask(
  vtkShadowVolumeClampPass* pass, vtkLight* light, const OracleImage& oracle, int sample)
{
  int width = 0;
  int height = 0;
  ShadowMask mask = pass->GetMask(light, width, height, sample);
  if (mask.empty())
  {
    // Nothing is in its shadow.
    mask.assign(oracle.Samples.size(), 0);
    return mask;
  }
  EXPECT_EQ(width, oracle.Width);
  EXPECT_EQ(height, oracle.Height);
  return mask;
}

void Check(const Stage& stage, vtkShadowVolumeClampPass* pass, vtkLight* light,
  const OracleImage& oracle, int sample)
{
  std::map<int, ShadowMask> masks;
  for (int mode : Modes)
  {
    SCOPED_TRACE("mode " + std::to_string(mode));
    pass->SetMode(mode);
    stage.Window->Render();
    masks[mode] = GetMask(pass, light, oracle, sample);
    EXPECT_TRUE(MatchesOracle(masks[mode], oracle)) << pass->GetStatistics().GetAsJSON();
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  }
  // Where there is a receiver that the light reaches.
  int differing = 0;
  for (std::size_t i = 0; i < oracle.Samples.size(); ++i)
  {
    differing += oracle.Samples[i] != OracleSample::Background &&
      oracle.Samples[i] != OracleSample::Unlit &&
      masks[vtkShadowVolumeClampPass::Unclamped][i] !=
        masks[vtkShadowVolumeClampPass::Scissored][i];
  }
  EXPECT_EQ(differing, 0) << "Scissored differs from Unclamped";
}

void Check(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  stage.Window->Render();
  Oracle oracle(stage.GetRenderer());
  const std::vector<std::array<double, 2>> places = GetSamplePlaces(stage.Window);
  for (vtkLight* light : stage.Lights)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      SCOPED_TRACE("sample " + std::to_string(i));
      oracle.SetSample(places[i][0], places[i][1]);
      Check(stage, pass, light, oracle.Cast(OracleLight(light)), static_cast<int>(i));
    }
  }
}
}

TEST_P(ShadowPass, IsExact)
{
  const NamedScene& scene = this->GetParam();
  Stage stage = SetStage(scene);
  vtkNew<vtkShadowVolumeClampPass> pass;
  stage.GetRenderer()->SetPass(pass);
  Check(stage, pass);
  if (scene.Change)
  {
    scene.Change(stage.GetRenderer());
    SCOPED_TRACE("after the change");
    Check(stage, pass);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadowPass, ::testing::ValuesIn(GetScenes()),
  [](const ::testing::TestParamInfo<NamedScene>& info) { return info.param.Name; });
