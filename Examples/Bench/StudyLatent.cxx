// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Study.h"
#include "StudyFrames.h"
#include "VisibleProps.h"

#include <algorithm>
#include <unordered_set>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

/// Returns the places of the props that vtkNBufferCuller's default settings find hidden in a
/// finished frame.
std::unordered_set<int> FindHidden(const DepthFrame& frame)
{
  const NBufferStudy::ContenderPointer contender = NBufferStudy::MakeModuleContender(4, true);
  contender->Build(frame);
  std::unordered_set<int> hidden;
  NBufferStudy::ContestCounts counts;
  for (const DepthBox& box : frame.Boxes)
  {
    if (contender->IsHidden(frame, box, counts))
    {
      hidden.insert(box.Prop);
    }
  }
  return hidden;
}

vtkSmartPointer<vtkUnsignedCharArray> DrawProps(
  Session& session, const NBufferExamples::CameraPose& pose, const std::vector<vtkProp*>& props)
{
  session.SetPose(pose);
  RenderOnly(session, props);
  return session.ReadPixels();
}

/// Counts pixels that differ, and paints them red in `image`.
long long MarkDifferences(vtkUnsignedCharArray* image, vtkUnsignedCharArray* expected)
{
  long long differing = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfValues(); i += 4)
  {
    unsigned char* pixel = image->GetPointer(i);
    if (!std::equal(pixel, pixel + 3, expected->GetPointer(i)))
    {
      ++differing;
      pixel[0] = 255;
      pixel[1] = pixel[2] = 0;
    }
  }
  return differing;
}
}

Json::Value MeasureLatent(
  Session& session, const CameraPath& path, int step, int pairs, const std::string& fileName)
{
  const std::vector<vtkProp*> props = session.GetProps();
  Json::Int64 missing = 0;
  Json::Int64 wrong = 0;
  Json::Int64 worst = 0;
  Json::Int64 hiddenProps = 0;
  Json::Int64 leftOut = 0;
  int popping = 0;
  const std::size_t last = path.size() - 1 - static_cast<std::size_t>(step);
  for (int pair = 0; pair < pairs; ++pair)
  {
    const std::size_t from = last * static_cast<std::size_t>(pair) / std::max(pairs - 1, 1);
    const CameraPath poses = { path[from], path[from + static_cast<std::size_t>(step)] };
    const std::vector<DepthFrame> frames = CollectFrames(session, poses);
    const std::unordered_set<int> hidden = FindHidden(frames[0]);
    for (const DepthBox& box : frames[1].Boxes)
    {
      const bool isOut = hidden.count(box.Prop) > 0;
      missing += box.Visible && isOut ? 1 : 0;
      hiddenProps += box.Visible ? 0 : 1;
      leftOut += !box.Visible && isOut ? 1 : 0;
    }
    std::vector<vtkProp*> drawn;
    for (std::size_t i = 0; i < props.size(); ++i)
    {
      if (hidden.count(static_cast<int>(i)) == 0)
      {
        drawn.push_back(props[i]);
      }
    }
    const vtkSmartPointer<vtkUnsignedCharArray> expected = DrawProps(session, poses[1], props);
    const vtkSmartPointer<vtkUnsignedCharArray> latent = DrawProps(session, poses[1], drawn);
    const Json::Int64 differing = MarkDifferences(latent, expected);
    wrong += differing;
    popping += differing > 0 ? 1 : 0;
    if (differing > worst)
    {
      worst = differing;
      WritePNG(session.MakeImage(latent), fileName);
    }
  }
  Json::Value result;
  result["step"] = step;
  result["frames"] = pairs;
  result["popping_frames"] = popping;
  result["missing_props"] = missing;
  result["wrong_pixels"] = wrong;
  result["most_wrong_pixels"] = worst;
  result["hidden_props"] = hiddenProps;
  result["left_out"] = leftOut;
  return result;
}

} // namespace NBufferBench
