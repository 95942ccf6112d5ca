// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"

#include "Contest.h"
#include "DepthFormats.h"

namespace NBufferBench
{

Json::Value MeasureFormats(
  const NBufferStudy::DepthFrame& frame, double near, double far, int repetitions)
{
  using namespace NBufferStudy;
  Json::Value entries(Json::arrayValue);
  for (double ratio = far / near; ratio < 2e7; ratio *= 10.0)
  {
    for (const DepthFormat& format : GetDepthFormats())
    {
      ShowProgress(std::string("depth formats: ") + format.Name);
      std::vector<DepthFrame> frames = { Convert(frame, near, far, far / ratio, format) };
      std::vector<ContenderPointer> contenders;
      contenders.push_back(MakeFamilyContender(DepthFamily()));
      const ContestResult result = RunContest(frames, contenders, repetitions, nullptr).front();
      Json::Value entry;
      entry["ratio"] = Round(ratio);
      entry["format"] = format.Name;
      entry["boxes"] = static_cast<Json::Int64>(result.Boxes);
      entry["hidden"] = static_cast<Json::Int64>(result.Hidden);
      entry["false_visible"] = static_cast<Json::Int64>(result.FalseVisible);
      entry["false_hidden"] = static_cast<Json::Int64>(result.FalseHidden);
      entry["total_ms"] = Summarize(result.GetTimes());
      entry["slack"] = Summarize(GetSlacks(frames.front(), far / ratio, far, format));
      entries.append(entry);
    }
  }
  return entries;
}

} // namespace NBufferBench
