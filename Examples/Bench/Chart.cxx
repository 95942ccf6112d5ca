// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "Images.h"
#include "Report.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkGL2PSExporter.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
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

void SetFont(vtkTextProperty* font, int size)
{
  font->SetFontFamilyToArial();
  font->SetFontSize(size);
  font->SetColor(0.15, 0.15, 0.15);
  font->SetBold(0);
  font->SetItalic(0);
}

/// Ticks at 1, 2 and 5 times the powers of ten, written as plain numbers.
void SetTimeAxis(vtkAxis* axis, double low, double high)
{
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  low /= 1.25;
  high *= 1.25;
  for (double decade = 1e-3; decade < 1e6; decade *= 10.0)
  {
    for (double step : { 1.0, 2.0, 5.0 })
    {
      const double value = step * decade;
      if (value >= low && value <= high)
      {
        char text[32];
        std::snprintf(text, sizeof(text), "%g", value);
        places->InsertNextValue(std::log10(value));
        labels->InsertNextValue(text);
      }
    }
  }
  axis->LogScaleOn();
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(low, high);
  axis->SetCustomTickPositions(places, labels);
}
}

void WriteChart(const WalkResult& result, const std::string& title, const std::string& fileStem)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(1200, 640);
  window->AddRenderer(renderer);
  renderer->SetBackground(1.0, 1.0, 1.0);

  vtkNew<vtkContextActor> actor;
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  vtkNew<vtkChartXY> chart;
  actor->GetScene()->AddItem(chart);
  chart->SetTitle(title);
  SetFont(chart->GetTitleProperties(), 20);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetInline(false);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  chart->GetLegend()->SetLabelSize(16);
  chart->GetLegend()->SetPadding(14); // Viewers of the SVG file take other, wider fonts.

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
  bottom->SetTitle("frame");
  left->SetTitle("milliseconds per frame");
  for (vtkAxis* axis : { bottom, left })
  {
    SetFont(axis->GetTitleProperties(), 17);
    SetFont(axis->GetLabelProperties(), 15);
    axis->GetGridPen()->SetColor(225, 225, 225, 255);
  }
  bottom->SetBehavior(vtkAxis::FIXED);
  bottom->SetRange(0.0, static_cast<double>(std::max<std::size_t>(result.Frames, 2) - 1));
  SetTimeAxis(left, low, high);

  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  WritePNG(grab->GetOutput(), fileStem + ".png");

  vtkNew<vtkGL2PSExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetFilePrefix(fileStem.c_str());
  exporter->SetFileFormatToSVG();
  exporter->CompressOff();
  exporter->SetSortToOff();
  exporter->DrawBackgroundOn();
  exporter->SilentOn();
  exporter->Write();
}

} // namespace NBufferBench
