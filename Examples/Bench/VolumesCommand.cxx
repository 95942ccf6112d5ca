// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumesCommand.cxx
 * @brief The subcommand volumes: the paper's figures 5 (where the volume of one caster begins and
 * ends) and 7 (clamped volumes of a scene) as pictures, drawn from the volumes of the module.
 */
#include "Command.h"
#include "Panels.h"
#include "Report.h"
#include "ShadowScene.h"
#include "VolumeStudy.h"

#include "Parts.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkSphereSource.h"

#include <iostream>
#include <memory>

namespace NBufferBench
{
namespace
{
using NBufferExamples::AddPart;
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;
using NBufferExamples::Scene;
using Image = vtkSmartPointer<vtkImageData>;

/// One slab around all receivers of a caster, as in the paper, or several; by the litmap alone.
VolumeWay MakeWay(bool isOneSlab)
{
  VolumeWay way;
  way.Boxes = false;
  way.Tiles = false;
  way.Tuning.SlabGap = isOneSlab ? 64 : vtkShadowTuning().SlabGap;
  return way;
}

vtkSmartPointer<vtkActor> MakeActor(
  vtkPolyData* data, const glm::dvec3& color, double opacity = 1.0)
{
  const auto mapper = NBufferExamples::MakePartMapper(data);
  // Places that stand for infinity must not cost the others their digits.
  vtkOpenGLPolyDataMapper::SafeDownCast(mapper)->SetVBOShiftScaleMethod(
    vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetPointSize(2.0F);
  return actor;
}

const glm::dvec3 VolumeColor(0.95, 0.75, 0.05);

/// One of the configurations of figure 5.
struct Configuration
{
  const char* Name;
  const char* Caption;
  bool HidesCaster;
  bool HidesShadow;
  bool HasTable; ///< An occluder between the caster and the floor.
  bool IsOneSlab;
  bool IsNearestOnly; ///< A sample is a receiver only of the nearest caster that shadows it.
};
constexpr Configuration Configurations[] = { { "a", "(a) both are seen", false, false, false, true,
                                               false },
  { "b", "(b) the shadow is seen", true, false, false, true, false },
  { "c", "(c) the caster is seen", false, true, false, true, false },
  { "d", "(d) neither is seen", true, true, false, true, false },
  { "e", "(e) a table between", false, false, true, true, false },
  { "e, slabs", "(e) several slabs", false, false, true, false, false },
  { "e, nearest", "(e) nearest caster alone", false, false, true, true, true } };

/// From the side: x to the right, z up. The selected caster is the first actor.
Scene MakeConfiguration(const Configuration& configuration)
{
  Scene scene;
  scene.Name = "figure 5";
  vtkNew<vtkCubeSource> cube;
  const auto box = NBufferExamples::MakePartMapper(cube);
  const auto add = [&](const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& color)
  {
    vtkActor* actor = AddPart(scene, box, 0.5 * (low + high), high - low);
    actor->GetProperty()->SetColor(color.r, color.g, color.b);
    actor->GetProperty()->LightingOff(); // The lamp would leave what is seen from the side dark.
  };
  const glm::dvec3 grey(0.62);
  add({ 4.4, -0.5, 3.9 }, { 5.6, 0.5, 4.5 }, { 0.9, 0.55, 0.1 });
  add({ -0.5, -1.2, -0.2 }, { 9.5, 1.2, 0.0 }, grey);
  add({ 4.5, -0.6, 0.0 }, { 5.5, 0.6, 0.5 }, grey);
  if (configuration.HidesCaster)
  {
    add({ 1.2, -1.2, 2.6 }, { 1.3, 1.2, 3.4 }, grey);
  }
  if (configuration.HidesShadow)
  {
    add({ 1.2, -1.2, 0.0 }, { 1.3, 1.2, 1.75 }, grey);
  }
  if (configuration.HasTable)
  {
    add({ 3.4, -1.0, 1.4 }, { 6.6, 1.0, 1.5 }, grey);
  }
  return scene;
}

const glm::dvec3 Observer(-1.0, 0.0, 2.2);
const glm::dvec3 Lamp(5.0, 0.0, 9.0);

/// Draws what Run() found of a configuration from the side. The session keeps what is added.
Image DrawFromTheSide(
  Session& session, vtkPolyData* volumes, const std::vector<glm::dvec3>& receivers)
{
  vtkRenderer* renderer = session.GetRenderer();
  const auto addBall = [renderer](const glm::dvec3& place, const glm::dvec3& color)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.22);
    ball->SetCenter(place.x, place.y, place.z);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(24);
    ball->Update();
    renderer->AddActor(MakeActor(ball->GetOutput(), color));
  };
  addBall(Observer, { 0.1, 0.35, 0.8 });
  addBall(Lamp, { 0.95, 0.8, 0.1 });
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (const glm::dvec3& place : receivers)
  {
    // Towards the viewer, so that nothing hides them.
    const vtkIdType point = points->InsertNextPoint(place.x, place.y - 3.0, place.z);
    vertices->InsertNextCell({ point });
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->SetVerts(vertices);
  renderer->AddActor(MakeActor(cloud, { 0.8, 0.1, 0.1 }));
  renderer->AddActor(MakeActor(volumes, VolumeColor, 0.35));
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->GradientBackgroundOff();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(5.3);
  camera->SetPosition(4.2, -20.0, 4.6);
  camera->SetFocalPoint(4.2, 0.0, 4.6);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(1.0, 40.0);
  session.Render();
  return session.MakeImage(session.ReadPixels());
}

/// Draws a configuration, and adds the heights of its pieces to the report.
Image DrawConfiguration(const Configuration& configuration, Json::Value& report)
{
  const Scene scene = MakeConfiguration(configuration);
  SessionOptions options;
  options.Size = { 300, 280 };
  Session& session = Session::New(scene, options);
  session.GetRenderer()->RemoveAllLights();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(35.0);
  lamp->SetPosition(Lamp.x, Lamp.y, Lamp.z);
  lamp->SetFocalPoint(Lamp.x, Lamp.y, 0.0);
  session.GetRenderer()->AddLight(lamp);
  CameraPose pose;
  pose.Eye = Observer;
  pose.Target = { 5.0, 0.0, 2.2 };
  pose.Up = { 0.0, 0.0, 1.0 };
  pose.ViewAngle = 70.0;
  pose.Near = 0.1;
  pose.Far = 30.0;

  VolumeStudy study(session, nullptr);
  session.SetPose(pose);
  const CasterPixels nearest = study.FindNearestCasters(lamp);
  std::vector<glm::dvec3> receivers;
  std::vector<vtkShadowBlock> pieces;
  study.Run(pose,
    [&]()
    {
      receivers = study.GetReceivers();
      VolumeWay way = MakeWay(configuration.IsOneSlab);
      way.Only = configuration.IsNearestOnly ? &nearest : nullptr;
      study.Draw(way, [](int caster) { return caster == 0; });
      pieces = study.GetPieces();
    });
  Json::Value& entry = report["figure5"][configuration.Name];
  entry["pieces"] = Json::Value(Json::arrayValue);
  for (const vtkShadowBlock& piece : pieces)
  {
    Json::Value heights;
    heights.append(Round(piece.Low.z));
    heights.append(Round(piece.High.z));
    entry["pieces"].append(heights);
  }
  return DrawFromTheSide(session, study.GetVolumes(1e3), receivers);
}

/// Draws those with a table, or those without one.
Image DrawFigure5(bool hasTable, Json::Value& report)
{
  std::vector<Panel> panels;
  for (const Configuration& configuration : Configurations)
  {
    if (configuration.HasTable == hasTable)
    {
      panels.push_back({ DrawConfiguration(configuration, report), configuration.Caption });
    }
  }
  return ComposePanels(panels, 1.0);
}

struct VolumesOptions
{
  ViewOptions View;
  std::string Folder;
  std::string JSON;
};

/// Draws a frame with the volumes over it, and with the shadows.
Image DrawFigure7(const VolumesOptions& options)
{
  const std::string& name = options.View.SceneNames.front();
  const Scene scene = LoadShadowScene(options.View);
  const CameraPath path = options.View.MakePath(scene, 1);
  Session& session = Session::New(scene, options.View.Window);
  vtkRenderer* renderer = session.GetRenderer();
  LightScene(name, scene, path, renderer);
  const vtkSmartPointer<vtkInformation> keys = MarkCasters(scene);
  const CameraPose& pose = path.back();
  const double reach = 100.0 * scene.GetBounds().GetDiagonalLength();
  VolumeStudy study(session, keys);
  VolumeWay whole;
  whole.Mode = vtkShadowMode::Unclamped;
  const struct
  {
    const char* Caption;
    VolumeWay Way;
  } ways[] = { { "whole volumes", whole }, { "one slab", MakeWay(true) },
    { "several slabs", MakeWay(false) } };
  std::vector<Panel> panels;
  for (const auto& way : ways)
  {
    study.Run(pose, [&]() { study.Draw(way.Way); });
    // A layer of its own, in which nothing hides the volumes: what they fill is shown, as often as
    // they fill it.
    vtkNew<vtkRenderer> layer;
    layer->SetLayer(1);
    layer->SetActiveCamera(renderer->GetActiveCamera());
    layer->AddActor(MakeActor(study.GetVolumes(reach), VolumeColor, 0.12));
    session.GetWindow()->SetNumberOfLayers(2);
    session.GetWindow()->AddRenderer(layer);
    session.SetPose(pose);
    session.Render();
    panels.push_back({ session.MakeImage(session.ReadPixels()), way.Caption });
    session.GetWindow()->RemoveRenderer(layer);
  }
  vtkNew<vtkShadowVolumeClampPass> pass;
  pass->SetCasterKeys(keys);
  renderer->SetPass(pass);
  session.SetPose(pose);
  session.Render();
  panels.push_back({ session.MakeImage(session.ReadPixels()), "shadows" });
  renderer->SetPass(nullptr);
  return ComposePanels(panels, 1.0);
}

int RunVolumes(const VolumesOptions& options)
{
  MakeFolder(options.Folder);
  CheckWritable(options.JSON);
  Json::Value report;
  WritePNG(DrawFigure5(false, report), options.Folder + "/figure-5.png");
  WritePNG(DrawFigure5(true, report), options.Folder + "/figure-5-e.png");
  WritePNG(
    DrawFigure7(options), options.Folder + "/figure-7-" + options.View.SceneNames.front() + ".png");
  std::cout << report["figure5"] << "\n";
  WriteJSON(report, options.JSON);
  return Success;
}
}

void AddVolumesCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("volumes",
    "Draw the paper's figure 5, the extents of a shadow volume in five configurations, and figure "
    "7, the volumes of a scene");
  auto options = std::make_shared<VolumesOptions>();
  options->View.SceneNames = { "birds" };
  options->View.SceneHelp = "as those of shadow";
  options->View.Window.Size = { 320, 240 };
  options->View.AddTo(*command, program);
  command->add_option("--json", options->JSON, "File for the heights of the pieces of figure 5");
  command->add_option("--out", options->Folder, "Folder for the pictures")->required();
  command->callback([options, &run]() { run = [options]() { return RunVolumes(*options); }; });
}

} // namespace NBufferBench
