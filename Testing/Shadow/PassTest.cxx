// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The masks of vtkShadowVolumeClampPass against rays, and against each other.
#include "OffscreenFixture.h"
#include "ShadowTest.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkLight.h"
#include "vtkNew.h"

namespace
{
constexpr int Modes[] = { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Exact,
  vtkShadowVolumeClampPass::Clamped };

class ShadowPass
  : public OffscreenFixture
  , public ::testing::WithParamInterface<NamedScene>
{
};

ShadowMask GetMask(vtkShadowVolumeClampPass* pass, vtkLight* light, const OracleImage& oracle)
{
  int width = 0;
  int height = 0;
  ShadowMask mask = pass->GetMask(light, width, height);
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

void Check(const ShadowStage& stage, vtkShadowVolumeClampPass* pass)
{
  for (vtkLight* light : stage.Lights)
  {
    const OracleImage oracle = Cast(stage.Renderer, light);
    ShadowMask masks[3];
    for (int mode : Modes)
    {
      SCOPED_TRACE("mode " + std::to_string(mode));
      pass->SetMode(mode);
      stage.Window->Render();
      masks[mode] = GetMask(pass, light, oracle);
      EXPECT_TRUE(MatchesOracle(masks[mode], oracle)) << pass->GetStatistics().GetAsJSON();
      EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    }
    // Where there is a receiver that the light reaches.
    int differing = 0;
    for (std::size_t i = 0; i < oracle.Samples.size(); ++i)
    {
      differing += oracle.Samples[i] != OracleSample::Background &&
        oracle.Samples[i] != OracleSample::Unlit && masks[0][i] != masks[1][i];
    }
    EXPECT_EQ(differing, 0) << "Exact differs from Unclamped";
  }
}
}

TEST_P(ShadowPass, IsExact)
{
  const NamedScene& scene = this->GetParam();
  ShadowStage stage(scene);
  vtkNew<vtkShadowVolumeClampPass> pass;
  stage.Renderer->SetPass(pass);
  Check(stage, pass);
  if (scene.Change)
  {
    scene.Change(stage.Renderer);
    SCOPED_TRACE("after the change");
    Check(stage, pass);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShadowPass, ::testing::ValuesIn(GetScenes()),
  [](const ::testing::TestParamInfo<NamedScene>& info) { return info.param.Name; });
