// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyCommand.cxx
 * @brief The subcommand study: what accuracy costs in time. All depth structures get the same
 * frames; the figures of the paper are measured again. Scripts/study.py adds settings and shadows.
 */
#include "Command.h"
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"
#include "Walk.h"

#include "Contest.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <regex>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;
using NBufferExamples::Scene;
using NBufferStudy::ContestResult;
using NBufferStudy::DepthFrame;

struct StudyOptions
{
  ViewOptions View;
  std::string Folder = "out/study";
  std::string JSON;
  bool IsQuick = false;
  bool IsTiny = false;
  bool PathsOnly = false;
  bool DepthOnly = false;
  bool DeviceOnly = false;
  ///@{
  /// 0: as many as the extent of the run says.
  int Repetitions = 0;
  int WalkFrames = 0;
  int LatentPairs = 0;
  ///@}
};

/// Structures that need more for a frame are left out.
constexpr double MostMegabytes = 120.0;

/// How much of everything is measured.
struct Effort
{
  int Frames;
  int Repetitions;
  int PaperFrames;      ///< Of table 2.
  int LargestRectangle; ///< Of figure 4.
  int MostProps;        ///< Of the hierarchy.
  int MostParticles;
  int WalkFrames; ///< Whole frames.
  int LatentPairs;
  int FragmentFrames;
  int DeviceRepetitions;
  int MostDevicePixels;
  int DepthSteps;      ///< Distances for each power of ten.
  double LargestRatio; ///< Of far to near plane.
};
constexpr Effort Full = { 8, 7, 6, 256, 1000000, 57600, 30, 12, 4, 9, 1648 * 1776, 4, 1e7 };
constexpr Effort Quick = { 3, 3, 2, 128, 100000, 3600, 5, 3, 1, 2, 1920 * 1080, 2, 1e5 };
constexpr Effort Tiny = { 1, 1, 1, 16, 1000, 3600, 2, 1, 1, 1, 256 * 256, 1, 1e3 };

/// Whole frames are measured in these modes, in this order.
const std::vector<std::string> Peers = { "stock", "nbuffer", "queries", "queries-conservative",
  "chc", "oracle" };

std::string GetFileName(const std::string& text)
{
  const std::string name = std::regex_replace(text, std::regex("[^[:alnum:]]+"), "-");
  return std::regex_replace(name, std::regex("^-|-$"), "");
}

/// Returns poses that are far enough apart to be different work.
CameraPath Spread(const CameraPath& path, int frames)
{
  CameraPath spread;
  for (int i = 0; i < frames; ++i)
  {
    spread.push_back(
      path[path.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(frames)]);
  }
  return spread;
}

/// Returns rows of ten poses, in which the camera moves on, at several places of a path.
CameraPath MakeRuns(const CameraPath& path, int frames)
{
  constexpr std::size_t row = 10;
  const std::size_t runs = (static_cast<std::size_t>(frames) + row - 1) / row;
  CameraPath poses;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i)
  {
    poses.push_back(path[(i / row * path.size() / runs + i % row) % path.size()]);
  }
  return poses;
}

Json::Value ReportContest(
  const std::vector<DepthFrame>& frames, const std::vector<ContestResult>& results)
{
  Json::Value scene;
  const auto count = static_cast<double>(frames.size());
  double inView = 0.0;
  double hidden = 0.0;
  double crossing = 0.0;
  for (const DepthFrame& frame : frames)
  {
    inView += static_cast<double>(frame.Boxes.size());
    crossing += frame.Crossing;
    hidden += static_cast<double>(std::count_if(frame.Boxes.begin(), frame.Boxes.end(),
      [](const NBufferStudy::DepthBox& box) { return !box.Visible; }));
    scene["props"] =
      static_cast<int>(frame.Boxes.size()) + frame.Crossing + frame.Outside + frame.NotCandidates;
  }
  scene["frames"] = static_cast<Json::UInt64>(frames.size());
  scene["size"] =
    std::to_string(frames.front().Width) + "x" + std::to_string(frames.front().Height);
  scene["in_view"] = Round(inView / count);
  scene["hidden"] = Round(hidden / count);
  scene["crossing"] = Round(crossing / count);
  for (const ContestResult& result : results)
  {
    Json::Value point;
    point["name"] = result.Name;
    point["is_default"] = result.Name == NBufferStudy::GetDefaultName();
    point["hidden"] = static_cast<Json::Int64>(result.Hidden);
    point["false_visible"] = static_cast<Json::Int64>(result.FalseVisible);
    point["false_hidden"] = static_cast<Json::Int64>(result.FalseHidden);
    point["area"] = result.Area;
    point["covered_area"] = result.CoveredArea;
    point["build_ms"] = Summarize(result.BuildTimes);
    point["query_ms"] = Summarize(result.QueryTimes);
    point["total_ms"] = Summarize(result.GetTimes());
    point["queries"] = Round(static_cast<double>(result.Counts.Queries) / count);
    point["lookups"] = Round(static_cast<double>(result.Counts.Lookups) / count);
    point["texels"] = static_cast<Json::UInt64>(result.Texels);
    point["bytes"] = static_cast<Json::UInt64>(result.Memory);
    scene["structures"].append(point);
  }
  return scene;
}

class Study
{
public:
  explicit Study(const StudyOptions& options)
    : Options(options)
    , Spent(options.IsTiny  ? Tiny
          : options.IsQuick ? Quick
                            : Full)
  {
    const auto choose = [](int wanted, int& usual) { usual = wanted > 0 ? wanted : usual; };
    choose(options.View.Frames, this->Spent.Frames);
    choose(options.Repetitions, this->Spent.Repetitions);
    choose(options.WalkFrames, this->Spent.WalkFrames);
    choose(options.LatentPairs, this->Spent.LatentPairs);
  }

  /// Measures three paths through the city; of another scene, the path that the options name.
  int Run()
  {
    MakeFolder(this->Options.Folder);
    CheckWritable(this->Options.JSON);
    const Scene scene = this->Options.View.LoadScene();
    Session& session = Session::New(scene, this->Options.View.Window);
    this->Options.View.Describe(scene, session, this->Report);
    this->Report.removeMember("path");
    const bool isOfCity = scene.Plan && this->Options.View.Path.empty();
    const std::vector<std::string> paths = isOfCity
      ? std::vector<std::string>{ "street", "rooftop", "drone" }
      : std::vector<std::string>{ this->Options.View.GetPathName(scene) };
    if (!this->Options.DepthOnly && !this->Options.DeviceOnly)
    {
      this->RunAllButDevice(scene, session, paths);
    }
    if (scene.Plan && !this->Options.PathsOnly && !this->Options.DeviceOnly)
    {
      this->RunDepth(scene, session, "drone");
    }
    if (!this->Options.PathsOnly && !this->Options.DepthOnly)
    {
      for (const std::string& path : paths)
      {
        this->RunRebuild(scene, session, path);
      }
      this->Report["device"] =
        MeasureDevice(session, this->MakePath(scene, paths.front(), 1).front(),
          this->Spent.DeviceRepetitions, this->Spent.MostDevicePixels);
      this->Report["packed"] =
        MeasurePacked(session, this->MakePath(scene, paths.front(), 1).front(),
          this->Spent.DeviceRepetitions, this->Spent.MostDevicePixels);
    }
    WriteJSON(this->Report, this->Options.JSON);
    return this->Wrong == 0 ? Success : ImagesDiffer;
  }

private:
  void RunAllButDevice(const Scene& scene, Session& session, const std::vector<std::string>& paths)
  {
    for (const std::string& path : paths)
    {
      this->RunPath(scene, session, path);
    }
    if (this->Options.PathsOnly)
    {
      return;
    }
    for (const std::string& path : paths)
    {
      this->RunHierarchy(scene, session, path);
    }
    this->RunPaper(scene, session, paths.front());
  }

  /// Counts and reports visible props that were hidden, and bytes that differ.
  void CountWrong(const std::string& what, const Json::Value& count)
  {
    this->Wrong += count.asInt64();
    if (count.asInt64() > 0)
    {
      std::cerr << "nbuffer-bench: " << what << ": " << count.asInt64() << " wrong\n";
    }
  }

  CameraPath MakePath(const Scene& scene, const std::string& name, int frames) const
  {
    // As far as a walk of some minutes goes; once around everything else.
    const int length = scene.Plan || !scene.Paths.empty() ? 60 * frames : frames;
    return Spread(NBufferExamples::MakePath(scene, name, length, this->Options.View.Seed), frames);
  }

  void RunPath(const Scene& scene, Session& session, const std::string& name)
  {
    const CameraPath poses = this->MakePath(scene, name, this->Spent.Frames);
    const std::vector<DepthFrame> work = CollectFrames(session, poses);
    std::vector<NBufferStudy::ContenderPointer> contenders =
      NBufferStudy::MakeContenders(work.front().Width, work.front().Height, MostMegabytes);
    if (scene.Known)
    {
      contenders.push_back(MakeKnownContender(*scene.Known, work, poses));
    }
    const std::vector<ContestResult> results =
      NBufferStudy::RunContest(work, contenders, this->Spent.Repetitions,
        [&](int turn, int turns)
        {
          ShowProgress(name + ": " + std::to_string(contenders.size()) + " structures, turn " +
            std::to_string(turn) + " of " + std::to_string(turns));
        });
    Json::Value report = ReportContest(work, results);
    for (const Json::Value& point : report["structures"])
    {
      if (point["name"].asString() != KnownName) // CheckKnown() says why.
      {
        this->CountWrong("hidden by " + point["name"].asString(), point["false_hidden"]);
      }
    }
    if (scene.Known)
    {
      report["table"] = CheckKnown(session, *scene.Known, work, poses);
      this->CountWrong("pixels of props that the map's table says cannot be seen",
        report["table"]["contradictions"]);
    }
    report["scene"] = scene.Name;
    report["path"] = name;
    report["repetitions"] = this->Spent.Repetitions;
    report["file_name"] = GetFileName(scene.Name) + "-" + GetFileName(name);
    this->RunPeers(scene, session, name, report);
    this->Report["scenes"].append(report);
  }

  /// Measures whole frames, one pose after the other.
  void RunPeers(const Scene& scene, Session& session, const std::string& name, Json::Value& report)
  {
    WalkOptions options;
    options.Verify = true;
    options.Modes.clear();
    Json::Value skipped(Json::objectValue);
    for (const std::string& mode : Peers)
    {
      const std::string why = Mode::WhyNot(mode);
      const bool isQuery = mode != "stock" && mode != "nbuffer" && mode != "oracle";
      if (!why.empty())
      {
        skipped[mode] = why;
      }
      else if (!isQuery || !this->Options.PathsOnly)
      {
        options.Modes.push_back(mode);
      }
    }
    const std::vector<std::string> modes = options.Modes;
    options.Modes.insert(options.Modes.end(), { "none", "in-view" });
    const std::uint64_t seed = this->Options.View.Seed;
    const CameraPath path = NBufferExamples::MakePath(scene, name, 480, seed);
    report["walk"] = RunWalk(session,
      scene.Plan ? NBufferExamples::MakePath(scene, name, this->Spent.WalkFrames, seed)
                 : MakeRuns(path, this->Spent.WalkFrames),
      options);
    report["walk"]["skipped"] = skipped;
    this->CountWrong("bytes of whole frames of " + name, report["walk"]["differing_bytes"]);
    if (!this->Options.PathsOnly && GetFragmentsObstacle(session).empty())
    {
      report["fragments"] = MeasureFragments(session, path, modes, this->Spent.FragmentFrames);
    }
    for (int step : { 1, 10 })
    {
      ShowProgress("by verdicts of " + std::to_string(step) + " poses ago");
      report["latent"].append(MeasureLatent(session, path, step, this->Spent.LatentPairs,
        this->Options.Folder + "/latent-" + report["file_name"].asString() + "-" +
          std::to_string(step) + ".png"));
    }
  }

  /// Builds levels again in part.
  void RunRebuild(const Scene& scene, Session& session, const std::string& name)
  {
    const CameraPath path = NBufferExamples::MakePath(scene, name, 480, this->Options.View.Seed);
    for (int step : { 1, 10 })
    {
      ShowProgress(name + ": levels built again in part");
      for (Json::Value entry :
        MeasureRebuild(session, path, step, this->Spent.LatentPairs, this->Spent.Repetitions))
      {
        entry["path"] = name;
        this->Report["rebuild"].append(entry);
      }
    }
  }

  /// Tests all props of the scene, and copies of it, in a frame of the path.
  void RunHierarchy(const Scene& scene, Session& session, const std::string& name)
  {
    CameraPose pose = this->MakePath(scene, name, 1).front();
    if (scene.Plan)
    {
      pose.Near = 0.5;
      pose.Far = 20000.0; // So that the copies are in view.
    }
    const DepthFrame frame = CollectFrames(session, { pose }).front();
    Json::Value hierarchy;
    hierarchy["scene"] = scene.Name;
    hierarchy["path"] = name;
    hierarchy["file_name"] = GetFileName(scene.Name) + "-" + GetFileName(name);
    hierarchy["entries"] = MeasureHierarchy(
      frame, CollectBoxes(session), pose.Eye, this->Spent.MostProps, this->Spent.Repetitions);
    this->Report["hierarchy"].append(hierarchy);
  }

  /// Measures formats of depth by themselves, and in a view from above, where nothing is near: the
  /// planes can be a hundredfold apart.
  void RunDepth(const Scene& scene, Session& session, const std::string& name)
  {
    this->Report["depth"] = MeasureDepth(session, this->Spent.DepthSteps);
    CameraPose pose = this->MakePath(scene, name, 1).front();
    pose.Near = 60.0;
    pose.Far = 6000.0;
    Json::Value& formats = this->Report["formats"];
    formats["scene"] = scene.Name;
    formats["path"] = name;
    formats["entries"] = MeasureFormats(session, pose, this->Spent.LargestRatio);
    for (const Json::Value& entry : formats["entries"])
    {
      this->CountWrong("hidden with depth of " + entry["format"].asString(), entry["false_hidden"]);
    }
  }

  void RunPaper(const Scene& scene, Session& session, const std::string& path)
  {
    ShowProgress("the paper's table 2");
    session.GetWindow()->SetSize(512, 512);
    this->Report["table2"] =
      MeasureTable2(CollectFrames(session, this->MakePath(scene, path, this->Spent.PaperFrames)));
    this->CountWrong("hidden in table 2", this->Report["table2"]["false_hidden"]);
    this->Report["particles"] = MeasureParticles(session, this->MakePath(scene, path, 1).front(),
      this->Spent.MostParticles, this->Spent.DeviceRepetitions);
    for (const Json::Value& entry : this->Report["particles"])
    {
      this->CountWrong("visible particles rejected", entry["wrongly_rejected"]);
      this->CountWrong("verdicts that an early accept changed", entry["changed"]);
    }
    ShowProgress("the paper's figure 4");
    this->Report["figure4"] = MeasureFigure4(this->Spent.LargestRectangle);
  }

  const StudyOptions& Options;
  Effort Spent;
  Json::Value Report;
  long long Wrong = 0;
};
}

void AddStudyCommand(CLI::App& app, const std::string& program, Run& run)
{
  CLI::App* command = app.add_subcommand("study",
    "What accuracy costs in time: every depth structure on the same frames, and the paper's "
    "figures. Scripts/study.py adds other scenes, settings and shadows");
  auto options = std::make_shared<StudyOptions>();
  options->View.AddTo(*command, program);
  command->add_option("--json", options->JSON, "File for the figures");
  command->add_option("--out", options->Folder, "Folder for pictures of wrong frames")
    ->capture_default_str();
  command->add_flag("--quick", options->IsQuick, "Fewer frames and repetitions");
  command->add_flag("--tiny", options->IsTiny, "One frame of each: only whether everything runs");
  command->add_flag("--paths-only", options->PathsOnly,
    "Only structures and whole frames, without queries of the hardware");
  command->add_flag("--depth-only", options->DepthOnly, "Only formats of depth, in a city");
  command->add_flag("--device-only", options->DeviceOnly,
    "Only how levels are built: again in part, and on the graphics device by size");
  const auto add = [command](
                     const char* name, int& value, int Effort::*usual, const std::string& help)
  {
    command
      ->add_option(name, value,
        help + "; default: " + std::to_string(Full.*usual) + ", with --quick " +
          std::to_string(Quick.*usual) + ", with --tiny " + std::to_string(Tiny.*usual))
      ->check(CLI::Range(1, 1000));
  };
  add("--repeat", options->Repetitions, &Effort::Repetitions,
    "Timed repetitions of each frame that is tested");
  add("--walk-frames", options->WalkFrames, &Effort::WalkFrames, "Whole frames of a path");
  add("--latent-pairs", options->LatentPairs, &Effort::LatentPairs,
    "Pairs of poses for latent culling and for levels that are built again in part");
  command->callback([options, &run]() { run = [options]() { return Study(*options).Run(); }; });
}

} // namespace NBufferBench
