// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Random scenes, cameras, windows, passes and changes: every frame with the culler has to be the
// frame without it. Some cast shadows: those have to be the shadows of a pass without litmaps and
// caches.
#include "Checker.h"
#include "Generator.h"
#include "Messages.h"
#include "ScenarioJson.h"
#include "Shrinker.h"
#include "Undefined.h"

#include "vtkLogger.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <random>

using namespace TestScene;

namespace
{
enum ExitCode
{
  Success = 0,
  Failed = 1,
  Skipped = 125
};

constexpr int ShrinkBudget = 1500;

struct Options
{
  long long Frames = 0;
  double Seconds = 0.0;
  std::uint64_t Seed = 0;
  int MaximumFailures = 3;
  bool Shrink = true;
  double Shadows = 0.3;
  double Reversed = 0.1;
  std::string JsonFile;
  std::string ReplayFile;
  std::string ScenarioFile;
  std::string Output = ".";
  int Backend = vtkNBufferCuller::Auto; ///< Another one replaces that of all scenarios.
};

/// What to say if VTK, the driver or the module crashes.
char RunningScenario[64] = "";

extern "C" void SayWhatCrashed(int signal)
{
  std::fputs(RunningScenario, stderr);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Seeds that follow each other give engines that resemble each other.
std::uint64_t Mix(std::uint64_t seed, std::uint64_t n)
{
  std::seed_seq sequence{ static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
    static_cast<std::uint32_t>(n) };
  std::uint32_t words[2];
  sequence.generate(words, words + 2);
  // JSON readers of other languages keep 53 bits.
  return (static_cast<std::uint64_t>(words[0]) << 32 | words[1]) >> 11;
}

/// What a scenario seed stands for is the same in every run with the same share.
ScenarioKind ChooseKind(std::uint64_t scenarioSeed, double shareOfShadows)
{
  constexpr std::uint64_t parts = 1000;
  return static_cast<double>(scenarioSeed % parts) < shareOfShadows * parts ? ScenarioKind::Shadows
                                                                            : ScenarioKind::Culling;
}

/// The scenario of a seed, as it is run.
Scenario Generate(std::uint64_t seed, const Options& options)
{
  const ScenarioKind kind = ChooseKind(seed, options.Shadows);
  Scenario scenario = MakeScenario(seed, kind);
  constexpr std::uint64_t parts = 1000;
  if (kind == ScenarioKind::Culling &&
    static_cast<double>(seed / parts % parts) < options.Reversed * parts)
  {
    TestScene::Renderer& renderer = scenario.Renderers.front();
    renderer.Pass = PassKind::Reversed;
    renderer.InfiniteFar = seed % 2 == 0;
    RemoveUndefined(scenario);
  }
  if (options.Backend != vtkNBufferCuller::Auto)
  {
    scenario.Culler.Backend = options.Backend;
  }
  return scenario;
}

enum class Blame
{
  Culler,   ///< Fails with the culler only, from the start.
  History,  ///< Fails only after the scenarios before it.
  Elsewhere ///< VTK does not repeat itself, or its own culler drops what is seen.
};

Blame FindBlame(const Scenario& scenario)
{
  const auto fails = [&scenario](Role tested, Role reference)
  { return Checker(tested, reference).Run(scenario, true).HasFailed(); };
  if (fails(Role::Reference, Role::Reference))
  {
    return Blame::Elsewhere;
  }
  if (fails(Role::Stock, Role::Reference))
  {
    // VTK's own culler drops what is seen. Held props are not in the list that it gets behind ours,
    // so that the frame need not be that of VTK's own culler; without that one it has to be right.
    Scenario alone = scenario;
    alone.Culler.DefaultCuller = DefaultCuller::Removed;
    if (!fails(Role::Culled, Role::Stock) || !Checker().Run(alone, true).HasFailed())
    {
      return Blame::Elsewhere;
    }
  }
  return Checker().Run(scenario, true).HasFailed() ? Blame::Culler : Blame::History;
}

Json::Value MakeSmall(const Scenario& scenario, const Options& options)
{
  const Json::Value whole = ToJson(scenario);
  if (!options.Shrink)
  {
    return whole;
  }
  Checker tested;
  Checker stock(Role::Stock);
  const auto fails = [&](const Json::Value& value)
  {
    const Scenario candidate = FromJson(value);
    return tested.Run(candidate, true).HasFailed() && !stock.Run(candidate, true).HasFailed();
  };
  const ShrinkResult result = Shrink(whole, fails, ShrinkBudget);
  std::cout << "  shrunk in " << result.Questions << " runs" << std::endl;
  return result.Value;
}

void PrintOutcome(const Outcome& outcome)
{
  std::cout << "  frame " << outcome.Frame << ": " << outcome.Failure << std::flush;
}

Json::Value ToJson(const std::map<std::string, long long>& counts)
{
  Json::Value result(Json::objectValue);
  for (const auto& [name, count] : counts)
  {
    result[name] = Json::Int64(count);
  }
  return result;
}

/// One run over many scenarios.
class Session
{
public:
  explicit Session(const Options& options)
    : Settings(options)
  {
  }

  int Run()
  {
    std::cout << "seed " << this->Settings.Seed << std::endl;
    while (!this->IsOver())
    {
      const std::uint64_t seed =
        Mix(this->Settings.Seed, static_cast<std::uint64_t>(this->Counts.Scenarios));
      Scenario scenario = Generate(seed, this->Settings);
      if (this->Settings.Frames > 0)
      {
        scenario.Frames = static_cast<int>(
          std::min<long long>(scenario.Frames, this->Settings.Frames - this->Counts.Frames));
      }
      std::snprintf(RunningScenario, sizeof(RunningScenario), "crashed in scenario seed %llu\n",
        static_cast<unsigned long long>(seed));
      // Windows of their own now and then: what begins with a context is tested, too.
      const bool fresh = this->Counts.Scenarios % ScenariosPerWindow == 0;
      const Outcome outcome = this->Checking.Run(scenario, fresh, &this->Counts);
      if (outcome.HasFailed())
      {
        this->Report(scenario, outcome);
      }
    }
    this->Summarize();
    return this->Failures > 0 ? Failed : Success;
  }

private:
  static constexpr int ScenariosPerWindow = 100;

  double GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

  bool IsOver() const
  {
    return this->Failures >= this->Settings.MaximumFailures ||
      (this->Settings.Frames > 0 && this->Counts.Frames >= this->Settings.Frames) ||
      (this->Settings.Seconds > 0.0 && this->GetSeconds() >= this->Settings.Seconds);
  }

  void Report(const Scenario& scenario, const Outcome& outcome)
  {
    const Blame blame = FindBlame(scenario);
    if (blame == Blame::Elsewhere)
    {
      ++this->Excused;
      std::cout << "scenario seed " << scenario.Seed << " (" << scenario.Family
                << ") differs without the culler, too" << std::endl;
      PrintOutcome(outcome);
      return;
    }
    ++this->Failures;
    this->FirstFailure = this->FirstFailure < 0 ? this->Counts.Frames : this->FirstFailure;
    std::cout << "FAILED: seed " << this->Settings.Seed << ", scenario seed " << scenario.Seed
              << " (" << scenario.Family << "), after " << this->Counts.Frames << " frames"
              << (blame == Blame::History ? "; only after the scenarios before it" : "")
              << std::endl;
    PrintOutcome(outcome);
    const std::string file =
      this->Settings.Output + "/fuzz-" + std::to_string(scenario.Seed) + ".json";
    WriteJson(file,
      blame == Blame::Culler ? MakeSmall(scenario, this->Settings) : TestScene::ToJson(scenario));
    std::cout << "  replay with --replay " << file << std::endl;
  }

  void Summarize() const
  {
    const Tally& t = this->Counts;
    Json::Value json;
    json["seed"] = Json::UInt64(this->Settings.Seed);
    json["scenarios"] = Json::Int64(t.Scenarios);
    json["frames"] = Json::Int64(t.Frames);
    json["failures"] = this->Failures;
    json["frames_until_failure"] = Json::Int64(this->FirstFailure);
    json["differs_without_culler"] = this->Excused;
    json["gl_errors"] = Json::Int64(t.GLErrors);
    json["undefined_without_culler"] = Json::Int64(t.Undefined);
    json["props"] = Json::Int64(t.Props);
    json["tested"] = Json::Int64(t.Tested);
    json["held_back"] = Json::Int64(t.HeldBack);
    json["hidden"] = Json::Int64(t.Hidden);
    json["redrawn"] = Json::Int64(t.Redrawn);
    json["frames_with_hidden"] = Json::Int64(t.FramesWithHidden);
    json["shadow_frames"] = Json::Int64(t.ShadowFrames);
    json["shadow_samples"] = Json::Int64(t.Shadows.Samples);
    json["shadow_samples_shadowed"] = Json::Int64(t.Shadows.Shadowed);
    json["shadow_samples_flipped_by_clamping"] = Json::Int64(t.Shadows.ClampedFlips);
    json["shadow_strays"] = Json::Int64(t.Shadows.Strays);
    json["shadow_strays_unseen"] = Json::Int64(t.Shadows.UnseenStrays);
    json["shadow_strays_in_portions"] = Json::Int64(t.Shadows.StraysInPortions);
    json["shadow_samples_flipped_away_from_edges"] = Json::Int64(t.Shadows.ClampedFlipsElsewhere);
    json["shadow_rays"] = Json::Int64(t.Shadows.Rays);
    json["shadow_rays_ambiguous"] = Json::Int64(t.Shadows.RaysAmbiguous);
    json["shadow_decisions"] = ToJson(t.ShadowDecisions);
    json["shadow_verdicts"] = ToJson(t.ShadowVerdicts);
    json["seconds"] = this->GetSeconds();
    json["decisions"] = ToJson(t.Decisions);
    json["verdicts"] = ToJson(t.Verdicts);
    json["features"] = ToJson(t.Features);
    if (!this->Settings.JsonFile.empty())
    {
      WriteJson(this->Settings.JsonFile, json);
    }
    json.removeMember("features");
    std::cout << ToText(json) << this->Failures << " failures in " << t.Frames << " frames, seed "
              << this->Settings.Seed << std::endl;
  }

  const Options& Settings;
  Checker Checking;
  Tally Counts;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  int Failures = 0;
  int Excused = 0;
  long long FirstFailure = -1;
};

int Replay(const Options& options, const Scenario& scenario)
{
  const Outcome outcome = Checker().Run(scenario, true);
  std::cout << "scenario seed " << scenario.Seed << ": ";
  if (!outcome.HasFailed())
  {
    std::cout << "all " << scenario.Frames << " frames are right" << std::endl;
    return Success;
  }
  std::cout << "FAILED" << std::endl;
  PrintOutcome(outcome);
  const Blame blame = FindBlame(scenario);
  if (blame == Blame::Elsewhere)
  {
    std::cout << "  (it differs without the culler, too)" << std::endl;
  }
  if (!options.ScenarioFile.empty())
  {
    WriteJson(options.ScenarioFile, MakeSmall(scenario, options));
  }
  return Failed;
}

/// Run the scenario of a file, or each of a list of them.
int ReplayFile(const Options& options)
{
  const Json::Value file = ReadJson(options.ReplayFile);
  if (!file.isArray())
  {
    return Replay(options, FromJson(file));
  }
  int result = file.empty() ? Failed : Success;
  for (const Json::Value& value : file)
  {
    result = std::max(result, Replay(options, FromJson(value)));
  }
  return result;
}
}

int main(int argc, char* argv[])
{
  Options options;
  options.Seed = std::random_device()();
  CLI::App app("Compares random frames with and without vtkNBufferCuller.", "nbuffer-fuzz");
  app.add_option("--frames", options.Frames, "Stop after so many frames")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--seconds", options.Seconds, "Stop after so long")->check(CLI::NonNegativeNumber);
  app.add_option("--seed", options.Seed, "Of all that is random; any if not given");
  app.add_option("--max-failures", options.MaximumFailures, "Stop after so many")
    ->check(CLI::PositiveNumber);
  app.add_option("--shadows", options.Shadows, "Share of scenarios with shadow volumes")
    ->check(CLI::Range(0.0, 1.0));
  app
    .add_option(
      "--reversed", options.Reversed, "Share of the other scenarios that draw reversed depth")
    ->check(CLI::Range(0.0, 1.0));
  const std::map<std::string, int> backends = { { "auto", vtkNBufferCuller::Auto },
    { "opengl", vtkNBufferCuller::OpenGL }, { "cpu", vtkNBufferCuller::CPU } };
  app.add_option("--backend", options.Backend, "Use this back-end of the culler in all scenarios")
    ->transform(CLI::CheckedTransformer(backends));
  app.add_flag("!--no-shrink", options.Shrink, "Write failing scenarios as they are");
  app.add_option("--json", options.JsonFile, "Write what was counted");
  app.add_option("--output", options.Output, "Folder for scenarios that fail")
    ->check(CLI::ExistingDirectory);
  app.add_option("--replay", options.ReplayFile, "Run the scenarios of a file instead")
    ->check(CLI::ExistingFile);
  app.add_option("--write-scenario", options.ScenarioFile,
    "Write the scenario of the seed of a scenario, and run nothing; with --replay, write what "
    "shrinking leaves of one that fails");
  CLI11_PARSE(app, argc, argv);
#ifndef _WIN32
  // In windows as small as these, waking Mesa's rasteriser threads takes longer than drawing.
  setenv("LP_NUM_THREADS", "0", 0);
#endif
  // Messages are collected and compared; VTK provokes many by itself in such scenes.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  try
  {
    if (!options.ScenarioFile.empty() && options.ReplayFile.empty())
    {
      WriteJson(options.ScenarioFile, TestScene::ToJson(Generate(options.Seed, options)));
      return Success;
    }
    const std::string whyNot = FindWindowFault();
    if (!whyNot.empty())
    {
      std::cout << "SKIPPED: " << whyNot << std::endl;
      return Skipped;
    }
    if (!options.ReplayFile.empty())
    {
      return ReplayFile(options);
    }
    if (options.Frames == 0 && options.Seconds == 0.0)
    {
      options.Frames = 1000;
    }
    for (const int fault : { SIGABRT, SIGFPE, SIGSEGV })
    {
      std::signal(fault, &SayWhatCrashed);
    }
    return Session(options).Run();
  }
  catch (const std::exception& error)
  {
    std::cerr << "nbuffer-fuzz: " << error.what() << std::endl;
    return Failed;
  }
}
