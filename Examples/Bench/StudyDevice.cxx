// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "SingleLevel.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferTexture.h"

#include "vtkCallbackCommand.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkOpenGLRenderTimer.h"
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

/// Times of something that is done several times, the first of which does not count.
struct Times
{
  std::vector<double> Build;
  std::vector<double> Device;
  std::vector<double> Read;

  void WriteTo(Json::Value& row) const
  {
    row["build_ms"] = Summarize(this->Build);
    if (!this->Device.empty())
    {
      row["device_ms"] = Summarize(this->Device);
    }
    if (!this->Read.empty())
    {
      row["read_ms"] = Summarize(this->Read);
    }
  }
};

Json::Value MakeRow(const char* name, int factor, int levels, int width, int height)
{
  Json::Value row;
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
  Times times;
  for (int i = 0; i <= drawn.Repetitions; ++i)
  {
    drawn.Window->WaitForCompletion();
    vtkNBufferClock clock;
    if (!texture->Build(drawn.Window, drawn.Source, drawn.Source.Viewport[0],
          drawn.Source.Viewport[1], drawn.GetWidth(), drawn.GetHeight(), factor, levels,
          vtkNBufferExtremum::Maximum))
    {
      throw std::runtime_error("no levels by OpenGL: " + texture->GetError());
    }
    drawn.Window->WaitForCompletion();
    const double build = clock.Restart();
    if (!texture->Download(drawn.Window, host))
    {
      throw std::runtime_error("levels cannot be read back: " + texture->GetError());
    }
    const double read = clock.GetMilliseconds();
    const double device = texture->GetDeviceTime();
    if (i > 0)
    {
      times.Build.push_back(build);
      times.Read.push_back(read);
      if (device > 0.0)
      {
        times.Device.push_back(device);
      }
    }
  }
  Json::Value row =
    MakeRow(name, factor, texture->GetNumberOfLevels(), drawn.GetWidth(), drawn.GetHeight());
  times.WriteTo(row);
  texture->ReleaseGraphicsResources(drawn.Window);
  return row;
}

Json::Value MeasureHost(
  const Drawn& drawn, const std::vector<float>& depth, const char* name, int factor, int levels)
{
  vtkNBufferLevels host;
  Times times;
  for (int i = 0; i <= drawn.Repetitions; ++i)
  {
    const vtkNBufferClock clock;
    host.BuildBase(
      depth.data(), drawn.GetWidth(), drawn.GetHeight(), factor, vtkNBufferExtremum::Maximum);
    host.BuildLevels(levels);
    if (i > 0)
    {
      times.Build.push_back(clock.GetMilliseconds());
    }
  }
  Json::Value row =
    MakeRow(name, factor, host.GetNumberOfLevels(), drawn.GetWidth(), drawn.GetHeight());
  times.WriteTo(row);
  return row;
}

Json::Value MeasureSingle(
  const Drawn& drawn, SingleLevel& single, const char* name, ReduceMethod method, int factor)
{
  Json::Value row = MakeRow(name, factor, 1, drawn.GetWidth(), drawn.GetHeight());
  const std::string obstacle = SingleLevel::WhyNot(method);
  if (!obstacle.empty())
  {
    row["skipped"] = obstacle;
    return row;
  }
  Times times;
  std::vector<float> level;
  std::string why;
  for (int i = 0; i <= drawn.Repetitions; ++i)
  {
    drawn.Window->WaitForCompletion();
    vtkNBufferClock clock;
    const bool done = single.Reduce(method, factor, why);
    drawn.Window->WaitForCompletion();
    const double build = clock.Restart();
    if (!done || !single.Download(level, why))
    {
      throw std::runtime_error("no level by OpenGL: " + why);
    }
    const double read = clock.GetMilliseconds();
    const double device = single.GetDeviceTime();
    if (i > 0)
    {
      times.Build.push_back(build);
      times.Read.push_back(read);
      if (device >= 0.0)
      {
        times.Device.push_back(device);
      }
    }
  }
  times.WriteTo(row);
  return row;
}

Json::Value MeasureBuilds(const Drawn& drawn)
{
  std::vector<double> reads;
  std::vector<float> depth;
  for (int i = 0; i <= drawn.Repetitions; ++i)
  {
    std::string why;
    drawn.Window->WaitForCompletion();
    const vtkNBufferClock clock;
    if (!drawn.Source.Read(drawn.Window, drawn.Source.Viewport[0], drawn.Source.Viewport[1],
          drawn.GetWidth(), drawn.GetHeight(), depth, why))
    {
      throw std::runtime_error("the depth cannot be read: " + why);
    }
    if (i > 0)
    {
      reads.push_back(clock.GetMilliseconds());
    }
  }
  Json::Value result;
  result["width"] = drawn.GetWidth();
  result["height"] = drawn.GetHeight();
  result["read_ms"] = Summarize(reads);
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

/// The frame by VTK alone, with its default culler.
void MeasureDrawing(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, Json::Value& result)
{
  vtkNew<vtkFrustumCoverageCuller> frustum;
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  session.GetRenderer()->AddCuller(frustum);
  vtkOpenGLRenderTimer timer;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&timer);
  observer->SetCallback(
    [](vtkObject*, unsigned long event, void* data, void*)
    {
      auto* drawing = static_cast<vtkOpenGLRenderTimer*>(data);
      event == vtkCommand::StartEvent ? drawing->Start() : drawing->Stop();
      glFlush();
    });
  const bool timed = vtkNBufferGL::HasVersion(3, 3) && vtkOpenGLRenderTimer::IsSupported();
  std::vector<double> wall;
  std::vector<double> device;
  for (int i = 0; i <= repetitions; ++i)
  {
    session.SetPose(pose);
    unsigned long tags[2] = { 0, 0 };
    if (timed)
    {
      tags[0] = session.GetRenderer()->AddObserver(vtkCommand::StartEvent, observer);
      tags[1] = session.GetRenderer()->AddObserver(vtkCommand::EndEvent, observer);
    }
    const double milliseconds = session.Render();
    if (timed)
    {
      session.GetRenderer()->RemoveObserver(tags[0]);
      session.GetRenderer()->RemoveObserver(tags[1]);
    }
    if (i > 0)
    {
      wall.push_back(milliseconds);
    }
    if (i > 0 && timed && timer.Ready())
    {
      device.push_back(1e-6 * static_cast<double>(timer.GetElapsedNanoseconds()));
    }
  }
  timer.ReleaseGraphicsResources();
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  result["draw_ms"] = Summarize(wall);
  if (!device.empty())
  {
    result["draw_device_ms"] = Summarize(device);
  }
}
}

Json::Value MeasureDevice(Session& session, const NBufferExamples::CameraPose& pose,
  int repetitions, int mostPixels, const Progress& progress)
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
    progress(std::to_string(size[0]) + " x " + std::to_string(size[1]));
    session.GetWindow()->SetSize(size[0], size[1]);
    Json::Value entry;
    RenderAndInspect(session, pose,
      [&](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source) {
        entry = MeasureBuilds({ window, source, repetitions });
      });
    MeasureDrawing(session, pose, repetitions, entry);
    result.append(entry);
  }
  return result;
}

} // namespace NBufferBench
