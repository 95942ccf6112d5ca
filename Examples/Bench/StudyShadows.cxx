// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyShadows.h"

#include "Report.h"
#include "ShadowMode.h"
#include "ShadowScene.h"
#include "StudyChart.h"
#include "StudyReport.h"

#include "vtkNBufferCuller.h"
#include "vtkNew.h"
#include "vtkPlotPoints.h"
#include "vtkShadowVolumeClampPass.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
struct Look
{
  const char* Mode;
  const char* Label;
  unsigned char Color[3];
  int Marker;
};
constexpr Look Looks[] = {
  { "unclamped", "unclamped", { 0, 0, 0 }, vtkPlotPoints::SQUARE },
  { "exact", "exact", { 0, 114, 178 }, vtkPlotPoints::SQUARE },
  { "clamp", "clamp: one slab", { 230, 159, 0 }, vtkPlotPoints::CIRCLE },
  { "slabs", "clamp: several slabs", { 204, 121, 167 }, vtkPlotPoints::DIAMOND },
  { "auto", "automatic", { 0, 158, 115 }, vtkPlotPoints::DIAMOND },
  { "paper", "the paper's litmap", { 213, 94, 0 }, vtkPlotPoints::CROSS },
  { "vtk", "vtkShadowMapPass", { 120, 120, 120 }, vtkPlotPoints::PLUS },
};

std::string GetMode(const Json::Value& point)
{
  const std::string name = point["name"].asString();
  return name.substr(0, name.find('@'));
}

double GetTime(const Json::Value& point)
{
  return point["ms"]["median"].asDouble();
}

double GetFragments(const Json::Value& point)
{
  return point["fragments_percent"].asDouble();
}

double GetWrong(const Json::Value& point)
{
  return point["wrong_percent"].asDouble();
}

std::vector<std::string> MakeModes(const std::vector<int>& litmaps)
{
  std::vector<std::string> modes = { "none", "unclamped" };
  for (int litmap : litmaps)
  {
    for (const char* mode : { "auto", "exact", "clamp", "slabs" })
    {
      modes.push_back(mode + ("@" + std::to_string(litmap)));
    }
  }
  for (const char* mode : { "paper@256", "vtk@256", "vtk@1024" })
  {
    modes.emplace_back(mode);
  }
  return modes;
}

Json::Value MakePoint(
  const ShadowWalkResult& result, const std::string& name, const std::string& defaultName)
{
  Json::Value point;
  point["name"] = name;
  const std::size_t at = name.find('@');
  point["litmap"] = at == std::string::npos ? 0 : std::stoi(name.substr(at + 1));
  point["ms"] = Summarize(result.Walk.Modes.at(name).Milliseconds);
  point["fragments_percent"] = -1;
  const auto fragments = result.Fragments.find(name);
  if (fragments != result.Fragments.end())
  {
    const auto all = static_cast<double>(result.Fragments.at("unclamped"));
    point["fragments"] =
      Round(static_cast<double>(fragments->second) / static_cast<double>(result.Walk.Frames));
    point["fragments_percent"] =
      Round(100.0 * static_cast<double>(fragments->second) / std::max(all, 1.0));
  }
  const OracleCounts& counts = result.Oracle.at(name);
  point["samples"] = static_cast<Json::Int64>(counts.Samples);
  point["wrong"] = static_cast<Json::Int64>(counts.Wrong);
  point["wrong_percent"] = Round(
    100.0 * static_cast<double>(counts.Wrong) / static_cast<double>(std::max(counts.Samples, 1LL)));
  point["ambiguous"] = static_cast<Json::Int64>(counts.Ambiguous);
  point["must_be_exact"] = ShadowMode::IsExact(name);
  point["is_default"] = name == defaultName;
  return point;
}

/// Nothing that is right is faster and covers less.
void MarkRight(Json::Value& points)
{
  constexpr double never = std::numeric_limits<double>::infinity();
  MarkPareto(points, GetTime, [](const Json::Value& point)
    { return GetWrong(point) > 0.0 || GetFragments(point) < 0.0 ? never : GetFragments(point); });
}
}

const std::vector<std::string>& GetShadowSceneNames()
{
  static const std::vector<std::string> names = { "city-sun", "city-spot", "birds", "simple" };
  return names;
}

ShadowWalkResult WalkShadows(const std::string& name, const ViewOptions& common,
  const ShadowEffort& effort, ShadowWalkOptions& options,
  const std::function<void(const std::string&)>& progress, Json::Value& report)
{
  ViewOptions view = common;
  view.SceneNames = { name };
  view.Window.Width = std::min(view.Window.Width, effort.Width);
  view.Window.Height = std::min(view.Window.Height, effort.Height);
  const NBufferExamples::Scene scene = LoadShadowScene(view);
  view.Frames = effort.Frames;
  const NBufferExamples::CameraPath path = view.MakePath(scene, effort.Frames);
  Session& session = Session::New(scene, view.Window);
  vtkLight* light = LightScene(name, scene, path, session.GetRenderer());
  vtkNew<vtkNBufferCuller> culler;
  session.GetRenderer()->AddCuller(culler);
  options.CasterKeys = MarkCasters(name, scene);
  options.Block = 2; // Many modes: turns have to be short to meet the same disturbances.
  options.Progress = [&](const std::string& text) { progress(name + ": " + text); };
  report["scene"] = name;
  report["path"] = view.GetPathName(scene);
  report["size"] = session.GetSize();
  report["frames"] = static_cast<Json::UInt64>(path.size());
  return RunShadowWalk(session, light, path, options);
}

Json::Value MeasureShadows(const std::string& name, const ViewOptions& common,
  const ShadowEffort& effort, const std::function<void(const std::string&)>& progress)
{
  ShadowWalkOptions options;
  options.Modes = MakeModes(effort.Litmaps);
  options.Oracle = true;
  options.OracleOnce = true; // Up to a minute for an image of the city.
  Json::Value report;
  const ShadowWalkResult result = WalkShadows(name, common, effort, options, progress, report);

  vtkNew<vtkShadowVolumeClampPass> usual;
  const std::string defaultName = "auto@" + std::to_string(usual->GetLitmapResolution());
  report["none_ms"] = Summarize(result.Walk.Modes.at("none").Milliseconds);
  report["shadowed_percent"] = Round(100.0 * static_cast<double>(result.Shadowed) /
    static_cast<double>(std::max(result.Fragments.at("unclamped"), 1LL)));
  report["points"] = Json::Value(Json::arrayValue);
  for (const std::string& mode : options.Modes)
  {
    if (mode != "none")
    {
      report["points"].append(MakePoint(result, mode, defaultName));
    }
  }
  MarkRight(report["points"]);
  return report;
}

void WriteShadowCharts(const Json::Value& scene, const std::string& folder)
{
  const auto write = [&](const std::function<double(const Json::Value&)>& error,
                       const std::string& left, const std::string& bound, double least,
                       const Json::Value& points, const std::string& stem)
  {
    ErrorChart chart;
    chart.Bottom = "milliseconds of a frame with shadows";
    chart.Left = left;
    chart.Bound = bound;
    chart.Least = least;
    for (const Look& look : Looks)
    {
      chart.Groups.push_back(
        { look.Label, { look.Color[0], look.Color[1], look.Color[2] }, look.Marker, {} });
      for (const Json::Value& point : points)
      {
        if (GetMode(point) == look.Mode && error(point) >= 0.0)
        {
          chart.Groups.back().Points.emplace_back(GetTime(point), error(point));
        }
      }
    }
    for (const Json::Value& point : points)
    {
      if (point["pareto"].asBool())
      {
        chart.Pareto.emplace_back(GetTime(point), error(point));
      }
      if (point["is_default"].asBool())
      {
        chart.Default.emplace_back(GetTime(point), error(point));
      }
    }
    WriteErrorChart(chart, scene["scene"].asString() + ", shadows, " + scene["size"].asString(),
      folder + "/" + stem + scene["scene"].asString());
  };
  write(GetFragments, "fragments of volumes, % of whole ones", "pixels that shadows change",
    scene["shadowed_percent"].asDouble(), scene["points"], "shadows-");
  Json::Value byError = scene["points"];
  MarkPareto(byError, GetTime, GetWrong);
  write(GetWrong, "samples that differ from rays and are not ambiguous, %", "none", 0.0, byError,
    "shadow-errors-");
}

long long GetWrongSamples(const Json::Value& scene)
{
  long long wrong = 0;
  for (const Json::Value& point : scene["points"])
  {
    wrong += point["must_be_exact"].asBool() ? point["wrong"].asInt64() : 0;
  }
  return wrong;
}

void WriteShadowCSV(const Json::Value& scenes, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << "scene,path,name,litmap,default,pareto,ms,ms_p10,ms_p90,fragments,fragments_percent,"
          "samples,wrong,ambiguous\n";
  for (const Json::Value& scene : scenes)
  {
    for (const Json::Value& point : scene["points"])
    {
      file << scene["scene"].asString() << ',' << scene["path"].asString() << ','
           << point["name"].asString() << ',' << point["litmap"].asInt() << ','
           << point["is_default"].asBool() << ',' << point["pareto"].asBool() << ','
           << GetTime(point) << ',' << point["ms"]["p10"].asDouble() << ','
           << point["ms"]["p90"].asDouble() << ',' << point["fragments"].asDouble() << ','
           << GetFragments(point) << ',' << point["samples"].asInt64() << ','
           << point["wrong"].asInt64() << ',' << point["ambiguous"].asInt64() << '\n';
    }
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferBench
