// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"

#include "SizeOption.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkVersion.h"

#include <algorithm>

namespace NBufferBench
{
void ViewOptions::AddTo(CLI::App& command, const std::string& program)
{
  this->Program = program;
  command.add_option("--scene", this->SceneNames, this->SceneHelp)->capture_default_str();
  command.add_flag("--split", this->SplitRegions,
    "A prop for each connected region of a file that holds one mesh; default: one prop");
  command
    .add_option("--merge", this->Merge,
      "All parts of the scene as one prop: one mesh, or composite data with a block for each part")
    ->check(CLI::IsMember({ "polydata", "composite" }));
  command.add_flag("--shuffle", this->Shuffle,
    "The triangles of a scene that is one mesh in a random order, always the same one");
  command.add_flag("--edges", this->Edges, "All surfaces show their edges");
  command
    .add_option("--points", this->Points,
      "Points of the scenes points-wall and points-terrain; default: 1000000")
    ->check(CLI::Range(1, 100000000));
  command
    .add_option("--instances", this->Instances,
      "Instances of the scenes glyph-wall, glyph-cloud and glyph-open; default: 200000")
    ->check(CLI::Range(1, 16000000));
  command.add_option("--path", this->Path,
    "street, rooftop, drone, cuts, aside (few of the props in view) or orbit, or a path that the "
    "scene has of its own; default: street in a city, orbit elsewhere");
  NBufferExamples::AddSizeOption(
    command, this->Window.Size, "Width and height of the image in pixels");
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
}

void ViewOptions::AddCullerTo(CLI::App& command)
{
  command.add_option("--backend", this->Backend, "Where vtkNBufferCuller builds its levels")
    ->check(CLI::IsMember({ "auto", "opengl", "cpu" }))
    ->capture_default_str();
}

NBufferExamples::Scene ViewOptions::LoadScene() const
{
  NBufferExamples::SceneOptions options;
  options.Program = this->Program;
  options.Seed = this->Seed;
  options.Progress = ShowProgress;
  options.SplitRegions = this->SplitRegions;
  options.Points = this->Points;
  options.Instances = this->Instances;
  NBufferExamples::Scene scene = NBufferExamples::LoadScene(this->SceneNames, options);
  scene.Tile(this->Props);
  if (!this->Merge.empty())
  {
    scene.Merge(this->Merge == "composite");
  }
  if (this->Shuffle)
  {
    scene.Shuffle();
  }
  for (const vtkSmartPointer<vtkActor>& actor : scene.Actors)
  {
    if (this->Edges) // A file may have switched them on.
    {
      actor->GetProperty()->EdgeVisibilityOn();
    }
  }
  return scene;
}

std::string ViewOptions::GetPathName(const NBufferExamples::Scene& scene) const
{
  return !this->Path.empty() ? this->Path : NBufferExamples::GetUsualPath(scene);
}

NBufferExamples::CameraPath ViewOptions::MakePath(
  const NBufferExamples::Scene& scene, int usualFrames) const
{
  const int frames = this->Frames > 0 ? this->Frames : usualFrames;
  NBufferExamples::CameraPath path = NBufferExamples::MakePath(
    scene, this->GetPathName(scene), std::max(frames, this->PathFrames), this->Seed);
  path.resize(static_cast<std::size_t>(frames));
  return path;
}

void ViewOptions::Describe(
  const NBufferExamples::Scene& scene, Session& session, Json::Value& report) const
{
  report["renderer"] = session.GetDevice();
  report["window"] = session.GetWindow()->GetClassName();
  report["vtk"] = vtkVersion::GetVTKVersion();
  report["scene"] = scene.Name;
  report["merged"] = this->Merge;
  report["shuffled"] = this->Shuffle;
  report["edges"] = this->Edges;
  if (this->Points > 0)
  {
    report["points"] = this->Points;
  }
  if (this->Instances > 0)
  {
    report["instances"] = this->Instances;
  }
  report["path"] = this->GetPathName(scene);
  report["size"] = session.GetSize();
  report["samples"] = session.GetWindow()->GetMultiSamples();
  report["seed"] = static_cast<Json::UInt64>(this->Seed);
}

} // namespace NBufferBench
