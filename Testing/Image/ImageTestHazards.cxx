// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A hazard with too many props for a named scenario (ImageTestScenarios.cxx).
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
