// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyFormats.h"

#include "Report.h"
#include "StudyChart.h"
#include "StudyReport.h"

#include "Contest.h"
#include "DepthFormats.h"

#include <algorithm>

namespace NBufferBench
{
namespace
{
using namespace NBufferStudy;
}

Json::Value MeasureFormats(const DepthFrame& frame, double near, double far, int repetitions,
  const std::function<void(const std::string&)>& progress)
{
  Json::Value entries(Json::arrayValue);
  for (double ratio = far / near; ratio < 2e7; ratio *= 10.0)
  {
    for (const DepthFormat& format : GetDepthFormats())
    {
      if (progress)
      {
        progress(format.Name);
      }
      std::vector<DepthFrame> frames = { Convert(frame, near, far, far / ratio, format) };
      std::vector<ContenderPointer> contenders;
      contenders.push_back(MakeFamilyContender(DepthFamily(), 8));
      const ContestResult result = RunContest(frames, contenders, repetitions, nullptr).front();
      Json::Value entry;
      entry["ratio"] = Round(ratio);
      entry["format"] = format.Name;
      entry["boxes"] = static_cast<Json::Int64>(result.Boxes);
      entry["false_visible_percent"] = Round(100.0 * result.GetFalseVisibleShare());
      entry["false_hidden"] = static_cast<Json::Int64>(result.FalseHidden);
      entry["total_ms"] = Summarize(result.GetTimes());
      entry["slack"] = Summarize(GetSlacks(frames.front(), far / ratio, far, format));
      entries.append(entry);
    }
  }
  return entries;
}

void WriteFormatsChart(
  const Json::Value& entries, const std::string& title, const std::string& fileStem)
{
  constexpr unsigned char colors[][3] = { { 213, 94, 0 }, { 0, 114, 178 }, { 86, 180, 233 },
    { 0, 158, 115 }, { 120, 120, 120 }, { 0, 0, 0 }, { 230, 159, 0 }, { 204, 121, 167 } };
  std::vector<ChartLine> lines;
  for (const DepthFormat& format : GetDepthFormats())
  {
    const unsigned char* color = colors[lines.size()];
    lines.push_back({ format.Name, { color[0], color[1], color[2] }, {} });
    for (const Json::Value& entry : entries)
    {
      if (entry["format"].asString() == format.Name)
      {
        lines.back().Points.emplace_back(
          entry["ratio"].asDouble(), std::max(entry["slack"]["median"].asDouble(), 1e-4));
      }
    }
  }
  WriteLineChart(lines, title, "far / near", "median slack of a box, metres", fileStem);
}

} // namespace NBufferBench
