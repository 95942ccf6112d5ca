// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyReport.h"

#include "Report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferStudy::ContestResult;
using NBufferStudy::DepthFrame;

/// What a point is drawn as; names are those of Contender.cxx.
std::string GetGroup(const std::string& name)
{
  const auto begins = [&name](const char* text) { return name.rfind(text, 0) == 0; };
  const auto has = [&name](const char* text) { return name.find(text) != std::string::npos; };
  return begins("culler") ? "culler"
    : begins("outline")   ? "outline"
    : begins("table")     ? "table"
    : has("positions")    ? "positions"
    : begins("one level") ? "one level"
    : has("mips")         ? "mips"
    : begins("rect")      ? "rectangles"
    : has(" s=")          ? "strided"
    : has(" in 8")        ? "squares in pieces"
    : has("x1 ")          ? "one square"
                          : "four squares";
}

double GetTotal(const Json::Value& point)
{
  return point["total_ms"]["median"].asDouble();
}

double GetError(const Json::Value& point)
{
  return point["false_visible_percent"].asDouble();
}

Json::Value ReportPoint(const ContestResult& result, double frames)
{
  Json::Value point;
  point["name"] = result.Name;
  point["group"] = GetGroup(result.Name);
  point["is_default"] = result.Name == NBufferStudy::GetDefaultName();
  point["false_visible_percent"] = Round(100.0 * result.GetFalseVisibleShare());
  point["false_hidden"] = static_cast<Json::Int64>(result.FalseHidden);
  point["over_covered_percent"] =
    result.CoveredArea > 0.0 ? Round(100.0 * result.GetOverCoverage()) : Json::Value(-1);
  point["build_ms"] = Summarize(result.BuildTimes);
  point["query_ms"] = Summarize(result.QueryTimes);
  point["total_ms"] = Summarize(result.GetTimes());
  point["queries"] = Round(static_cast<double>(result.Counts.Queries) / frames);
  point["lookups"] = Round(static_cast<double>(result.Counts.Lookups) / frames);
  point["texels"] = static_cast<Json::UInt64>(result.Texels);
  point["bytes"] = static_cast<Json::UInt64>(result.Memory);
  return point;
}
}

Json::Value Summarize(const std::vector<double>& values)
{
  Json::Value summary;
  summary["median"] = Round(GetQuantile(values, 0.5));
  summary["p10"] = Round(GetQuantile(values, 0.1));
  summary["p90"] = Round(GetQuantile(values, 0.9));
  return summary;
}

void MarkPareto(Json::Value& points, const std::function<double(const Json::Value&)>& time,
  const std::function<double(const Json::Value&)>& error)
{
  std::vector<Json::ArrayIndex> order(points.size());
  for (Json::ArrayIndex i = 0; i < points.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [&](Json::ArrayIndex a, Json::ArrayIndex b) { return time(points[a]) < time(points[b]); });
  double least = std::numeric_limits<double>::infinity();
  for (Json::ArrayIndex i : order)
  {
    const bool better = error(points[i]) < least;
    points[i]["pareto"] = better;
    least = std::min(least, error(points[i]));
  }
}

Json::Value ReportContest(
  const std::vector<DepthFrame>& frames, const std::vector<ContestResult>& results)
{
  Json::Value scene;
  const auto count = static_cast<double>(frames.size());
  double inView = 0.0;
  double hidden = 0.0;
  double crossing = 0.0;
  double props = 0.0;
  for (const DepthFrame& frame : frames)
  {
    inView += static_cast<double>(frame.Boxes.size());
    crossing += frame.Crossing;
    props = static_cast<double>(frame.Boxes.size()) + frame.Crossing + frame.Outside +
      frame.NotCandidates;
    hidden += static_cast<double>(std::count_if(frame.Boxes.begin(), frame.Boxes.end(),
      [](const NBufferStudy::DepthBox& box) { return !box.Visible; }));
  }
  scene["frames"] = static_cast<Json::UInt64>(frames.size());
  scene["props"] = props;
  scene["in_view"] = Round(inView / count);
  scene["hidden"] = Round(hidden / count);
  scene["crossing"] = Round(crossing / count);
  Json::Value& points = scene["points"] = Json::Value(Json::arrayValue);
  for (const ContestResult& result : results)
  {
    points.append(ReportPoint(result, count));
  }
  MarkPareto(points, GetTotal, GetError);
  return scene;
}

void AddLosses(Json::Value& scene, double microsecondsPerProp)
{
  for (Json::Value& point : scene["points"])
  {
    const double kept = 0.01 * GetError(point) * scene["hidden"].asDouble();
    point["loss_ms"] = Round(GetTotal(point) + 1e-3 * kept * microsecondsPerProp);
  }
}

void WriteStudyCSV(const Json::Value& report, const std::string& fileName)
{
  std::ofstream file(fileName);
  file << "scene,path,name,group,default,pareto,false_visible_percent,false_hidden,"
          "over_covered_percent,build_ms,query_ms,total_ms,total_ms_p10,total_ms_p90,loss_ms,"
          "queries,lookups,texels,bytes\n";
  for (const Json::Value& scene : report["scenes"])
  {
    for (const Json::Value& point : scene["points"])
    {
      file << scene["scene"].asString() << ',' << scene["path"].asString() << ','
           << point["name"].asString() << ',' << point["group"].asString() << ','
           << point["is_default"].asBool() << ',' << point["pareto"].asBool() << ','
           << GetError(point) << ',' << point["false_hidden"].asInt64() << ','
           << point["over_covered_percent"].asDouble() << ','
           << point["build_ms"]["median"].asDouble() << ','
           << point["query_ms"]["median"].asDouble() << ',' << GetTotal(point) << ','
           << point["total_ms"]["p10"].asDouble() << ',' << point["total_ms"]["p90"].asDouble()
           << ',' << point["loss_ms"].asDouble() << ',' << point["queries"].asDouble() << ','
           << point["lookups"].asDouble() << ',' << point["texels"].asUInt64() << ','
           << point["bytes"].asUInt64() << '\n';
    }
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

} // namespace NBufferBench
