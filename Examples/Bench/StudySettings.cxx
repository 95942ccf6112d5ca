// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudySettings.h"

#include "ModeSettings.h"
#include "Report.h"
#include "ShadowWalk.h"
#include "StudyFrames.h"
#include "StudyReport.h"
#include "VisibleProps.h"
#include "Walk.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkShadowVolumeClampPass.h"

#include <algorithm>
#include <map>
#include <vector>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

struct Values
{
  const char* Setting;
  std::vector<int> Tried;
};

const std::vector<Values>& GetCullerValues()
{
  static const std::vector<Values> values = { { "RoundSize", { 16, 32, 64, 128, 256, 1024 } },
    { "MaximumNumberOfRounds", { 1, 2, 3, 4, 6, 8 } }, { "BaseFactor", { 1, 2, 4, 8 } },
    { "MaximumNumberOfPieces", { 1, 2, 4, 8 } }, { "TestPixels", { 0, 1 } },
    { "BackOff", { 0, 1 } }, { "TakeOverFrustumCulling", { 0, 1 } } };
  return values;
}

/// Where culling gains little.
const std::vector<Values>& GetRestValues()
{
  static const std::vector<Values> values = { { "BackOff", { 0, 1 } }, { "BaseFactor", { 4, 8 } } };
  return values;
}

/// The default under other names. After a mode that draws everything the next one finds nothing of
/// its own in the caches: the first of these pays, and is not reported. The one drawn again, far
/// from the default's turn, shows what ratios are worth.
constexpr const char* CullerWarmUp = "nbuffer:TestPixels=1";
constexpr const char* CullerAgain = "nbuffer:BackOff=1";
constexpr const char* ShadowsWarmUp = "auto:SlabGap=4";
constexpr const char* ShadowsAgain = "auto:BoxCost=256";

std::string MakeName(const std::string& kind, const char* setting, int value)
{
  return kind + ":" + setting + "=" + std::to_string(value);
}

/// The default value stands for the mode without settings.
template <typename Object>
std::string MakeName(const std::string& kind, const char* setting, int value, Object* usual)
{
  return GetSetting(setting, usual) == value ? kind : MakeName(kind, setting, value);
}

void AddMode(std::vector<std::string>& modes, const std::string& name)
{
  if (std::find(modes.begin(), modes.end(), name) == modes.end())
  {
    modes.push_back(name);
  }
}

Json::Value MakePoint(const WalkResult& walk, const std::string& mode, const std::string& kind)
{
  Json::Value point;
  point["mode"] = mode;
  point["kind"] = kind;
  point["ms"] = Summarize(walk.Modes.at(mode).Milliseconds);
  point["ratio"] = Round(GetMedianRatio(walk.Modes.at(mode), walk.Modes.at(kind)));
  point["is_default"] = mode == kind;
  return point;
}

double GetDrawn(const WalkResult& walk, const std::string& mode)
{
  const std::vector<int>& drawn = walk.Modes.at(mode).Drawn;
  return GetQuantile(std::vector<double>(drawn.begin(), drawn.end()), 0.5);
}

/// Props that own a pixel, by frame; of some frames, for it takes longer than all modes together.
using SeenProps = std::map<std::size_t, std::size_t>;

SeenProps CountSeen(Session& session, const CameraPath& path)
{
  constexpr std::size_t step = 5;
  CameraPath some;
  for (std::size_t frame = 0; frame < path.size(); frame += step)
  {
    some.push_back(path[frame]);
  }
  const std::vector<std::vector<vtkProp*>> props =
    FindVisibleProps(session, some, [](std::size_t) {});
  SeenProps seen;
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    seen[step * i] = props[i].size();
  }
  return seen;
}

/// Of the hidden props those that a mode draws.
double GetKeptPercent(const WalkResult& walk, const std::string& mode, const SeenProps& seen)
{
  double kept = 0.0;
  double hidden = 0.0;
  for (const auto& [frame, count] : seen)
  {
    kept += static_cast<double>(walk.Modes.at(mode).Drawn[frame]) - static_cast<double>(count);
    hidden += static_cast<double>(walk.Modes.at("stock").Drawn[frame]) - static_cast<double>(count);
  }
  return hidden > 0.0 ? 100.0 * kept / hidden : 0.0;
}

Json::Value MakeCullerPoint(const WalkResult& walk, const std::string& mode, const SeenProps& seen)
{
  Json::Value point = MakePoint(walk, mode, "nbuffer");
  std::vector<double> rounds;
  for (const std::string& text : walk.Modes.at(mode).Statistics)
  {
    rounds.push_back(Parse(text)["rounds"].asDouble());
  }
  point["rounds"] = Round(GetQuantile(rounds, 0.5));
  point["drawn"] = GetDrawn(walk, mode);
  if (!seen.empty())
  {
    point["kept_percent"] = Round(GetKeptPercent(walk, mode, seen));
  }
  return point;
}

Json::Value MeasureValues(Session& session, const CameraPath& path,
  const std::vector<Values>& values, bool still, const Progress& progress)
{
  vtkNew<vtkNBufferCuller> usual;
  WalkOptions options;
  options.Modes = { "none", "stock", CullerWarmUp };
  options.Verify = true;
  options.Still = still;
  options.Progress = progress;
  for (const Values& row : values)
  {
    for (int value : row.Tried)
    {
      AddMode(options.Modes, MakeName("nbuffer", row.Setting, value, usual.Get()));
    }
  }
  options.Modes.emplace_back(CullerAgain);
  const SeenProps seen = still ? SeenProps() : CountSeen(session, path);
  const WalkResult walk = RunWalk(session, path, options);
  Json::Value report;
  report["size"] = session.GetSize();
  report["frames"] = static_cast<Json::UInt64>(path.size());
  report["stock_ms"] = Summarize(walk.Modes.at("stock").Milliseconds);
  report["wrong_bytes"] = static_cast<Json::Int64>(GetDifferingBytes(walk));
  report["again_ratio"] =
    Round(GetMedianRatio(walk.Modes.at(CullerAgain), walk.Modes.at("nbuffer")));
  report["points"] = Json::Value(Json::arrayValue);
  for (const Values& row : values)
  {
    for (int value : row.Tried)
    {
      Json::Value point =
        MakeCullerPoint(walk, MakeName("nbuffer", row.Setting, value, usual.Get()), seen);
      point["setting"] = row.Setting;
      point["value"] = value;
      report["points"].append(point);
    }
  }
  return report;
}

/// What VTK draws of the renderer; all again at the end.
class ShownProps
{
public:
  explicit ShownProps(vtkRenderer* renderer)
  {
    vtkPropCollection* list = renderer->GetViewProps();
    vtkCollectionSimpleIterator iterator;
    list->InitTraversal(iterator);
    while (vtkProp* prop = list->GetNextProp(iterator))
    {
      this->Props.push_back(prop);
    }
  }
  ~ShownProps()
  {
    for (vtkProp* prop : this->Props)
    {
      prop->VisibilityOn();
    }
  }
  ShownProps(const ShownProps&) = delete;
  void operator=(const ShownProps&) = delete;

  void ShowOnly(const std::vector<DepthBox>& boxes, std::size_t number)
  {
    for (vtkProp* prop : this->Props)
    {
      prop->VisibilityOff();
    }
    for (std::size_t i = 0; i < std::min(number, boxes.size()); ++i)
    {
      this->Props[static_cast<std::size_t>(boxes[i].Prop)]->VisibilityOn();
    }
  }

private:
  std::vector<vtkProp*> Props;
};

struct ShadowValues
{
  const char* Kind;
  Values Row;
};

const std::vector<ShadowValues>& GetShadowValues()
{
  const std::vector<int> costs = { 8, 16, 64, 256, 1024, 4096 };
  static const std::vector<ShadowValues> values = { { "auto", { "BoxCost", costs } },
    { "exact", { "BoxCost", costs } }, { "slabs", { "BoxCost", costs } },
    { "slabslit", { "BoxCost", { 8, 64, 256 } } },
    { "slabs", { "SlabGap", { 1, 2, 4, 8, 16, 64 } } } };
  return values;
}
}

Json::Value MeasureCullerSettings(
  Session& session, const CameraPath& path, bool onlyRest, const Progress& progress)
{
  return MeasureValues(
    session, path, onlyRest ? GetRestValues() : GetCullerValues(), false, progress);
}

Json::Value MeasureStill(Session& session, const CameraPath& path, const Progress& progress)
{
  return MeasureValues(session, path, { { "ReuseWhenStill", { 0, 1 } } }, true, progress);
}

Json::Value MeasureFewProps(Session& session, const CameraPath& path,
  const std::vector<std::size_t>& numbers, const Progress& progress)
{
  std::vector<DepthBox> boxes =
    CollectFrames(session, { path.front() }, std::function<void(std::size_t)>()).front().Boxes;
  std::stable_sort(boxes.begin(), boxes.end(),
    [](const DepthBox& a, const DepthBox& b) { return a.Screen.Nearest < b.Screen.Nearest; });
  ShownProps shown(session.GetRenderer());
  Json::Value entries(Json::arrayValue);
  for (const std::size_t number : numbers)
  {
    if (number > boxes.size())
    {
      break;
    }
    shown.ShowOnly(boxes, number);
    WalkOptions options;
    const std::vector<std::string> reported = { "nbuffer", "nbuffer:MinimumNumberOfCandidates=1",
      "nbuffer:MinimumNumberOfCandidates=1:BackOff=0" };
    options.Modes = { "none", CullerWarmUp, "stock" };
    options.Modes.insert(options.Modes.end(), reported.begin(), reported.end());
    options.Verify = true;
    options.Progress = progress;
    const WalkResult walk = RunWalk(session, path, options);
    Json::Value entry;
    entry["props"] = static_cast<Json::UInt64>(number);
    entry["drawn"] = GetDrawn(walk, reported.back());
    entry["stock_ms"] = Summarize(walk.Modes.at("stock").Milliseconds);
    entry["wrong_bytes"] = static_cast<Json::Int64>(GetDifferingBytes(walk));
    for (const std::string& mode : reported)
    {
      Json::Value point = MakePoint(walk, mode, "stock");
      point["is_default"] = mode == "nbuffer";
      point["drawn"] = GetDrawn(walk, mode);
      entry["points"].append(point);
    }
    entries.append(entry);
  }
  return entries;
}

Json::Value MeasureShadowSettings(const std::string& name, const ViewOptions& common,
  const ShadowEffort& effort, const Progress& progress)
{
  vtkNew<vtkShadowVolumeClampPass> usual;
  ShadowWalkOptions options;
  options.Modes = { "none", "unclamped", ShadowsWarmUp };
  for (const ShadowValues& row : GetShadowValues())
  {
    for (int value : row.Row.Tried)
    {
      AddMode(options.Modes, row.Kind);
      AddMode(options.Modes, MakeName(row.Kind, row.Row.Setting, value, usual.Get()));
    }
  }
  options.Modes.emplace_back(ShadowsAgain);
  Json::Value report;
  const ShadowWalkResult result = WalkShadows(name, common, effort, options, progress, report);
  report["none_ms"] = Summarize(result.Walk.Modes.at("none").Milliseconds);
  report["unclamped_ms"] = Summarize(result.Walk.Modes.at("unclamped").Milliseconds);
  const auto whole = static_cast<double>(std::max(result.Fragments.at("unclamped"), 1LL));
  report["again_ratio"] =
    Round(GetMedianRatio(result.Walk.Modes.at(ShadowsAgain), result.Walk.Modes.at("auto")));
  report["shadowed_percent"] = Round(100.0 * static_cast<double>(result.Shadowed) / whole);
  report["points"] = Json::Value(Json::arrayValue);
  for (const ShadowValues& row : GetShadowValues())
  {
    for (int value : row.Row.Tried)
    {
      const std::string mode = MakeName(row.Kind, row.Row.Setting, value, usual.Get());
      Json::Value point = MakePoint(result.Walk, mode, row.Kind);
      point["setting"] = row.Row.Setting;
      point["value"] = value;
      point["fragments_percent"] =
        Round(100.0 * static_cast<double>(result.Fragments.at(mode)) / whole);
      report["points"].append(point);
    }
  }
  return report;
}

Json::Value MeasureSettings(const NBufferExamples::Scene& city, Session& session,
  const ViewOptions& view, const SettingsEffort& effort, const Progress& progress)
{
  Json::Value report;
  const auto add = [&](const char* part, const NBufferExamples::Scene& scene,
                     const std::string& path, Json::Value entry)
  {
    entry["scene"] = scene.Name;
    entry["path"] = path;
    report[part].append(entry);
  };
  const auto makePath = [&](const NBufferExamples::Scene& scene, const std::string& name)
  {
    CameraPath path = NBufferExamples::MakePath(
      scene, name, scene.Plan ? effort.Frames : std::max(480, effort.Frames), view.Seed);
    path.resize(static_cast<std::size_t>(effort.Frames));
    return path;
  };
  for (const std::string& name : effort.Paths)
  {
    const Progress tell = [&](const std::string& text) { progress(name + ": settings, " + text); };
    const CameraPath path = makePath(city, name);
    add("culler", city, name, MeasureCullerSettings(session, path, false, tell));
    if (name == "cuts")
    {
      continue;
    }
    add("still", city, name, MeasureStill(session, path, tell));
    Json::Value few;
    few["entries"] = MeasureFewProps(session, path, effort.FewProps, tell);
    add("few", city, name, few);
  }
  if (effort.Plant)
  {
    ViewOptions ofPlant = view;
    ofPlant.SceneNames = { "plant" };
    const NBufferExamples::Scene plant = ofPlant.LoadScene();
    add("culler", plant, "around",
      MeasureCullerSettings(Session::New(plant, view.Window), makePath(plant, "around"), true,
        [&](const std::string& text) { progress("plant: settings, " + text); }));
  }
  for (const std::string& name : effort.ShadowScenes)
  {
    report["shadows"].append(MeasureShadowSettings(name, view, effort.Shadows, progress));
  }
  return report;
}

} // namespace NBufferBench
