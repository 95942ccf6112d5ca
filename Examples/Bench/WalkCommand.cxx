// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WalkCommand.cxx
 * @brief The subcommands walk, which times a camera path in several modes, first, which times the
 * first image of the process, and defaults, which prints the defaults of settings.
 */
#include "Command.h"
#include "FirstFrames.h"
#include "ModeSettings.h"
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"
#include "Walk.h"

#include "vtkProp.h"

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
  int Nearest = 0;        ///< 0: all props are visible.
  int FragmentFrames = 0; ///< Frames in which fragments are counted.
  int FirstFrames = 0;    ///< Runs of each mode in new windows; 0: a walk.
};

/// Leaves only the nearest props in view of a pose visible.
void ShowNearest(Session& session, const NBufferExamples::CameraPose& pose, int count)
{
  using NBufferStudy::DepthBox;
  std::vector<DepthBox> boxes = CollectFrames(session, { pose }).front().Boxes;
  std::stable_sort(boxes.begin(), boxes.end(),
    [](const DepthBox& a, const DepthBox& b) { return a.Screen.Nearest < b.Screen.Nearest; });
  if (static_cast<std::size_t>(count) > boxes.size())
  {
    throw std::runtime_error("there are only " + std::to_string(boxes.size()) + " props in view");
  }
  const std::vector<vtkProp*> props = session.GetProps();
  for (vtkProp* prop : props)
  {
    prop->VisibilityOff();
  }
  for (int i = 0; i < count; ++i)
  {
    props[static_cast<std::size_t>(boxes[static_cast<std::size_t>(i)].Prop)]->VisibilityOn();
  }
}

/// Measures the first frames of new windows instead of a walk in one window.
int RunFirstFramesCommand(const WalkCommandOptions& options)
{
  FirstFramesOptions first;
  const NBufferExamples::Scene scene = options.View.LoadScene();
  first.Path = options.View.MakePath(scene, 30);
  if (first.Path.size() < 12)
  {
    throw std::runtime_error("--first-frames compares frames 1 to 10 with those that follow, so "
                             "that --frames is to be at least 12");
  }
  for (const std::string& mode : options.Walk.Modes)
  {
    // The default of --modes has others, too, which know every frame of a walk.
    if (GetModeKind(mode) == "nbuffer")
    {
      first.Modes.push_back(mode);
    }
  }
  if (first.Modes.empty())
  {
    throw std::runtime_error(
      "--first-frames compares stock with modes nbuffer, and --modes has none");
  }
  first.LoadScene = [&options]() { return options.View.LoadScene(); };
  first.Window = options.View.Window;
  first.Backend = options.View.Backend;
  first.Runs = options.FirstFrames;
  Json::Value report = RunFirstFrames(first);
  options.View.Describe(scene, Session::New(scene, options.View.Window), report);
  PrintFirstFrames(report, std::cout);
  WriteJSON(report, options.JSON);
  return Success;
}

int RunWalkCommand(WalkCommandOptions& options)
{
  std::vector<std::string>& modes = options.Walk.Modes;
  RemoveRepeated(modes);
  if (options.Walk.Verify && std::find(modes.begin(), modes.end(), "none") == modes.end())
  {
    modes.emplace_back("none");
  }
  if (!options.Walk.ImageFolder.empty())
  {
    MakeFolder(options.Walk.ImageFolder);
  }
  CheckWritable(options.JSON);
  if (options.FirstFrames > 0)
  {
    return RunFirstFramesCommand(options);
  }
  const NBufferExamples::Scene scene = options.View.LoadScene();
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 120);
  Session& session = Session::New(scene, options.View.Window);
  for (const std::string& mode : modes)
  {
    const std::string why = Mode::WhyNot(mode);
    if (!why.empty())
    {
      throw std::runtime_error("mode " + mode + " cannot run here: " + why);
    }
  }
  if (options.FragmentFrames > 0 && path.size() < 3)
  {
    throw std::runtime_error("--fragments counts in frames that follow others, so that --frames is "
                             "to be at least 3");
  }
  if (options.Nearest > 0)
  {
    ShowNearest(session, path.front(), options.Nearest);
  }
  options.Walk.Backend = options.View.Backend;
  Json::Value report = RunWalk(session, path, options.Walk);
  if (options.FragmentFrames > 0)
  {
    report["fragments"] = MeasureFragments(session, path, modes, options.FragmentFrames);
  }
  options.View.Describe(scene, session, report);
  report["props"] = options.Nearest > 0 ? options.Nearest : report["props"].asInt();
  PrintModes(report, modes, std::cout,
    [](const Json::Value& mode)
    {
      const std::string bytes = mode["differing_bytes"].asString();
      const std::string units =
        mode["units"].isNull() ? "" : ", " + std::to_string(mode["units"].asInt()) + " units drawn";
      return ", " + std::to_string(mode["drawn"].asInt()) + " props drawn" + units +
        (bytes.empty() || bytes == "0" ? "" : ", " + bytes + " bytes differ");
    });
  WriteJSON(report, options.JSON);
  if (!options.Walk.Verify)
  {
    return Success;
  }
  std::cout << report["verified_frames"].asInt() << " frames compared with mode none, "
            << report["differing_bytes"].asInt64() << " bytes differ\n";
  return report["differing_bytes"].asInt64() == 0 ? Success : ImagesDiffer;
}

std::string CheckMode(std::string& name)
{
  try
  {
    const Mode mode(name);
    return std::string();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

struct FirstOptions
{
  ViewOptions View;
  std::string Mode = "nbuffer";
  std::string JSON;
};

int RunFirst(const FirstOptions& options)
{
  CheckWritable(options.JSON);
  const NBufferExamples::Scene scene = options.View.LoadScene();
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 1);
  Session& session = Session::New(scene, options.View.Window);
  Mode mode(options.Mode, options.View.Backend);
  mode.Enter(session.GetRenderer());
  session.SetPose(path.front());
  Json::Value report;
  report["mode"] = mode.GetName();
  report["first_image_ms"] = session.Render();
  report["drawn"] = session.GetRenderer()->GetNumberOfPropsRendered();
  report["props"] = static_cast<Json::UInt64>(scene.Actors.size());
  options.View.Describe(scene, session, report);
  std::cout << options.Mode << ": first image " << report["first_image_ms"].asDouble() << " ms\n";
  WriteJSON(report, options.JSON);
  return Success;
}
}

void AddWalkCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand(
    "walk", "Time the frames of a camera path in several modes, interleaved in one run");
  auto options = std::make_shared<WalkCommandOptions>();
  options->View.AddTo(*command, program);
  options->View.AddCullerTo(*command);
  command
    ->add_option("--modes", options->Walk.Modes,
      "stock: VTK's default culler; none: no culler; nbuffer: vtkNBufferCuller; oracle: exactly "
      "the props (of large props, the units) that own a pixel; in-view: exactly those in the view "
      "frustum; same-list: the blocks of composite data that nbuffer draws, without tests; "
      "queries, "
      "queries-conservative, queries-count: an occlusion "
      "query of the hardware for each prop, waited for; chc: coherent hierarchical culling by "
      "them; early-depth, early-depth-nbuffer: stock or nbuffer, depth first and then colours. "
      "nbuffer also with settings of its own, such as nbuffer:RoundSize=16:BackOff=0")
    ->delimiter(',')
    ->check(CLI::Validator(CheckMode, "MODE"))
    ->capture_default_str();
  command->add_option("--block", options->Walk.Block, "Timed frames of a mode in a row")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  command
    ->add_option("--warm-up", options->Walk.WarmUp,
      "Frames of each mode, forth and back along the path, before any is timed")
    ->check(CLI::Range(1, 1000000))
    ->capture_default_str();
  command->add_flag(
    "--verify", options->Walk.Verify, "Compare every frame byte for byte with mode none");
  command->add_option("--json", options->JSON, "File for the figures");
  command->add_option("--images", options->Walk.ImageFolder,
    "Folder for the first, middle and last frame of each mode and for frames that differ");
  command->add_flag(
    "--still", options->Walk.Still, "The camera stands still for each block of frames");
  command
    ->add_option("--nearest", options->Nearest,
      "Only so many props, the nearest ones in view of the first frame; all others are invisible")
    ->check(CLI::Range(1, 1000000));
  command
    ->add_option("--fragments", options->FragmentFrames,
      "Count the fragments of the draws of every mode in so many frames spread over the path; "
      "oracle's props are drawn in modes in-view and same-list, too")
    ->check(CLI::Range(1, 1000));
  command
    ->add_option("--first-frames", options->FirstFrames,
      "Instead of a walk in one window, so many runs of stock and of the modes nbuffer, each in a "
      "new window that loads the scene anew; says what the first frames cost")
    ->check(CLI::Range(1, 1000));
  command->callback([options, &run]() { run = [options]() { return RunWalkCommand(*options); }; });
}

void AddDefaultsCommand(CLI::App& app, Run& run)
{
  CLI::App* command =
    app.add_subcommand("defaults", "Print the defaults of the settings of modes as JSON");
  command->callback(
    [&run]()
    {
      run = []()
      {
        std::cout << GetDefaults();
        return Success;
      };
    });
}

void AddFirstCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("first",
    "Time the first image of this process: uploads and shaders, but not the context. Run it "
    "several times for a median");
  auto options = std::make_shared<FirstOptions>();
  options->View.AddTo(*command, program);
  options->View.AddCullerTo(*command);
  command->add_option("--mode", options->Mode, "stock, none or nbuffer")
    ->check(CLI::IsMember({ "stock", "none", "nbuffer" }))
    ->capture_default_str();
  command->add_option("--json", options->JSON, "File for the figures");
  command->callback([options, &run]() { run = [options]() { return RunFirst(*options); }; });
}

} // namespace NBufferBench
