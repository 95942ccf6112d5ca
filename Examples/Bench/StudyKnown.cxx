// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "VisibleProps.h"

#include "vtkNBufferCamera.h"

#include <array>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;
using NBufferExamples::PotentiallyVisibleSet;
using NBufferStudy::ContestCounts;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

class KnownContender : public NBufferStudy::Contender
{
public:
  KnownContender(const PotentiallyVisibleSet& known, const std::vector<DepthFrame>& frames,
    const CameraPath& path)
    : Contender(KnownName)
    , Known(known)
    , Frames(frames)
    , Path(path)
  {
  }

  void Build(const DepthFrame& frame) override
  {
    const auto place = static_cast<std::size_t>(&frame - this->Frames.data());
    this->Visible = this->Known.Find(this->Path.at(place).Eye);
  }

  bool IsHidden(const DepthFrame&, const DepthBox& box, ContestCounts& counts) override
  {
    ++counts.Queries;
    ++counts.Lookups;
    return !this->Visible.empty() && !this->Visible[static_cast<std::size_t>(box.Prop)];
  }

  std::size_t GetNumberOfTexels() const override { return 0; }
  std::size_t GetMemory() const override { return this->Visible.size(); }

private:
  const PotentiallyVisibleSet& Known;
  const std::vector<DepthFrame>& Frames;
  const CameraPath& Path;
  std::vector<char> Visible;
};

/// The places of pixels in the world.
class Unprojector
{
public:
  Unprojector(Session& session, const CameraPose& pose, const DepthFrame& frame)
    : Frame(frame)
  {
    session.SetPose(pose);
    this->ClipToWorld = vtkNBufferGLM::Invert(vtkNBufferCamera(session.GetRenderer()).WorldToClip);
  }

  glm::dvec3 GetPlace(int x, int y) const
  {
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Frame.Width) +
      static_cast<std::size_t>(x);
    const glm::dvec4 world = vtkNBufferGLM::Multiply(this->ClipToWorld,
      { 2.0 * (x + 0.5) / this->Frame.Width - 1.0, 2.0 * (y + 0.5) / this->Frame.Height - 1.0,
        2.0 * this->Frame.Depth[pixel] - 1.0, 1.0 });
    return glm::dvec3(world) / world.w;
  }

private:
  const DepthFrame& Frame;
  glm::dmat4 ClipToWorld;
};
}

NBufferStudy::ContenderPointer MakeKnownContender(
  const PotentiallyVisibleSet& known, const std::vector<DepthFrame>& frames, const CameraPath& path)
{
  return std::make_unique<KnownContender>(known, frames, path);
}

Json::Value CheckKnown(Session& session, const PotentiallyVisibleSet& known,
  const std::vector<DepthFrame>& frames, const CameraPath& path)
{
  double inView = 0.0;
  double inTable = 0.0;
  double visible = 0.0;
  Json::Int64 pixels = 0;
  Json::Int64 undrawn = 0;
  std::vector<std::array<int, 4>> contradictions; // Frame, x, y and prop.
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const DepthFrame& frame = frames[i];
    const std::vector<char> table = known.Find(path[i].Eye);
    if (table.empty())
    {
      throw std::runtime_error("the eye of a frame lies in a wall of the map");
    }
    for (const DepthBox& box : frame.Boxes)
    {
      inView += 1.0;
      inTable += table[static_cast<std::size_t>(box.Prop)];
      visible += box.Visible ? 1.0 : 0.0;
    }
    const std::vector<int> owners = FindPixelOwners(session, path[i]);
    const Unprojector unprojector(session, path[i], frame);
    for (std::size_t pixel = 0; pixel < owners.size(); ++pixel)
    {
      const int owner = owners[pixel];
      if (owner < 0 || !known.IsKnown(owner))
      {
        continue;
      }
      ++pixels;
      if (table[static_cast<std::size_t>(owner)])
      {
        continue;
      }
      const int x = static_cast<int>(pixel) % frame.Width;
      const int y = static_cast<int>(pixel) / frame.Width;
      if (known.IsBlocked(path[i].Eye, unprojector.GetPlace(x, y)))
      {
        ++undrawn;
        continue;
      }
      contradictions.push_back({ static_cast<int>(i), x, y, owner });
    }
  }
  const auto count = static_cast<double>(frames.size());
  Json::Value report;
  report["in_view"] = Round(inView / count);
  report["table"] = Round(inTable / count);
  report["visible"] = Round(visible / count);
  report["pixels"] = pixels;
  report["undrawn_pixels"] = undrawn;
  report["contradictions"] = static_cast<Json::UInt64>(contradictions.size());
  report["places"] = MakePlaces(contradictions);
  return report;
}

} // namespace NBufferBench
