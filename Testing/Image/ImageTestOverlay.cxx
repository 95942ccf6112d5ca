// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What is drawn over the scene: 2-D actors, axes, scalar bars, and an orientation marker in its own
// layer.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkAxesActor.h"
#include "vtkCamera.h"
#include "vtkCornerAnnotation.h"
#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#if VTKNBUFFER_TEST_HAS_INTERACTIONWIDGETS
#include "vtkOrientationMarkerWidget.h"
#include "vtkRenderWindowInteractor.h"
#endif

using Scenes::Wall;

// Hazard: 2-D actors cover pixels without writing depth, so that they hide nothing. They are drawn
// in their own stage, whether props are held back or not.
TEST(CullerOverlay, TextScalarBarAxesAndCornerAnnotation)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      vtkNew<vtkTextActor> text;
      text->SetInput("above");
      text->SetPosition(100, 60);
      text->GetTextProperty()->SetFontSize(40);
      stage.Add(text);
      vtkNew<vtkLookupTable> table;
      table->Build();
      vtkNew<vtkScalarBarActor> bar;
      bar->SetLookupTable(table);
      bar->SetTitle("depth");
      stage.Add(bar);
      vtkNew<vtkCornerAnnotation> corner;
      corner->SetText(vtkCornerAnnotation::UpperLeft, "upper left");
      stage.Add(corner);
      vtkNew<vtkAxesActor> axes;
      axes->SetTotalLength(6.0, 6.0, 6.0);
      stage.Add(axes);
    });
  for (int i = 0; i < 4; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.1 * i, "moved");
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    // Not a box in front is hidden by what covers it in the image.
    EXPECT_EQ(comparison.GetVerdict(Wall::FirstInFront), Verdict::Visible);
  }
  for (int prop = Wall::Count; prop < Wall::Count + 4; ++prop)
  {
    EXPECT_EQ(comparison.GetVerdict(prop), Verdict::NotAPlainActor);
  }
  comparison.Frame("text changed",
    [](Stage& stage)
    { vtkTextActor::SafeDownCast(stage.Props[Wall::Count])->SetInput("changed"); });
  comparison.Frame(
    "text invisible", [](Stage& stage) { stage.Props[Wall::Count]->VisibilityOff(); });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: a marker in an upper layer clears the depth of its corner of the window.
TEST(CullerOverlay, MarkerInALayerOfItsOwn)
{
  Comparison comparison(
    [](Stage& stage)
    {
      stage.Window->SetNumberOfLayers(2);
      Scenes::BuildWall(stage);
      vtkRenderer* corner = stage.AddRenderer(0.0, 0.0, 0.4, 0.5, 1);
      corner->InteractiveOff();
      stage.Add(vtkNew<vtkAxesActor>(), corner);
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("moved",
      [i](Stage& stage)
      {
        Scenes::SetWallCamera(stage.GetRenderer(), 0.2 * i);
        stage.Renderers[1]->GetActiveCamera()->SetPosition(0.3 * i, 1.0, 5.0);
        stage.Renderers[1]->ResetCamera();
      });
    EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
    EXPECT_EQ(comparison.GetDecision(1), Decision::FewCandidates);
    EXPECT_TRUE(DidNoWork(comparison.GetStatistics(1)));
  }
}

// Hazard: VTK's own widget adds a renderer and turns its camera in events of the window.
TEST(CullerOverlay, OrientationMarkerWidget)
{
#if VTKNBUFFER_TEST_HAS_INTERACTIONWIDGETS
  // The widget of a stage lives as long as its window is drawn.
  std::vector<vtkSmartPointer<vtkOrientationMarkerWidget>> widgets;
  std::vector<vtkSmartPointer<vtkRenderWindowInteractor>> interactors;
  {
    Comparison comparison(
      [&](Stage& stage)
      {
        Scenes::BuildWall(stage);
        auto interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
        interactor->SetRenderWindow(stage.Window);
        auto widget = vtkSmartPointer<vtkOrientationMarkerWidget>::New();
        widget->SetOrientationMarker(vtkNew<vtkAxesActor>());
        widget->SetInteractor(interactor);
        widget->SetDefaultRenderer(stage.GetRenderer());
        widget->SetViewport(0.0, 0.0, 0.4, 0.5);
        widget->SetEnabled(1);
        widget->InteractiveOff();
        widgets.push_back(widget);
        interactors.push_back(interactor);
      });
    Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.2, 0.4, 0.6 }, Wall::Hidden);
    for (const auto& widget : widgets)
    {
      widget->SetEnabled(0);
    }
    comparison.Frame("widget off");
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    widgets.clear();
    interactors.clear();
  }
#else
  GTEST_SKIP() << "this VTK comes without InteractionWidgets";
#endif
}
