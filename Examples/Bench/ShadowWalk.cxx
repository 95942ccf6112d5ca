// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowWalk.h"

#include "Images.h"
#include "RayOracle.h"
#include "ShadowMode.h"

#include "vtkLight.h"
#include "vtkProp.h"
#include "vtkShadowVolumeClampPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <set>
#include <utility>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;

/// For each pixel 0 lit, 1 in shadow, 2 unknown.
using Shadows = std::vector<unsigned char>;
constexpr unsigned char Unknown = 2;

/// Of a pixel as Session::ReadPixels() reads it.
constexpr vtkIdType Channels = 4;

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
    this->Volumes->SetMeasureDeviceTime(options.DeviceTimes);
    this->Volumes->SetSkipUnlitReceivers(options.SkipUnlitReceivers);
    if (options.BoxCost >= 0)
    {
      this->Volumes->SetBoxCost(options.BoxCost);
    }
    this->Result.Walk.Frames = path.size();
    for (const std::string& name : options.Modes)
    {
      this->Modes.emplace_back(name, options.Litmap, this->Volumes);
      this->Result.Walk.Names.push_back(name);
      this->Result.Walk.Modes[name].Milliseconds.resize(path.size());
    }
  }

  ShadowWalkResult Run()
  {
    for (const ShadowMode& mode : this->Modes)
    {
      this->Progress("uploading, " + mode.GetName());
      mode.Enter(this->Where.GetRenderer());
      this->RenderFrame(0);
    }
    const auto block = static_cast<std::size_t>(std::max(this->Options.Block, 1));
    std::size_t turn = 0;
    for (std::size_t begin = 0; begin < this->Path.size(); begin += block, ++turn)
    {
      const std::size_t end = std::min(begin + block, this->Path.size());
      for (std::size_t i = 0; i < this->Modes.size(); ++i)
      {
        this->TimeBlock(this->Modes[(i + turn) % this->Modes.size()], begin, end);
      }
      this->Progress(
        "timed frame " + std::to_string(end) + " of " + std::to_string(this->Path.size()));
    }
    this->CountFragments();
    this->CountShadowed();
    this->WriteImages();
    if (this->Options.Oracle)
    {
      this->CompareWithRays();
    }
    // Now, as the window may outlive this.
    for (const ShadowMode& mode : this->Modes)
    {
      mode.Release(this->Where.GetRenderer());
    }
    this->Progress("");
    return std::move(this->Result);
  }

private:
  void Progress(const std::string& text) const
  {
    if (this->Options.Progress)
    {
      this->Options.Progress(text);
    }
  }

  double RenderFrame(std::size_t frame)
  {
    // Masks of a pose that was rendered before are made anew.
    this->Volumes->Modified();
    this->Where.SetPose(this->Path[frame]);
    return this->Where.Render();
  }

  void TimeBlock(const ShadowMode& mode, std::size_t begin, std::size_t end)
  {
    mode.Enter(this->Where.GetRenderer());
    // Untimed: buffers and shaders change with the mode.
    this->RenderFrame(begin > 0 ? begin - 1 : std::min<std::size_t>(1, this->Path.size() - 1));
    ModeResult& result = this->Result.Walk.Modes[mode.GetName()];
    for (std::size_t frame = begin; frame < end; ++frame)
    {
      result.Milliseconds[frame] = this->RenderFrame(frame);
      if (mode.HasVolumes())
      {
        result.Statistics.push_back(this->Volumes->GetStatistics().GetAsJSON());
      }
    }
  }

  void CountFragments()
  {
    this->Volumes->CountFragmentsOn();
    for (const ShadowMode& mode : this->Modes)
    {
      if (!mode.HasVolumes())
      {
        continue;
      }
      this->Progress("counting fragments, " + mode.GetName());
      mode.Enter(this->Where.GetRenderer());
      long long& fragments = this->Result.Fragments[mode.GetName()];
      for (std::size_t frame = 0; frame < this->Path.size(); ++frame)
      {
        this->RenderFrame(frame);
        // -1: nothing was due.
        fragments += std::max(this->Volumes->GetStatistics().Fragments, 0LL);
      }
    }
    this->Volumes->CountFragmentsOff();
  }

  void CountShadowed()
  {
    const auto unclamped = std::find_if(this->Modes.begin(), this->Modes.end(),
      [](const ShadowMode& mode) { return mode.GetName() == "unclamped"; });
    if (unclamped == this->Modes.end())
    {
      return;
    }
    this->Progress("counting pixels in shadow");
    this->Result.Shadowed = 0;
    for (std::size_t frame = 0; frame < this->Path.size(); ++frame)
    {
      vtkNew<vtkUnsignedCharArray> images[2];
      for (const bool lit : { false, true })
      {
        this->Volumes->SetLightCasts(this->Light, !lit);
        unclamped->Enter(this->Where.GetRenderer());
        this->RenderFrame(frame);
        const int* size = this->Where.GetWindow()->GetActualSize();
        this->Where.GetWindow()->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, images[lit]);
      }
      const vtkIdType pixels = images[0]->GetNumberOfValues() / 3;
      for (vtkIdType i = 0; i < pixels; ++i)
      {
        const unsigned char* a = images[0]->GetPointer(3 * i);
        this->Result.Shadowed += !std::equal(a, a + 3, images[1]->GetPointer(3 * i));
      }
    }
    this->Volumes->SetLightCasts(this->Light, true);
  }

  void WriteImages()
  {
    if (this->Options.ImageFolder.empty())
    {
      return;
    }
    this->Volumes->SetDebugView(this->Options.DebugView);
    for (const ShadowMode& mode : this->Modes)
    {
      mode.Enter(this->Where.GetRenderer());
      this->RenderFrame(this->Path.size() / 2);
      vtkNew<vtkUnsignedCharArray> pixels;
      this->Where.ReadPixels(pixels);
      const int* size = this->Where.GetWindow()->GetActualSize();
      WritePNG(MakeImage(pixels, size[0], size[1]),
        this->Options.ImageFolder + "/shadow-" + mode.GetName() + ".png");
    }
    this->Volumes->SetDebugView(vtkShadowVolumeClampPass::NoDebugView);
  }

  void CompareWithRays()
  {
    // Through the centres of pixels, where there are no other samples.
    this->Where.GetWindow()->SetMultiSamples(0);
    std::set<std::size_t> frames = { this->Path.size() / 2 };
    if (!this->Options.OracleOnce)
    {
      frames.insert({ 0, this->Path.size() - 1 });
    }
    for (const std::size_t frame : frames)
    {
      this->Progress("casting rays, frame " + std::to_string(frame));
      this->Where.SetPose(this->Path[frame]);
      const Oracle oracle(this->Where.GetRenderer(),
        [this](vtkProp* prop) { return prop->HasKeys(this->Options.CasterKeys); });
      const OracleImage expected = oracle.Cast(OracleLight(this->Light));
      for (const ShadowMode& mode : this->Modes)
      {
        if (mode.GetName() != "none")
        {
          Compare(this->FindShadows(mode, frame, expected.Samples.size()), expected,
            static_cast<int>(frame), this->Result.Oracle[mode.GetName()]);
        }
      }
    }
  }

  static void Compare(
    const Shadows& shadows, const OracleImage& expected, int frame, OracleCounts& counts)
  {
    for (std::size_t i = 0; i < shadows.size(); ++i)
    {
      const OracleSample sample = expected.Samples[i];
      if (shadows[i] == Unknown ||
        (sample != OracleSample::Lit && sample != OracleSample::Shadowed))
      {
        continue;
      }
      ++counts.Samples;
      counts.Shadowed += sample == OracleSample::Shadowed;
      if ((shadows[i] != 0) == (sample == OracleSample::Shadowed))
      {
        continue;
      }
      if (expected.Ambiguous[i])
      {
        ++counts.Ambiguous;
        continue;
      }
      constexpr long long places = 20;
      if (counts.Wrong++ < places)
      {
        const int pixel = static_cast<int>(i);
        counts.Places.push_back({ frame, pixel % expected.Width, pixel / expected.Width });
      }
    }
  }

  Shadows FindShadows(const ShadowMode& mode, std::size_t frame, std::size_t size)
  {
    if (!mode.HasVolumes())
    {
      return this->FindShadowsInImages(mode, frame);
    }
    mode.Enter(this->Where.GetRenderer());
    this->RenderFrame(frame);
    int width = 0;
    int height = 0;
    Shadows mask = this->Volumes->GetMask(this->Light, width, height);
    for (unsigned char& value : mask)
    {
      value = value != 0;
    }
    mask.resize(size, 0); // Without a mask all is lit.
    if (this->Volumes->GetSkipUnlitReceivers())
    {
      // Masks know nothing of what faces away from the light, and no picture shows it.
      vtkNew<vtkUnsignedCharArray> lit;
      vtkNew<vtkUnsignedCharArray> dark;
      this->DrawWithoutShadows(frame, lit, dark);
      for (std::size_t i = 0; i < size; ++i)
      {
        const auto first = static_cast<vtkIdType>(i) * Channels;
        const unsigned char* pixel = lit->GetPointer(first);
        mask[i] = std::equal(pixel, pixel + Channels, dark->GetPointer(first)) ? Unknown : mask[i];
      }
    }
    return mask;
  }

  /// With and without the light.
  void DrawWithoutShadows(std::size_t frame, vtkUnsignedCharArray* lit, vtkUnsignedCharArray* dark)
  {
    const double intensity = this->Light->GetIntensity();
    this->Where.GetRenderer()->SetPass(nullptr);
    this->RenderFrame(frame);
    this->Where.ReadPixels(lit);
    this->Light->SetIntensity(0.0);
    this->RenderFrame(frame);
    this->Where.ReadPixels(dark);
    this->Light->SetIntensity(intensity);
  }

  /// Passes without masks: a pixel is in shadow if it is nearer to what it is without the light
  /// than to what it is with the light and without shadows; unknown where these two hardly differ.
  Shadows FindShadowsInImages(const ShadowMode& mode, std::size_t frame)
  {
    vtkNew<vtkUnsignedCharArray> lit;
    vtkNew<vtkUnsignedCharArray> dark;
    vtkNew<vtkUnsignedCharArray> shadowed;
    this->DrawWithoutShadows(frame, lit, dark);
    mode.Enter(this->Where.GetRenderer());
    this->RenderFrame(frame);
    this->Where.ReadPixels(shadowed);
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

  Session& Where;
  vtkLight* Light;
  const CameraPath& Path;
  const ShadowWalkOptions& Options;
  vtkNew<vtkShadowVolumeClampPass> Volumes;
  std::vector<ShadowMode> Modes;
  ShadowWalkResult Result;
};
}

ShadowWalkResult RunShadowWalk(
  Session& session, vtkLight* light, const CameraPath& path, const ShadowWalkOptions& options)
{
  return ShadowWalker(session, light, path, options).Run();
}

} // namespace NBufferBench
