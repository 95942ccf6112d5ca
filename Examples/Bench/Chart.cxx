// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "ChartPage.h"
#include "Report.h"

#include "vtkAxis.h"
#include "vtkDoubleArray.h"
#include "vtkPlot.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdio>

namespace NBufferBench
{
namespace
{
struct Look
{
  const char* Mode;
  const char* Label;
  unsigned char Color[3];
};
// Told apart also by those who do not tell red from green (Okabe and Ito).
constexpr Look Looks[] = { { "none", "no culler", { 120, 120, 120 } },
  { "stock", "VTK's default", { 213, 94, 0 } }, { "nbuffer", "N-buffer culler", { 0, 114, 178 } },
  { "no shadows", "no shadows", { 120, 120, 120 } },
  { "unclamped", "whole volumes", { 213, 94, 0 } }, { "exact", "exact", { 0, 114, 178 } },
  { "clamp", "one slab", { 86, 180, 233 } }, { "slabs", "several slabs", { 204, 121, 167 } },
  { "vtk", "VTK's shadow maps", { 230, 159, 0 } }, { "oracle", "lower bound", { 0, 158, 115 } } };

const Look& GetLook(const std::string& mode)
{
  return *std::find_if(std::begin(Looks), std::end(Looks) - 1,
    [&mode](const Look& look) { return mode == look.Mode; });
}

}

void WriteChart(const WalkResult& result, const std::string& title, const std::string& fileStem)
{
  ChartPage page(title, 1200, 640);
  vtkChartXY* chart = page.GetChart();

  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> frames;
  frames->SetName("frame");
  for (std::size_t i = 0; i < result.Frames; ++i)
  {
    frames->InsertNextValue(static_cast<double>(i));
  }
  table->AddColumn(frames);
  double low = 1e300;
  double high = 0.0;
  for (const std::string& name : result.Names)
  {
    const ModeResult& mode = result.Modes.at(name);
    const Look& look = GetLook(name);
    char label[96];
    std::snprintf(
      label, sizeof(label), "%s, %.3g ms", look.Label, GetQuantile(mode.Milliseconds, 0.5));
    vtkNew<vtkDoubleArray> column;
    column->SetName(label);
    for (double milliseconds : mode.Milliseconds)
    {
      column->InsertNextValue(milliseconds);
      low = std::min(low, milliseconds);
      high = std::max(high, milliseconds);
    }
    table->AddColumn(column);
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, table->GetNumberOfColumns() - 1);
    plot->SetColor(look.Color[0], look.Color[1], look.Color[2], 255);
    plot->SetWidth(2.5);
  }

  vtkAxis* bottom = chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = chart->GetAxis(vtkAxis::LEFT);
  page.SetAxisTitles("frame", "milliseconds per frame");
  bottom->SetBehavior(vtkAxis::FIXED);
  bottom->SetRange(0.0, static_cast<double>(std::max<std::size_t>(result.Frames, 2) - 1));
  SetLogAxis(left, low, high);
  page.Write(fileStem);
}

} // namespace NBufferBench
