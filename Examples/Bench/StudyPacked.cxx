// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "PackedLevels.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"

#include "vtkOpenGLRenderWindow.h"

namespace NBufferBench
{
namespace
{
using NBufferPeers::PackedLevels;

Json::Value Measure(vtkOpenGLRenderWindow* window, int width, int height, int repetitions)
{
  Json::Value entry;
  const std::string obstacle = PackedLevels::WhyNot(width, height);
  if (!obstacle.empty())
  {
    entry["skipped"] = obstacle;
    return entry;
  }
  PackedLevels packed;
  vtkNew<vtkNBufferTexture> arrays;
  vtkNew<vtkNBufferTexture> extrema;
  vtkNew<vtkNBufferTexture> base;
  extrema->BothExtremaOn();
  const auto time = [window](std::vector<double>& milliseconds, auto&& function)
  {
    window->WaitForCompletion();
    const vtkNBufferClock clock;
    function();
    window->WaitForCompletion();
    milliseconds.push_back(clock.GetMilliseconds());
  };
  const auto build = [&](vtkNBufferTexture* texture, int levels)
  {
    Check(texture->Build(window, 1, levels, vtkNBufferExtremum::Maximum),
      "packed levels: ", texture->GetError());
  };
  entry = Repeat(repetitions,
    [&](NamedTimes& times)
    {
      time(times["base_ms"], [&]() { build(base, 1); });
      time(times["arrays_ms"], [&]() { build(arrays, AllLevels); });
      time(times["both_extrema_ms"], [&]() { build(extrema, AllLevels); });
      time(times["packed_ms"],
        [&]()
        {
          build(base, 1);
          packed.Build(window, base);
        });
      time(times["query_arrays_ms"], [&]() { packed.Query(window, arrays); });
      const std::vector<float> expected = packed.ReadDepths();
      time(times["query_packed_ms"], [&]() { packed.Query(window, nullptr); });
      Check(packed.ReadDepths() == expected,
        "packed levels: ", "a query has another answer than that of the arrays");
    });
  packed.Release();
  return entry;
}
}

Json::Value MeasurePacked(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int mostPixels)
{
  constexpr int sizes[][2] = { { 256, 256 }, { 512, 512 }, { 1024, 1024 }, { 1920, 1080 } };
  Json::Value result(Json::arrayValue);
  for (const int(&size)[2] : sizes)
  {
    if (size[0] * size[1] > mostPixels)
    {
      continue;
    }
    ShowProgress("packed levels: " + std::to_string(size[0]) + " x " + std::to_string(size[1]));
    session.GetWindow()->SetSize(size[0], size[1]);
    RenderAndInspect(session, pose,
      [&](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource&)
      {
        Json::Value entry = Measure(window, size[0], size[1], repetitions);
        entry["width"] = size[0];
        entry["height"] = size[1];
        result.append(entry);
      });
  }
  return result;
}

} // namespace NBufferBench
