// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"

#include "vtkVersion.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace NBufferBench
{
namespace
{
/// "960x720" to width and height; returns the complaint, empty if there is none.
std::string ParseSize(const std::string& text, int& width, int& height)
{
  int used = 0;
  const bool parsed = std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &used) == 2 &&
    static_cast<std::size_t>(used) == text.size();
  const int largest = 16384;
  if (!parsed || width < 1 || height < 1 || width > largest || height > largest)
  {
    return "expected WIDTHxHEIGHT in pixels, such as 960x720, not " + text;
  }
  return std::string();
}

bool IsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}
}

void ViewOptions::AddTo(CLI::App& command)
{
  command.add_option("--scene", this->SceneNames, this->SceneHelp)->capture_default_str();
  command.add_option("--up", this->Up, "Axis that points up (x, y or z); default: by file format")
    ->check(CLI::IsMember({ "x", "y", "z" }));
  command.add_option("--path", this->Path,
    "street, rooftop, drone, orbit, cuts, or a camera file (per line: eye, target, up, "
    "[view angle, [near, far]]); default: street in a city, orbit elsewhere");
  command
    .add_option_function<std::string>(
      "--size",
      [this](const std::string& text)
      {
        const std::string complaint = ParseSize(text, this->Window.Width, this->Window.Height);
        if (!complaint.empty())
        {
          throw CLI::ValidationError("--size", complaint);
        }
      },
      "Size of the image in pixels")
    ->type_name("WxH")
    ->default_str(std::to_string(this->Window.Width) + "x" + std::to_string(this->Window.Height));
  command.add_option("--frames", this->Frames, "Frames of the path")->check(CLI::Range(1, 1000000));
  command
    .add_option("--of", this->PathFrames,
      "Frames of the whole path, of which the first --frames are rendered; default: these alone")
    ->check(CLI::Range(1, 1000000));
  command.add_option("--seed", this->Seed, "Where the path starts and turns")
    ->capture_default_str();
  command
    .add_option("--props", this->Props,
      "Copies of the scene beside it until it has this many props; default: the scene alone")
    ->check(CLI::Range(1, 10000000));
  command.add_option("--samples", this->Window.Samples, "Samples per pixel; 0: no multisampling")
    ->check(CLI::Range(0, 64))
    ->capture_default_str();
  command.add_option("--window", this->Window.Window, "Window system")
    ->check(CLI::IsMember({ "default", "osmesa", "egl", "glx" }))
    ->capture_default_str();
}

void ViewOptions::AddCullerTo(CLI::App& command)
{
  command.add_option("--backend", this->Mode.Backend, "Where vtkNBufferCuller builds its levels")
    ->check(CLI::IsMember({ "auto", "opengl", "cpu" }))
    ->capture_default_str();
  command.add_option("--base", this->Mode.Base, "Pixels per texel of level 0, default: 4")
    ->check(CLI::IsMember({ 1, 2, 4, 8 }));
}

NBufferExamples::Scene ViewOptions::LoadScene() const
{
  // Importers make windows, too.
  ChooseWindowSystem(this->Window.Window);
  NBufferExamples::SceneOptions options;
  options.DefaultCity = NBufferExamples::FindDefaultCity(this->Program);
  options.Up = this->Up;
  options.Seed = this->Seed;
  options.Progress = ShowProgress;
  NBufferExamples::Scene scene = NBufferExamples::LoadScene(this->SceneNames, options);
  scene.Tile(this->Props);
  ShowProgress("");
  return scene;
}

std::string ViewOptions::GetPathName(const NBufferExamples::Scene& scene) const
{
  return !this->Path.empty() ? this->Path
    : scene.Plan             ? "street"
    : !scene.Paths.empty()   ? scene.Paths.front().first
                             : "orbit";
}

NBufferExamples::CameraPath ViewOptions::MakePath(
  const NBufferExamples::Scene& scene, int usualFrames) const
{
  const std::string name = this->GetPathName(scene);
  const bool isFile = std::filesystem::is_regular_file(name);
  const int frames = this->Frames > 0 || isFile ? this->Frames : usualFrames;
  NBufferExamples::CameraPath path =
    NBufferExamples::MakePath(scene, name, std::max(frames, this->PathFrames), this->Seed);
  path.resize(frames > 0 ? std::min(path.size(), static_cast<std::size_t>(frames)) : path.size());
  return path;
}

void ViewOptions::Describe(
  const NBufferExamples::Scene& scene, Session& session, Json::Value& report) const
{
  report["renderer"] = session.GetDevice();
  report["window"] = session.GetWindowClass();
  report["vtk"] = vtkVersion::GetVTKVersion();
  report["scene"] = scene.Name;
  report["path"] = this->GetPathName(scene);
  report["size"] = session.GetSize();
  report["samples"] = session.GetWindow()->GetMultiSamples();
  report["seed"] = static_cast<Json::UInt64>(this->Seed);
}

void ShowProgress(const std::string& text)
{
  static std::size_t shown = 0;
  static std::chrono::steady_clock::time_point last;
  if (!IsTerminal())
  {
    // A log gets a line every few seconds instead of one that is overwritten.
    const auto now = std::chrono::steady_clock::now();
    if (!text.empty() && now - last > std::chrono::seconds(5))
    {
      std::cerr << text << std::endl;
      last = now;
    }
    return;
  }
  const std::size_t blanks = shown > text.size() ? shown - text.size() : 0;
  std::cerr << "\r" << text << std::string(blanks, ' ') << (text.empty() ? "\r" : "") << std::flush;
  shown = text.size();
}

void CheckWritable(const std::string& fileName)
{
  if (!fileName.empty() && !std::ofstream(fileName, std::ios::app))
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferBench
