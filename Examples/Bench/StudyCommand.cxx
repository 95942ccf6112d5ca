// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Study.h"
#include "StudyFiles.h"
#include "StudyOptions.h"
#include "StudyScenes.h"

#include <memory>
#include <string>
#include <vector>

namespace NBufferBench
{

void AddStudyCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("study",
    "What accuracy costs in time: every depth structure on the same frames, charts of error "
    "against time, and the paper's figures");
  auto options = std::make_shared<StudyOptions>();
  auto from = std::make_shared<std::vector<std::string>>();
  options->View.Program = program;
  options->View.SceneHelp += "; shadows, settings, shadow-settings: these of the study alone";
  options->View.AddTo(*command);
  command
    ->add_option("--out", options->Folder,
      "Folder for study.json, study.csv, peers.csv, device.csv, settings.csv and the charts")
    ->capture_default_str();
  command->add_option("--links", options->Links, "Folder of the charts as seen from accuracy.md")
    ->capture_default_str();
  command
    ->add_option("--scenes", options->Scenes,
      std::string("Folder of the scenes that ") + GetSceneCommand() + " builds")
    ->capture_default_str();
  command->add_option("--from", *from,
    "A study.json from which accuracy.md and charts of error are made again, with the shadows and "
    "the settings of the last one that has some; nothing is measured");
  command->add_flag("--quick", options->IsQuick, "Fewer frames and repetitions: under 3 minutes");
  command->add_flag("--tiny", options->IsTiny, "One frame of each: only whether everything runs");
  command->add_flag("--no-settings", options->LeavesOutSettings,
    "Without the settings of the culler and of the shadow pass, a third of a full run");
  command
    ->add_option("--repeat", options->Repetitions, "Timed repetitions of each frame; default: 7")
    ->check(CLI::Range(1, 1000));
  command
    ->add_option(
      "--megabytes", options->Megabytes, "Leave out structures that need more for a frame")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->callback(
    [options, from, &run]()
    {
      run = [options, from]() -> int
      {
        if (from->empty())
        {
          return RunStudy(*options);
        }
        RewriteStudy(*options, *from);
        return Success;
      };
    });
}

} // namespace NBufferBench
