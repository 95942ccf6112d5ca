// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "PackedLevels.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"

#include "vtkOpenGLRenderWindow.h"

#include <map>

namespace NBufferBench
{
namespace
{
using NBufferPeers::PackedLevels;

Json::Value Measure(vtkOpenGLRenderWindow* window, int width, int height, int repetitions)
{
  Json::Value entry;
  entry["width"] = width;
  entry["height"] = height;
  const std::string obstacle = PackedLevels::WhyNot(width, height);
  if (!obstacle.empty())
  {
    entry["skipped"] = obstacle;
    return entry;
  }
  constexpr int all = 64;
  PackedLevels packed;
  vtkNew<vtkNBufferTexture> arrays;
  vtkNew<vtkNBufferTexture> extrema;
  vtkNew<vtkNBufferTexture> base;
  extrema->BothExtremaOn();
  std::map<std::string, std::vector<double>> times;
  const auto time = [&](const char* name, int repetition, auto&& function)
  {
    window->WaitForCompletion();
    const vtkNBufferClock clock;
    function();
    window->WaitForCompletion();
    if (repetition > 0) // The first time does not count.
    {
      times[name].push_back(clock.GetMilliseconds());
    }
  };
  const auto build = [&](vtkNBufferTexture* texture, int levels)
  {
    Check(texture->Build(window, 1, levels, vtkNBufferExtremum::Maximum),
      "packed levels: ", texture->GetError());
  };
  for (int i = 0; i <= repetitions; ++i)
  {
    time("base", i, [&]() { build(base, 1); });
    time("arrays", i, [&]() { build(arrays, all); });
    time("both_extrema", i, [&]() { build(extrema, all); });
    time("packed", i,
      [&]()
      {
        build(base, 1);
        packed.Build(window, base);
      });
    time("query_arrays", i, [&]() { packed.Query(window, arrays); });
    const std::vector<float> expected = packed.ReadDepths();
    time("query_packed", i, [&]() { packed.Query(window, nullptr); });
    Check(packed.ReadDepths() == expected,
      "packed levels: ", "a query has another answer than that of the arrays");
  }
  for (const auto& [name, values] : times)
  {
    entry[name + "_ms"] = Summarize(values);
  }
  packed.Release();
  for (vtkNBufferTexture* texture : { arrays.Get(), extrema.Get(), base.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
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
      { result.append(Measure(window, size[0], size[1], repetitions)); });
  }
  return result;
}

} // namespace NBufferBench
