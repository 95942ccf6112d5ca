// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyChart.h"

#include "ChartPage.h"
#include "Viridis.h"

#include "vtkAxis.h"
#include "vtkContext2D.h"
#include "vtkContextItem.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPlotPoints.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace NBufferBench
{
namespace
{
struct Look
{
  const char* Group;
  const char* Label;
  unsigned char Color[3];
  int Marker;
};
// Okabe and Ito, and shapes for those who see no colours.
constexpr Look Looks[] = {
  { "one square", "one square", { 230, 159, 0 }, vtkPlotPoints::SQUARE },
  { "four squares", "four squares", { 0, 114, 178 }, vtkPlotPoints::SQUARE },
  { "squares in pieces", "squares, boxes in 8 pieces", { 0, 114, 178 }, vtkPlotPoints::DIAMOND },
  { "strided", "strided squares", { 86, 180, 233 }, vtkPlotPoints::SQUARE },
  { "rectangles", "rectangles", { 204, 121, 167 }, vtkPlotPoints::CIRCLE },
  { "mips", "mip chain", { 213, 94, 0 }, vtkPlotPoints::CROSS },
  { "one level", "one level", { 120, 120, 120 }, vtkPlotPoints::PLUS },
  { "table", "table of the map", { 170, 0, 0 }, vtkPlotPoints::CIRCLE },
  { "positions", "squares with positions", { 0, 114, 178 }, vtkPlotPoints::PLUS },
  { "culler", "vtkNBufferCuller", { 0, 158, 115 }, vtkPlotPoints::DIAMOND },
  { "outline", "outline per pixel", { 0, 0, 0 }, vtkPlotPoints::DIAMOND },
};

double GetTime(const Json::Value& point)
{
  return point["total_ms"]["median"].asDouble();
}

double GetError(const Json::Value& point)
{
  return point["false_visible_percent"].asDouble();
}

/// Adds columns of points, and a plot of them.
vtkPlot* AddPlot(vtkChartXY* chart, int type, const std::string& label,
  const std::vector<std::pair<double, double>>& points)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("milliseconds");
  y->SetName(label.c_str());
  for (const auto& point : points)
  {
    x->InsertNextValue(point.first);
    y->InsertNextValue(point.second);
  }
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* plot = chart->AddPlot(type);
  plot->SetInputData(table, 0, 1);
  return plot;
}

/// Texts beside places of a chart.
class Labels : public vtkContextItem
{
public:
  static Labels* New();
  vtkTypeMacro(Labels, vtkContextItem);

  void Add(double x, double y, const std::string& text) { this->Texts.push_back({ x, y, text }); }

  bool Paint(vtkContext2D* painter) override
  {
    painter->GetTextProp()->SetFontFamilyToArial();
    painter->GetTextProp()->SetFontSize(14);
    painter->GetTextProp()->SetBold(0);
    painter->GetTextProp()->SetColor(0.1, 0.1, 0.1);
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
    for (const Text& text : this->Texts)
    {
      const double x = Place(this->Chart->GetAxis(vtkAxis::BOTTOM), text.X, 0);
      const double y = Place(this->Chart->GetAxis(vtkAxis::LEFT), text.Y, 1);
      painter->DrawString(static_cast<float>(x + 6.0), static_cast<float>(y + 4.0), text.Words);
    }
    return true;
  }

  vtkChartXY* Chart = nullptr;

private:
  struct Text
  {
    double X, Y;
    std::string Words;
  };

  static double Place(vtkAxis* axis, double value, int coordinate)
  {
    const double begin = axis->GetPoint1()[coordinate];
    const double end = axis->GetPoint2()[coordinate];
    const double low = axis->GetMinimum();
    const double high = axis->GetMaximum();
    const double scaled = axis->GetLogScaleActive() ? std::log10(value) : value;
    return begin + (scaled - low) / (high - low) * (end - begin);
  }

  std::vector<Text> Texts;
};
vtkStandardNewMacro(Labels);

/// A colour for every point: without an array of them VTK 9.7 dereferences a null pointer when it
/// writes markers as SVG.
void SetColor(vtkPlotPoints* points, const unsigned char color[3], double opacity)
{
  vtkTable* table = points->GetInput();
  vtkNew<vtkDoubleArray> zeros;
  zeros->SetName("color");
  zeros->SetNumberOfTuples(table->GetNumberOfRows());
  zeros->FillComponent(0, 0.0);
  table->AddColumn(zeros);
  vtkNew<vtkLookupTable> lookup;
  lookup->SetNumberOfTableValues(1);
  lookup->SetTableValue(0, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, opacity);
  lookup->SetRange(0.0, 1.0);
  points->SetLookupTable(lookup);
  points->SelectColorArray("color");
  points->ScalarVisibilityOn();
  points->SetColor(color[0], color[1], color[2], static_cast<unsigned char>(255.0 * opacity));
}
}

void WriteErrorChart(
  const ErrorChart& errors, const std::string& title, const std::string& fileStem)
{
  ChartPage page(title, 1200, 720);
  vtkChartXY* chart = page.GetChart();
  double low = 1e300;
  double high = 0.0;
  double most = 0.0;
  double least = 100.0;
  for (const ErrorGroup& group : errors.Groups)
  {
    for (const ChartPoint& point : group.Points)
    {
      low = std::min(low, point.first);
      high = std::max(high, point.first);
      most = std::max(most, point.second);
      least = point.second > 0.0 ? std::min(least, point.second) : least;
    }
  }
  // What stands for nothing at all on a logarithmic axis: below all that is more than nothing.
  const double floor = 0.5 * least;
  const auto place = [floor](std::vector<ChartPoint> points)
  {
    for (ChartPoint& point : points)
    {
      point.second = std::max(point.second, floor);
    }
    return points;
  };
  std::vector<ChartPoint> line = place(errors.Pareto);
  std::sort(line.begin(), line.end());

  vtkNew<Labels> labels;
  labels->Chart = chart;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    labels->Add(line[i].first, line[i].second, std::to_string(i + 1));
  }
  if (line.size() > 1)
  {
    vtkPlot* pareto = AddPlot(chart, vtkChart::LINE, "Pareto line", line);
    pareto->SetColor(60, 60, 60, 255);
    pareto->SetWidth(1.5);
  }
  for (const ErrorGroup& group : errors.Groups)
  {
    if (!group.Points.empty())
    {
      auto* points = vtkPlotPoints::SafeDownCast(
        AddPlot(chart, vtkChart::POINTS, group.Label, place(group.Points)));
      points->SetMarkerStyle(group.Marker);
      points->SetMarkerSize(9.0f);
      SetColor(points, group.Color, 1.0);
    }
  }
  if (!errors.Default.empty())
  {
    auto* ring = vtkPlotPoints::SafeDownCast(
      AddPlot(chart, vtkChart::POINTS, "default settings", place(errors.Default)));
    ring->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    ring->SetMarkerSize(20.0f);
    const unsigned char green[] = { 0, 158, 115 };
    SetColor(ring, green, 0.4);
  }
  const double bottom = errors.Least > 0.0 ? errors.Least : floor;
  vtkPlot* bound =
    AddPlot(chart, vtkChart::LINE, errors.Bound, { { low / 2.0, bottom }, { 2.0 * high, bottom } });
  bound->SetColor(0, 158, 115, 255);
  bound->GetPen()->SetLineType(vtkPen::DASH_LINE);
  bound->SetWidth(2.0);
  page.GetScene()->AddItem(labels);

  page.SetAxisTitles(errors.Bottom, errors.Left);
  SetLogAxis(chart->GetAxis(vtkAxis::LEFT), std::min(bottom, floor), std::max(most, 2.0 * floor));
  SetLogAxis(chart->GetAxis(vtkAxis::BOTTOM), low, high);
  page.Write(fileStem);
}

void WriteParetoChart(
  const Json::Value& scene, const std::string& title, const std::string& fileStem)
{
  ErrorChart chart;
  chart.Bottom = "milliseconds of a frame: build and all queries";
  chart.Left = "hidden props that are kept, %";
  chart.Bound = "oracle: 0 %, in no time";
  for (const Look& look : Looks)
  {
    chart.Groups.push_back(
      { look.Label, { look.Color[0], look.Color[1], look.Color[2] }, look.Marker, {} });
    for (const Json::Value& point : scene["points"])
    {
      if (point["group"].asString() == look.Group)
      {
        chart.Groups.back().Points.emplace_back(GetTime(point), GetError(point));
      }
    }
  }
  for (const Json::Value& point : scene["points"])
  {
    if (point["pareto"].asBool())
    {
      chart.Pareto.emplace_back(GetTime(point), GetError(point));
    }
    if (point["is_default"].asBool())
    {
      chart.Default.emplace_back(GetTime(point), GetError(point));
    }
  }
  WriteErrorChart(chart, title, fileStem);
}

void WriteLineChart(const std::vector<ChartLine>& lines, const std::string& title,
  const std::string& bottom, const std::string& left, const std::string& fileStem)
{
  ChartPage page(title, 1200, 640);
  double low[2] = { 1e300, 1e300 };
  double high[2] = { 0.0, 0.0 };
  for (const ChartLine& line : lines)
  {
    for (const auto& point : line.Points)
    {
      low[0] = std::min(low[0], point.first);
      low[1] = std::min(low[1], point.second);
      high[0] = std::max(high[0], point.first);
      high[1] = std::max(high[1], point.second);
    }
    if (line.Points.size() > 1)
    {
      vtkPlot* plot = AddPlot(page.GetChart(), vtkChart::LINE, line.Label, line.Points);
      plot->SetColor(line.Color[0], line.Color[1], line.Color[2], 255);
      plot->SetWidth(2.5);
    }
    else
    {
      SetColor(vtkPlotPoints::SafeDownCast(
                 AddPlot(page.GetChart(), vtkChart::POINTS, line.Label, line.Points)),
        line.Color, 1.0);
    }
  }
  page.SetAxisTitles(bottom, left);
  SetLogAxis(page.GetChart()->GetAxis(vtkAxis::BOTTOM), low[0], high[0]);
  SetLogAxis(page.GetChart()->GetAxis(vtkAxis::LEFT), low[1], high[1]);
  page.Write(fileStem);
}

vtkSmartPointer<vtkImageData> MakeCoverageImage(
  const NBufferStudy::OverCoverage& coverage, double most)
{
  const vtkSmartPointer<vtkColorTransferFunction> colors = MakeViridis();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(coverage.Size, coverage.Size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (double share : coverage.Shares)
  {
    double rgb[3];
    colors->GetColor(std::min(std::log1p(std::max(share, 0.0)) / std::log1p(most), 1.0), rgb);
    for (double value : rgb)
    {
      *pixel++ = static_cast<unsigned char>(std::lround(255.0 * value));
    }
  }
  return image;
}

} // namespace NBufferBench
