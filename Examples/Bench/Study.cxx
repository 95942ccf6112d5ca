// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Study.h"

#include "Images.h"
#include "Report.h"
#include "StudyDevice.h"
#include "StudyFiles.h"
#include "StudyFormats.h"
#include "StudyFragments.h"
#include "StudyFrames.h"
#include "StudyHierarchy.h"
#include "StudyKnown.h"
#include "StudyPaper.h"
#include "StudyPeers.h"
#include "StudyPeersCSV.h"
#include "StudyPoses.h"
#include "StudyReport.h"
#include "StudyScenes.h"
#include "StudySettings.h"
#include "StudySettingsTables.h"
#include "StudyShadows.h"

#include "Contest.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <iostream>

namespace NBufferBench
{
namespace
{
/// How much of everything.
struct Effort
{
  int Frames;
  int Repetitions;
  int PaperFrames;      ///< Of table 2.
  int PaperRepetitions; ///< Of table 1.
  int LargestImage;     ///< Of table 1.
  int LargestRectangle; ///< Of figure 4.
  int MostProps;        ///< Of the hierarchy.
  int WalkFrames;       ///< Of the peers, whole frames.
  int LatentPairs;
  int FragmentFrames;
  int DeviceRepetitions;
  int MostDevicePixels;
  bool AllPeers; ///< Queries of the hardware too, and fragments.
};
constexpr Effort Full = { 8, 7, 6, 9, 1024, 256, 1000000, 30, 12, 4, 9, 1920 * 1080, true };
constexpr Effort Quick = { 3, 3, 2, 3, 1024, 128, 100000, 5, 3, 1, 2, 1920 * 1080, true };
constexpr Effort Tiny = { 1, 1, 1, 1, 256, 16, 1000, 2, 1, 1, 1, 256 * 256, true };

Effort GetEffort(const StudyOptions& options)
{
  Effort effort = options.Choose(Full, Quick, Tiny);
  effort.Frames = options.View.Frames > 0 ? options.View.Frames : effort.Frames;
  effort.Repetitions = options.Repetitions > 0 ? options.Repetitions : effort.Repetitions;
  return effort;
}

std::string GetFileName(const std::string& text)
{
  std::string name;
  for (char c : text)
  {
    if (std::isalnum(static_cast<unsigned char>(c)))
    {
      name += c;
    }
    else if (!name.empty() && name.back() != '-')
    {
      name += '-';
    }
  }
  name.erase(name.find_last_not_of('-') + 1);
  return name;
}

class Study
{
public:
  explicit Study(const StudyOptions& options)
    : Options(options)
    , Spent(GetEffort(options))
  {
  }

  int Run()
  {
    const auto begin = std::chrono::steady_clock::now();
    MakeFolder(this->Options.Folder);
    CheckWritable(this->Options.Folder + "/study.json");
    const std::vector<std::string>& scenes = this->Options.View.SceneNames;
    const std::string part = scenes.size() == 1 ? scenes.front() : "";
    if (part == "shadows")
    {
      this->RunShadows();
    }
    else if (part == "settings" || part == "shadow-settings")
    {
      this->RunSettingsAlone(part == "settings");
    }
    else
    {
      this->RunAll();
    }
    ShowProgress("");
    this->Report["seconds"] =
      Round(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    WriteJSON(this->Report, this->Options.Folder + "/study.json");
    if (this->Report.isMember("scenes"))
    {
      WriteStudyCSV(this->Report, this->Options.Folder + "/study.csv");
      WritePeersCSV(this->Report, this->Options.Folder);
    }
    if (this->IsOfCity)
    {
      WriteDocuments(this->Options, this->Report);
    }
    std::cout << "written to " << this->Options.Folder << " in " << this->Report["seconds"].asInt()
              << " s\n";
    return this->Wrong == 0 ? Success : ImagesDiffer;
  }

private:
  /// What was measured where.
  void Describe(const NBufferExamples::Scene& scene, Session& session)
  {
    this->Report = this->Options.View.Describe(scene, session);
    this->Report.removeMember("path");
    this->Report["effort"] = this->Options.Choose<std::string>("full", "quick", "tiny");
  }

  void RunSettingsAlone(bool ofCuller)
  {
    ViewOptions view = this->Options.View;
    view.SceneNames = { "city" };
    const NBufferExamples::Scene city = view.LoadScene();
    Session& session = Session::New(city, view.Window);
    this->Describe(city, session);
    this->RunSettings(city, session, ofCuller);
  }

  /// Of the city all there is; of another scene or path what is not about the city.
  void RunAll()
  {
    const NBufferExamples::Scene scene = this->Options.View.LoadScene();
    Session& session = Session::New(scene, this->Options.View.Window);
    this->Describe(scene, session);
    this->Report["default"] = NBufferStudy::GetDefaultName();
    this->IsOfCity = scene.Plan && this->Options.View.Path.empty();
    const std::vector<std::string> paths = this->IsOfCity
      ? std::vector<std::string>{ "street", "rooftop", "drone" }
      : std::vector<std::string>{ this->Options.View.GetPathName(scene) };
    this->Report["scenes"] = Json::Value(Json::arrayValue);
    this->Report["hierarchy"] = Json::Value(Json::arrayValue);
    for (const std::string& path : paths)
    {
      this->RunPath(scene, session, path);
    }
    for (const std::string& path : paths)
    {
      this->RunHierarchy(scene, session, path);
    }
    if (scene.Plan)
    {
      this->RunFormats(scene, session, "drone");
    }
    this->RunPaper(scene, session, paths.front());
    this->Report["device"] = MeasureDevice(session, this->MakePath(scene, paths.front(), 1).front(),
      this->Spent.DeviceRepetitions, this->Spent.MostDevicePixels,
      [](const std::string& size) { ShowProgress("the device: " + size); });
    if (this->IsOfCity)
    {
      if (!this->Options.LeavesOutSettings)
      {
        this->RunSettings(scene, session, true);
      }
      this->RunOtherScenes();
      this->RunShadows();
    }
  }

  NBufferExamples::CameraPath MakePath(
    const NBufferExamples::Scene& scene, const std::string& name, int frames) const
  {
    // As far as a walk of some minutes goes; once around everything else.
    const int length = scene.Plan || !scene.Paths.empty() ? 60 * frames : frames;
    return Spread(NBufferExamples::MakePath(scene, name, length, this->Options.View.Seed), frames);
  }

  void RunPath(const NBufferExamples::Scene& scene, Session& session, const std::string& name)
  {
    const int frames = this->Spent.Frames;
    const NBufferExamples::CameraPath poses = this->MakePath(scene, name, frames);
    const std::vector<NBufferStudy::DepthFrame> work = CollectFrames(session, poses,
      [&](std::size_t frame)
      {
        ShowProgress(name + ": which props own a pixel, frame " + std::to_string(frame + 1) +
          " of " + std::to_string(frames));
      });
    std::vector<NBufferStudy::ContenderPointer> contenders = NBufferStudy::MakeContenders(
      work.front().Width, work.front().Height, this->Options.Megabytes);
    if (scene.Known)
    {
      contenders.push_back(MakeKnownContender(*scene.Known, work, poses));
    }
    const int repetitions = this->Spent.Repetitions;
    const std::vector<NBufferStudy::ContestResult> results =
      NBufferStudy::RunContest(work, contenders, repetitions,
        [&](int turn, int turns)
        {
          ShowProgress(name + ": " + std::to_string(contenders.size()) + " structures, turn " +
            std::to_string(turn) + " of " + std::to_string(turns));
        });
    Json::Value report = ReportContest(work, results);
    if (scene.Known)
    {
      report["table"] = CheckKnown(session, *scene.Known, work, poses);
      const long long contradictions = report["table"]["contradictions"].asInt64();
      this->Wrong += contradictions;
      if (contradictions > 0)
      {
        std::cerr << "nbuffer-bench: " << contradictions
                  << " pixels belong to props that the map's table says cannot be seen\n";
      }
    }
    report["scene"] = scene.Name;
    report["path"] = name;
    report["size"] = std::to_string(work.front().Width) + "x" + std::to_string(work.front().Height);
    report["repetitions"] = repetitions;
    report["frames_by_mode"] = this->RunPeers(scene, session, name, report);
    AddLosses(report, report["frames_by_mode"]["draw_us"].asDouble());
    report["chart"] = "pareto-" + GetFileName(scene.Name) + "-" + GetFileName(name);
    WriteSceneChart(report, this->Options.Folder);
    for (const NBufferStudy::ContestResult& result : results)
    {
      if (result.Name == GetKnownName())
      {
        continue; // See CheckKnown.
      }
      this->Wrong += result.FalseHidden;
      if (result.FalseHidden > 0)
      {
        std::cerr << "nbuffer-bench: " << result.Name << " hides " << result.FalseHidden
                  << " visible props\n";
      }
    }
    this->Report["scenes"].append(report);
  }

  void RunOtherScenes()
  {
    this->Report["left_out"] = Json::Value(Json::arrayValue);
    for (const StudyScene& other : GetStudyScenes())
    {
      if (this->Options.IsTiny || (this->Options.IsQuick && !other.InQuick))
      {
        continue;
      }
      if (!other.IsThere(this->Options.Scenes))
      {
        this->Report["left_out"].append(other.Name);
        std::cout << other.Name << " is not in " << this->Options.Scenes << " and left out; "
                  << GetSceneCommand() << " builds it\n";
        continue;
      }
      ViewOptions view = this->Options.View;
      view.SceneNames = { other.GetPath(this->Options.Scenes) };
      const NBufferExamples::Scene scene = view.LoadScene();
      Session& session = Session::New(scene, view.Window);
      const Effort city = this->Spent;
      this->Spent.AllPeers = false;
      this->Spent.Frames = std::min(city.Frames, other.Frames);
      this->Spent.Repetitions = std::min(city.Repetitions, other.Repetitions);
      this->Spent.WalkFrames = std::min(city.WalkFrames, other.WalkFrames);
      this->Spent.LatentPairs = std::min(city.LatentPairs, other.LatentPairs);
      const std::size_t paths = this->Options.IsQuick ? 1 : other.Paths.size();
      for (std::size_t i = 0; i < paths; ++i)
      {
        this->RunPath(scene, session, other.Paths[i]);
      }
      this->Spent = city;
    }
  }

  void RunShadows()
  {
    const ShadowEffort effort =
      this->Options.Choose<ShadowEffort>({ 8, 640, 480, { 32, 64, 128, 256, 512, 1024 } },
        { 2, 320, 240, { 64, 256 } }, { 1, 320, 240, { 64 } });
    const bool isFull = !this->Options.IsTiny && !this->Options.IsQuick;
    this->Report["shadows"] = Json::Value(Json::arrayValue);
    for (const std::string& name : GetShadowSceneNames())
    {
      // The cheapest in a quick run, one of each kind in a tiny one.
      const bool isWanted =
        isFull || name == "birds" || (name == "city-sun" && this->Options.IsTiny);
      if (!isWanted)
      {
        continue;
      }
      const Json::Value scene = MeasureShadows(name, this->Options.View, effort, ShowProgress);
      WriteShadowCharts(scene, this->Options.Folder);
      this->Report["shadows"].append(scene);
      const long long wrong = GetWrongSamples(scene);
      this->Wrong += wrong;
      if (wrong > 0)
      {
        std::cerr << "nbuffer-bench: " << name << ": " << wrong << " samples in wrong light\n";
      }
    }
    WriteShadowCSV(this->Report["shadows"], this->Options.Folder + "/shadows.csv");
  }

  /// Of the culler in the city, and of shadows.
  void RunSettings(const NBufferExamples::Scene& city, Session& session, bool ofCuller)
  {
    const SettingsEffort full = { 15, { "street", "rooftop", "drone", "cuts" },
      { 8, 16, 24, 32, 48, 64, 128 }, true, GetShadowSceneNames(), { 8, 640, 480, {} } };
    const SettingsEffort quick = { 5, { "street" }, { 32 }, false, { "birds" },
      { 1, 320, 240, {} } };
    const SettingsEffort tiny = { 2, { "street" }, { 8 }, false, { "birds" }, { 1, 320, 240, {} } };
    const auto begin = std::chrono::steady_clock::now();
    session.GetWindow()->SetSize(this->Options.View.Window.Width, this->Options.View.Window.Height);
    SettingsEffort effort = this->Options.Choose(full, quick, tiny);
    if (!ofCuller)
    {
      effort.Paths.clear();
      effort.Plant = false;
    }
    Json::Value settings = MeasureSettings(city, session, this->Options.View, effort, ShowProgress);
    for (const char* part : { "culler", "still" })
    {
      for (const Json::Value& scene : settings[part])
      {
        this->CountWrong("settings", scene);
      }
    }
    for (const Json::Value& scene : settings["few"])
    {
      for (const Json::Value& entry : scene["entries"])
      {
        this->CountWrong("few props", entry);
      }
    }
    // They may be put beside the figures of another run.
    for (const char* name : { "renderer", "vtk", "size", "effort" })
    {
      settings[name] = this->Report[name];
    }
    settings["seconds"] =
      Round(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    WriteSettingsCharts(settings, this->Options.Folder);
    WriteSettingsCSV(settings, this->Options.Folder + "/settings.csv");
    this->Report["settings"] = settings;
  }

  /// Bytes that differ from VTK without cullers.
  void CountWrong(const std::string& what, const Json::Value& frames)
  {
    const long long bytes = frames["wrong_bytes"].asInt64();
    this->Wrong += bytes;
    if (bytes > 0)
    {
      std::cerr << "nbuffer-bench: " << what << " differ in " << bytes << " bytes\n";
    }
  }

  /// Whole frames, one pose after the other.
  Json::Value RunPeers(const NBufferExamples::Scene& scene, Session& session,
    const std::string& name, Json::Value& report)
  {
    const auto progress = [&name](const std::string& text)
    { ShowProgress(name + ": whole frames, " + text); };
    const int walkFrames = this->Spent.WalkFrames;
    const std::vector<std::string> modes = this->Spent.AllPeers
      ? GetPeersThatRun()
      : std::vector<std::string>{ "stock", "nbuffer", "oracle" };
    const Json::Value frames = MeasureFrames(session,
      scene.Plan ? NBufferExamples::MakePath(scene, name, walkFrames, this->Options.View.Seed)
                 : MakeRuns(NBufferExamples::MakePath(scene, name, 480, this->Options.View.Seed),
                     walkFrames),
      modes, progress);
    this->CountWrong("whole frames of " + name, frames);
    const NBufferExamples::CameraPath path =
      NBufferExamples::MakePath(scene, name, 480, this->Options.View.Seed);
    const std::string why = GetFragmentsObstacle(session.GetRenderer());
    if (this->Spent.AllPeers && why.empty())
    {
      report["fragments"] =
        MeasureFragments(session, path, modes, this->Spent.FragmentFrames, progress);
    }
    for (int step : { 1, 10 })
    {
      progress("by verdicts of " + std::to_string(step) + " poses ago");
      report["latent"].append(MeasureLatent(session, path, step, this->Spent.LatentPairs,
        this->Options.Folder + "/latent-" + GetFileName(scene.Name) + "-" + GetFileName(name) +
          "-" + std::to_string(step) + ".png"));
    }
    return frames;
  }

  /// All props of the scene, and copies of it, tested in a frame of the path.
  void RunHierarchy(const NBufferExamples::Scene& scene, Session& session, const std::string& name)
  {
    NBufferExamples::CameraPose pose = this->MakePath(scene, name, 1).front();
    if (scene.Plan)
    {
      pose.Near = 0.5;
      pose.Far = 20000.0; // The copies as well.
    }
    const NBufferStudy::DepthFrame frame =
      CollectFrames(session, { pose }, std::function<void(std::size_t)>()).front();
    Json::Value hierarchy;
    hierarchy["scene"] = scene.Name;
    hierarchy["path"] = name;
    hierarchy["entries"] = MeasureHierarchy(frame, CollectBoxes(session), pose.Eye,
      this->Spent.MostProps, this->Spent.Repetitions,
      [&](int count) { ShowProgress(name + ": hierarchy over " + std::to_string(count)); });
    hierarchy["chart"] = "hierarchy-" + GetFileName(scene.Name) + "-" + GetFileName(name);
    WriteHierarchyChart(hierarchy["entries"], scene.Name + ", " + name + ", copies side by side",
      this->Options.Folder + "/" + hierarchy["chart"].asString());
    this->Report["hierarchy"].append(hierarchy);
  }

  /// Of a view from above, where nothing is near: the planes can be a hundredfold apart.
  void RunFormats(const NBufferExamples::Scene& scene, Session& session, const std::string& name)
  {
    NBufferExamples::CameraPose pose = this->MakePath(scene, name, 1).front();
    pose.Near = 60.0;
    pose.Far = 6000.0;
    const NBufferStudy::DepthFrame frame =
      CollectFrames(session, { pose }, std::function<void(std::size_t)>()).front();
    Json::Value formats;
    formats["scene"] = scene.Name;
    formats["path"] = name;
    formats["entries"] = MeasureFormats(frame, pose.Near, pose.Far, this->Spent.Repetitions,
      [](const std::string& format) { ShowProgress("depth formats: " + format); });
    WriteFormatsChart(formats["entries"], scene.Name + ", " + name + ": formats of depth",
      this->Options.Folder + "/formats");
    for (const Json::Value& entry : formats["entries"])
    {
      this->Wrong += entry["false_hidden"].asInt();
    }
    this->Report["formats"] = formats;
  }

  void RunPaper(const NBufferExamples::Scene& scene, Session& session, const std::string& path)
  {
    ShowProgress("the paper's table 2");
    session.GetWindow()->SetSize(512, 512);
    this->Report["table2"] = MakeTable2(CollectFrames(session,
      this->MakePath(scene, path, this->Spent.PaperFrames), std::function<void(std::size_t)>()));
    this->Wrong += this->Report["table2"]["false_hidden"].asInt();
    ShowProgress("the paper's table 1");
    this->Report["table1"] = MakeTable1(session, this->MakePath(scene, path, 1).front(),
      this->Spent.PaperRepetitions, this->Spent.LargestImage);
    ShowProgress("the paper's figure 4");
    this->Report["figure4"] = MakeFigure4(this->Spent.LargestRectangle, this->Options.Folder);
  }

  const StudyOptions& Options;
  Effort Spent;
  Json::Value Report;
  bool IsOfCity = false; ///< What the documents are about.
  long long Wrong = 0;   ///< Visible props that were hidden, bytes that differ, samples.
};
}

int RunStudy(const StudyOptions& options)
{
  return Study(options).Run();
}

} // namespace NBufferBench
