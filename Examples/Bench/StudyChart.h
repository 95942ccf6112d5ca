// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyChart.h
 * @brief Pictures of the study: error against time, and over-coverage by size of the rectangle.
 */
#ifndef StudyChart_h
#define StudyChart_h

#include "OverCoverage.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtk_jsoncpp.h"

#include <string>
#include <utility>
#include <vector>

namespace NBufferBench
{

/**
 * A scene of the report (StudyReport.h) as `fileStem`.png and .svg: one marker for each point,
 * those of the Pareto line numbered along it, the default in a ring, the oracle, which keeps
 * nothing and takes no time, as a line.
 */
void WriteParetoChart(
  const Json::Value& scene, const std::string& title, const std::string& fileStem);

using ChartPoint = std::pair<double, double>;

struct ErrorGroup
{
  std::string Label;
  unsigned char Color[3];
  int Marker; ///< Of vtkPlotPoints.
  std::vector<ChartPoint> Points;
};

/// Errors against times; both axes logarithmic, an error of 0 below all others.
struct ErrorChart
{
  std::string Bottom;
  std::string Left;
  std::string Bound;  ///< What the dashed line is,
  double Least = 0.0; ///< and where.
  std::vector<ErrorGroup> Groups;
  ///@{
  /// Points of the groups: those of the line, numbered along it, and those in a ring.
  std::vector<ChartPoint> Pareto;
  std::vector<ChartPoint> Default;
  ///@}
};

/// `fileStem`.png and .svg.
void WriteErrorChart(
  const ErrorChart& errors, const std::string& title, const std::string& fileStem);

struct ChartLine
{
  std::string Label;
  unsigned char Color[3];
  std::vector<std::pair<double, double>> Points; ///< Both above 0.
};

/// Both axes logarithmic; `fileStem`.png and .svg.
void WriteLineChart(const std::vector<ChartLine>& lines, const std::string& title,
  const std::string& bottom, const std::string& left, const std::string& fileStem);

/// Logarithmic from 0 (dark) to `most` and more (light); width to the right, height upwards.
vtkSmartPointer<vtkImageData> MakeCoverageImage(
  const NBufferStudy::OverCoverage& coverage, double most);

} // namespace NBufferBench

#endif
