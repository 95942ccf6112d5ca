// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walk.h"

#include "Images.h"
#include "VisibleProps.h"

#include "vtkPropCollection.h"

#include <algorithm>
#include <cstring>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;

const char* GetBackendName(int backend)
{
  return backend == vtkNBufferCuller::CPU ? "CPU"
    : backend == vtkNBufferCuller::OpenGL ? "OpenGL"
                                          : "none used";
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
      this->Modes.emplace_back(name, options.Mode);
      this->Result.Names.push_back(name);
      ModeResult& result = this->Result.Modes[name];
      result.Milliseconds.resize(path.size());
      result.Drawn.resize(path.size());
    }
    this->Result.Frames = path.size();
    this->Result.Props =
      static_cast<std::size_t>(session.GetRenderer()->GetViewProps()->GetNumberOfItems());
  }

  WalkResult Run()
  {
    this->Prepare();
    const auto block = static_cast<std::size_t>(std::max(this->Options.Block, 1));
    std::size_t turn = 0;
    for (std::size_t begin = 0; begin < this->Path.size(); begin += block, ++turn)
    {
      const std::size_t end = std::min(begin + block, this->Path.size());
      this->Images.clear();
      for (std::size_t i = 0; i < this->Modes.size(); ++i)
      {
        this->RunBlock(this->Modes[(i + turn) % this->Modes.size()], begin, end);
      }
      this->Compare(begin, end);
      this->Progress("frame " + std::to_string(end) + " of " + std::to_string(this->Path.size()));
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

  /// What the oracle needs, and everything uploaded and compiled.
  void Prepare()
  {
    const auto isOracle = [](Mode& mode) { return mode.GetOracleCuller() != nullptr; };
    if (std::any_of(this->Modes.begin(), this->Modes.end(), isOracle))
    {
      this->Visible = FindVisibleProps(this->Where, this->Path,
        [this](std::size_t frame)
        {
          this->Progress("which props own a pixel: frame " + std::to_string(frame + 1) + " of " +
            std::to_string(this->Path.size()));
        });
    }
    this->Progress("uploading");
    Mode all("none", this->Options.Mode);
    all.Enter(this->Where.GetRenderer());
    this->Where.SetPose(this->Path.front());
    this->Where.Render();
    all.Leave(this->Where.GetRenderer());
    for (Mode& mode : this->Modes)
    {
      mode.Enter(this->Where.GetRenderer());
      this->RenderFrame(mode, 0);
      mode.Leave(this->Where.GetRenderer());
    }
  }

  double RenderFrame(Mode& mode, std::size_t frame)
  {
    if (OracleCuller* oracle = mode.GetOracleCuller())
    {
      oracle->SetProps(&this->Visible[frame]);
    }
    this->Where.SetPose(this->Path[frame]);
    return this->Where.Render();
  }

  void RunBlock(Mode& mode, std::size_t begin, std::size_t end)
  {
    mode.Enter(this->Where.GetRenderer());
    // The first frame comes after the second one, walked backwards.
    const std::size_t before = this->Options.Still ? begin : begin > 0 ? begin - 1 : 1;
    if (before < this->Path.size())
    {
      this->RenderFrame(mode, before);
    }
    ModeResult& result = this->Result.Modes[mode.GetName()];
    for (std::size_t frame = begin; frame < end; ++frame)
    {
      result.Milliseconds[frame] =
        this->Options.Still ? this->Where.Render() : this->RenderFrame(mode, frame);
      result.Drawn[frame] = this->Where.GetRenderer()->GetNumberOfPropsRendered();
      if (vtkNBufferCuller* culler = mode.GetNBufferCuller())
      {
        result.Statistics.push_back(culler->GetStatisticsAsJSON());
        result.Backend = GetBackendName(culler->GetBackendInUse());
      }
      if (NBufferPeers::QueryCuller* culler = mode.GetQueryCuller())
      {
        result.Queries.push_back(culler->GetStatistics());
      }
      this->KeepImage(mode.GetName(), frame);
    }
    mode.Leave(this->Where.GetRenderer());
  }

  bool IsPictured(std::size_t frame) const
  {
    return !this->Options.ImageFolder.empty() &&
      (frame == 0 || frame == this->Path.size() / 2 || frame + 1 == this->Path.size());
  }

  void KeepImage(const std::string& mode, std::size_t frame)
  {
    if (!this->Options.Verify && !this->IsPictured(frame))
    {
      return;
    }
    vtkSmartPointer<vtkUnsignedCharArray>& image = this->Images[mode][frame];
    image = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Where.ReadPixels(image);
    if (this->IsPictured(frame))
    {
      this->WriteImage(image, mode, frame, "");
    }
  }

  void WriteImage(vtkUnsignedCharArray* image, const std::string& mode, std::size_t frame,
    const std::string& suffix)
  {
    const int* size = this->Where.GetWindow()->GetActualSize();
    std::string number = std::to_string(frame);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    WritePNG(MakeImage(image, size[0], size[1]),
      this->Options.ImageFolder + "/frame-" + number + "-" + mode + suffix + ".png");
  }

  void Compare(std::size_t begin, std::size_t end)
  {
    if (!this->Options.Verify)
    {
      return;
    }
    for (auto& [name, result] : this->Result.Modes)
    {
      for (std::size_t frame = begin; frame < end; ++frame)
      {
        const long long differing = name == "none"
          ? 0
          : CountDifferingBytes(this->Images["none"][frame], this->Images[name][frame]);
        result.DifferingBytes.push_back(differing);
        if (differing > 0 && !this->Options.ImageFolder.empty())
        {
          this->WriteImage(this->Images["none"][frame], "none", frame, "-expected");
          this->WriteImage(this->Images[name][frame], name, frame, "-differs");
        }
      }
    }
    this->Result.VerifiedFrames += end - begin;
  }

  static long long CountDifferingBytes(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
  {
    const vtkIdType count = a->GetNumberOfValues();
    if (b->GetNumberOfValues() != count)
    {
      return std::max(count, b->GetNumberOfValues());
    }
    const unsigned char* p = a->GetPointer(0);
    const unsigned char* q = b->GetPointer(0);
    if (std::memcmp(p, q, static_cast<std::size_t>(count)) == 0)
    {
      return 0;
    }
    long long differing = 0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      differing += p[i] != q[i];
    }
    return differing;
  }

  Session& Where;
  const CameraPath& Path;
  const WalkOptions& Options;
  std::vector<Mode> Modes;
  std::vector<std::vector<vtkProp*>> Visible;
  /// Of this block, by mode and frame.
  std::map<std::string, std::map<std::size_t, vtkSmartPointer<vtkUnsignedCharArray>>> Images;
  WalkResult Result;
};
}

WalkResult RunWalk(Session& session, const CameraPath& path, const WalkOptions& options)
{
  return Walker(session, path, options).Run();
}

} // namespace NBufferBench
