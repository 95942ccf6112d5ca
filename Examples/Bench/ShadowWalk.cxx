// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowWalk.h"

#include "RayOracle.h"
#include "Report.h"
#include "ShadowErrors.h"
#include "ShadowMode.h"
#include "Tune.h"
#include "Walk.h"

#include "vtkLight.h"
#include "vtkProp.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using Pixels = vtkSmartPointer<vtkUnsignedCharArray>;

/// For each pixel 0 lit, 1 in shadow, 2 unknown.
using Shadows = std::vector<unsigned char>;
constexpr unsigned char Unknown = 2;

/// Channels of a pixel as Session::ReadPixels() returns it.
constexpr vtkIdType Channels = 4;

/// The samples that the light reaches where nothing shadows them, against rays.
struct OracleCounts
{
  long long Samples = 0;
  long long Shadowed = 0;            ///< Samples that are in shadow by rays.
  long long Ambiguous = 0;           ///< Samples that differ and are ambiguous.
  std::array<long long, 4> Errors{}; ///< By ShadowError, those that are not ambiguous.
  /// Frame, x and y (from below) of the samples that differ and are not ambiguous.
  std::vector<std::array<int, 3>> Wrong;

  void Add(const Shadows& shadows, const Oracle& oracle, const OracleLight& light,
    const OracleImage& expected, int frame)
  {
    for (std::size_t i = 0; i < shadows.size(); ++i)
    {
      const OracleSample sample = expected.Samples[i];
      if (shadows[i] == Unknown ||
        (sample != OracleSample::Lit && sample != OracleSample::Shadowed))
      {
        continue;
      }
      ++this->Samples;
      this->Shadowed += sample == OracleSample::Shadowed;
      if ((shadows[i] != 0) == (sample == OracleSample::Shadowed))
      {
        continue;
      }
      if (expected.Ambiguous[i])
      {
        ++this->Ambiguous;
        continue;
      }
      const int x = static_cast<int>(i) % expected.Width;
      const int y = static_cast<int>(i) / expected.Width;
      this->Wrong.push_back({ frame, x, y });
      ++this->Errors[static_cast<std::size_t>(ClassifyShadowError(oracle, light, expected, x, y))];
    }
  }

  Json::Value GetReport() const
  {
    Json::Value report;
    report["samples"] = static_cast<Json::Int64>(this->Samples);
    report["shadowed"] = static_cast<Json::Int64>(this->Shadowed);
    report["wrong"] = static_cast<Json::UInt64>(this->Wrong.size());
    report["ambiguous"] = static_cast<Json::Int64>(this->Ambiguous);
    constexpr const char* names[] = { "outline", "acne", "peter_panning", "leak" };
    for (std::size_t i = 0; i < this->Errors.size(); ++i)
    {
      report["errors"][names[i]] = static_cast<Json::Int64>(this->Errors[i]);
    }
    report["wrong_places"] = MakePlaces(this->Wrong);
    return report;
  }
};

/// A mode and what its frames gave.
struct ShadowRunner
{
  ShadowRunner(const ShadowMode& mode, std::size_t frames)
    : Mode(mode)
    , Milliseconds(frames)
  {
  }

  ShadowMode Mode;
  std::vector<double> Milliseconds; ///< By frame.
  /// As JSON, in the order of the turns. The texts are parsed after the last frame, because many
  /// small allocations between the frames would slow down those that follow.
  std::vector<std::string> Statistics;
  long long Fragments = 0; ///< Of all frames.
  OracleCounts Oracle;
};

class ShadowWalker
{
public:
  ShadowWalker(
    Session& session, vtkLight* light, const CameraPath& path, const ShadowWalkOptions& options)
    : Where(session)
    , Light(light)
    , Path(path)
    , Options(options)
  {
    this->Volumes->SetCasterKeys(options.CasterKeys);
    Tune(this->Volumes, &vtkShadowTuning::MeasureDeviceTime, options.DeviceTimes);
    for (const std::string& name : options.Modes)
    {
      this->Runners.emplace_back(ShadowMode(name, this->Volumes), path.size());
    }
  }

  Json::Value Run()
  {
    for (const ShadowRunner& runner : this->Runners)
    {
      ShowProgress("uploading, " + runner.Mode.GetName());
      runner.Mode.Enter(this->Where.GetRenderer());
      this->RenderFrame(runner.Mode, 0);
    }
    TakeTurns(
      this->Runners.size(), this->Path.size(), this->Options.Block,
      [this](std::size_t mode, std::size_t begin, std::size_t end)
      { this->TimeBlock(this->Runners[mode], begin, end); },
      [this](std::size_t, std::size_t end)
      {
        ShowProgress(
          "timed frame " + std::to_string(end) + " of " + std::to_string(this->Path.size()));
      });
    Json::Value report;
    this->CountFragments();
    this->CountShadowed(report);
    this->WriteImages();
    if (this->Options.Oracle)
    {
      this->CompareWithRays();
    }
    // Resources are released now, because the window may outlive this object.
    for (const ShadowRunner& runner : this->Runners)
    {
      runner.Mode.Release(this->Where.GetRenderer());
    }
    this->AddModes(report);
    return report;
  }

private:
  ShadowRunner* Find(const std::string& name)
  {
    const auto found = std::find_if(this->Runners.begin(), this->Runners.end(),
      [&name](const ShadowRunner& runner) { return runner.Mode.GetName() == name; });
    return found == this->Runners.end() ? nullptr : &*found;
  }

  double RenderFrame(const ShadowMode& mode, std::size_t frame)
  {
    if (mode.DrawsMapEachFrame())
    {
      this->Light->Modified();
    }
    // Otherwise the pass would keep the masks of a pose that was rendered before.
    this->Volumes->Modified();
    this->Where.SetPose(this->Path[frame]);
    return this->Where.Render();
  }

  Pixels Draw(const ShadowMode& mode, std::size_t frame)
  {
    mode.Enter(this->Where.GetRenderer());
    this->RenderFrame(mode, frame);
    return this->Where.ReadPixels();
  }

  void TimeBlock(ShadowRunner& runner, std::size_t begin, std::size_t end)
  {
    runner.Mode.Enter(this->Where.GetRenderer());
    // This frame is not timed: buffers and shaders change with the mode.
    this->RenderFrame(
      runner.Mode, begin > 0 ? begin - 1 : std::min<std::size_t>(1, this->Path.size() - 1));
    for (std::size_t frame = begin; frame < end; ++frame)
    {
      runner.Milliseconds[frame] = this->RenderFrame(runner.Mode, frame);
      if (runner.Mode.HasVolumes())
      {
        runner.Statistics.push_back(this->Volumes->GetStatistics().GetAsJSON());
      }
    }
  }

  void CountFragments()
  {
    Tune(this->Volumes, &vtkShadowTuning::CountFragments, true);
    for (ShadowRunner& runner : this->Runners)
    {
      if (!runner.Mode.HasVolumes())
      {
        continue;
      }
      ShowProgress("counting fragments, " + runner.Mode.GetName());
      runner.Mode.Enter(this->Where.GetRenderer());
      for (std::size_t frame = 0; frame < this->Path.size(); ++frame)
      {
        this->RenderFrame(runner.Mode, frame);
        // -1 says that there was nothing to draw.
        runner.Fragments += std::max(this->Volumes->GetStatistics().Fragments, 0LL);
      }
    }
    Tune(this->Volumes, &vtkShadowTuning::CountFragments, false);
  }

  /// Counts the pixels that shadows change, with and without whole volumes.
  void CountShadowed(Json::Value& report)
  {
    const ShadowRunner* unclamped = this->Find("unclamped");
    if (!unclamped)
    {
      return;
    }
    ShowProgress("counting pixels in shadow");
    long long shadowed = 0;
    for (std::size_t frame = 0; frame < this->Path.size(); ++frame)
    {
      Pixels images[2];
      for (const bool casts : { true, false })
      {
        this->Volumes->SetLightCasts(this->Light, casts);
        images[casts] = this->Draw(unclamped->Mode, frame);
      }
      for (vtkIdType i = 0; i < images[0]->GetNumberOfValues(); i += Channels)
      {
        const unsigned char* a = images[0]->GetPointer(i);
        shadowed += !std::equal(a, a + 3, images[1]->GetPointer(i));
      }
    }
    this->Volumes->SetLightCasts(this->Light, true);
    report["shadowed"] =
      static_cast<Json::Int64>(shadowed / static_cast<long long>(this->Path.size()));
  }

  void WriteImages()
  {
    this->Volumes->SetDebugView(this->Options.DebugView);
    for (const ShadowRunner& runner : this->Runners)
    {
      if (!this->Options.ImageFolder.empty())
      {
        WritePNG(this->Where.MakeImage(this->Draw(runner.Mode, this->Path.size() / 2)),
          this->Options.ImageFolder + "/shadow-" + runner.Mode.GetName() + ".png");
      }
    }
    this->Volumes->SetDebugView(vtkShadowVolumeClampPass::NoDebugView);
  }

  void CompareWithRays()
  {
    // Rays lead through the centres of pixels, so that there must be no other samples.
    this->Where.GetWindow()->SetMultiSamples(0);
    std::set<std::size_t> frames = { this->Path.size() / 2 };
    if (!this->Options.OracleOnce)
    {
      frames.insert({ 0, this->Path.size() - 1 });
    }
    for (const std::size_t frame : frames)
    {
      ShowProgress("casting rays, frame " + std::to_string(frame));
      this->Where.SetPose(this->Path[frame]);
      const Oracle oracle(this->Where.GetRenderer(),
        [this](vtkProp* prop) { return prop->HasKeys(this->Options.CasterKeys); });
      const OracleLight light(this->Light);
      const OracleImage expected = oracle.Cast(light);
      for (ShadowRunner& runner : this->Runners)
      {
        if (runner.Mode.GetName() != "none")
        {
          runner.Oracle.Add(runner.Mode.HasVolumes()
              ? this->FindShadowsInMask(runner.Mode, frame, expected.Samples.size())
              : this->FindShadowsInImages(runner.Mode, frame),
            oracle, light, expected, static_cast<int>(frame));
        }
      }
    }
  }

  Shadows FindShadowsInMask(const ShadowMode& mode, std::size_t frame, std::size_t size)
  {
    mode.Enter(this->Where.GetRenderer());
    this->RenderFrame(mode, frame);
    int width = 0;
    int height = 0;
    Shadows mask = this->Volumes->GetMask(this->Light, width, height);
    std::replace_if(
      mask.begin(), mask.end(), [](unsigned char value) { return value != 0; }, 1);
    mask.resize(size, 0); // Without a mask everything is lit.
    return mask;
  }

  /// For passes without masks: a pixel is in shadow if it is nearer to its colour without the light
  /// than to its colour with the light and without shadows. It is unknown where these two hardly
  /// differ.
  Shadows FindShadowsInImages(const ShadowMode& mode, std::size_t frame)
  {
    const ShadowMode none("none", this->Volumes);
    const double intensity = this->Light->GetIntensity();
    const Pixels lit = this->Draw(none, frame);
    this->Light->SetIntensity(0.0);
    const Pixels dark = this->Draw(none, frame);
    this->Light->SetIntensity(intensity);
    const Pixels shadowed = this->Draw(mode, frame);
    constexpr int least = 8; // levels of 255
    constexpr vtkIdType green = 1;
    Shadows result;
    for (vtkIdType i = green; i < lit->GetNumberOfValues(); i += Channels)
    {
      const int range = lit->GetValue(i) - dark->GetValue(i);
      const int above = shadowed->GetValue(i) - dark->GetValue(i);
      result.push_back(range < least ? Unknown : 2 * above < range);
    }
    return result;
  }

  void AddModes(Json::Value& report)
  {
    const ShadowRunner* unclamped = this->Find("unclamped");
    const auto frames = static_cast<double>(this->Path.size());
    std::size_t wrong = 0;
    for (const ShadowRunner& runner : this->Runners)
    {
      const std::string& name = runner.Mode.GetName();
      Json::Value& mode = report["modes"][name];
      AddTimes(mode, runner.Milliseconds);
      if (runner.Mode.HasVolumes())
      {
        const auto fragments = static_cast<double>(runner.Fragments);
        mode["fragments"] = static_cast<Json::Int64>(std::llround(fragments / frames));
        if (unclamped && unclamped->Fragments > 0)
        {
          mode["fragments_percent"] =
            Round(100.0 * fragments / static_cast<double>(unclamped->Fragments));
        }
        mode["statistics"] = GetMedian(ParseAll(runner.Statistics));
        mode["statistics"].removeMember("fragments");
      }
      if (this->Options.Oracle && name != "none")
      {
        mode["must_be_exact"] = runner.Mode.IsExact();
        mode["oracle"] = runner.Oracle.GetReport();
        wrong += runner.Mode.IsExact() ? runner.Oracle.Wrong.size() : 0;
      }
    }
    AddRatios(report, { "unclamped", "none" });
    report["frames"] = static_cast<Json::UInt64>(this->Path.size());
    report["block"] = this->Options.Block;
    report["litmap"] = vtkShadowTuning().LitmapResolution;
    report["wrong_samples"] = static_cast<Json::UInt64>(wrong);
  }

  Session& Where;
  vtkLight* Light;
  const CameraPath& Path;
  const ShadowWalkOptions& Options;
  vtkNew<vtkShadowVolumeClampPass> Volumes;
  std::vector<ShadowRunner> Runners;
};
}

Json::Value RunShadowWalk(
  Session& session, vtkLight* light, const CameraPath& path, const ShadowWalkOptions& options)
{
  return ShadowWalker(session, light, path, options).Run();
}

} // namespace NBufferBench
