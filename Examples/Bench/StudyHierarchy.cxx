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
#include <functional>

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
        const glm::dvec3 shift(x * bounds.GetLength(0), y * bounds.GetLength(1), 0.0);
        for (vtkNBufferBox box : scene)
        {
          box.Center += shift;
          box.Origin += shift;
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

/// One way of finding out which of the boxes may be seen; the counts are those of the last run.
struct Way
{
  std::vector<double> Milliseconds;
  long long Tests = 0;
  long long Lookups = 0;
  long long Kept = 0;
  long long Nodes = 0;

  /// Times visit(isHidden). isHidden(box) returns whether a box is outside the view or hidden.
  template <typename Visit>
  void Run(const DepthFrame& frame, const vtkNBufferLevels& levels, Visit&& visit)
  {
    const vtkNBufferClock clock;
    vtkNBufferOcclusionTest test(levels);
    this->Tests = this->Kept = this->Nodes = 0;
    visit(
      [&](const vtkNBufferBox& box)
      {
        if (frame.Projection.IsOutside(box))
        {
          return true;
        }
        ++this->Tests;
        vtkNBufferScreenBox screen;
        const vtkNBufferPlacement placement = frame.Projection.Project(box, screen);
        return placement == vtkNBufferPlacement::Outside ||
          (placement == vtkNBufferPlacement::Inside && test.IsHidden(screen));
      });
    this->Milliseconds.push_back(clock.GetMilliseconds());
    this->Lookups = test.GetLookups();
  }

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
}

Json::Value MeasureHierarchy(const DepthFrame& frame, const std::vector<vtkNBufferBox>& scene,
  const glm::dvec3& eye, int most, int repetitions)
{
  vtkNBufferLevels levels;
  levels.BuildBase(frame.Depth.data(), frame.Width, frame.Height, 4, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(AllLevels);
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
      flat.Run(frame, levels,
        [&](const auto& isHidden)
        { flat.Kept = std::count_if(boxes.begin(), boxes.end(), std::not_fn(isHidden)); });
      hierarchy.Run(frame, levels,
        [&](const auto& isHidden)
        {
          tree.Visit(0,
            [&](const vtkNBufferHierarchy::Node& node)
            {
              ++hierarchy.Nodes;
              const bool hidden = isHidden(node.Box);
              for (int slot = node.Begin; !hidden && node.Left < 0 && slot < node.End; ++slot)
              {
                const auto place = static_cast<std::size_t>(tree.GetOrder()[slot]);
                hierarchy.Kept += isHidden(boxes[place]) ? 0 : 1;
              }
              return !hidden;
            });
        });
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
