// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"

#include "DepthChain.h"
#include "SingleLevel.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferTexture.h"

#include "vtkFrustumCoverageCuller.h"
#include "vtkOpenGLRenderWindow.h"

#include <functional>

namespace NBufferBench
{
namespace
{
using NBufferPeers::ChainEdges;
using NBufferPeers::DepthChain;
using NBufferPeers::GroupForm;
using NBufferPeers::ReduceMethod;
using NBufferPeers::SingleLevel;

constexpr int LevelFactors[] = { 4, 8, 16 };

/// A window whose frame has been drawn, while its framebuffer is bound.
struct Drawn
{
  vtkOpenGLRenderWindow* Window;
  const vtkNBufferDepthSource& Source;
  int Repetitions;

  int GetWidth() const { return this->Source.Viewport[2]; }
  int GetHeight() const { return this->Source.Viewport[3]; }
};

/// Returns the row of a table; `row` has its times.
Json::Value MakeRow(const Drawn& drawn, const char* name, int factor, int levels, Json::Value row)
{
  row["name"] = name;
  row["factor"] = factor;
  row["levels"] = levels;
  row["texels"] = static_cast<Json::Int64>(levels) *
    vtkNBufferMath::GetBaseSize(drawn.GetWidth(), factor) *
    vtkNBufferMath::GetBaseSize(drawn.GetHeight(), factor);
  return row;
}

/// Measures building levels by build(), on the device alone by getDeviceTime() (not above 0 where
/// that is not possible), and reading them back by read(), if there is one.
template <typename Build, typename GetDeviceTime>
Json::Value RepeatOnDevice(const Drawn& drawn, Build&& build, GetDeviceTime&& getDeviceTime,
  const std::function<void()>& read = {})
{
  return Repeat(drawn.Repetitions,
    [&](NamedTimes& times)
    {
      drawn.Window->WaitForCompletion();
      vtkNBufferClock clock;
      build();
      drawn.Window->WaitForCompletion();
      const double built = clock.Restart();
      times["build_ms"].push_back(built);
      if (read)
      {
        clock.Restart();
        read();
        const double transferred = clock.GetMilliseconds();
        times["read_ms"].push_back(transferred);
      }
      const double device = getDeviceTime();
      if (device > 0.0)
      {
        times["device_ms"].push_back(device);
      }
    });
}

Json::Value MeasureModule(const Drawn& drawn, const char* name, int factor, int levels)
{
  vtkNew<vtkNBufferTexture> texture;
  vtkNBufferLevels host;
  const int* corner = drawn.Source.Viewport;
  const Json::Value times = RepeatOnDevice(
    drawn,
    [&]()
    {
      Check(texture->Build(drawn.Window, drawn.Source, corner[0], corner[1], drawn.GetWidth(),
              drawn.GetHeight(), factor, levels, vtkNBufferExtremum::Maximum),
        "no levels by OpenGL: ", texture->GetError());
    },
    [&]() { return texture->GetDeviceTime(); },
    [&]()
    {
      Check(
        texture->Download(drawn.Window, host), "levels cannot be read back: ", texture->GetError());
    });
  return MakeRow(drawn, name, factor, texture->GetNumberOfLevels(), times);
}

Json::Value MeasureHost(
  const Drawn& drawn, const std::vector<float>& depth, const char* name, int factor, int levels)
{
  vtkNBufferLevels host;
  const Json::Value times = Repeat(drawn.Repetitions,
    [&](NamedTimes& result)
    {
      const vtkNBufferClock clock;
      host.BuildBase(
        depth.data(), drawn.GetWidth(), drawn.GetHeight(), factor, vtkNBufferExtremum::Maximum);
      host.BuildLevels(levels);
      const double built = clock.GetMilliseconds();
      result["build_ms"].push_back(built);
    });
  return MakeRow(drawn, name, factor, host.GetNumberOfLevels(), times);
}

Json::Value MeasureSingle(
  const Drawn& drawn, SingleLevel& single, const char* name, ReduceMethod method, int factor)
{
  Json::Value times;
  const std::string obstacle = SingleLevel::WhyNot(method);
  if (!obstacle.empty())
  {
    times["skipped"] = obstacle;
    return MakeRow(drawn, name, factor, 1, times);
  }
  std::vector<float> level;
  times = RepeatOnDevice(
    drawn, [&]() { single.Reduce(method, factor); }, [&]() { return single.GetDeviceTime(); },
    [&]() { single.Download(level); });
  return MakeRow(drawn, name, factor, 1, times);
}

/// Measures what is built for two eyes at a time. Both have the same depth, which no time depends
/// on.
class EyesStudy
{
public:
  EyesStudy(const Drawn& drawn, const std::vector<float>& depth)
    : Screen(drawn)
    , Depth(depth)
  {
  }

  Json::Value Run()
  {
    this->Chain.SetDepth(this->Screen.Window, { this->Depth, this->Depth }, this->Screen.GetWidth(),
      this->Screen.GetHeight());
    this->AddChain("exact chain", ChainEdges::Exact, AllLevels);
    this->AddChain("fat chain", ChainEdges::Fat, AllLevels);
    this->AddChain("exact chain, levels 1 to 4", ChainEdges::Exact, 4);
    this->AddChain("fat chain, levels 1 to 4", ChainEdges::Fat, 4);
    for (int side : { 16, 8, 4, 2 })
    {
      for (bool atomics : { true, false })
      {
        this->AddGroups({ side, false, atomics });
        if (side < 16)
        {
          this->AddGroups({ side, true, atomics });
        }
      }
    }
    this->AddPasses();
    this->AddModule("N-buffer, all levels", 1);
    this->AddModule("N-buffer, all levels on 1/4", 4);
    return this->Rows;
  }

private:
  template <typename Build, typename GetDeviceTime>
  void Add(const std::string& name, const std::string& obstacle, Build&& build,
    GetDeviceTime&& getDeviceTime)
  {
    Json::Value row;
    if (obstacle.empty())
    {
      row = RepeatOnDevice(this->Screen, build, getDeviceTime);
    }
    else
    {
      row["skipped"] = obstacle;
    }
    row["name"] = name;
    this->Rows.append(row);
  }

  void AddChain(const char* name, ChainEdges edges, int levels)
  {
    this->Add(
      name, "", [=]() { this->Chain.BuildChain(edges, levels); },
      [this]() { return this->Chain.GetDeviceTime(); });
  }

  void AddGroups(const GroupForm& form)
  {
    const std::string side = std::to_string(form.Side);
    this->Add(
      "groups " + side + " x " + side + (form.Gather ? ", gather" : ", fetch") +
        (form.Atomics ? ", atomics" : ", tree"),
      DepthChain::WhyNotGroups(), [=]() { this->Chain.BuildGroups(form); },
      [this]() { return this->Chain.GetDeviceTime(); });
  }

  /// One level of 1/16 by a fragment pass for each eye.
  void AddPasses()
  {
    constexpr int factor = 16;
    SingleLevel eyes[2];
    for (SingleLevel& eye : eyes)
    {
      eye.SetDepth(
        this->Screen.Window, this->Depth, this->Screen.GetWidth(), this->Screen.GetHeight());
    }
    this->Add(
      "pass", "",
      [&]()
      {
        for (SingleLevel& eye : eyes)
        {
          eye.Reduce(ReduceMethod::OnePass, factor);
        }
      },
      [&]() { return eyes[0].GetDeviceTime() + eyes[1].GetDeviceTime(); });
  }

  void AddModule(const char* name, int factor)
  {
    const vtkNew<vtkNBufferTexture> eyes[2];
    const int* corner = this->Screen.Source.Viewport;
    this->Add(
      name, "",
      [&]()
      {
        for (vtkNBufferTexture* eye : eyes)
        {
          Check(eye->Build(this->Screen.Window, this->Screen.Source, corner[0], corner[1],
                  this->Screen.GetWidth(), this->Screen.GetHeight(), factor, AllLevels,
                  vtkNBufferExtremum::Maximum),
            "no levels by OpenGL: ", eye->GetError());
        }
      },
      [&]() { return eyes[0]->GetDeviceTime() + eyes[1]->GetDeviceTime(); });
  }

  const Drawn& Screen;
  const std::vector<float>& Depth;
  DepthChain Chain;
  Json::Value Rows = Json::Value(Json::arrayValue);
};

Json::Value MeasureBuilds(const Drawn& drawn)
{
  std::vector<float> depth;
  Json::Value result = Repeat(drawn.Repetitions,
    [&](NamedTimes& times)
    {
      drawn.Window->WaitForCompletion();
      const vtkNBufferClock clock;
      ReadDepth(drawn.Window, drawn.Source, depth);
      const double read = clock.GetMilliseconds();
      times["read_ms"].push_back(read);
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
  single.SetDepth(drawn.Window, depth, drawn.GetWidth(), drawn.GetHeight());
  for (int factor : LevelFactors)
  {
    rows.append(MeasureSingle(drawn, single, "pass", ReduceMethod::OnePass, factor));
    rows.append(MeasureSingle(drawn, single, "passes", ReduceMethod::Passes, factor));
    rows.append(MeasureSingle(drawn, single, "compute", ReduceMethod::Compute, factor));
  }
  result["eyes"] = EyesStudy(drawn, depth).Run();
  return result;
}

/// Draws the frame by VTK alone, with its default culler.
Json::Value MeasureDrawing(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions)
{
  session.SetCuller(vtkNew<vtkFrustumCoverageCuller>());
  const Json::Value times = Repeat(repetitions,
    [&](NamedTimes& result)
    {
      session.SetPose(pose);
      result["draw_ms"].push_back(session.Render());
    });
  session.SetCuller();
  return times["draw_ms"];
}
}

Json::Value MeasureDevice(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int mostPixels)
{
  constexpr int sizes[][2] = { { 256, 256 }, { 512, 512 }, { 640, 480 }, { 1024, 1024 },
    { 1920, 1080 }, { 1648, 1776 } };
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
