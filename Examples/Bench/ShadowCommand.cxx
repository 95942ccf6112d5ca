// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCommand.cxx
 * @brief Fragments, times and errors of shadows, by mode.
 *
 *     renderer, window, vtk, scene, path, size, samples, seed, frames, props, block, litmap,
 *     ground_casts, all_receivers; lamp: place and cone angle of the spot of city-spot
 *     modes.NAME              median_ms, p10_ms, p90_ms, frames_ms
 *     shadowed                pixels that shadows change (mean of all frames): no mode can have
 *                             fewer fragments
 *     modes.(volumes)         also fragments (mean of all frames), fragments_percent (of mode
 *                             unclamped) and statistics: the members of vtkShadowStatistics, each
 *                             the median over the timed frames; device_milliseconds are -1
 *                             without --device-times and without timers
 *     modes.NAME.oracle       only with --oracle: samples compared with rays; shadowed: those in
 *                             shadow by rays; wrong: those that differ and are not ambiguous;
 * ambiguous: those that differ and are; wrong_places: [frame, x, y] of the first wrong ones
 *     ratios.A/B              median over the frames of (ms of mode A) / (ms of mode B)
 */
#include "Chart.h"
#include "Command.h"
#include "Images.h"
#include "ModeSettings.h"
#include "Report.h"
#include "ShadowMode.h"
#include "ShadowScene.h"
#include "ShadowWalk.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkShadowVolumeClampPass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>

namespace NBufferBench
{
namespace
{
struct ShadowCommandOptions
{
  ViewOptions View;
  ShadowWalkOptions Walk;
  bool GroundCasts = false;
  bool AllReceivers = false;
  bool Culler = true;
  /// Empty: that of the scene.
  std::vector<double> Lamp;
  std::string JSON;
};

Json::Value MakeModeReport(const ShadowWalkResult& result, const std::string& name)
{
  const ModeResult& mode = result.Walk.Modes.at(name);
  Json::Value report = SummarizeTimes(mode);
  const auto fragments = result.Fragments.find(name);
  if (fragments != result.Fragments.end())
  {
    const auto frames = static_cast<double>(result.Walk.Frames);
    report["fragments"] =
      static_cast<Json::Int64>(std::llround(static_cast<double>(fragments->second) / frames));
    const auto all = result.Fragments.find("unclamped");
    if (all != result.Fragments.end() && all->second > 0)
    {
      report["fragments_percent"] =
        Round(100.0 * static_cast<double>(fragments->second) / static_cast<double>(all->second));
    }
  }
  if (!mode.Statistics.empty())
  {
    std::vector<Json::Value> frames;
    std::transform(
      mode.Statistics.begin(), mode.Statistics.end(), std::back_inserter(frames), Parse);
    report["statistics"] = GetMedian(frames);
    report["statistics"].removeMember("fragments");
  }
  const auto counts = result.Oracle.find(name);
  if (counts != result.Oracle.end())
  {
    Json::Value& oracle = report["oracle"];
    oracle["samples"] = static_cast<Json::Int64>(counts->second.Samples);
    oracle["shadowed"] = static_cast<Json::Int64>(counts->second.Shadowed);
    oracle["wrong"] = static_cast<Json::Int64>(counts->second.Wrong);
    oracle["ambiguous"] = static_cast<Json::Int64>(counts->second.Ambiguous);
    for (const auto& place : counts->second.Places)
    {
      Json::Value pixel(Json::arrayValue);
      for (const int value : place)
      {
        pixel.append(value);
      }
      oracle["wrong_places"].append(pixel);
    }
  }
  return report;
}

void AddRatio(
  const WalkResult& walk, const std::string& a, const std::string& b, Json::Value& ratios)
{
  const auto first = walk.Modes.find(a);
  const auto second = walk.Modes.find(b);
  if (a != b && first != walk.Modes.end() && second != walk.Modes.end())
  {
    ratios[a + "/" + b] = Round(GetMedianRatio(first->second, second->second));
  }
}

void PrintShadowTable(
  const Json::Value& report, const std::vector<std::string>& names, std::ostream& out)
{
  char line[256];
  const auto longest = std::max_element(names.begin(), names.end(),
    [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
  const int width = longest == names.end() ? 0 : static_cast<int>(longest->size());
  std::snprintf(line, sizeof(line), "%12s%9s%9s%12s%9s%12s%8s\n", "median ms", "p10", "p90",
    "fragments", "%", "unclamped/", "/none");
  out << std::left << std::setw(width) << "mode" << line;
  const Json::Value& ratios = report["ratios"];
  for (const std::string& name : names)
  {
    const Json::Value& mode = report["modes"][name];
    const auto format = [](const char* how, const Json::Value& value)
    {
      char text[32] = "-";
      if (!value.isNull())
      {
        std::snprintf(text, sizeof(text), how, value.asDouble());
      }
      return std::string(text);
    };
    std::snprintf(line, sizeof(line), "%12.2f%9.2f%9.2f%12s%9s%12s%8s",
      mode["median_ms"].asDouble(), mode["p10_ms"].asDouble(), mode["p90_ms"].asDouble(),
      format("%.0f", mode["fragments"]).c_str(), format("%.2f", mode["fragments_percent"]).c_str(),
      format("%.2f", ratios["unclamped/" + name]).c_str(),
      format("%.2f", ratios[name + "/none"]).c_str());
    out << std::setw(width) << name << line;
    const Json::Value& device = mode["statistics"]["device_milliseconds"];
    if (device["color"].asDouble() >= 0.0 && device.isObject())
    {
      std::snprintf(line, sizeof(line), "   device: depth %.2f, draw %.2f, color %.2f ms",
        device["depth"].asDouble(), device["draw"].asDouble(), device["color"].asDouble());
      out << line;
    }
    if (mode.isMember("oracle"))
    {
      const Json::Value& oracle = mode["oracle"];
      out << "   " << oracle["wrong"].asInt64() << " wrong and " << oracle["ambiguous"].asInt64()
          << " ambiguous of " << oracle["samples"].asInt64() << ", " << oracle["shadowed"].asInt64()
          << " in shadow";
    }
    out << "\n";
  }
}

/// The chart has a line for each kind of shadows, not for each resolution.
WalkResult GetCharted(const WalkResult& walk)
{
  WalkResult charted;
  charted.Frames = walk.Frames;
  for (const std::string& name : walk.Names)
  {
    if (name.find('@') == std::string::npos)
    {
      // As Chart.cxx calls it.
      charted.Names.push_back(name == "none" ? "no shadows" : name);
      charted.Modes[charted.Names.back()] = walk.Modes.at(name);
    }
  }
  return charted;
}

bool IsWrong(const ShadowWalkResult& result)
{
  return std::any_of(result.Oracle.begin(), result.Oracle.end(), [&](const auto& counts)
    { return counts.second.Wrong > 0 && ShadowMode::IsExact(counts.first); });
}

int RunShadowCommand(ShadowCommandOptions& options)
{
  std::vector<std::string>& modes = options.Walk.Modes;
  for (auto mode = modes.begin(); mode != modes.end();)
  {
    mode = std::find(modes.begin(), mode, *mode) == mode ? mode + 1 : modes.erase(mode);
  }
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
    vtkNew<vtkNBufferCuller> culler;
    session.GetRenderer()->AddCuller(culler);
  }
  if (!options.GroundCasts)
  {
    options.Walk.CasterKeys = MarkCasters(name, scene);
  }
  options.Walk.SkipUnlitReceivers = !options.AllReceivers;
  options.Walk.Progress = ShowProgress;
  const ShadowWalkResult result = RunShadowWalk(session, light, path, options.Walk);

  Json::Value report = options.View.Describe(scene, session);
  report["scene"] = name == "city-sun" || name == "city-spot" ? name : scene.Name;
  report["frames"] = static_cast<Json::UInt64>(path.size());
  report["props"] = static_cast<Json::UInt64>(scene.Actors.size());
  report["culler"] = options.Culler;
  report["ground_casts"] = options.Walk.CasterKeys == nullptr;
  report["all_receivers"] = options.AllReceivers;
  if (name == "city-spot")
  {
    for (const double number : { lamp.Offset[0], lamp.Offset[1], lamp.Offset[2], lamp.ConeAngle })
    {
      report["lamp"].append(number);
    }
  }
  report["block"] = options.Walk.Block;
  report["litmap"] = options.Walk.Litmap;
  report["box_cost"] = options.Walk.BoxCost;
  if (result.Shadowed >= 0)
  {
    report["shadowed"] =
      static_cast<Json::Int64>(result.Shadowed / static_cast<long long>(path.size()));
  }
  report["ratios"] = Json::Value(Json::objectValue);
  for (const std::string& mode : result.Walk.Names)
  {
    report["modes"][mode] = MakeModeReport(result, mode);
    AddRatio(result.Walk, "unclamped", mode, report["ratios"]);
    AddRatio(result.Walk, mode, "none", report["ratios"]);
    AddRatio(result.Walk, mode, GetModeKind(mode), report["ratios"]); // Of a setting.
  }
  std::cout << report["scene"].asString() << ", " << report["path"].asString() << ", "
            << report["size"].asString() << ", " << path.size() << " frames, "
            << scene.Actors.size() << " props, litmaps of " << options.Walk.Litmap << ", "
            << report["renderer"].asString() << ", VTK " << report["vtk"].asString() << "\n";
  PrintShadowTable(report, result.Walk.Names, std::cout);
  if (report.isMember("shadowed"))
  {
    std::cout << "pixels that shadows change, and that each need a fragment: "
              << report["shadowed"].asInt64() << " a frame\n";
  }
  if (!options.Walk.ImageFolder.empty())
  {
    WriteChart(GetCharted(result.Walk),
      report["scene"].asString() + ", shadows, " + report["size"].asString(),
      options.Walk.ImageFolder + "/shadow-times");
  }
  if (!options.JSON.empty())
  {
    WriteJSON(report, options.JSON);
  }
  return IsWrong(result) ? ImagesDiffer : Success;
}

void CheckModes(const std::vector<std::string>& names)
{
  vtkNew<vtkShadowVolumeClampPass> volumes;
  for (const std::string& name : names)
  {
    ShadowMode(name, 1, volumes);
  }
}
}

void AddShadowCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("shadow",
    "Time shadows in several modes, interleaved in one run, and count what the volumes cover");
  auto options = std::make_shared<ShadowCommandOptions>();
  options->View.Program = program;
  options->View.SceneNames = { "city-sun" };
  options->Walk.BoxCost = vtkNew<vtkShadowVolumeClampPass>()->GetBoxCost();
  options->View.SceneHelp = "city-sun, city-spot, birds (synthetic), simple, or a file that walk "
                            "knows";
  options->View.Window.Width = 640;
  options->View.Window.Height = 480;
  options->View.AddTo(*command);
  command
    ->add_option("--modes", options->Walk.Modes,
      "none; of vtkShadowVolumeClampPass unclamped, cull (whole volumes of casters with "
      "receivers), exact (in boxes around these), auto (unclamped or exact), clamp (exact, one "
      "slab), slabs, slabslit (slabs, with SkipUnlitReceivers), paper (clamp with litmaps "
      "drawn from the light, which lose shadows); vtk: vtkShadowMapPass; exact@64: with a litmap "
      "of 64 x 64, vtk@64 with such maps; those of volumes also with settings of their own, such "
      "as auto:BoxCost=16, slabs@64:SlabGap=2")
    ->delimiter(',')
    ->capture_default_str();
  command->add_option("--litmap", options->Walk.Litmap, "Lexels along each side of the litmaps")
    ->check(CLI::Range(1, 4096))
    ->capture_default_str();
  command
    ->add_option("--box-cost", options->Walk.BoxCost,
      "Pixels that one more box around a caster's receivers has to leave out")
    ->check(CLI::Range(0, 1000000000))
    ->capture_default_str();
  command->add_flag("--oracle", options->Walk.Oracle,
    "Compare the first, middle and last frame with rays in double precision");
  command->add_flag("--device-times", options->Walk.DeviceTimes,
    "Measure how long the graphics device takes for depth, volumes and colours");
  command->add_option("--block", options->Walk.Block, "Timed frames of a mode in a row")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  command->add_flag("--ground-caster", options->GroundCasts,
    "In vtkShadowVolumeClampPass ground and streets cast, too, which is its default; without this "
    "they only receive shadows (those of files are not told apart)");
  command->add_flag("--all-receivers", options->AllReceivers,
    "In cull, exact, clamp and slabs all that is seen receives shadows, which is the default of "
    "vtkShadowVolumeClampPass; without this only what faces the light does (SkipUnlitReceivers), "
    "which changes no picture. auto and unclamped have that default");
  command
    ->add_option("--lamp", options->Lamp,
      "x,y,z,cone: where the spot of city-spot hangs, in metres from the place on the street that "
      "it shines on, and the degrees from its axis to its edge; 25,-25,120,20 if not given")
    ->delimiter(',')
    ->expected(4);
  command->add_flag("!--no-culler", options->Culler, "All modes without vtkNBufferCuller");
  command->add_option("--json", options->JSON, "File for the figures");
  command->add_option("--images", options->Walk.ImageFolder,
    "Folder for the middle frame of each mode and the chart of frame times");
  const std::map<std::string, int> views = { { "litmaps", vtkShadowVolumeClampPass::Litmaps },
    { "extents", vtkShadowVolumeClampPass::Extents },
    { "volumes", vtkShadowVolumeClampPass::Volumes },
    { "counts", vtkShadowVolumeClampPass::Counts } };
  command
    ->add_option("--view", options->Walk.DebugView,
      "Lay litmaps, extents, volumes or counts over the images of vtkShadowVolumeClampPass")
    ->transform(CLI::Transformer(views));
  command->callback(
    [options, &run]()
    {
      run = [options]()
      {
        CheckModes(options->Walk.Modes);
        return RunShadowCommand(*options);
      };
    });
}

} // namespace NBufferBench
