// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "SingleLevel.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferTexture.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkOpenGLRenderWindow.h"

#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferPeers::ReduceMethod;
using NBufferPeers::SingleLevel;

constexpr int AllLevels = 64;
constexpr int LevelFactors[] = { 4, 8, 16 };

/// Milliseconds of building levels once, on the device alone, and of reading the levels back; below
/// 0 where that is not measured.
struct Sample
{
  double Build = -1.0;
  double Device = -1.0;
  double Read = -1.0;
};

/// Calls measure() once for nothing and then `repetitions` times; the samples go to `row`.
template <typename Measure>
void Repeat(int repetitions, Json::Value& row, Measure&& measure)
{
  std::vector<double> times[3];
  for (int i = 0; i <= repetitions; ++i)
  {
    const Sample sample = measure();
    const double values[3] = { sample.Build, sample.Device, sample.Read };
    for (int j = 0; j < 3; ++j)
    {
      if (i > 0 && values[j] >= 0.0)
      {
        times[j].push_back(values[j]);
      }
    }
  }
  const char* const names[3] = { "build_ms", "device_ms", "read_ms" };
  for (int j = 0; j < 3; ++j)
  {
    if (!times[j].empty())
    {
      row[names[j]] = Summarize(times[j]);
    }
  }
}

/// Returns the row of a table; `row` has its times.
Json::Value MakeRow(
  const char* name, int factor, int levels, int width, int height, Json::Value row)
{
  row["name"] = name;
  row["factor"] = factor;
  row["levels"] = levels;
  row["texels"] = static_cast<Json::Int64>(levels) * vtkNBufferMath::GetBaseSize(width, factor) *
    vtkNBufferMath::GetBaseSize(height, factor);
  return row;
}

/// A window whose frame has been drawn, while its framebuffer is bound.
struct Drawn
{
  vtkOpenGLRenderWindow* Window;
  const vtkNBufferDepthSource& Source;
  int Repetitions;

  int GetWidth() const { return this->Source.Viewport[2]; }
  int GetHeight() const { return this->Source.Viewport[3]; }
};

Json::Value MeasureModule(const Drawn& drawn, const char* name, int factor, int levels)
{
  vtkNew<vtkNBufferTexture> texture;
  vtkNBufferLevels host;
  Json::Value times;
  Repeat(drawn.Repetitions, times,
    [&]()
    {
      Sample sample;
      drawn.Window->WaitForCompletion();
      vtkNBufferClock clock;
      if (!texture->Build(drawn.Window, drawn.Source, drawn.Source.Viewport[0],
            drawn.Source.Viewport[1], drawn.GetWidth(), drawn.GetHeight(), factor, levels,
            vtkNBufferExtremum::Maximum))
      {
        throw std::runtime_error("no levels by OpenGL: " + texture->GetError());
      }
      drawn.Window->WaitForCompletion();
      sample.Build = clock.Restart();
      if (!texture->Download(drawn.Window, host))
      {
        throw std::runtime_error("levels cannot be read back: " + texture->GetError());
      }
      sample.Read = clock.GetMilliseconds();
      const double device = texture->GetDeviceTime();
      sample.Device = device > 0.0 ? device : -1.0;
      return sample;
    });
  Json::Value row =
    MakeRow(name, factor, texture->GetNumberOfLevels(), drawn.GetWidth(), drawn.GetHeight(), times);
  texture->ReleaseGraphicsResources(drawn.Window);
  return row;
}

Json::Value MeasureHost(
  const Drawn& drawn, const std::vector<float>& depth, const char* name, int factor, int levels)
{
  vtkNBufferLevels host;
  Json::Value times;
  Repeat(drawn.Repetitions, times,
    [&]()
    {
      const vtkNBufferClock clock;
      host.BuildBase(
        depth.data(), drawn.GetWidth(), drawn.GetHeight(), factor, vtkNBufferExtremum::Maximum);
      host.BuildLevels(levels);
      return Sample{ clock.GetMilliseconds() };
    });
  return MakeRow(
    name, factor, host.GetNumberOfLevels(), drawn.GetWidth(), drawn.GetHeight(), times);
}

Json::Value MeasureSingle(
  const Drawn& drawn, SingleLevel& single, const char* name, ReduceMethod method, int factor)
{
  Json::Value times;
  const std::string obstacle = SingleLevel::WhyNot(method);
  if (!obstacle.empty())
  {
    times["skipped"] = obstacle;
    return MakeRow(name, factor, 1, drawn.GetWidth(), drawn.GetHeight(), times);
  }
  std::vector<float> level;
  std::string why;
  Repeat(drawn.Repetitions, times,
    [&]()
    {
      Sample sample;
      drawn.Window->WaitForCompletion();
      vtkNBufferClock clock;
      const bool done = single.Reduce(method, factor, why);
      drawn.Window->WaitForCompletion();
      sample.Build = clock.Restart();
      if (!done || !single.Download(level, why))
      {
        throw std::runtime_error("no level by OpenGL: " + why);
      }
      sample.Read = clock.GetMilliseconds();
      sample.Device = single.GetDeviceTime();
      return sample;
    });
  return MakeRow(name, factor, 1, drawn.GetWidth(), drawn.GetHeight(), times);
}

Json::Value MeasureBuilds(const Drawn& drawn)
{
  std::vector<float> depth;
  Json::Value result;
  Repeat(drawn.Repetitions, result,
    [&]()
    {
      std::string why;
      drawn.Window->WaitForCompletion();
      const vtkNBufferClock clock;
      if (!drawn.Source.Read(drawn.Window, drawn.Source.Viewport[0], drawn.Source.Viewport[1],
            drawn.GetWidth(), drawn.GetHeight(), depth, why))
      {
        throw std::runtime_error("the depth cannot be read: " + why);
      }
      return Sample{ -1.0, -1.0, clock.GetMilliseconds() };
    });
  result["width"] = drawn.GetWidth();
  result["height"] = drawn.GetHeight();
  Json::Value& rows = result["rows"] = Json::Value(Json::arrayValue);
  for (int factor : { 1, 4 })
  {
    rows.append(MeasureModule(drawn, "module, all levels", factor, AllLevels));
    rows.append(MeasureHost(drawn, depth, "CPU, all levels", factor, AllLevels));
  }
  for (int factor : { 4, 8 })
  {
    rows.append(MeasureModule(drawn, "module, one level", factor, 1));
  }
  for (int factor : LevelFactors)
  {
    rows.append(MeasureHost(drawn, depth, "CPU, one level", factor, 1));
  }
  SingleLevel single;
  std::string why;
  if (!single.SetDepth(drawn.Window, depth, drawn.GetWidth(), drawn.GetHeight(), why))
  {
    throw std::runtime_error("no texture of depth: " + why);
  }
  for (int factor : LevelFactors)
  {
    rows.append(MeasureSingle(drawn, single, "pass", ReduceMethod::OnePass, factor));
    rows.append(MeasureSingle(drawn, single, "passes", ReduceMethod::Passes, factor));
    rows.append(MeasureSingle(drawn, single, "compute", ReduceMethod::Compute, factor));
  }
  single.ReleaseGraphicsResources(drawn.Window);
  return result;
}

/// Draws the frame by VTK alone, with its default culler.
Json::Value MeasureDrawing(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions)
{
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  session.GetRenderer()->AddCuller(vtkNew<vtkFrustumCoverageCuller>());
  std::vector<double> milliseconds;
  for (int i = 0; i <= repetitions; ++i)
  {
    session.SetPose(pose);
    milliseconds.push_back(session.Render());
  }
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  milliseconds.erase(milliseconds.begin()); // The first time does not count.
  return Summarize(milliseconds);
}
}

Json::Value MeasureDevice(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int mostPixels)
{
  constexpr int sizes[][2] = { { 256, 256 }, { 512, 512 }, { 640, 480 }, { 1024, 1024 },
    { 1920, 1080 } };
  Json::Value result(Json::arrayValue);
  for (const int(&size)[2] : sizes)
  {
    if (size[0] * size[1] > mostPixels)
    {
      continue;
    }
    ShowProgress("the device: " + std::to_string(size[0]) + " x " + std::to_string(size[1]));
    session.GetWindow()->SetSize(size[0], size[1]);
    Json::Value entry;
    RenderAndInspect(session, pose,
      [&](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source) {
        entry = MeasureBuilds({ window, source, repetitions });
      });
    entry["draw_ms"] = MeasureDrawing(session, pose, repetitions);
    result.append(entry);
  }
  return result;
}

} // namespace NBufferBench
