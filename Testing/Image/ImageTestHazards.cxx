// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Hazards that the named scenarios (ImageTestScenarios.cxx) have no words for.
#include "CullerTest.h"
#include "Scenes.h"
#include "Tune.h"

#include "vtkCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <random>
#include <vector>

using Scenes::AddQuad;

namespace
{
void LookAt(
  Stage& stage, double x, double y, double z, double fx = 0.0, double fy = 0.0, double fz = 0.0)
{
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(fx, fy, fz);
  stage.GetRenderer()->ResetCameraClippingRange();
}

/// Actors that share one mapper and one property, some of them behind a wall of 5 by 3.
void BuildSpecks(Stage& stage, int count)
{
  Scenes::AddBox(stage, 0.0, 0.0, 0.0, 5.0, 3.0, 0.2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(Scenes::MakeBox({ 0.0, 0.0, 0.0 }, { 0.02, 0.02, 0.02 }));
  vtkNew<vtkProperty> property;
  property->SetColor(1.0, 0.8, 0.2);
  std::mt19937 random(5);
  const auto uniform = [&random](double a, double b)
  { return a + (b - a) * static_cast<double>(random() % 100000) / 100000.0; };
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    // Made at the first draw it would modify the actor, and have the shared buffers made anew.
    actor->GetShaderProperty();
    // Nine of ten behind the wall, some before it, the others beside it.
    if (i % 10)
    {
      actor->SetPosition(uniform(-2.0, 2.0), uniform(-1.0, 1.0), uniform(-2.0, -0.5));
    }
    else
    {
      actor->SetPosition(
        uniform(-6.0, 6.0), uniform(-4.0, 4.0), i % 2000 ? uniform(-3.0, -0.5) : 0.5);
    }
    // AddViewProp() would look for it in the whole list first.
    stage.GetRenderer()->GetViewProps()->AddItem(actor);
    actor->AddConsumer(stage.GetRenderer());
  }
}

void LookAtSpecks(Comparison& comparison, double shift)
{
  comparison.Both(
    [shift](Stage& stage)
    {
      vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
      camera->SetPosition(shift, 0.0, 16.0);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetClippingRange(5.0, 30.0);
    });
}

}

// Hazard: a hundred thousand specks smaller than a pixel: none in view may vanish, and indices,
// counts and the list of props must hold that many.
TEST(CullerHazards, OneHundredThousandSpecks)
{
  constexpr int Count = 100000;
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  options.CompareDraws = false; // a shared mapper does not tell for whom it draws
  options.RoundSize = 0;        // the culler's own
  Comparison comparison([](Stage& stage) { BuildSpecks(stage, Count); }, options);
  for (int i = 0; i < 2; ++i)
  {
    LookAtSpecks(comparison, 0.1 * i);
    comparison.Frame();
    EXPECT_EQ(comparison.GetStatistics().Props, Count + 1);
    EXPECT_GE(comparison.GetHidden(), Count * 8 / 10);
  }
}

// Hazard: long props, the whole of whose nearest depth is that of one end.
TEST(CullerHazards, LongPropsAreTestedInPieces)
{
  const auto build = [](Stage& stage)
  {
    // A corridor wall that recedes, and rails behind it that recede with it.
    Scenes::AddBox(stage, -1.0, 0.0, -20.0, 0.1, 6.0, 50.0);
    for (int i = 0; i < 60; ++i)
    {
      Scenes::AddBox(stage, -1.6 - 0.02 * i, 0.05 * i - 1.5, -22.0, 0.02, 0.02, 44.0);
    }
    stage.GetRenderer()->GetActiveCamera()->SetViewAngle(60.0);
    LookAt(stage, 1.0, 0.0, 4.0, -0.5, 0.0, -20.0);
  };
  int hidden[2] = { 0, 0 };
  for (int pieces : { 1, 8 })
  {
    ComparisonOptions options;
    options.Configure = [pieces](vtkNBufferCuller* c)
    { Tune(c, &vtkNBufferTuning::MaximumNumberOfPieces, pieces); };
    Comparison comparison(build, options);
    for (int i = 0; i < 3; ++i)
    {
      comparison.Both(
        [i](Stage& stage) { LookAt(stage, 1.0 + 0.1 * i, 0.0, 4.0, -0.5, 0.0, -20.0); });
      comparison.Frame();
    }
    hidden[pieces > 1] = comparison.GetHidden();
  }
  EXPECT_GE(hidden[1], hidden[0]);
  EXPECT_GT(hidden[1], 20) << "cut in pieces nearly all of them are behind the wall";
}

// Hazard: in a row of parts that touch, drawing one of them late has all others drawn again.
TEST(CullerHazards, PartsThatTouchAreDrawnAgainWhereTheyTouch)
{
  constexpr int Parts = 50;
  constexpr int Door = Parts;
  Comparison comparison(
    [](Stage& stage)
    {
      // From the far end to the near one, and a door before the first.
      for (int i = 0; i < Parts; ++i)
      {
        Scenes::AddBox(stage, 0.2 * i - 5.0, 0.0, 0.0, 0.2, 0.6, 0.2);
      }
      Scenes::AddBox(stage, -5.0, 0.0, 1.0, 0.3, 1.2, 0.05);
      stage.GetRenderer()->GetActiveCamera()->SetPosition(-5.0, 0.0, 25.0);
      stage.GetRenderer()->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
      stage.GetRenderer()->ResetCameraClippingRange();
    });
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame("door shut");
  }
  EXPECT_EQ(comparison.GetHidden(), 1);
  comparison.Both([](Stage& stage) { stage.GetActor(Door)->SetPosition(0.0, 2.0, 0.0); });
  comparison.Frame("door open");
  const vtkNBufferStatistics& statistics = comparison.GetStatistics();
  EXPECT_EQ(statistics.GetCount(Verdict::Hidden), 0);
  EXPECT_EQ(statistics.DrawnInRound[1], 1);
  // The second part, where it touches the first; not the 48 that follow.
  EXPECT_EQ(statistics.Redrawn, 1);
}

// Hazard: an occluder moves on and uncovers what it hid; that has to show in the same frame.
TEST(CullerHazards, AMovingOccluderUncoversWhatItHid)
{
  constexpr int Width = 301;
  constexpr int Height = 199;
  constexpr int Columns = 20;
  constexpr int Rows = 12;
  constexpr double Panel = 110.0; // its width
  Comparison comparison(
    [](Stage& stage)
    {
      AddQuad(stage, 0.0, 0.0, Panel, Height, 60.0);
      for (int i = 0; i < Columns * Rows; ++i)
      {
        Scenes::AddBox(
          stage, 14.0 * (i % Columns) + 10.0, 16.0 * (i / Columns) + 10.0, 20.0, 9.0, 9.0, 9.0);
      }
      Scenes::SetPixelCamera(stage.GetRenderer(), Width, Height);
    },
    Scenes::MakeExactOptions(Width, Height));
  std::vector<bool> wasCovered(Columns * Rows, false);
  int hidden = 0;
  const double places[] = { 0.0, 0.0, 0.0, 17.3, 40.0, 40.5, 90.0, 190.0, 190.0, 3.0, 3.0, 150.0,
    20.25, 150.0, 20.25, 400.0, 20.25, 20.25 };
  for (double place : places)
  {
    comparison.Both([place](Stage& stage) { stage.GetActor(0)->SetPosition(place, 0.0, 0.0); });
    comparison.Frame("panel at " + std::to_string(place));
    for (int i = 0; i < Columns * Rows; ++i)
    {
      const double left = 14.0 * (i % Columns) + 5.5;
      const bool covered = left > place + 1.25 && left + 9.0 < place + Panel - 1.25;
      const bool uncovered = left < place - 1.0 || left + 9.0 > place + Panel + 1.0;
      const Verdict verdict = comparison.GetVerdict(i + 1);
      EXPECT_TRUE(!uncovered || verdict == Verdict::Visible) << i;
      // What was visible in the last frame is drawn before the test.
      EXPECT_TRUE(!covered || !wasCovered[i] || verdict == Verdict::Hidden) << i;
      wasCovered[i] = covered && verdict == Verdict::Hidden;
      hidden += verdict == Verdict::Hidden;
    }
  }
  EXPECT_GT(hidden, 500) << "in all frames together";
}

// Hazard: with multisampling a prop that covers no middle of a pixel may own samples.
TEST(CullerHazards, SamplesThatAreNoMiddles)
{
  constexpr int count = 40;
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(samples);
    ComparisonOptions options = Scenes::MakeExactOptions(64, 48);
    options.MultiSamples = samples;
    options.CompareDepth = samples == 0;
    Comparison comparison(
      [](Stage& stage)
      {
        for (int i = 0; i < count; ++i)
        {
          // Over the corner that four pixels share.
          const double x = 4.0 + 5.0 * (i % 10);
          const double y = 4.0 + 5.0 * (i / 10);
          Scenes::AddQuad(stage, x - 0.4, y - 0.4, x + 0.4, y + 0.4, 50.0);
        }
        Scenes::SetPixelCamera(stage.GetRenderer(), 64, 48);
      },
      options);
    Scenes::Settle(comparison);
    comparison.Frame();
    const bool hasSamples = comparison.Culled.Window->GetMultiSamples() > 0;
    EXPECT_EQ(comparison.GetHidden(), hasSamples ? 0 : count);
  }
}
