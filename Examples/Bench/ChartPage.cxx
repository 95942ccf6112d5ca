// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartPage.h"

#include "Images.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkGL2PSExporter.h"
#include "vtkPen.h"
#include "vtkStringArray.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <cstdio>

namespace NBufferBench
{
namespace
{
void SetFont(vtkTextProperty* font, int size)
{
  font->SetFontFamilyToArial();
  font->SetFontSize(size);
  font->SetColor(0.15, 0.15, 0.15);
  font->SetBold(0);
  font->SetItalic(0);
}
}

void SetLogAxis(vtkAxis* axis, double low, double high)
{
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  low /= 1.25;
  high *= 1.25;
  // Over many decades the powers of ten alone.
  const bool wide = high > 1e4 * low;
  for (double decade = 1e-6; decade < 1e9; decade *= 10.0)
  {
    for (double step : { 1.0, 2.0, 5.0 })
    {
      if (wide && step > 1.0)
      {
        break;
      }
      const double value = step * decade;
      if (value >= low && value <= high)
      {
        char text[32];
        std::snprintf(text, sizeof(text), value < 1e6 ? "%g" : "%.0e", value);
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

ChartPage::ChartPage(const std::string& title, int width, int height)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);

  vtkNew<vtkContextActor> actor;
  this->Renderer->AddActor(actor);
  this->Scene = actor->GetScene();
  this->Scene->SetRenderer(this->Renderer);
  this->Scene->AddItem(this->Chart);
  this->Chart->SetTitle(title);
  SetFont(this->Chart->GetTitleProperties(), 20);
  this->Chart->SetShowLegend(true);
  this->Chart->GetLegend()->SetInline(false);
  this->Chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  this->Chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  this->Chart->GetLegend()->SetLabelSize(16);
  this->Chart->GetLegend()->SetPadding(14); // Viewers of the SVG file take other, wider fonts.
}

void ChartPage::SetAxisTitles(const std::string& bottom, const std::string& left)
{
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(bottom);
  this->Chart->GetAxis(vtkAxis::LEFT)->SetTitle(left);
  for (int place : { vtkAxis::BOTTOM, vtkAxis::LEFT })
  {
    vtkAxis* axis = this->Chart->GetAxis(place);
    SetFont(axis->GetTitleProperties(), 17);
    SetFont(axis->GetLabelProperties(), 15);
    axis->GetGridPen()->SetColor(225, 225, 225, 255);
  }
}

void ChartPage::Write(const std::string& fileStem)
{
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->ReadFrontBufferOff();
  grab->Update();
  WritePNG(grab->GetOutput(), fileStem + ".png");

  vtkNew<vtkGL2PSExporter> exporter;
  exporter->SetRenderWindow(this->Window);
  exporter->SetFilePrefix(fileStem.c_str());
  exporter->SetFileFormatToSVG();
  exporter->CompressOff();
  exporter->SetSortToOff();
  exporter->DrawBackgroundOn();
  exporter->SilentOn();
  exporter->Write();
}

} // namespace NBufferBench
