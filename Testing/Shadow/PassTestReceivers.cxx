// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Receivers that their shading turns away from a light are left out: less is drawn, and the picture
// stays.
#include "OffscreenFixture.h"
#include "PassTestTools.h"
#include "ShadowShapes.h"
#include "Tune.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkLight.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
struct Frame
{
  Picture Image;
  std::vector<ShadowMask> Masks;
  vtkShadowStatistics Statistics;
};

Frame Render(const Stage& stage, vtkShadowVolumeClampPass* pass, bool skip)
{
  pass->SetSkipUnlitReceivers(skip);
  stage.Window->Render();
  Frame frame;
  frame.Image = TakePicture(stage.Window);
  frame.Statistics = pass->GetStatistics();
  EXPECT_EQ(frame.Statistics.FailedFrames, 0);
  EXPECT_EQ(FindInconsistency(frame.Statistics), "");
  for (vtkLight* light : stage.Lights)
  {
    frame.Masks.push_back(GetMask(pass, light, CountPixels(stage.GetRenderer())));
  }
  return frame;
}

/// Renders without and with, and returns the frame with.
Frame ExpectSamePicture(const Stage& stage, vtkShadowVolumeClampPass* pass)
{
  const Frame all = Render(stage, pass, false);
  Frame lit = Render(stage, pass, true);
  EXPECT_EQ(FindDifferenceInView(stage, all.Image, lit.Image), "");
  EXPECT_LE(lit.Statistics.Receivers, all.Statistics.Receivers);
  // What was in shadow is, or is left out, which is 255, too.
  for (std::size_t i = 0; i < all.Masks.size(); ++i)
  {
    int lost = 0;
    for (std::size_t k = 0; k < all.Masks[i].size(); ++k)
    {
      lost += lit.Masks[i][k] < all.Masks[i][k];
    }
    EXPECT_EQ(lost, 0) << "light " << i;
  }
  return lit;
}

class PassReceivers
  : public OffscreenFixture
  , public ::testing::WithParamInterface<NamedScene>
{
};

class PassReceiversOnce : public OffscreenFixture
{
};
}

TEST_P(PassReceivers, PictureStays)
{
  const Stage stage = SetStage(this->GetParam());
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  ExpectSamePicture(stage, pass);
  if (this->GetParam().Change)
  {
    this->GetParam().Change(stage.GetRenderer());
    SCOPED_TRACE("after the change");
    ExpectSamePicture(stage, pass);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PassReceivers, ::testing::ValuesIn(GetScenes()),
  [](const auto& info) { return info.param.Name; });

// Most, not all: boxes around fewer tiles need not be smaller.
TEST_F(PassReceiversOnce, LessIsDrawn)
{
  int less = 0;
  int more = 0;
  for (const NamedScene& scene : GetScenes())
  {
    const Stage stage = SetStage(scene);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    Tune(pass, &vtkShadowTuning::CountFragments, true);
    const vtkShadowStatistics all = Render(stage, pass, false).Statistics;
    const vtkShadowStatistics lit = Render(stage, pass, true).Statistics;
    EXPECT_EQ(lit.ReadBacks, all.ReadBacks) << "of depth";
    less += lit.Fragments < 0.98 * all.Fragments;
    more += lit.Fragments > 1.02 * all.Fragments;
  }
  std::cout << "less in " << less << " scenes, more in " << more << "\n";
  EXPECT_GT(less, more);
}

// The mapper of a shadow's receiver has to have room for all lights, or leave none out.
TEST_F(PassReceiversOnce, MoreLightsThanBits)
{
  Stage stage = SetStage(GetScene("Directional"));
  for (int i = 0; i < 27; ++i)
  {
    const double angle = 0.23 * i;
    vtkLight* light = ShadowShapes::AddDirectional(
      stage.GetRenderer(), { std::cos(angle), std::sin(angle), -0.2 - 0.1 * (i % 5) });
    light->SetIntensity(0.05);
    stage.Lights.emplace_back(light);
  }
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  ExpectSamePicture(stage, pass);
}

// PBR takes something of every light from all sides: nothing may be left out.
TEST_F(PassReceiversOnce, PhysicallyBasedShading)
{
  const Stage stage = SetStage(GetScene("CadDirectional"));
  vtkActorCollection* actors = stage.GetRenderer()->GetActors();
  vtkCollectionSimpleIterator cookie;
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    actor->GetProperty()->SetInterpolationToPBR();
  }
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const vtkIdType receivers = Render(stage, pass, false).Statistics.Receivers;
  EXPECT_EQ(ExpectSamePicture(stage, pass).Statistics.Receivers, receivers);
}

// Masks of a still frame are those of the frame that made them; Unclamped leaves nothing out.
TEST_F(PassReceiversOnce, StillFramesAndOtherModes)
{
  const Stage stage = SetStage(GetScene("ManyLights"));
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  Render(stage, pass, true);
  const Frame made = Render(stage, pass, true);
  const Frame still = Render(stage, pass, true);
  EXPECT_EQ(still.Statistics.Decision, vtkShadowDecision::Still);
  EXPECT_TRUE(still.Masks == made.Masks);
  EXPECT_EQ(FindDifference(made.Image, still.Image), "");
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  const Frame unclamped = Render(stage, pass, false);
  const Frame skipped = Render(stage, pass, true);
  EXPECT_TRUE(skipped.Masks == unclamped.Masks);
  EXPECT_EQ(FindDifference(made.Image, skipped.Image), "");
}
