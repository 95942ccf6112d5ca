// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walk.h"

#include "Report.h"
#include "SameList.h"
#include "VisibleUnits.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CountDifferingBytes;

/// A mode and what its frames gave.
struct Runner
{
  Runner(const std::string& name, const std::string& backend, std::size_t frames)
    : Cullers(name, backend)
    , Milliseconds(frames)
    , Drawn(frames)
  {
  }

  Mode Cullers;
  int Untimed = 0; ///< Frames that were drawn and not timed.
  ///@{
  /// By frame.
  std::vector<std::vector<vtkProp*>> Given; ///< The props that OracleCuller draws.
  std::vector<double> GivenUnits;           ///< The units of large props among them, if known.
  std::vector<double> Milliseconds;
  std::vector<double> Drawn;
  std::vector<long long> DifferingBytes;
  std::map<std::size_t, vtkSmartPointer<vtkUnsignedCharArray>> Images; ///< Of this block.
  ///@}
  ///@{
  /// In the order of the turns. They become JSON after the last frame, because many small
  /// allocations between the frames would slow down those that follow.
  std::vector<std::string> Statistics; ///< As the culler writes them.
  std::vector<NBufferPeers::QueryStatistics> Queries;
  ///@}
};

Json::Value SummarizeStatistics(const std::vector<Json::Value>& frames)
{
  std::vector<Json::Value> tested;
  std::vector<double> perProp;
  Json::Value result = GetMedian(frames);
  Json::Value& decisions = result["decisions"];
  for (const Json::Value& frame : frames)
  {
    Json::Value& count = decisions[frame["decision"].asString()];
    count = count.asInt() + 1;
    if (frame["tested"].asDouble() > 0.0)
    {
      tested.push_back(frame["milliseconds"]);
      perProp.push_back(
        1000.0 * frame["milliseconds"]["test"].asDouble() / frame["tested"].asDouble());
    }
  }
  if (!tested.empty())
  {
    Json::Value& stages = result["when_tested"];
    stages["frames"] = static_cast<Json::UInt64>(tested.size());
    stages["milliseconds"] = GetMedian(tested);
    stages["test_microseconds_per_prop"] = Round(GetQuantile(perProp, 0.5));
  }
  return result;
}

/// Adds `units`, the median of the units that were drawn, over the frames that tested units.
void AddUnits(Json::Value& mode, const std::vector<Json::Value>& frames)
{
  std::vector<double> drawn;
  for (const Json::Value& frame : frames)
  {
    const double visible = frame["units_kept"].asDouble() + frame["units_fresh"].asDouble();
    if (visible + frame["units_hidden"].asDouble() > 0.0)
    {
      drawn.push_back(visible);
    }
  }
  if (!drawn.empty())
  {
    mode["units"] = GetQuantile(drawn, 0.5);
  }
}

Json::Value MakeQueryReport(const NBufferPeers::QueryStatistics& statistics)
{
  Json::Value frame;
  frame["in_view"] = statistics.InView;
  frame["queries"] = statistics.Queries;
  frame["waits"] = statistics.Waits;
  frame["wait_ms"] = statistics.WaitTime;
  frame["nodes"] = statistics.Nodes;
  frame["visits"] = statistics.Visits;
  frame["drawn"] = statistics.Drawn;
  frame["hidden"] = statistics.Hidden;
  frame["redrawn"] = statistics.Redrawn;
  return frame;
}

class Walker
{
public:
  Walker(Session& session, const CameraPath& path, const WalkOptions& options)
    : Where(session)
    , Path(path)
    , Options(options)
  {
    for (const std::string& name : options.Modes)
    {
      this->Runners.emplace_back(name, options.Backend, path.size());
    }
  }

  Json::Value Run()
  {
    this->Prepare();
    TakeTurns(
      this->Runners.size(), this->Path.size(), this->Options.Block,
      [this](std::size_t mode, std::size_t begin, std::size_t end)
      { this->RunBlock(this->Runners[mode], begin, end); },
      [this](std::size_t begin, std::size_t end)
      {
        this->Compare(begin, end);
        ShowProgress("frame " + std::to_string(end) + " of " + std::to_string(this->Path.size()));
      });
    return this->MakeReport();
  }

private:
  /// Finds what oracle and in-view draw; uploads and compiles everything; lets each mode warm up.
  void Prepare()
  {
    for (Runner& runner : this->Runners)
    {
      if (runner.Cullers.GetOracleCuller())
      {
        this->FindGiven(runner);
      }
    }
    ShowProgress("uploading");
    Mode all("none");
    all.Enter(this->Where.GetRenderer());
    this->Where.SetPose(this->Path.front());
    this->Where.Render();
    all.Leave(this->Where.GetRenderer());
    for (Runner& runner : this->Runners)
    {
      runner.Cullers.Enter(this->Where.GetRenderer());
      const int frames = static_cast<int>(this->Path.size());
      for (; runner.Untimed < this->Options.WarmUp; ++runner.Untimed)
      {
        const int place = runner.Untimed % (2 * frames);
        this->RenderFrame(
          runner, static_cast<std::size_t>(std::min(place, 2 * frames - 1 - place)));
        ShowProgress("warming up " + runner.Cullers.GetName());
      }
      runner.Cullers.Leave(this->Where.GetRenderer());
    }
  }

  /// Finds what a mode with an OracleCuller draws.
  void FindGiven(Runner& runner)
  {
    const std::string& name = runner.Cullers.GetName();
    if (name == "oracle")
    {
      runner.Given = FindVisibleProps(this->Where, this->Path);
      this->OfOracle = ReplaceByVisibleUnits(this->Where, this->Path, runner.Given);
      runner.GivenUnits = this->OfOracle.Counts;
    }
    else if (name == "same-list")
    {
      runner.Given = this->OfNBuffer.Record(this->Where, this->Path, this->Options.Backend);
      runner.GivenUnits = this->OfNBuffer.CountBlocks();
    }
    else
    {
      runner.Given = FindPropsInView(this->Where, this->Path);
    }
  }

  double RenderFrame(Runner& runner, std::size_t frame)
  {
    if (OracleCuller* oracle = runner.Cullers.GetOracleCuller())
    {
      oracle->SetProps(&runner.Given[frame]);
    }
    this->OfNBuffer.SetFrame(frame); // Other modes do not draw its copies.
    this->Where.SetPose(this->Path[frame]);
    return this->Where.Render();
  }

  void RunBlock(Runner& runner, std::size_t begin, std::size_t end)
  {
    Mode& mode = runner.Cullers;
    mode.Enter(this->Where.GetRenderer());
    // Before the first frame comes the second one, as if the path were walked backwards.
    const std::size_t before = this->Options.Still ? begin : begin > 0 ? begin - 1 : 1;
    if (before < this->Path.size())
    {
      this->RenderFrame(runner, before);
      ++runner.Untimed;
    }
    for (std::size_t frame = begin; frame < end; ++frame)
    {
      runner.Milliseconds[frame] =
        this->Options.Still ? this->Where.Render() : this->RenderFrame(runner, frame);
      runner.Drawn[frame] = mode.CountDrawn(this->Where.GetRenderer());
      if (vtkNBufferCuller* culler = mode.GetNBufferCuller())
      {
        runner.Statistics.push_back(culler->GetStatisticsAsJSON());
      }
      if (NBufferPeers::QueryCuller* culler = mode.GetQueryCuller())
      {
        runner.Queries.push_back(culler->GetStatistics());
      }
      if (this->Options.Verify || this->IsPictured(frame))
      {
        runner.Images[frame] = this->Where.ReadPixels();
      }
      if (this->IsPictured(frame))
      {
        this->WriteImage(runner, frame, "");
      }
    }
    mode.Leave(this->Where.GetRenderer());
  }

  bool IsPictured(std::size_t frame) const
  {
    return !this->Options.ImageFolder.empty() &&
      (frame == 0 || frame == this->Path.size() / 2 || frame + 1 == this->Path.size());
  }

  void WriteImage(Runner& runner, std::size_t frame, const char* suffix)
  {
    char number[16];
    std::snprintf(number, sizeof(number), "%04zu", frame);
    WritePNG(this->Where.MakeImage(runner.Images[frame]),
      this->Options.ImageFolder + "/frame-" + number + "-" + runner.Cullers.GetName() + suffix +
        ".png");
  }

  void Compare(std::size_t begin, std::size_t end)
  {
    const auto none = std::find_if(this->Runners.begin(), this->Runners.end(),
      [](const Runner& runner) { return runner.Cullers.GetName() == "none"; });
    for (Runner& runner : this->Runners)
    {
      for (std::size_t frame = begin; this->Options.Verify && frame < end; ++frame)
      {
        runner.DifferingBytes.push_back(
          CountDifferingBytes(none->Images[frame], runner.Images[frame]));
        if (runner.DifferingBytes.back() > 0 && !this->Options.ImageFolder.empty())
        {
          this->WriteImage(*none, frame, "-expected");
          this->WriteImage(runner, frame, "-differs");
        }
      }
    }
    for (Runner& runner : this->Runners)
    {
      runner.Images.clear();
    }
  }

  Json::Value MakeReport()
  {
    Json::Value report;
    report["frames"] = static_cast<Json::UInt64>(this->Path.size());
    report["props"] = static_cast<Json::UInt64>(this->Where.GetProps().size());
    report["block"] = this->Options.Block;
    long long wrong = 0;
    for (Runner& runner : this->Runners)
    {
      const std::string& name = runner.Cullers.GetName();
      Json::Value& mode = report["modes"][name];
      AddTimes(mode, runner.Milliseconds);
      mode["untimed_frames"] = runner.Untimed;
      mode["drawn"] = GetQuantile(runner.Drawn, 0.5);
      for (double drawn : runner.Drawn)
      {
        mode["frames_drawn"].append(static_cast<int>(drawn));
      }
      if (!runner.GivenUnits.empty())
      {
        mode["units"] = GetQuantile(runner.GivenUnits, 0.5);
      }
      if (vtkNBufferCuller* culler = runner.Cullers.GetNBufferCuller())
      {
        const int backend = culler->GetBackendInUse();
        mode["backend"] = backend == vtkNBufferCuller::CPU ? "CPU"
          : backend == vtkNBufferCuller::OpenGL            ? "OpenGL"
                                                           : "none used";
        const std::vector<Json::Value> frames = ParseAll(runner.Statistics);
        mode["statistics"] = SummarizeStatistics(frames);
        AddUnits(mode, frames);
      }
      if (!runner.Queries.empty())
      {
        std::vector<Json::Value> queries;
        std::transform(runner.Queries.begin(), runner.Queries.end(), std::back_inserter(queries),
          MakeQueryReport);
        mode["queries"] = GetMedian(queries);
      }
      if (this->Options.Verify)
      {
        Json::Int64 bytes = 0;
        mode["differing_frames"] = Json::Value(Json::arrayValue);
        for (std::size_t frame = 0; frame < runner.DifferingBytes.size(); ++frame)
        {
          bytes += runner.DifferingBytes[frame];
          if (runner.DifferingBytes[frame] > 0)
          {
            mode["differing_frames"].append(static_cast<Json::UInt64>(frame));
          }
        }
        mode["differing_bytes"] = bytes;
        // The oracle is a bound and no culler: two props may own one pixel by turns.
        wrong += name == "oracle" ? 0 : bytes;
      }
    }
    AddRatios(report, { "stock", "oracle", "same-list" });
    report["verified_frames"] =
      static_cast<Json::UInt64>(this->Options.Verify ? this->Path.size() : 0);
    report["differing_bytes"] = static_cast<Json::Int64>(wrong);
    return report;
  }

  Session& Where;
  const CameraPath& Path;
  const WalkOptions& Options;
  std::vector<Runner> Runners;
  VisibleUnits OfOracle; ///< What the oracle draws of large props.
  SameList OfNBuffer;    ///< What the mode same-list draws of composite data.
};
}

Json::Value RunWalk(Session& session, const CameraPath& path, const WalkOptions& options)
{
  return Walker(session, path, options).Run();
}

} // namespace NBufferBench
