// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The oracle in the scenes of shadow hazards: it sees what is drawn, and changes that leave shadows
// as they are do not change its result.
#include "SceneChanges.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using OracleSceneTest = OffscreenFixtureWithParam<NamedScenario>;

/// Window depth of what the oracle sees there.
double GetDepth(
  const Oracle& oracle, vtkMatrix4x4* worldToClip, int x, int y, double jitterX, double jitterY)
{
  Oracle::Receiver receiver;
  if (!oracle.GetReceiver(x, y, jitterX, jitterY, receiver))
  {
    return 1.0;
  }
  double clip[4] = { receiver.Position[0], receiver.Position[1], receiver.Position[2], 1.0 };
  worldToClip->MultiplyPoint(clip, clip);
  return 0.5 * clip[2] / clip[3] + 0.5;
}

/// Counts pixels whose depth is not that of the oracle, nor between the oracle's depths at places
/// 1/32 of a pixel away.
int CountOtherDepths(Stage& stage)
{
  const Oracle oracle(stage.GetRenderer());
  const vtkNBufferRectangle view = GetPixels(stage.GetRenderer());
  vtkNew<vtkFloatArray> depths;
  stage.Window->GetZbufferData(view.X0, view.Y0, view.X1 - 1, view.Y1 - 1, depths);
  vtkMatrix4x4* worldToClip =
    stage.GetRenderer()->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      stage.GetRenderer()->GetTiledAspectRatio(), -1.0, 1.0);
  constexpr double tolerance = 1e-5;
  int result = 0;
  vtkIdType next = 0;
  for (const auto& [x, y] : Pixels(view.GetWidth(), view.GetHeight()))
  {
    const double drawn = depths->GetValue(next++);
    double low = GetDepth(oracle, worldToClip, x, y, 0.0, 0.0);
    double high = low;
    if (std::abs(drawn - low) <= tolerance)
    {
      continue;
    }
    for (const double jitterX : { -1.0 / 32.0, 1.0 / 32.0 })
    {
      for (const double jitterY : { -1.0 / 32.0, 1.0 / 32.0 })
      {
        const double depth = GetDepth(oracle, worldToClip, x, y, jitterX, jitterY);
        low = std::min(low, depth);
        high = std::max(high, depth);
      }
    }
    result += drawn < low - tolerance || drawn > high + tolerance;
  }
  return result;
}

std::vector<OracleImage> CastAll(const Stage& stage)
{
  const Oracle oracle(stage.GetRenderer());
  std::vector<OracleImage> result;
  for (vtkLight* light : stage.Lights)
  {
    result.push_back(oracle.Cast(OracleLight(light)));
  }
  return result;
}

/// What is unambiguous in `expected` is the same in the stage, in every third pixel.
void ExpectSame(const Stage& stage, const std::vector<OracleImage>& expected)
{
  const Oracle oracle(stage.GetRenderer());
  ASSERT_EQ(stage.Lights.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const OracleLight light(stage.Lights[i]);
    int wrong = 0;
    std::size_t pixel = 0;
    for (const auto& [x, y] : Pixels(expected[i].Width, expected[i].Height))
    {
      wrong += pixel % 3 == 0 && !expected[i].Ambiguous[pixel] &&
        oracle.Classify(x, y, 0.0, 0.0, light).Sample != expected[i].Samples[pixel];
      ++pixel;
    }
    EXPECT_EQ(wrong, 0) << "light " << i;
  }
}
}

TEST_P(OracleSceneTest, SeesWhatIsDrawn)
{
  NamedScenario scene = this->GetParam();
  scene.Scenario.Window.MultiSamples = 0; // depth of the centres
  Stage stage = SetStage(scene);
  stage.Window->Render();
  EXPECT_EQ(CountOtherDepths(stage), 0);
  if (ChangeStage(stage, scene))
  {
    stage.Window->Render();
    EXPECT_EQ(CountOtherDepths(stage), 0);
  }
}

// Each light lights something and casts a shadow, except for a light that is enclosed. The result
// must not depend on winding, shared points, grouping and order of the triangles, or on the place
// of the scene in the world.
TEST_P(OracleSceneTest, HasLightAndShadowAndKeepsThem)
{
  const NamedScenario& scene = this->GetParam();
  const Stage whole = SetStage(scene);
  EXPECT_FALSE(whole.Lights.empty());
  const std::vector<OracleImage> images = CastAll(whole);
  for (const OracleImage& image : images)
  {
    std::cout << image.Count(OracleSample::Lit) << " lit, " << image.Count(OracleSample::Shadowed)
              << " in shadow, " << image.Count(OracleSample::Unlit) << " unlit, "
              << image.CountAmbiguous() << " ambiguous\n";
    EXPECT_EQ(image.Count(OracleSample::Lit) > 100, scene.Name != "LightInsideCaster");
    EXPECT_GT(image.Count(OracleSample::Shadowed), 100);
    // Boundaries only.
    EXPECT_LT(image.CountAmbiguous(), image.Width * image.Height / 10);
  }
  for (const SceneChanges::Change& change : SceneChanges::GetChanges())
  {
    SCOPED_TRACE(change.Name);
    const Stage stage = SetStage(scene);
    change.Make(stage.GetRenderer());
    ExpectSame(stage, images);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OracleSceneTest, ::testing::ValuesIn(GetScenarios()),
  [](const auto& info) { return info.param.Name; });
