// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"

#include "vtkBoundingBox.h"
#include "vtkNBufferClock.h"
#include "vtkNBufferHierarchy.h"
#include "vtkNBufferOcclusionTest.h"

#include <algorithm>
#include <cmath>

namespace NBufferBench
{
namespace
{
using NBufferStudy::DepthFrame;

double GetDistance2(const vtkNBufferBox& box, const glm::dvec3& eye)
{
  const glm::dvec3 step = box.Center - eye;
  return glm::dot(step, step);
}

/// Copies of the scene around it, ring by ring, until there are `count` boxes; then the nearest.
std::vector<vtkNBufferBox> MakeBoxes(
  const std::vector<vtkNBufferBox>& scene, const glm::dvec3& eye, int count)
{
  vtkBoundingBox bounds;
  for (const vtkNBufferBox& box : scene)
  {
    bounds.AddPoint(box.Center[0], box.Center[1], box.Center[2]);
  }
  const auto wanted = static_cast<std::size_t>(count);
  std::vector<vtkNBufferBox> boxes;
  for (int ring = 0; boxes.size() < wanted; ++ring)
  {
    for (int y = -ring; y <= ring; ++y)
    {
      for (int x = -ring; x <= ring; ++x)
      {
        if (std::max(std::abs(x), std::abs(y)) < ring)
        {
          continue;
        }
        const double shift[2] = { x * bounds.GetLength(0), y * bounds.GetLength(1) };
        for (vtkNBufferBox box : scene)
        {
          for (int j = 0; j < 2; ++j)
          {
            box.Center[j] += shift[j];
            box.Origin[j] += shift[j];
          }
          boxes.push_back(box);
        }
      }
    }
  }
  std::nth_element(boxes.begin(), boxes.begin() + (count - 1), boxes.end(),
    [&eye](const vtkNBufferBox& a, const vtkNBufferBox& b)
    { return GetDistance2(a, eye) < GetDistance2(b, eye); });
  boxes.resize(wanted);
  return boxes;
}

/// One way of finding out which of the boxes may be seen.
struct Way
{
  std::vector<double> Milliseconds;
  long long Tests = 0;
  long long Lookups = 0;
  long long Kept = 0;
  long long Nodes = 0;
  std::vector<char> Visible;

  Json::Value Report() const
  {
    Json::Value value;
    value["ms"] = Summarize(this->Milliseconds);
    value["tests"] = static_cast<Json::Int64>(this->Tests);
    value["lookups"] = static_cast<Json::Int64>(this->Lookups);
    value["kept"] = static_cast<Json::Int64>(this->Kept);
    value["nodes"] = static_cast<Json::Int64>(this->Nodes);
    return value;
  }
};

class Tester
{
public:
  Tester(const DepthFrame& frame, const vtkNBufferLevels& levels)
    : Frame(frame)
    , Levels(levels)
  {
  }

  void RunFlat(const std::vector<vtkNBufferBox>& boxes, Way& way) const
  {
    const vtkNBufferClock clock;
    vtkNBufferOcclusionTest test = this->Begin(boxes.size(), way);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      way.Visible[i] = !this->IsHidden(boxes[i], test, way);
    }
    this->End(clock, test, way);
  }

  void RunTree(
    const std::vector<vtkNBufferBox>& boxes, const vtkNBufferHierarchy& tree, Way& way) const
  {
    const vtkNBufferClock clock;
    vtkNBufferOcclusionTest test = this->Begin(boxes.size(), way);
    tree.Visit(0,
      [&](const vtkNBufferHierarchy::Node& node)
      {
        ++way.Nodes;
        if (this->IsHidden(node.Box, test, way))
        {
          return false;
        }
        if (node.Left < 0)
        {
          for (int slot = node.Begin; slot < node.End; ++slot)
          {
            const auto place = static_cast<std::size_t>(tree.GetOrder()[slot]);
            way.Visible[place] = !this->IsHidden(boxes[place], test, way);
          }
        }
        return true;
      });
    this->End(clock, test, way);
  }

private:
  bool MayBeSeen(const vtkNBufferBox& box, vtkNBufferOcclusionTest& test, Way& way) const
  {
    ++way.Nodes;
    if (this->Frame.Projection.IsOutside(box))
    {
      return false;
    }
    ++way.Tests;
    vtkNBufferScreenBox screen;
    switch (this->Frame.Projection.Project(box, screen))
    {
      case vtkNBufferPlacement::Outside:
        return false;
      case vtkNBufferPlacement::Inside:
        return !test.IsHidden(box, screen);
      case vtkNBufferPlacement::Crossing:
        break;
    }
    return true;
  }

  vtkNBufferOcclusionTest Begin(std::size_t count, Way& way) const
  {
    way.Tests = way.Nodes = 0;
    way.Visible.assign(count, 0);
    return vtkNBufferOcclusionTest(this->Frame.Projection, this->Levels, 8);
  }

  /// Returns whether a box is outside the view or hidden.
  bool IsHidden(const vtkNBufferBox& box, vtkNBufferOcclusionTest& test, Way& way) const
  {
    if (this->Frame.Projection.IsOutside(box))
    {
      return true;
    }
    ++way.Tests;
    vtkNBufferScreenBox screen;
    const vtkNBufferPlacement placement = this->Frame.Projection.Project(box, screen);
    return placement == vtkNBufferPlacement::Outside ||
      (placement == vtkNBufferPlacement::Inside && test.IsHidden(box, screen));
  }

  static void End(const vtkNBufferClock& clock, const vtkNBufferOcclusionTest& test, Way& way)
  {
    way.Milliseconds.push_back(clock.GetMilliseconds());
    way.Lookups = test.GetLookups();
    way.Kept = std::count(way.Visible.begin(), way.Visible.end(), 1);
  }

  const DepthFrame& Frame;
  const vtkNBufferLevels& Levels;
};
}

Json::Value MeasureHierarchy(const DepthFrame& frame, const std::vector<vtkNBufferBox>& scene,
  const glm::dvec3& eye, int most, int repetitions)
{
  vtkNBufferLevels levels;
  levels.BuildBase(frame.Depth.data(), frame.Width, frame.Height, 4, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(64);
  const Tester tester(frame, levels);
  Json::Value entries(Json::arrayValue);
  for (int count : { 1000, 3000, 10000, 30000, 100000, 300000, 1000000 })
  {
    if (count > most)
    {
      break;
    }
    ShowProgress("hierarchy over " + std::to_string(count));
    const std::vector<vtkNBufferBox> boxes = MakeBoxes(scene, eye, count);
    vtkNBufferHierarchy tree;
    std::vector<double> build;
    std::vector<double> refit;
    Way flat;
    Way hierarchy;
    for (int i = 0; i < repetitions; ++i)
    {
      vtkNBufferClock clock;
      tree.Build(boxes);
      build.push_back(clock.Restart());
      for (int place : tree.GetOrder())
      {
        tree.Move(place, boxes[static_cast<std::size_t>(place)]);
      }
      tree.Refit();
      refit.push_back(clock.GetMilliseconds());
      tester.RunFlat(boxes, flat);
      tester.RunTree(boxes, tree, hierarchy);
    }
    Json::Value entry;
    entry["props"] = count;
    entry["flat"] = flat.Report();
    entry["tree"] = hierarchy.Report();
    entry["tree_nodes"] = static_cast<Json::UInt64>(tree.GetNodes().size());
    entry["build_ms"] = Summarize(build);
    entry["refit_ms"] = Summarize(refit);
    entries.append(entry);
  }
  return entries;
}

} // namespace NBufferBench
