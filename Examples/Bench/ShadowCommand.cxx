// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCommand.cxx
 * @brief The subcommand shadow: fragments, times and errors of shadows, by mode.
 */
#include "Command.h"
#include "ModeSettings.h"
#include "Report.h"
#include "ShadowMode.h"
#include "ShadowScene.h"
#include "ShadowWalk.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkShadowVolumeClampPass.h"

#include <iostream>
#include <map>
#include <memory>
#include <sstream>

namespace NBufferBench
{
namespace
{
struct ShadowCommandOptions
{
  ViewOptions View;
  ShadowWalkOptions Walk;
  bool GroundCasts = false;
  bool Culler = true;
  /// Empty: the lamp of the scene.
  std::vector<double> Lamp;
  std::string JSON;
};

/// Returns what is printed of a mode behind its times.
std::string DescribeMode(const Json::Value& mode)
{
  std::ostringstream text;
  if (mode.isMember("fragments"))
  {
    text << ", " << mode["fragments"].asInt64() << " fragments";
  }
  if (mode.isMember("fragments_percent"))
  {
    text << " (" << mode["fragments_percent"].asDouble() << " % of unclamped)";
  }
  const Json::Value& device = mode["statistics"]["device_milliseconds"];
  if (device.isObject() && device["color"].asDouble() >= 0.0)
  {
    text << ", device: depth " << device["depth"].asDouble() << ", draw "
         << device["draw"].asDouble() << ", color " << device["color"].asDouble() << " ms";
  }
  if (mode.isMember("oracle"))
  {
    const Json::Value& oracle = mode["oracle"];
    text << ", " << oracle["wrong"].asInt64() << " wrong and " << oracle["ambiguous"].asInt64()
         << " ambiguous of " << oracle["samples"].asInt64() << " samples, "
         << oracle["shadowed"].asInt64() << " in shadow";
  }
  return text.str();
}

int RunShadowCommand(ShadowCommandOptions& options)
{
  for (const std::string& name : options.Walk.Modes)
  {
    ShadowMode(name, vtkNew<vtkShadowVolumeClampPass>()); // Throws if there is no such mode.
  }
  RemoveRepeated(options.Walk.Modes);
  if (!options.Walk.ImageFolder.empty())
  {
    MakeFolder(options.Walk.ImageFolder);
  }
  CheckWritable(options.JSON);
  const std::string& name = options.View.SceneNames.front();
  const SpotLamp lamp = options.Lamp.empty() ? SpotLamp() : ReadLamp(name, options.Lamp);
  const NBufferExamples::Scene scene = LoadShadowScene(options.View);
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 30);
  Session& session = Session::New(scene, options.View.Window);
  vtkLight* light = LightScene(name, scene, path, session.GetRenderer(), lamp);
  if (options.Culler)
  {
    session.GetRenderer()->AddCuller(vtkNew<vtkNBufferCuller>());
  }
  if (!options.GroundCasts)
  {
    options.Walk.CasterKeys = MarkCasters(scene);
  }
  Json::Value report = RunShadowWalk(session, light, path, options.Walk);
  options.View.Describe(scene, session, report);
  report["scene"] = name == "city-sun" || name == "city-spot" ? name : scene.Name;
  report["props"] = static_cast<Json::UInt64>(scene.Actors.size());
  report["culler"] = options.Culler;
  report["ground_casts"] = options.Walk.CasterKeys == nullptr;
  if (name == "city-spot")
  {
    for (const double number : { lamp.Offset[0], lamp.Offset[1], lamp.Offset[2], lamp.ConeAngle })
    {
      report["lamp"].append(number);
    }
  }
  PrintModes(report, options.Walk.Modes, std::cout, DescribeMode);
  if (report.isMember("shadowed"))
  {
    std::cout << "pixels that shadows change, and that each need a fragment: "
              << report["shadowed"].asInt64() << " a frame\n";
  }
  WriteJSON(report, options.JSON);
  return report["wrong_samples"].asInt64() > 0 ? ImagesDiffer : Success;
}
}

void AddShadowCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("shadow",
    "Time shadows in several modes, interleaved in one run, and count what the volumes cover");
  auto options = std::make_shared<ShadowCommandOptions>();
  options->View.SceneNames = { "city-sun" };
  options->View.SceneHelp =
    "city-sun, city-spot, birds, towers (both synthetic), swarm (10000 glyphs), "
    "simple, or a file that walk knows";
  options->View.Window.Size = { 640, 480 };
  options->View.AddTo(*command, program);
  command
    ->add_option("--modes", options->Walk.Modes,
      "none; of vtkShadowVolumeClampPass unclamped, cull (whole volumes of casters with "
      "receivers), exact (in boxes around these), auto (unclamped or exact), clamp (exact, one "
      "slab), slabs, paper (clamp with litmaps drawn from the light, which lose shadows); vtk: "
      "vtkShadowMapPass; exact@64: with a litmap of 64 x 64, vtk@64 with such "
      "maps; those of volumes and vtk also with settings of their own, such as auto:BoxCost=16, "
      "slabs@64:SlabGap=2, vtk@1024:Exponent=80:OffsetFactor=4:OffsetUnits=4:EachFrame=1 (draws "
      "the map anew for each frame)")
    ->delimiter(',')
    ->capture_default_str();
  command->add_flag("--oracle", options->Walk.Oracle,
    "Compare the first, middle and last frame with rays in double precision");
  command->add_flag("--oracle-once", options->Walk.OracleOnce, "Of these the middle frame alone");
  command->add_flag("--device-times", options->Walk.DeviceTimes,
    "Measure how long the graphics device takes for depth, volumes and colours");
  command->add_option("--block", options->Walk.Block, "Timed frames of a mode in a row")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  command->add_flag("--ground-caster", options->GroundCasts,
    "In vtkShadowVolumeClampPass ground and streets cast, too, which is its default; without this "
    "option they only receive shadows (the parts of a file are not distinguished)");
  command
    ->add_option("--lamp", options->Lamp,
      "x,y,z,cone: where the spot of city-spot hangs, in metres from the place on the street that "
      "it shines on, and the degrees from its axis to its edge; 25,-25,120,20 if not given")
    ->delimiter(',')
    ->expected(4);
  command->add_flag("!--no-culler", options->Culler, "All modes without vtkNBufferCuller");
  command->add_option("--json", options->JSON, "File for the figures");
  command->add_option(
    "--images", options->Walk.ImageFolder, "Folder for the middle frame of each mode");
  const std::map<std::string, int> views = { { "litmaps", vtkShadowVolumeClampPass::Litmaps },
    { "extents", vtkShadowVolumeClampPass::Extents },
    { "volumes", vtkShadowVolumeClampPass::Volumes },
    { "counts", vtkShadowVolumeClampPass::Counts } };
  command
    ->add_option("--view", options->Walk.DebugView,
      "Lay litmaps, extents, volumes or counts over the images of vtkShadowVolumeClampPass")
    ->transform(CLI::Transformer(views));
  command->callback(
    [options, &run]() { run = [options]() { return RunShadowCommand(*options); }; });
}

} // namespace NBufferBench
