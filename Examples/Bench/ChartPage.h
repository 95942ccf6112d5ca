// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class ChartPage
 * @brief A page with one chart and a legend beside it, written as PNG and SVG.
 */
#ifndef ChartPage_h
#define ChartPage_h

#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>

class vtkAxis;

namespace NBufferBench
{

/// Logarithmic, a little wider than [low, high]: ticks at 1, 2 and 5 times the powers of ten,
/// written as plain numbers.
void SetLogAxis(vtkAxis* axis, double low, double high);

class ChartPage
{
public:
  ChartPage(const std::string& title, int width, int height);

  vtkChartXY* GetChart() { return this->Chart; }
  vtkContextScene* GetScene() { return this->Scene; }

  void SetAxisTitles(const std::string& bottom, const std::string& left);

  /// `fileStem`.png and `fileStem`.svg.
  void Write(const std::string& fileStem);

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkChartXY> Chart;
  vtkContextScene* Scene = nullptr;
};

} // namespace NBufferBench

#endif
