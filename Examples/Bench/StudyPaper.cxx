// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"

#include "PaperMeasures.h"

#include "vtkNBufferHierarchy.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include <algorithm>

namespace NBufferBench
{
namespace
{
using NBufferStudy::DepthBox;
using NBufferStudy::DepthFrame;

/// What table 2 counts in a frame.
struct Tests
{
  double Flat = 0.0;
  double Hierarchy = 0.0;
  double Nodes = 0.0;
  int FalseHidden = 0; ///< Visible boxes that the hierarchy leaves out.
};

/// Tests of the boxes of a frame, flat and over a hierarchy. isHidden(box, screen, tests) adds the
/// depth comparisons that it took.
template <typename IsHidden>
Tests CountTests(const DepthFrame& frame, const vtkNBufferHierarchy& tree, IsHidden&& isHidden)
{
  Tests tests;
  for (const DepthBox& box : frame.Boxes)
  {
    isHidden(box.Box, box.Screen, tests.Flat);
    tests.FalseHidden += box.Visible ? 1 : 0;
  }
  tree.Visit(0,
    [&](const vtkNBufferHierarchy::Node& node)
    {
      vtkNBufferScreenBox screen;
      ++tests.Nodes;
      if (frame.Projection.Project(node.Box, screen) == vtkNBufferPlacement::Inside &&
        isHidden(node.Box, screen, tests.Hierarchy))
      {
        return false;
      }
      for (int slot = node.Begin; node.Left < 0 && slot < node.End; ++slot)
      {
        const DepthBox& box = frame.Boxes[static_cast<std::size_t>(tree.GetOrder()[slot])];
        const bool hidden = isHidden(box.Box, box.Screen, tests.Hierarchy);
        tests.FalseHidden -= box.Visible && !hidden ? 1 : 0;
      }
      return true;
    });
  return tests;
}

void Add(Json::Value& value, double more)
{
  value = value.asDouble() + more;
}
}

Json::Value MeasureTable2(const std::vector<DepthFrame>& frames)
{
  Json::Value table;
  const double share = 1.0 / static_cast<double>(frames.size());
  for (const DepthFrame& frame : frames)
  {
    std::vector<vtkNBufferBox> boxes;
    for (const DepthBox& box : frame.Boxes)
    {
      boxes.push_back(box.Box);
    }
    vtkNBufferHierarchy tree;
    tree.Build(boxes, 4);

    vtkNBufferLevels levels;
    levels.BuildBase(frame.Depth.data(), frame.Width, frame.Height, 1, vtkNBufferExtremum::Maximum);
    levels.BuildLevels(AllLevels);
    vtkNBufferPixelTest pixels(frame.Projection, levels, frame.Depth.data(), 0.0);
    const Tests oq = CountTests(frame, tree,
      [&](const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, double& tests)
      {
        tests +=
          static_cast<double>(NBufferStudy::CountOutlinePixels(frame.Projection, box, screen));
        return pixels.IsHidden(box, screen);
      });
    vtkNBufferOcclusionTest squares(levels);
    const Tests nb = CountTests(frame, tree,
      [&](const vtkNBufferBox&, const vtkNBufferScreenBox& screen, double& tests)
      {
        const long long before = squares.GetLookups();
        const bool hidden = squares.IsHidden(screen);
        tests += static_cast<double>(squares.GetLookups() - before);
        return hidden;
      });
    Add(table["boxes"], share * static_cast<double>(frame.Boxes.size()));
    Add(table["visible"],
      share *
        static_cast<double>(std::count_if(frame.Boxes.begin(), frame.Boxes.end(),
          [](const DepthBox& box) { return box.Visible; })));
    Add(table["tests"]["oq"], share * oq.Flat);
    Add(table["tests"]["oq_hierarchy"], share * oq.Hierarchy);
    Add(table["tests"]["nb"], share * nb.Flat);
    Add(table["tests"]["nb_hierarchy"], share * nb.Hierarchy);
    Add(table["false_hidden"], oq.FalseHidden + nb.FalseHidden);
    Add(table["nodes"]["oq"], share * oq.Nodes);
    Add(table["nodes"]["nb"], share * nb.Nodes);
  }
  return table;
}

Json::Value MeasureFigure4(int size)
{
  using namespace NBufferStudy;
  const DepthGrid windows = DepthGrid::Windows;
  const struct
  {
    const char* Caption;
    DepthFamily Family;
    int Places;
  } kinds[] = {
    { "one square", { 1, windows, FullStride, 0, DepthTaps::One, false }, 1 },
    { "four squares", { 1, windows, FullStride, 0, DepthTaps::Four, false }, 1 },
    { "strided s=2", { 1, windows, 2, 0, DepthTaps::Four, false }, 8 },
    { "mips, 2 x 2 taps", { 1, DepthGrid::Mips, FullStride, 0, DepthTaps::TwoByTwo, false }, 8 },
    { "mips, 4 x 4 taps", { 1, DepthGrid::Mips, FullStride, 0, DepthTaps::FourByFour, false }, 8 },
    { "rectangles, band 1", { 1, windows, FullStride, 1, DepthTaps::Four, false }, 1 },
  };
  Json::Value figure(Json::arrayValue);
  for (const auto& kind : kinds)
  {
    const OverCoverage coverage = MeasureOverCoverage(kind.Family, size, kind.Places);
    Json::Value entry;
    entry["name"] = kind.Family.GetName();
    entry["caption"] = kind.Caption;
    entry["mean_percent"] = Round(100.0 * coverage.GetMean());
    entry["area_percent"] = Round(100.0 * coverage.GetShareOfArea());
    entry["median_percent"] = Round(100.0 * coverage.GetQuantile(0.5));
    entry["most_percent"] = Round(100.0 * coverage.GetQuantile(1.0));
    entry["step"] = std::max(size / 64, 1);
    const auto side = static_cast<std::size_t>(size);
    const std::size_t step = std::max<std::size_t>(side / 64, 1);
    for (std::size_t height = 0; height < side; height += step)
    {
      Json::Value row;
      for (std::size_t width = 0; width < side; width += step)
      {
        row.append(Round(coverage.Shares[height * side + width]));
      }
      entry["shares"].append(row);
    }
    figure.append(entry);
  }
  return figure;
}

} // namespace NBufferBench
