// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Command.h
 * @brief What the subcommands of nbuffer-bench share, such as the options that say what is
 * rendered.
 */
#ifndef Command_h
#define Command_h

#include "CameraPath.h"
#include "FileFormats.h"
#include "LoadScene.h"
#include "Mode.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Exit codes. Wrong options end with a code of CLI11, above 100.
enum ExitCode
{
  Success = 0,
  Failure = 1,     ///< An error; its message went to stderr.
  ImagesDiffer = 2 ///< Bytes differ from mode none.
};

struct ViewOptions
{
  std::string Program;
  std::vector<std::string> SceneNames = { "city" };
  std::string Path;
  int Frames = 0;
  int PathFrames = 0; ///< The frames of the whole path; 0: as many as are rendered.
  std::uint64_t Seed = 1;
  bool SplitRegions = false; ///< As in NBufferExamples::SceneOptions.
  std::string Merge;         ///< What the scene becomes: "", "polydata" or "composite".
  bool Shuffle = false;      ///< Whether the triangles of the only mesh are shuffled.
  bool Edges = false;        ///< Whether all surfaces show their edges.
  int Points = 0;            ///< As in NBufferExamples::SceneOptions.
  int Instances = 0;         ///< As in NBufferExamples::SceneOptions.
  int Props = 0;             ///< The scene is copied until it has this many props; 0: not copied.
  SessionOptions Window;
  std::string Backend = "auto"; ///< The back-end of vtkNBufferCuller: auto, opengl or cpu.

  /// The possible values of --scene, for the help.
  std::string SceneHelp = "city, plant, isosurface, terrain, points-wall, points-terrain, "
                          "glyph-wall, glyph-cloud, glyph-open, shells, leaves "
                          "(synthetic), a folder of "
                          ".kicad_pcb (with :actors behind: all "
                          "actors of VTK's importer), or a file of " +
    NBufferExamples::ListEndings() + ", or several of " + NBufferExamples::ListEndings(true) +
    "; each also as .gz";

  ///@{
  /// Add the options to a subcommand; this object must outlive it.
  void AddTo(CLI::App& command, const std::string& program);
  void AddCullerTo(CLI::App& command);
  ///@}

  NBufferExamples::Scene LoadScene() const;

  /// Makes the path that the options name: by default street in a city and orbit elsewhere, and
  /// `usualFrames` frames.
  NBufferExamples::CameraPath MakePath(const NBufferExamples::Scene& scene, int usualFrames) const;
  std::string GetPathName(const NBufferExamples::Scene& scene) const;

  /// Adds to a report what was rendered where.
  void Describe(const NBufferExamples::Scene& scene, Session& session, Json::Value& report) const;
};

using NBufferExamples::CheckWritable;

///@{
/// Add the subcommands. If a subcommand is given, parsing sets `run` to the function that does it
/// and returns the exit code.
using Run = std::function<int()>;
void AddWalkCommand(CLI::App& app, const std::string& program, Run& run);
void AddFillCommand(CLI::App& app, const std::string& program, Run& run);
void AddFirstCommand(CLI::App& app, const std::string& program, Run& run);
void AddPicturesCommand(CLI::App& app, const std::string& program, Run& run);
void AddRanksCommand(CLI::App& app, const std::string& program, Run& run);
void AddShadowCommand(CLI::App& app, const std::string& program, Run& run);
void AddStudyCommand(CLI::App& app, const std::string& program, Run& run);
void AddVolumesCommand(CLI::App& app, const std::string& program, Run& run);
void AddDefaultsCommand(CLI::App& app, Run& run);
///@}

} // namespace NBufferBench

#endif
