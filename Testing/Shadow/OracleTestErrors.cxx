// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// What is wrong with samples whose shadows differ from the rays', where the answer is known.
#include "SceneBuilder.h"
#include "ShadowErrors.h"
#include "ShadowTest.h"

namespace
{
using OracleErrorTest = OffscreenFixture;

/// A floor seen from above, a unit for each pixel, under light that falls at 45 degrees towards +x.
/// One block floats from 8 to 10 above it, the other one stands on it and is 6 high.
Stage MakeStage()
{
  return SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(200.0);
      scene.Box({ 20.0, 30.0, 9.0 }, { 10.0, 10.0, 2.0 });
      scene.Box({ 50.0, 30.0, 3.0 }, { 10.0, 10.0, 6.0 });
      scene.Directional({ 1.0, 0.0, -1.0 });
      scene.LookParallel({ 40.0, 30.0, 100.0 }, { 40.0, 30.0, 0.0 }, 30.0);
    },
    80, 60);
}
}

TEST_F(OracleErrorTest, WrongSamplesAreClassified)
{
  const Stage stage = MakeStage();
  const Oracle oracle(stage.GetRenderer());
  const OracleLight light(stage.Lights[0]);
  const OracleImage image = oracle.Cast(light);
  const auto classify = [&](int x) { return ClassifyShadowError(oracle, light, image, x, 30); };
  EXPECT_EQ(classify(28), ShadowError::Leak);
  EXPECT_EQ(classify(57), ShadowError::PeterPanning);
  // The shadow of the block that stands ends at 61.
  EXPECT_EQ(classify(58), ShadowError::PeterPanning);
  EXPECT_EQ(classify(59), ShadowError::Outline);
  EXPECT_EQ(classify(62), ShadowError::Outline);
  EXPECT_EQ(classify(63), ShadowError::Acne);
}
