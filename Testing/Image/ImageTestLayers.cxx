// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// What a renderer leaves for the next one of the window: the picture, the depth and OpenGL state.
#include "CullerTest.h"
#include "LargeProps.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkNBufferGL.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkDiskSource.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSphereSource.h"

#include <string>
#include <utility>

using Scenes::Wall;

namespace
{
/// A layer over the wall's scene that does not erase, with a sphere behind the camera, which is
/// returned.
vtkActor* BuildLayerOverWall(Stage& stage)
{
  Scenes::BuildWall(stage);
  stage.Window->SetNumberOfLayers(2);
  vtkRenderer* layer = stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 1);
  layer->SetErase(false);
  layer->SetActiveCamera(stage.GetRenderer()->GetActiveCamera());
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.0, 0.0, 1e4);
  sphere->Update();
  const double color[3] = { 1.0, 0.0, 0.0 };
  return stage.AddActor(sphere->GetOutput(), color, layer);
}
}

// Hazard: a renderer whose list is empty does nothing at all, and does not even process (FXAA, for
// example) the picture of the layers below. So the culler must not empty the list.
TEST(CullerLayers, LayerWithNothingInsideProcessesWhatLiesBelow)
{
  for (const bool stock : { false, true })
  {
    ComparisonOptions options;
    options.KeepDefaultCuller = options.StockReference = stock;
    options.Tuning.MinimumNumberOfCandidates = 1;
    Comparison comparison([](Stage& stage) { BuildLayerOverWall(stage); }, options);
    comparison.Frame("plain");
    // In the first frame VTK's own culler removes the prop before ours sees it.
    EXPECT_EQ(comparison.GetStatistics(1).GetCount(Verdict::Outside), stock ? 0 : 1);
    comparison.Frame("FXAA", [](Stage& stage) { stage.Renderers[1]->SetUseFXAA(true); });
    comparison.Frame("FXAA and SSAO", [](Stage& stage) { stage.Renderers[1]->SetUseSSAO(true); });
    EXPECT_EQ(comparison.GetStatistics(1).GetCount(Verdict::Untested), 1);
    EXPECT_GE(comparison.GetHidden(0), Wall::Hidden);
  }
}

namespace
{
/// A layer with 40 boxes, all behind the wall of the layer below. Returns its renderer.
vtkRenderer* BuildLayerBehindWall(Stage& stage)
{
  Scenes::BuildWall(stage);
  stage.Window->SetNumberOfLayers(2);
  vtkRenderer* layer = stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 1);
  layer->SetActiveCamera(stage.GetRenderer()->GetActiveCamera());
  for (int i = 0; i < 40; ++i)
  {
    Scenes::AddBox(stage, 0.2 * (i % 8) - 0.7, 0.2 * (i / 8) - 0.5, -6.0, 0.1, 0.1, 0.1);
    vtkActor* box = stage.GetActor(Wall::Count + i);
    layer->AddActor(box);
    stage.GetRenderer()->RemoveActor(box);
  }
  return layer;
}
}

// Hazard: the depth of the layer below hides props, and is then erased while nothing else changes.
TEST(CullerLayers, KeptDepthThatIsErased)
{
  Comparison comparison(
    [](Stage& stage) { BuildLayerBehindWall(stage)->SetPreserveDepthBuffer(true); });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("kept");
  }
  EXPECT_EQ(comparison.GetHidden(1), 40);
  comparison.Frame(
    "erased", [](Stage& stage) { stage.Renderers[1]->SetPreserveDepthBuffer(false); });
  EXPECT_EQ(comparison.GetHidden(1), 0);
}

// Hazard: a renderer whose passes do not erase draws over the depth of the layer below, of which
// the wall then goes while nothing else changes.
TEST(CullerLayers, PassesThatEraseNothing)
{
  Comparison comparison(
    [](Stage& stage)
    {
      vtkRenderer* layer = BuildLayerBehindWall(stage);
      vtkNew<vtkOpaquePass> opaque;
      layer->SetPass(TestScene::InSequence({ vtkNew<vtkLightsPass>(), opaque }));
      // It lies in all rows, of which the culler would otherwise read none.
      Scenes::AddBox(stage, 5.0, 0.0, 5.0, 0.2, 30.0, 0.2, layer);
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("behind the wall");
  }
  EXPECT_EQ(comparison.GetHidden(1), 40);
  comparison.Frame(
    "without the wall", [](Stage& stage) { stage.GetActor(Wall::Index)->SetVisibility(false); });
  EXPECT_EQ(comparison.GetDecision(1), Decision::Culled);
  EXPECT_LT(comparison.GetHidden(1), 40);
}

// Hazard: a large prop of which no unit is in the view is kept for the image processing, beside the
// culler's proxy, so that the list becomes longer than that of the renderer.
TEST(CullerLayers, LargePropWithoutUnitsInTheView)
{
  ComparisonOptions options = LargeProps::MakeOptions();
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.MayBeOfOneColor = true;
  const auto build = [](Stage& stage)
  {
    vtkNew<vtkDiskSource> ring;
    ring->SetInnerRadius(9.0);
    ring->SetOuterRadius(10.0);
    ring->SetCircumferentialResolution(400);
    ring->Update();
    const double color[3] = { 1.0, 0.0, 0.0 };
    stage.AddActor(ring->GetOutput(), color);
    stage.GetRenderer()->SetUseFXAA(true);
  };
  Comparison comparison(build, options);
  for (int i = 0; i < 8; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.1 * i, 0.0, 10.0);
        camera->SetFocalPoint(0.1 * i, 0.0, 0.0);
        stage.GetRenderer()->ResetCameraClippingRange();
      });
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
  EXPECT_EQ(comparison.GetVerdict(0), Verdict::Outside);
}

// Hazard: vtkNBufferCuller leaves a prop in the list although it may be outside, so that the list
// is not empty; VTK's own culler, behind it, removes this prop. Another prop is removed by
// vtkNBufferCuller, although VTK's culler, which tests spheres, would keep it. Together they empty
// the list.
TEST(CullerLayers, LayerWhoseRestTheDefaultCullerRemovesProcessesWhatLiesBelow)
{
  ComparisonOptions options;
  options.KeepDefaultCuller = options.StockReference = true;
  options.Tuning.MinimumNumberOfCandidates = 1;
  Comparison comparison(
    [](Stage& stage)
    {
      BuildLayerOverWall(stage)->GetProperty()->SetRepresentationToWireframe();
      stage.Renderers[1]->SetUseFXAA(true);
      vtkNew<vtkCubeSource> flat;
      flat->SetBounds(-50.0, 50.0, 50.0, 50.1, -0.1, 0.1);
      flat->Update();
      const double color[3] = { 1.0, 0.0, 0.0 };
      stage.AddActor(flat->GetOutput(), color, stage.Renderers[1]);
    },
    options);
  for (int frame = 0; frame < 3; ++frame)
  {
    comparison.Frame("frame " + std::to_string(frame));
  }
  EXPECT_EQ(comparison.GetStatistics(1).GetCount(Verdict::Untested), 1);
  EXPECT_EQ(comparison.GetStatistics(1).GetCount(Verdict::NotASurface), 1);
}

namespace
{
/// Ends, from the second frame on, as VTK's own passes do when a selection is drawn through them.
class LeavesDepthTestOff : public vtkRenderStepsPass
{
public:
  static LeavesDepthTestOff* New();
  vtkTypeMacro(LeavesDepthTestOff, vtkRenderStepsPass);

  void Render(const vtkRenderState* s) override
  {
    this->Superclass::Render(s);
    if (this->Frame++ > 0)
    {
      static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow())
        ->GetState()
        ->vtkglDisable(GL_DEPTH_TEST);
    }
  }

private:
  int Frame = 0;
};
vtkStandardNewMacro(LeavesDepthTestOff);
}

// Hazard: a pass leaves the depth test off for the next renderer, in which the prop that is drawn
// last then wins, whatever its depth is.
TEST(CullerLayers, DepthTestLeftOffByAnotherRenderersPass)
{
  ComparisonOptions options;
  options.CompareDraws = false;
  Comparison comparison(
    [](Stage& stage)
    {
      stage.AddRenderer(0.0, 0.0, 1.0, 1.0)->SetErase(false);
      std::swap(stage.Renderers[0], stage.Renderers[1]);
      for (int i = 0; i < 40; ++i)
      {
        Scenes::AddBox(stage, 0.05 * i, 0.02 * i, 0.1 * i - 4.0, 3.0, 3.0, 0.02);
      }
      vtkNew<LeavesDepthTestOff> pass;
      stage.Renderers[1]->SetPass(pass);
    },
    options);
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame(
      [i](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.5 * i, 0.0, 15.0);
        camera->SetFocalPoint(0.0, 0.0, 0.0);
        stage.GetRenderer()->ResetCameraClippingRange();
      });
    EXPECT_EQ(comparison.GetDecision(), i > 0 ? Decision::OtherView : Decision::Culled);
  }
}
