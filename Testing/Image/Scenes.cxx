// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "CompositeMapper.h"
#include "LightRig.h"
#include "SceneBuilder.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkTextureObject.h"

#include <cmath>
#include <random>

namespace Scenes
{
void GetColor(int index, double color[3])
{
  std::minstd_rand random(static_cast<unsigned int>(index) + 1);
  random.discard(3);
  for (int i = 0; i < 3; ++i)
  {
    color[i] = 0.2 + 0.8 * static_cast<double>(random() % 1000) / 999.0;
  }
}

int AddBox(Stage& stage, double x, double y, double z, double sx, double sy, double sz,
  vtkRenderer* renderer)
{
  const int index = static_cast<int>(stage.Props.size());
  double color[3];
  GetColor(index, color);
  stage.AddActor(MakeBox({ x, y, z }, { sx, sy, sz }), color, renderer);
  return index;
}

namespace
{
/// The props of a scenario, in colours of their own here.
void AddProps(Stage& stage, const TestScene::SceneBuilder& scene, vtkRenderer* renderer)
{
  for (const TestScene::Prop& prop : scene.Scene.Props)
  {
    double color[3];
    GetColor(static_cast<int>(stage.Props.size()), color);
    stage.AddActor(TestScene::MakeShape(prop.Shape), color, renderer)
      ->GetProperty()
      ->SetLighting(prop.Lighting);
  }
}
}

vtkSmartPointer<vtkActor> MakeTwoBlocks(
  vtkDataObject* first, vtkDataObject* second, double opacityOfSecond)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  if (opacityOfSecond < 1.0)
  {
    mapper->SetBlockOpacity(2, opacityOfSecond);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void BuildWall(Stage& stage)
{
  AddWall(stage, stage.GetRenderer());
}

void AddWall(Stage& stage, vtkRenderer* renderer)
{
  renderer->SetBackground(0.1, 0.2, 0.3);
  TestScene::SceneBuilder scene;
  scene.AddWall();
  AddProps(stage, scene, renderer);
  SetWallCamera(renderer);
}

void SetWallCamera(vtkRenderer* renderer, double shift)
{
  const TestScene::View view = TestScene::SceneBuilder().LookAtWall(shift);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(glm::value_ptr(view.Position));
  camera->SetFocalPoint(glm::value_ptr(view.FocalPoint));
  camera->SetViewUp(glm::value_ptr(view.ViewUp));
  renderer->ResetCameraClippingRange();
}

void AddTranslucentBoxes(Stage& stage)
{
  for (int i = 0; i < 8; ++i)
  {
    const int index =
      AddBox(stage, -5.0 + 1.4 * i, 0.3 * i - 1.0, i % 2 ? 3.0 : -4.0, 1.8, 1.6, 0.7);
    stage.GetActor(index)->GetProperty()->SetOpacity(0.4);
  }
}

void SetSpotLight(Stage& stage)
{
  stage.GetRenderer()->RemoveAllLights();
  stage.GetRenderer()->AddLight(TestScene::MakeLight(
    TestScene::SceneBuilder().Spot({ 8.0, 9.0, 14.0 }, glm::dvec3(0.0), 60.0)));
}

void BuildCity(Stage& stage, int count, vtkRenderer* renderer)
{
  vtkRenderer* target = renderer ? renderer : stage.GetRenderer();
  target->SetBackground(0.5, 0.7, 0.9);
  const double extent = 12.0 * count;
  AddBox(stage, 0.5 * extent, 0.5 * extent, -0.5, 1.2 * extent, 1.2 * extent, 1.0, target);
  std::mt19937 random(17);
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      const double height = 3.0 + 0.02 * static_cast<double>(random() % 700);
      AddBox(stage, 12.0 * i + 6.0, 12.0 * j + 6.0, 0.5 * height, 8.0, 8.0, height, target);
    }
  }
  SetCityCamera(target, 0.0);
}

void SetCityCamera(vtkRenderer* renderer, double t)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double angle = 0.8 * std::sin(7.0 * t);
  const double position[3] = { 24.0 + 0.5 * std::sin(20.0 * t), 1.0 + 100.0 * t, 1.7 };
  camera->SetPosition(position);
  camera->SetFocalPoint(
    position[0] + std::sin(angle), position[1] + std::cos(angle), position[2] + 0.05);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(60.0);
  renderer->ResetCameraClippingRange();
}

int AddQuad(Stage& stage, double x0, double y0, double x1, double y1, double z, int cells)
{
  TestScene::SceneBuilder scene;
  scene.Quad(x0, y0, x1, y1, z, cells);
  AddProps(stage, scene, stage.GetRenderer());
  return static_cast<int>(stage.Props.size()) - 1;
}

int MoveTheDoorBeforeTies(
  unsigned int seed, int frames, const Comparison::Change& set, ComparisonOptions options)
{
  SCOPED_TRACE(seed);
  options.Tuning.RoundSize = 5;
  int door = 0;
  int redrawn = 0;
  Comparison comparison(
    [&](Stage& stage)
    {
      TestScene::SceneBuilder scene;
      door = scene.AddTies(seed, true);
      AddProps(stage, scene, stage.GetRenderer());
      stage.GetRenderer()->GetActiveCamera()->SetPosition(0.0, 0.0, 15.0);
      stage.GetRenderer()->ResetCameraClippingRange();
      set(stage);
    },
    options);
  for (int i = 0; i < frames; ++i)
  {
    comparison.Frame([i, door](Stage& stage)
      { stage.GetActor(door)->SetPosition(2.5 * (i % 4) - 4.0, 0.0, 0.0); });
    redrawn += comparison.GetStatistics().Redrawn;
  }
  return redrawn;
}

ComparisonOptions MakeExactOptions(int width, int height, int baseFactor)
{
  ComparisonOptions options;
  options.Width = width;
  options.Height = height;
  options.KeepDefaultCuller = false;
  options.Tuning.BaseFactor = baseFactor;
  options.Tuning.MinimumNumberOfCandidates = 1;
  options.Tuning.ReuseWhenStill = false;
  return options;
}

void SetPixelCamera(vtkRenderer* renderer, int width, int height, double shiftX, double shiftY)
{
  const double x = 0.5 * width + shiftX;
  const double y = 0.5 * height + shiftY;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
  camera->SetPosition(x, y, 100.0);
  camera->SetFocalPoint(x, y, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 201.0);
}

void SetDepthFormat(Stage& stage, int format)
{
  stage.Window->Render(); // makes the framebuffers
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
  const int* size = window->GetSize();
  vtkNew<vtkTextureObject> depth;
  depth->SetContext(window);
  depth->SetSamples(window->GetMultiSamples());
  depth->SetMinificationFilter(vtkTextureObject::Nearest);
  depth->SetMagnificationFilter(vtkTextureObject::Nearest);
  ASSERT_TRUE(depth->AllocateDepth(size[0], size[1], format));
  window->GetState()->PushFramebufferBindings();
  window->GetRenderFramebuffer()->Bind();
  window->GetRenderFramebuffer()->AddDepthAttachment(depth);
  window->GetState()->PopFramebufferBindings();
}

void MoveWallCamera(Comparison& comparison, double shift)
{
  comparison.Both([shift](Stage& stage) { SetWallCamera(stage.GetRenderer(), shift); });
}

void FrameOfWall(Comparison& comparison, double shift, const std::string& what)
{
  MoveWallCamera(comparison, shift);
  comparison.Frame(what);
}

void FramesOfWall(Comparison& comparison, std::initializer_list<double> shifts)
{
  for (const double shift : shifts)
  {
    FrameOfWall(comparison, shift);
  }
}

void ExpectFramesOfWall(Comparison& comparison, std::initializer_list<double> shifts, int hidden)
{
  for (const double shift : shifts)
  {
    FrameOfWall(comparison, shift);
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled) << "shifted by " << shift;
    EXPECT_GE(comparison.GetHidden(), hidden) << "shifted by " << shift;
  }
}

void ExpectStepsAside(
  Comparison& comparison, std::initializer_list<double> shifts, Decision decision)
{
  for (const double shift : shifts)
  {
    FrameOfWall(comparison, shift);
    EXPECT_EQ(comparison.GetDecision(), decision) << "shifted by " << shift;
    EXPECT_EQ(comparison.GetHidden(), 0) << "shifted by " << shift;
  }
}

void MoveCityCamera(Comparison& comparison, double t)
{
  comparison.Both([t](Stage& stage) { SetCityCamera(stage.GetRenderer(), t); });
}

void FrameOfCity(Comparison& comparison, double t, const std::string& what)
{
  MoveCityCamera(comparison, t);
  comparison.Frame(what);
}

void ExpectOneWarning(const std::string& messages, const std::vector<std::string>& words)
{
  const std::string beginning = "vtkNBufferCuller draws everything";
  const std::size_t first = messages.find(beginning);
  EXPECT_NE(first, std::string::npos) << messages;
  EXPECT_EQ(messages.find(beginning, first + 1), std::string::npos) << messages;
  for (const std::string& word : words)
  {
    EXPECT_NE(messages.find(word), std::string::npos) << messages;
  }
}

void ExpectFailure(const Comparison::Change& build, ComparisonOptions options, Decision failure,
  const std::vector<std::string>& words)
{
  options.KeepMessages = true;
  Comparison comparison(build, options);
  for (int i = 0; i < 4; ++i)
  {
    FrameOfWall(comparison, 0.01 * i);
    EXPECT_EQ(comparison.GetDecision(), failure);
    EXPECT_EQ(comparison.GetHidden(), 0);
    // The first frame's list has been through VTK's own culler.
    EXPECT_EQ(comparison.GetStatistics().GetNumberOfPropsDrawn(),
      comparison.GetStatistics().Props - comparison.GetStatistics().GetCount(Verdict::Outside));
    EXPECT_EQ(comparison.GetStatistics().FailedFrames, i + 1);
  }
  ExpectOneWarning(comparison.Messages, words);
}

void Settle(Comparison& comparison)
{
  // The first frame draws the nearest props, the second finds out which of them are hidden, the
  // third holds those back.
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("settling");
  }
}
}
