// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstFrames.h"

#include "Mode.h"
#include "Report.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <memory>
#include <numeric>

namespace NBufferBench
{
namespace
{
using Times = std::vector<double>; ///< Milliseconds of the frames of a run.

constexpr std::ptrdiff_t FirstTen = 10;

Times MakeRun(const FirstFramesOptions& options, const std::string& name)
{
  const NBufferExamples::Scene scene = options.LoadScene();
  const std::unique_ptr<Session> session(&Session::New(scene, options.Window));
  Mode mode(name, options.Backend);
  mode.Enter(session->GetRenderer());
  Times times;
  for (const NBufferExamples::CameraPose& pose : options.Path)
  {
    session->SetPose(pose);
    times.push_back(session->Render());
  }
  return times;
}

double GetFirstTen(const Times& times)
{
  return std::accumulate(times.begin(), times.begin() + FirstTen, 0.0);
}

Times GetRatios(const Times& a, const Times& b)
{
  Times ratios(a.size());
  std::transform(a.begin(), a.end(), b.begin(), ratios.begin(), std::divides<>());
  return ratios;
}

Json::Value Compare(const std::vector<Times>& stock, const std::vector<Times>& other)
{
  Times first;
  Times firstTen;
  Times afterTen;
  std::vector<Times> frames(stock.front().size());
  for (std::size_t run = 0; run < stock.size(); ++run)
  {
    const Times ratios = GetRatios(stock[run], other[run]);
    first.push_back(ratios.front());
    firstTen.push_back(GetFirstTen(stock[run]) / GetFirstTen(other[run]));
    afterTen.push_back(GetQuantile({ ratios.begin() + FirstTen, ratios.end() }, 0.5));
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      frames[i].push_back(ratios[i]);
    }
  }
  Json::Value result;
  result["first"] = Summarize(first);
  result["first_ten"] = Summarize(firstTen);
  result["after_ten"] = Summarize(afterTen);
  for (const Times& ratios : frames)
  {
    result["frames"].append(Round(GetQuantile(ratios, 0.5)));
  }
  return result;
}
}

Json::Value RunFirstFrames(const FirstFramesOptions& options)
{
  std::vector<std::string> modes = options.Modes;
  modes.erase(std::remove(modes.begin(), modes.end(), "stock"), modes.end());
  modes.insert(modes.begin(), "stock");
  // Whatever the process does only once is not to be part of the first run.
  MakeRun(options, "stock");
  std::map<std::string, std::vector<Times>> runs;
  for (int run = 0; run < options.Runs; ++run)
  {
    for (std::size_t i = 0; i < modes.size(); ++i)
    {
      const std::string& mode = modes[(i + static_cast<std::size_t>(run)) % modes.size()];
      runs[mode].push_back(MakeRun(options, mode));
    }
    ShowProgress("run " + std::to_string(run + 1) + " of " + std::to_string(options.Runs));
  }
  Json::Value report;
  report["runs"] = options.Runs;
  report["frames"] = static_cast<Json::UInt64>(options.Path.size());
  report["first_frames"] = Json::Value(Json::objectValue);
  for (const std::string& mode : modes)
  {
    for (const Times& run : runs[mode])
    {
      Json::Value times(Json::arrayValue);
      for (double time : run)
      {
        times.append(Round(time));
      }
      report["modes"][mode]["runs_ms"].append(times);
    }
    if (mode != "stock")
    {
      report["first_frames"][mode] = Compare(runs["stock"], runs[mode]);
    }
  }
  return report;
}

void PrintFirstFrames(const Json::Value& report, std::ostream& out)
{
  out << report["scene"].asString() << ", " << report["path"].asString() << ", "
      << report["size"].asString() << ", " << report["renderer"].asString() << ", "
      << report["runs"].asInt() << " runs of " << report["frames"].asInt() << " frames, VTK "
      << report["vtk"].asString() << "\n"
      << "stock / mode, median of the runs (p10 to p90):\n"
      << std::fixed << std::setprecision(2);
  for (const std::string& mode : report["first_frames"].getMemberNames())
  {
    const auto print = [&](const char* title, const char* member)
    {
      const Json::Value& ratio = report["first_frames"][mode][member];
      out << title << ratio["median"].asDouble() << " (" << ratio["p10"].asDouble() << " to "
          << ratio["p90"].asDouble() << ")";
    };
    print((mode + ": first frame ").c_str(), "first");
    print(", frames 1 to 10 ", "first_ten");
    print(", after 10 frames ", "after_ten");
    out << "\n";
  }
}

} // namespace NBufferBench
