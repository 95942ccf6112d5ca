// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Windows, renderers and lifetimes.
#include "PassTestTools.h"
#include "ScenePasses.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferGL.h"
#include "vtkShadowTarget.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSSAOPass.h"
#include "vtkSelection.h"
#include "vtkSphereSource.h"
#include "vtkTextureUnitManager.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

using PassWindows = OffscreenFixture;

namespace
{
/// Two renderers of one window, at odd corners and of odd sizes.
std::array<Stage, 2> SetTwoStages(const std::string& rightScene)
{
  Stage left = SetNamedStage("Directional");
  left.Window->SetSize(307, 211);
  left.GetRenderer()->SetViewport(0.05, 0.3, 0.45, 0.95);
  Stage right = left;
  right.Renderers.clear();
  right.AddRenderer(0.0, 0.0, 1.0, 1.0)->SetAutomaticLightCreation(0);
  FillStage(right, GetScenario(rightScene));
  right.GetRenderer()->SetViewport(0.5, 0.1, 0.97, 0.7);
  right.Lights = { vtkLight::SafeDownCast(right.GetRenderer()->GetLights()->GetItemAsObject(0)) };
  return { left, right };
}
}

// Each renderer has its own pass.
TEST_F(PassWindows, TwoRenderers)
{
  const std::array<Stage, 2> stages = SetTwoStages("Spot");
  for (const int mode : ShadowModes)
  {
    SCOPED_TRACE("mode " + std::to_string(mode));
    const vtkSmartPointer<vtkShadowVolumeClampPass> passes[2] = { AddPass(stages[0]),
      AddPass(stages[1]) };
    for (std::size_t i = 0; i < 2; ++i)
    {
      passes[i]->SetMode(mode);
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      ExpectMatchesOracle(stages[i], passes[i]);
      EXPECT_GT(ExpectComposedOfDimmed(stages[i], passes[i]), 100);
    }
  }
}

// VTK's own passes ignore stereo until a frame was drawn without a pass.
TEST_F(PassWindows, EyesOfStereo)
{
  const auto draw = [](int type, bool plainFrameBefore)
  {
    Stage stage = SetNamedStage("ManyLights");
    stage.Window->SetSize(301, 211);
    stage.GetRenderer()->SetViewport(0.1, 0.0, 0.9, 0.8);
    stage.Window->SetStereoType(type);
    stage.Window->SetStereoRender(1);
    if (plainFrameBefore)
    {
      stage.Window->Render();
    }
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    const Picture image = RenderPicture(stage);
    EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
    for (std::size_t i = 0; i < stage.Lights.size(); ++i)
    {
      EXPECT_TRUE(
        MatchesOracle(GetMask(stage, pass, i), Cast(stage.GetRenderer(), stage.Lights[i])));
    }
    EXPECT_EQ(FindDifference(image, RenderPicture(stage)), "");
    return image;
  };
  const Picture left = draw(VTK_STEREO_LEFT, false);
  const Picture right = draw(VTK_STEREO_RIGHT, false);
  // What is outside of the viewport is drawn by nobody.
  constexpr int viewport[] = { 31, 0, 239, 168 };
  EXPECT_NE(FindDifference(left, right, viewport), "");
  EXPECT_EQ(FindDifference(left, draw(VTK_STEREO_LEFT, true), viewport), "");
  EXPECT_EQ(FindDifference(right, draw(VTK_STEREO_RIGHT, true), viewport), "");
}

// Hazard: a viewport without a pixel counts as a failure.
TEST_F(PassWindows, ViewportOfSizeZero)
{
  const Stage stage = SetNamedStage("Directional");
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const Picture before = RenderPicture(stage);
  stage.GetRenderer()->SetViewport(0.5, 0.2, 0.5, 0.8);
  RenderPicture(stage);
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::NoReceiver);
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  stage.GetRenderer()->SetViewport(0.0, 0.0, 1.0, 1.0);
  EXPECT_EQ(FindDifference(before, RenderPicture(stage)), "");
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
}

// Renderers of one window that share a pass see their own shadows.
TEST_F(PassWindows, OnePassForTwoRenderers)
{
  const auto [left, right] = SetTwoStages("ManyLights");
  const vtkSmartPointer<vtkShadowVolumeClampPass> leftPass = AddPass(left);
  const vtkSmartPointer<vtkShadowVolumeClampPass> rightPass = AddPass(right);
  const Picture expected = RenderPicture(left);
  const vtkSmartPointer<vtkShadowVolumeClampPass> shared = AddPass(left);
  right.GetRenderer()->SetPass(shared);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_EQ(FindDifference(expected, RenderPicture(left)), "") << "frame " << frame;
  }
}

// A pass and actors are moved between windows.
TEST_F(PassWindows, OnePassForTwoWindows)
{
  std::array<Stage, 2> stages = { SetNamedStage("Directional"), SetNamedStage("Spot") };
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stages[0]);
  stages[1].GetRenderer()->SetPass(pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    for (const Stage& stage : stages)
    {
      ExpectMatchesOracle(stage, pass);
      EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    }
  }
  for (Stage& stage : stages)
  {
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
  stages[0].Renderers.clear();
  stages[0].Window = nullptr;
  ExpectMatchesOracle(stages[1], pass);
}

TEST_F(PassWindows, Resizing)
{
  Stage stage = SetNamedStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (const auto& [width, height] : std::initializer_list<std::pair<int, int>>{
         { 200, 150 }, { 97, 203 }, { 333, 55 }, { 1, 1 }, { 201, 151 }, { 2, 120 }, { 64, 64 } })
  {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    stage.Window->SetSize(width, height);
    ExpectMatchesOracle(stage, pass);
    ExpectComposedOfDimmed(stage, pass);
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  }
}

TEST_F(PassWindows, MultiSamplesOnAndOff)
{
  Stage stage = SetNamedStage("Spot");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (int samples : { 4, 0, 2, 4 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    stage.Window->SetMultiSamples(samples);
    ExpectMatchesOracle(stage, pass);
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
}

// At the edge of a surface, a pixel may have samples in which nothing is seen. What volumes count
// there, where Scissored leaves out casters, must be in no mask.
TEST_F(PassWindows, MultiSamplesBesideReceivers)
{
  const Stage stage = SetNamedStage("ManyLights");
  stage.GetRenderer()->GetActiveCamera()->Zoom(0.3);
  stage.Window->SetMultiSamples(4);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  const Picture expected = RenderPicture(stage);
  const std::vector<ShadowMask> masks = GetMasks(stage, pass);
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  for (std::size_t i = 0; i < masks.size(); ++i)
  {
    EXPECT_EQ(CountShadowed(masks[i]) > 0, pass->GetLightCasts(stage.Lights[i]));
    EXPECT_TRUE(GetMask(stage, pass, i) == masks[i]) << "light " << i;
  }
}

// From inside of a closed caster its inside is seen, which is in shadow, and other things are seen
// where the near plane cuts the caster away.
TEST_F(PassWindows, CameraInsideAClosedCaster)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3.0);
  sphere->Update();
  const Stage stage = SetNamedStage("Directional");
  AddMesh(stage.GetRenderer(), sphere->GetOutput());
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  for (const auto& [distance, nearest] :
    std::initializer_list<std::pair<double, double>>{ { 1.0, 0.1 }, { 5.0, 3.0 }, { 5.0, 0.1 } })
  {
    camera->SetPosition(distance, 0.1 * distance, 0.2 * distance);
    camera->SetClippingRange(nearest, 100.0);
    SCOPED_TRACE("distance " + std::to_string(distance));
    ExpectAllModesMatchOracle(stage, pass);
  }
}

// Edges (before VTK 9.2) and cell colours are read from buffer textures, whose samplers must not
// share a texture unit with those of the masks.
TEST_F(PassWindows, BufferTextures)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.8);
  sphere->Update();
  vtkPolyData* data = sphere->GetOutput();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    colors->InsertNextTuple3(255.0, static_cast<double>(i % 256), 0.0);
  }
  data->GetCellData()->SetScalars(colors);
  const Stage stage = SetNamedStage("Directional");
  vtkActor* actor = AddMesh(stage.GetRenderer(), data);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
    actor->GetProperty()->EdgeVisibilityOff();
    ExpectMatchesOracle(stage, pass);
    const long long receivers = pass->GetStatistics().Receivers;
    EXPECT_GT(receivers, 1000);
    // Older VTK draws edges as lines, which reach beyond the surface: rays do not know them.
    actor->GetProperty()->EdgeVisibilityOn();
    stage.Window->Render();
    EXPECT_GE(pass->GetStatistics().Receivers, receivers);
  }
}

// With the culler and the pass together, props that are hidden from the camera still cast.
TEST_F(PassWindows, WithTheCuller)
{
  for (const char* name : { "CityDirectional", "ManyLights" })
  {
    SCOPED_TRACE(name);
    const Stage stage = SetNamedStage(name);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->Render();
    const Picture expected = RenderPicture(stage);
    vtkNew<vtkNBufferCuller> culler;
    stage.GetRenderer()->AddCuller(culler);
    for (int frame = 0; frame < 3; ++frame)
    {
      SCOPED_TRACE("frame " + std::to_string(frame));
      stage.GetRenderer()->GetActiveCamera()->Modified();
      EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
      ExpectMatchesOracle(stage, pass);
    }
  }
}

// Hazard: vtkSSAOPass makes its own draw buffers those of the framebuffer of the receivers' depth,
// in which they are missing. OpenGL before 4.1 does not draw into it then.
TEST_F(PassWindows, InsideAmbientOcclusion)
{
  const Stage stage = SetNamedStage("Directional");
  vtkNew<vtkSSAOPass> occlusion;
  vtkNew<vtkShadowVolumeClampPass> shadows;
  occlusion->SetDelegatePass(TestScene::MakeSequence({ vtkNew<vtkLightsPass>(), shadows }));
  stage.GetRenderer()->SetPass(occlusion);
  int depthDraws = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&depthDraws);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* draws, void*)
    {
      int type = 0;
      glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
      if (type == GL_NONE)
      {
        ++*static_cast<int*>(draws);
        int buffers[2] = { 0, 0 };
        glGetIntegerv(GL_DRAW_BUFFER0, &buffers[0]);
        glGetIntegerv(GL_DRAW_BUFFER1, &buffers[1]);
        EXPECT_EQ(buffers[0], GL_NONE);
        EXPECT_EQ(buffers[1], GL_NONE);
      }
    });
  for (vtkActor* actor : GetActors(stage.GetRenderer()))
  {
    actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, command);
  }
  stage.Window->Render();
  EXPECT_EQ(shadows->GetStatistics().Decision, vtkShadowDecision::Drawn);
  EXPECT_GT(depthDraws, 0);
}

//------------------------------------------------------------------------------------------------
using PassLifetime = OffscreenFixture;

TEST_F(PassLifetime, WindowBeforePass)
{
  vtkSmartPointer<vtkShadowVolumeClampPass> pass;
  std::array<ShadowMask, 2> masks;
  for (ShadowMask& mask : masks)
  {
    const Stage stage = SetNamedStage("ManyLights");
    pass = pass ? pass : AddPass(stage);
    stage.GetRenderer()->SetPass(pass);
    stage.Window->Render();
    mask = GetMask(stage, pass);
  }
  EXPECT_TRUE(masks[0] == masks[1]);
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
}

TEST_F(PassLifetime, NeverRendered)
{
  vtkNew<vtkShadowVolumeClampPass> pass;
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::None);
  int width = -1;
  int height = -1;
  EXPECT_TRUE(pass->GetMask(nullptr, width, height).empty());
  EXPECT_EQ(width, 0);
  EXPECT_EQ(height, 0);
  pass->ReleaseGraphicsResources(nullptr);
}

// Hazard: objects of a context that is gone are used.
TEST_F(PassLifetime, ReleasedAndDrawnAgain)
{
  const Stage stage = SetNamedStage("ManyLights");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const Picture expected = RenderPicture(stage);
  const std::function<void()> releases[] = { [&] { pass->ReleaseGraphicsResources(stage.Window); },
    [&] { stage.GetRenderer()->ReleaseGraphicsResources(stage.Window); },
    [&] { stage.Window->Finalize(); },
    [&]
    {
      pass->ReleaseGraphicsResources(stage.Window);
      pass->ReleaseGraphicsResources(stage.Window);
      stage.Window->Finalize();
    } };
  for (const std::function<void()>& release : releases)
  {
    release();
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
}

// Hazard: the window loses its context while the renderer has no pass, which VTK then tells
// nothing.
TEST_F(PassLifetime, SmoothedInAnotherContext)
{
  const Stage stage = SetNamedStage("Directional");
  stage.GetRenderer()->UseFXAAOn();
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const Picture expected = RenderPicture(stage);
  stage.GetRenderer()->SetPass(nullptr);
  stage.Window->Finalize();
  stage.Window->Render();
  stage.GetRenderer()->SetPass(pass);
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
}

// Hazard: the masks of a frame in which mappers have left out receivers are kept.
TEST_F(PassLifetime, AbortedFramesLeaveNoMasks)
{
  const Stage stage = SetNamedStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const Picture expected = RenderPicture(stage);
  pass = AddPass(stage);
  vtkMapper* mapper = GetActors(stage.GetRenderer())[0]->GetMapper();
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(stage.Window);
  abort->SetCallback([](vtkObject*, unsigned long, void* window, void*)
    { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  const unsigned long tag = mapper->AddObserver(vtkCommand::EndEvent, abort);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Failed);
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  mapper->RemoveObserver(tag);
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
}

// Hazard: masks get no texture unit, or leave none to the textures of props.
TEST_F(PassLifetime, MoreLightsThanTextureUnits)
{
  const Stage stage = SetNamedStage("Directional");
  stage.Window->SetSize(40, 30);
  stage.Window->Render();
  const int units = vtkOpenGLRenderWindow::SafeDownCast(stage.Window)
                      ->GetState()
                      ->GetTextureUnitManager()
                      ->GetNumberOfTextureUnits();
  std::vector<vtkSmartPointer<vtkLight>> more;
  for (int i = 0; i < units * vtkShadowTarget::LightsPerMask; ++i)
  {
    more.push_back(TestScene::MakeLight(SceneBuilder().Directional({ 0.01 * i, 0.2, -1.0 })));
    more.back()->SetIntensity(0.01);
    stage.GetRenderer()->AddLight(more.back());
  }
  const Picture plain = RenderPicture(stage);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  EXPECT_EQ(FindDifference(plain, RenderPicture(stage)), "");
  EXPECT_EQ(FindDifference(plain, RenderPicture(stage)), "");
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 2);

  // As many as possible, and then few: masks that are not needed take no units.
  const auto keep = [&](std::size_t count)
  {
    for (std::size_t i = 0; i < more.size(); ++i)
    {
      more[i]->SetSwitch(i < count);
    }
  };
  keep((units - 8) * vtkShadowTarget::LightsPerMask);
  stage.Window->Render();
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
  keep(1);
  const Picture again = RenderPicture(stage);
  AddPass(stage);
  EXPECT_EQ(FindDifference(RenderPicture(stage), again), "");
}

// Hazard: a selection draws nothing because the pass draws the frame.
TEST_F(PassWindows, SelectionsFindWhatTheyFindWithoutIt)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Sphere({ 0.0, 0.0, 1.5 }, 1.0);
      scene.Directional({ 0.3, 0.2, -1.0 });
      scene.Look({ 0.0, -6.0, 4.0 }, { 0.0, 0.0, 1.5 });
    },
    200, 150);
  vtkRenderer* renderer = stage.GetRenderer();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, 199, 149);
  vtkNew<vtkPropPicker> picker;
  vtkNew<vtkPropPicker> picksFloor;
  picksFloor->PickFromListOn();
  picksFloor->AddPickList(GetActors(renderer)[0]);
  const auto count = [&]()
  {
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    EXPECT_EQ(picksFloor->Pick(100.0, 75.0, 0.0, renderer), 1);
    EXPECT_EQ(picksFloor->GetActor(), GetActors(renderer)[0]) << "the sphere is not in the list";
    // Without a list it comes last: a renderer keeps the list of the last picker.
    EXPECT_EQ(picker->Pick(100.0, 75.0, 0.0, renderer), 1);
    EXPECT_EQ(picker->GetActor(), GetActors(renderer)[1]);
    return selection->GetNumberOfNodes();
  };
  EXPECT_EQ(count(), 2u);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  EXPECT_EQ(count(), 2u);
  stage.Window->Render();
  EXPECT_GT(CountShadowed(GetMask(stage, pass)), 50);
}
