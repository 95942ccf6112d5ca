// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyCommand.cxx
 * @brief What accuracy costs in time: all depth structures on the same frames, and the figures of
 * the paper.
 */
#include "Command.h"
#include "Images.h"
#include "Report.h"
#include "StudyChart.h"
#include "StudyFrames.h"
#include "StudyPaper.h"
#include "StudyReport.h"

#include "Contest.h"

#include <chrono>
#include <iostream>
#include <memory>

namespace NBufferBench
{
namespace
{
struct StudyOptions
{
  ViewOptions View;
  std::string Folder = "out/study";
  bool Quick = false;
  bool Tiny = false;
  int Repetitions = 0;
  double Megabytes = 120.0;
};

/// Poses far enough apart to be different work.
NBufferExamples::CameraPath Spread(const NBufferExamples::CameraPath& path, int frames)
{
  NBufferExamples::CameraPath spread;
  for (int i = 0; i < frames; ++i)
  {
    spread.push_back(
      path[path.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(frames)]);
  }
  return spread;
}

std::string GetFileName(const std::string& text)
{
  std::string name;
  for (char c : text)
  {
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  }
  return name;
}

class Study
{
public:
  explicit Study(StudyOptions& options)
    : Options(options)
  {
  }

  int Run()
  {
    const auto begin = std::chrono::steady_clock::now();
    MakeFolder(this->Options.Folder);
    CheckWritable(this->Options.Folder + "/study.json");
    const NBufferExamples::Scene scene = this->Options.View.LoadScene();
    Session& session = Session::New(scene, this->Options.View.Window);
    this->Report = this->Options.View.Describe(scene, session);
    this->Report.removeMember("path");
    this->Report["quick"] = this->Options.Quick;
    this->Report["default"] = NBufferStudy::GetDefaultName();

    std::vector<std::string> paths = { this->Options.View.GetPathName(scene) };
    if (this->Options.View.Path.empty() && scene.Plan)
    {
      paths = { "street", "rooftop", "drone" };
    }
    this->Report["scenes"] = Json::Value(Json::arrayValue);
    for (const std::string& path : paths)
    {
      this->RunPath(scene, session, path);
    }
    this->RunPaper(scene, session, paths.front());
    ShowProgress("");
    this->Report["seconds"] =
      Round(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    WriteJSON(this->Report, this->Options.Folder + "/study.json");
    WriteStudyCSV(this->Report, this->Options.Folder + "/study.csv");
    std::cout << "written to " << this->Options.Folder << " in " << this->Report["seconds"].asInt()
              << " s\n";
    return this->FalseHidden == 0 ? Success : ImagesDiffer;
  }

private:
  NBufferExamples::CameraPath MakePath(
    const NBufferExamples::Scene& scene, const std::string& name, int frames) const
  {
    // As far as a walk of some minutes goes; once around everything else.
    const int length = scene.Plan ? 60 * frames : frames;
    return Spread(NBufferExamples::MakePath(scene, name, length, this->Options.View.Seed), frames);
  }

  void RunPath(const NBufferExamples::Scene& scene, Session& session, const std::string& name)
  {
    const int usual = this->Options.Tiny ? 1 : this->Options.Quick ? 3 : 8;
    const int frames = this->Options.View.Frames > 0 ? this->Options.View.Frames : usual;
    const std::vector<NBufferStudy::DepthFrame> work =
      CollectFrames(session, this->MakePath(scene, name, frames),
        [&](std::size_t frame)
        {
          ShowProgress(name + ": which props own a pixel, frame " + std::to_string(frame + 1) +
            " of " + std::to_string(frames));
        });
    const std::vector<NBufferStudy::ContenderPointer> contenders = NBufferStudy::MakeContenders(
      work.front().Width, work.front().Height, this->Options.Megabytes);
    const int repetitions = this->Options.Repetitions > 0 ? this->Options.Repetitions
      : this->Options.Tiny                                ? 1
      : this->Options.Quick                               ? 3
                                                          : 7;
    const std::vector<NBufferStudy::ContestResult> results =
      NBufferStudy::RunContest(work, contenders, repetitions,
        [&](int turn, int turns)
        {
          ShowProgress(name + ": " + std::to_string(contenders.size()) + " structures, turn " +
            std::to_string(turn) + " of " + std::to_string(turns));
        });
    Json::Value report = ReportContest(work, results);
    report["scene"] = scene.Name;
    report["path"] = name;
    report["size"] = std::to_string(work.front().Width) + "x" + std::to_string(work.front().Height);
    report["repetitions"] = repetitions;
    report["chart"] = "pareto-" + GetFileName(scene.Name) + "-" + GetFileName(name);
    WriteParetoChart(report, scene.Name + ", " + name + ", " + report["size"].asString(),
      this->Options.Folder + "/" + report["chart"].asString());
    for (const NBufferStudy::ContestResult& result : results)
    {
      this->FalseHidden += result.FalseHidden;
      if (result.FalseHidden > 0)
      {
        std::cerr << "nbuffer-bench: " << result.Name << " hides " << result.FalseHidden
                  << " visible props\n";
      }
    }
    this->Report["scenes"].append(report);
  }

  void RunPaper(const NBufferExamples::Scene& scene, Session& session, const std::string& path)
  {
    const int frames = this->Options.Tiny ? 1 : this->Options.Quick ? 2 : 6;
    ShowProgress("the paper's table 2");
    session.GetWindow()->SetSize(512, 512);
    this->Report["table2"] = MakeTable2(CollectFrames(
      session, this->MakePath(scene, path, frames), std::function<void(std::size_t)>()));
    ShowProgress("the paper's table 1");
    this->Report["table1"] = MakeTable1(session, this->MakePath(scene, path, 1).front(),
      this->Options.Tiny      ? 1
        : this->Options.Quick ? 3
                              : 9,
      this->Options.Tiny ? 256 : 1024);
    ShowProgress("the paper's figure 4");
    this->Report["figure4"] = MakeFigure4(this->Options.Tiny ? 16
        : this->Options.Quick                                ? 128
                                                             : 256,
      this->Options.Folder);
  }

  StudyOptions& Options;
  Json::Value Report;
  long long FalseHidden = 0;
};
}

void AddStudyCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("study",
    "What accuracy costs in time: every depth structure on the same frames, charts of error "
    "against "
    "time, and the paper's figures");
  auto options = std::make_shared<StudyOptions>();
  options->View.Program = program;
  options->View.AddTo(*command);
  command->add_option("--out", options->Folder, "Folder for study.json, study.csv and the charts")
    ->capture_default_str();
  command->add_flag("--quick", options->Quick, "Fewer frames and repetitions: under 3 minutes");
  command->add_flag("--tiny", options->Tiny, "One frame of each: only whether everything runs");
  command
    ->add_option("--repeat", options->Repetitions, "Timed repetitions of each frame; default: 7")
    ->check(CLI::Range(1, 1000));
  command
    ->add_option(
      "--megabytes", options->Megabytes, "Leave out structures that need more for a frame")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  command->callback([options, &run]() { run = [options]() { return Study(*options).Run(); }; });
}

} // namespace NBufferBench
