// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Hazards that the named scenarios (ImageTestScenarios.cxx) have no words for: too many props for a
// list, and two settings that are compared.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <random>

namespace
{
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
}

// Hazard: a hundred thousand specks smaller than a pixel: none in view may vanish, and indices,
// counts and the list of props must hold that many.
TEST(CullerHazards, OneHundredThousandSpecks)
{
  constexpr int Count = 100000;
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  options.CompareDraws = false; // a shared mapper does not tell for whom it draws
  options.Tuning.RoundSize = vtkNBufferTuning().RoundSize;
  Comparison comparison([](Stage& stage) { BuildSpecks(stage, Count); }, options);
  for (int i = 0; i < 2; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.1 * i, 0.0, 16.0);
        camera->SetFocalPoint(0.0, 0.0, 0.0);
        camera->SetClippingRange(5.0, 30.0);
      });
    EXPECT_EQ(comparison.GetStatistics().Props, Count + 1);
    EXPECT_GE(comparison.GetHidden(), Count * 8 / 10);
  }
}

// Hazard: long props, the whole of whose nearest depth is that of one end.
TEST(CullerHazards, LongPropsAreHiddenPixelByPixel)
{
  for (const int samples : { 0, 4 })
  {
    int hidden[2] = { 0, 0 };
    for (const bool testPixels : { false, true })
    {
      ComparisonOptions options;
      options.MultiSamples = samples;
      options.Tuning.TestPixels = testPixels;
      Comparison comparison(
        [](Stage& stage)
        {
          // A corridor wall that recedes, and rails behind it that recede with it.
          Scenes::AddBox(stage, -1.0, 0.0, -20.0, 0.1, 6.0, 50.0);
          for (int i = 0; i < 60; ++i)
          {
            Scenes::AddBox(stage, -1.6 - 0.02 * i, 0.05 * i - 1.5, -22.0, 0.02, 0.02, 44.0);
          }
          stage.GetRenderer()->GetActiveCamera()->SetViewAngle(60.0);
          stage.GetRenderer()->GetActiveCamera()->SetFocalPoint(-0.5, 0.0, -20.0);
        },
        options);
      for (int i = 0; i < 3; ++i)
      {
        comparison.Frame(
          [i](Stage& stage)
          {
            stage.GetRenderer()->GetActiveCamera()->SetPosition(1.0 + 0.1 * i, 0.0, 4.0);
            stage.GetRenderer()->ResetCameraClippingRange();
          });
      }
      hidden[testPixels] = comparison.GetHidden();
    }
    EXPECT_LT(hidden[0], 20) << "the test would show nothing, samples: " << samples;
    EXPECT_GT(hidden[1], 20) << "pixel by pixel nearly all are behind the wall: " << samples;
  }
}
