// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"
#include "Command.h"
#include "Images.h"
#include "Report.h"
#include "Walk.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
struct WalkCommandOptions
{
  ViewOptions View;
  WalkOptions Walk;
  std::string JSON;
  std::string SavePath;
};

int RunWalkCommand(WalkCommandOptions& options)
{
  std::vector<std::string>& modes = options.Walk.Modes;
  for (auto mode = modes.begin(); mode != modes.end();)
  {
    mode = std::find(modes.begin(), mode, *mode) == mode ? mode + 1 : modes.erase(mode);
  }
  if (options.Walk.Verify && std::find(modes.begin(), modes.end(), "none") == modes.end())
  {
    modes.emplace_back("none");
  }
  if (!options.Walk.ImageFolder.empty())
  {
    MakeFolder(options.Walk.ImageFolder);
  }
  CheckWritable(options.JSON);
  const NBufferExamples::Scene scene = options.View.LoadScene();
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 120);
  if (!options.SavePath.empty())
  {
    NBufferExamples::WriteCameraFile(path, options.SavePath);
  }
  Session& session = Session::New(scene, options.View.Window);
  for (const std::string& mode : modes)
  {
    const std::string why = Mode::WhyNot(mode);
    if (!why.empty())
    {
      throw std::runtime_error("mode " + mode + " cannot run here: " + why);
    }
  }
  options.Walk.Mode = options.View.Mode;
  options.Walk.Progress = ShowProgress;
  const WalkResult result = RunWalk(session, path, options.Walk);

  Json::Value report = options.View.Describe(scene, session);
  const Json::Value figures = MakeReport(result);
  for (const std::string& name : figures.getMemberNames())
  {
    report[name] = figures[name];
  }
  report["block"] = options.Walk.Block;
  std::cout << report["scene"].asString() << ", " << report["path"].asString() << ", "
            << report["size"].asString() << ", " << result.Frames << " frames, " << result.Props
            << " props, " << report["renderer"].asString() << ", VTK " << report["vtk"].asString()
            << "\n";
  PrintTable(report, std::cout);
  if (!options.Walk.ImageFolder.empty())
  {
    WriteChart(result,
      scene.Name + ", " + report["path"].asString() + " walk, " + report["size"].asString(),
      options.Walk.ImageFolder + "/frame-times");
  }
  if (!options.JSON.empty())
  {
    WriteJSON(report, options.JSON);
  }
  if (options.Walk.Verify)
  {
    const long long bytes = GetDifferingBytes(result);
    std::cout << result.VerifiedFrames << " frames compared with mode none, " << bytes
              << " bytes differ\n";
    return bytes == 0 ? Success : ImagesDiffer;
  }
  return Success;
}
}

void AddWalkCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand(
    "walk", "Time the frames of a camera path in several modes, interleaved in one run");
  auto options = std::make_shared<WalkCommandOptions>();
  options->View.Program = program;
  options->View.AddTo(*command);
  options->View.AddCullerTo(*command);
  command
    ->add_option("--modes", options->Walk.Modes,
      "stock: VTK's default culler; none: no culler; nbuffer: vtkNBufferCuller; oracle: exactly "
      "the props that own a pixel; queries, queries-conservative, queries-count: an occlusion "
      "query of the hardware for each prop, waited for; chc: coherent hierarchical culling by "
      "them. nbuffer also with settings of its own, such as nbuffer:RoundSize=16:BackOff=0")
    ->delimiter(',')
    ->check(CLI::Validator(
      [](std::string& name)
      {
        try
        {
          const Mode mode(name, ModeOptions());
        }
        catch (const std::runtime_error& error)
        {
          return std::string(error.what());
        }
        return std::string();
      },
      "MODE"))
    ->capture_default_str();
  command->add_option("--block", options->Walk.Block, "Timed frames of a mode in a row")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  command->add_flag(
    "--verify", options->Walk.Verify, "Compare every frame byte for byte with mode none");
  command->add_option("--json", options->JSON, "File for the figures");
  command->add_option("--images", options->Walk.ImageFolder,
    "Folder for the first, middle and last frame of each mode, frames that differ, and the chart "
    "of frame times");
  command->add_option("--save-path", options->SavePath, "Write the path as a camera file");
  command->callback([options, &run]() { run = [options]() { return RunWalkCommand(*options); }; });
}

} // namespace NBufferBench
