// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPeers.h"

#include "Images.h"
#include "OracleCuller.h"
#include "Report.h"
#include "StudyFrames.h"
#include "Walk.h"

#include "Contender.h"

#include "vtkCullerCollection.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

std::vector<vtkProp*> GetProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  vtkPropCollection* list = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  list->InitTraversal(iterator);
  while (vtkProp* prop = list->GetNextProp(iterator))
  {
    props.push_back(prop);
  }
  return props;
}

/// Places of the props that vtkNBufferCuller's default settings find hidden in a finished frame.
std::unordered_set<int> FindHidden(const DepthFrame& frame)
{
  const NBufferStudy::ContenderPointer contender = NBufferStudy::MakeModuleContender(4, 8, true);
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

vtkSmartPointer<vtkUnsignedCharArray> Draw(
  Session& session, const CameraPose& pose, const std::vector<vtkProp*>& props)
{
  vtkNew<OracleCuller> culler;
  culler->SetProps(&props);
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  session.GetRenderer()->AddCuller(culler);
  session.SetPose(pose);
  session.Render();
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  session.ReadPixels(pixels);
  session.GetRenderer()->GetCullers()->RemoveAllItems();
  return pixels;
}

/// Counts pixels that differ, and paints them red in `image`.
long long MarkDifferences(vtkUnsignedCharArray* image, vtkUnsignedCharArray* expected)
{
  long long differing = 0;
  unsigned char* a = image->GetPointer(0);
  const unsigned char* b = expected->GetPointer(0);
  const vtkIdType bytes = std::min(image->GetNumberOfValues(), expected->GetNumberOfValues());
  for (vtkIdType i = 0; i + 3 < bytes; i += 4)
  {
    if (!std::equal(a + i, a + i + 3, b + i))
    {
      ++differing;
      a[i] = 255;
      a[i + 1] = a[i + 2] = 0;
    }
  }
  return differing;
}
}

const std::vector<std::string>& GetPeerNames()
{
  static const std::vector<std::string> names = { "stock", "nbuffer", "queries",
    "queries-conservative", "chc", "oracle" };
  return names;
}

std::vector<std::string> GetPeersThatRun()
{
  std::vector<std::string> names;
  std::copy_if(GetPeerNames().begin(), GetPeerNames().end(), std::back_inserter(names),
    [](const std::string& name) { return Mode::WhyNot(name).empty(); });
  return names;
}

Json::Value MeasureFrames(Session& session, const CameraPath& path,
  const std::vector<std::string>& modes, const std::function<void(const std::string&)>& progress)
{
  WalkOptions options;
  options.Progress = progress;
  options.Modes = modes;
  options.Modes.emplace_back("none");
  options.Verify = true;
  const WalkResult result = RunWalk(session, path, options);
  const Json::Value report = MakeReport(result);
  Json::Value frames;
  frames["ratios"] = report["ratios"];
  for (const std::string& name : result.Names)
  {
    Json::Value mode = report["modes"][name];
    mode.removeMember("frames_ms");
    mode.removeMember("statistics");
    frames["modes"][name] = mode;
  }
  frames["wrong_bytes"] = static_cast<Json::Int64>(GetDifferingBytes(result));
  frames["skipped"] = Json::Value(Json::objectValue);
  for (const std::string& name : GetPeerNames())
  {
    const std::string why = Mode::WhyNot(name);
    if (!why.empty())
    {
      frames["skipped"][name] = why;
    }
  }
  const Json::Value& none = frames["modes"]["none"];
  const Json::Value& oracle = frames["modes"]["oracle"];
  const double props = none["drawn"].asDouble() - oracle["drawn"].asDouble();
  frames["draw_us"] = Round(props > 0.0
      ? 1e3 * (none["median_ms"].asDouble() - oracle["median_ms"].asDouble()) / props
      : 0.0);
  return frames;
}

Json::Value MeasureLatent(
  Session& session, const CameraPath& path, int step, int pairs, const std::string& fileName)
{
  const std::vector<vtkProp*> props = GetProps(session.GetRenderer());
  const int* size = session.GetWindow()->GetActualSize();
  long long missing = 0;
  long long wrong = 0;
  long long worst = 0;
  long long hiddenProps = 0;
  long long leftOut = 0;
  int popping = 0;
  const std::size_t last = path.size() - 1 - static_cast<std::size_t>(step);
  for (int pair = 0; pair < pairs; ++pair)
  {
    const std::size_t from = last * static_cast<std::size_t>(pair) / std::max(pairs - 1, 1);
    const CameraPath poses = { path[from], path[from + static_cast<std::size_t>(step)] };
    const std::vector<DepthFrame> frames =
      CollectFrames(session, poses, std::function<void(std::size_t)>());
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
    const vtkSmartPointer<vtkUnsignedCharArray> expected = Draw(session, poses[1], props);
    const vtkSmartPointer<vtkUnsignedCharArray> latent = Draw(session, poses[1], drawn);
    const long long differing = MarkDifferences(latent, expected);
    wrong += differing;
    popping += differing > 0 ? 1 : 0;
    if (differing > worst)
    {
      worst = differing;
      WritePNG(MakeImage(latent, size[0], size[1]), fileName);
    }
  }
  Json::Value result;
  result["step"] = step;
  result["frames"] = pairs;
  result["popping_frames"] = popping;
  result["missing_props"] = static_cast<Json::Int64>(missing);
  result["wrong_pixels"] = static_cast<Json::Int64>(wrong);
  result["most_wrong_pixels"] = static_cast<Json::Int64>(worst);
  result["hidden_share_percent"] =
    Round(hiddenProps > 0 ? 100.0 * static_cast<double>(leftOut) / hiddenProps : 0.0);
  return result;
}

} // namespace NBufferBench
