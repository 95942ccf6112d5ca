// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FirstCommand.cxx
 * @brief The first image of a fresh process: uploads, shaders and all, but not the context.
 */
#include "Command.h"
#include "Report.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
namespace fs = std::filesystem;

struct FirstOptions
{
  ViewOptions View;
  std::vector<std::string> Modes = { "stock", "nbuffer" };
  int Repeat = 3;
  bool Here = false;
  std::string JSON;
};

/// The one image of this process.
int RunHere(const FirstOptions& options)
{
  const NBufferExamples::Scene scene = options.View.LoadScene();
  const NBufferExamples::CameraPath path = options.View.MakePath(scene, 1);
  Session& session = Session::New(scene, options.View.Window);
  Mode mode(options.Modes.front(), options.View.Mode);
  mode.Enter(session.GetRenderer());
  session.SetPose(path.front());
  Json::Value report = options.View.Describe(scene, session);
  report["props"] = static_cast<Json::UInt64>(scene.Actors.size());
  report["mode"] = mode.GetName();
  report["first_image_ms"] = session.Render();
  report["drawn"] = session.GetRenderer()->GetNumberOfPropsRendered();
  WriteJSON(report, options.JSON);
  return Success;
}

std::string Quote(const std::string& text)
{
#ifdef _WIN32
  return "\"" + text + "\"";
#else
  std::string quoted = "'";
  for (char c : text)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
#endif
}

Json::Value RunElsewhere(
  const FirstOptions& options, const std::vector<std::string>& arguments, const std::string& mode)
{
  const fs::path file = fs::temp_directory_path() /
    ("nbuffer-first-" + std::to_string(std::random_device()()) + ".json");
  std::string command = Quote(options.View.Program) + " first --here --modes " + mode + " --json " +
    Quote(file.string());
  for (const std::string& argument : arguments)
  {
    command += " " + Quote(argument);
  }
  const int code = std::system(command.c_str());
  Json::Value report;
  std::ifstream stream(file);
  const bool read =
    code == 0 && Json::parseFromStream(Json::CharReaderBuilder(), stream, &report, nullptr);
  stream.close();
  std::error_code ignored;
  fs::remove(file, ignored);
  if (!read)
  {
    throw std::runtime_error("the process that renders in mode " + mode + " failed");
  }
  return report;
}

int RunAll(const FirstOptions& options, const std::vector<std::string>& arguments)
{
  CheckWritable(options.JSON);
  Json::Value report;
  std::map<std::string, std::vector<double>> times;
  for (int i = 0; i < options.Repeat; ++i)
  {
    for (const std::string& mode : options.Modes)
    {
      ShowProgress("first image " + std::to_string(i + 1) + " of " +
        std::to_string(options.Repeat) + " in mode " + mode);
      const Json::Value single = RunElsewhere(options, arguments, mode);
      for (const char* name :
        { "renderer", "window", "vtk", "scene", "path", "size", "samples", "seed", "props" })
      {
        report[name] = single[name];
      }
      times[mode].push_back(single["first_image_ms"].asDouble());
      report["modes"][mode]["drawn"] = single["drawn"];
    }
  }
  for (const std::string& mode : options.Modes)
  {
    const double median = GetQuantile(times[mode], 0.5);
    report["modes"][mode]["first_image_ms"] = median;
    std::cout << mode << ": first image " << median << " ms\n";
  }
  if (times.count("stock") && times.count("nbuffer"))
  {
    const double ratio = GetQuantile(times["nbuffer"], 0.5) / GetQuantile(times["stock"], 0.5);
    report["ratios"]["nbuffer/stock"] = ratio;
    std::cout << "nbuffer/stock " << ratio << "\n";
  }
  if (!options.JSON.empty())
  {
    WriteJSON(report, options.JSON);
  }
  return Success;
}

/// What says what is rendered, for the processes that do it.
std::vector<std::string> GetArguments(const CLI::App& command)
{
  std::vector<std::string> arguments;
  for (const CLI::Option* option : command.get_options())
  {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--modes" || name == "--repeat" || name == "--json")
    {
      continue;
    }
    arguments.push_back(name);
    for (const std::string& value : option->results())
    {
      arguments.push_back(value);
    }
  }
  return arguments;
}
}

void AddFirstCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand(
    "first", "Time the first image of a fresh process, uploads included, in several modes");
  auto options = std::make_shared<FirstOptions>();
  options->View.Program = program;
  options->View.AddTo(*command);
  options->View.AddCullerTo(*command);
  command->add_option("--modes", options->Modes, "stock, none or nbuffer")
    ->delimiter(',')
    ->check(CLI::IsMember({ "stock", "none", "nbuffer" }))
    ->capture_default_str();
  command->add_option("--repeat", options->Repeat, "Processes per mode; medians are reported")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  command->add_flag("--here", options->Here, "Render in this process, once, in the first mode");
  command->add_option("--json", options->JSON, "File for the figures");
  command->callback(
    [options, command, &run]()
    {
      run = [options, command]()
      { return options->Here ? RunHere(*options) : RunAll(*options, GetArguments(*command)); };
    });
}

} // namespace NBufferBench
