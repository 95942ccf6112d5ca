// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPaper.h"

#include "Images.h"
#include "Panels.h"
#include "Report.h"
#include "StudyChart.h"
#include "StudyReport.h"

#include "BoxOutline.h"
#include "OverCoverage.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferHierarchy.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include <algorithm>
#include <cstdio>

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
  tree.Visit(
    [&](const vtkNBufferBox& box)
    {
      vtkNBufferScreenBox screen;
      ++tests.Nodes;
      return frame.Projection.Project(box, screen) == vtkNBufferPlacement::Inside &&
          isHidden(box, screen, tests.Hierarchy)
        ? vtkNBufferHierarchy::Answer::Skip
        : vtkNBufferHierarchy::Answer::Descend;
    },
    [&](int i)
    {
      const DepthBox& box = frame.Boxes[static_cast<std::size_t>(i)];
      const bool hidden = isHidden(box.Box, box.Screen, tests.Hierarchy);
      tests.FalseHidden -= box.Visible && !hidden ? 1 : 0;
    });
  return tests;
}

void Add(Json::Value& value, double more)
{
  value = value.asDouble() + more;
}

std::string Print(double percent)
{
  char text[32];
  std::snprintf(text, sizeof(text), percent < 100.0 ? "%.1f %%" : "%.0f %%", percent);
  return text;
}
}

Json::Value MakeTable1(
  Session& session, const NBufferExamples::CameraPose& pose, int repetitions, int largest)
{
  struct Column
  {
    int Width, Height, Levels;
    double Milliseconds;
  };
  // The paper's: a GeForce FX 6800.
  constexpr Column paper[] = { { 256, 256, 8, 2.0 }, { 512, 512, 9, 8.0 }, { 640, 480, 10, 10.0 },
    { 1024, 1024, 10, 31.0 } };
  Json::Value table(Json::arrayValue);
  for (const Column& column : paper)
  {
    if (column.Width > largest)
    {
      continue;
    }
    const DeviceBuild device =
      MeasureDeviceBuild(session, pose, column.Width, column.Height, 1, repetitions);
    std::vector<double> host;
    vtkNBufferLevels levels;
    for (int i = 0; i <= repetitions; ++i)
    {
      const vtkNBufferClock clock;
      levels.BuildBase(
        device.Depth.data(), device.Width, device.Height, 1, vtkNBufferExtremum::Maximum);
      levels.BuildLevels(64);
      if (i > 0)
      {
        host.push_back(clock.GetMilliseconds());
      }
    }
    Json::Value row;
    row["width"] = device.Width;
    row["height"] = device.Height;
    row["levels"] = device.Levels;
    row["cpu_ms"] = Summarize(host);
    row["opengl_ms"] = Summarize(device.Milliseconds);
    row["paper_levels"] = column.Levels;
    row["paper_ms"] = column.Milliseconds;
    table.append(row);
  }
  return table;
}

Json::Value MakeTable2(const std::vector<DepthFrame>& frames)
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
    levels.BuildLevels(64);
    vtkNBufferPixelTest pixels(frame.Projection, levels, frame.Depth.data());
    const Tests oq = CountTests(frame, tree,
      [&](const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, double& tests)
      {
        tests +=
          static_cast<double>(NBufferStudy::CountOutlinePixels(frame.Projection, box, screen));
        return pixels.IsHidden(box, screen);
      });
    vtkNBufferOcclusionTest squares(frame.Projection, levels, 1);
    const Tests nb = CountTests(frame, tree,
      [&](const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, double& tests)
      {
        const long long before = squares.GetLookups();
        const bool hidden = squares.IsHidden(box, screen);
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
  table["paper"]["oq_hierarchy"] = 1100000;
  table["paper"]["oq"] = 200000;
  table["paper"]["nb_hierarchy"] = 350;
  table["paper"]["nb"] = 500;
  return table;
}

Json::Value MakeFigure4(int size, const std::string& folder)
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
  std::vector<Panel> panels;
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
    figure.append(entry);
    panels.push_back({ MakeCoverageImage(coverage, 30.0),
      std::string(kind.Caption) + ": " + Print(100.0 * coverage.GetMean()) });
  }
  WritePNG(ComposePanels(panels, size < 256 ? 256.0 / size : 1.0), folder + "/figure-4.png");
  return figure;
}

} // namespace NBufferBench
