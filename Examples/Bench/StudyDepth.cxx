// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"
#include "Study.h"

#include "DepthMeasures.h"

#include "vtkOpenGLRenderWindow.h"

#include <cmath>

namespace NBufferBench
{
namespace
{
using NBufferPeers::DepthMeasures;
using NBufferStudy::DepthFormat;
using NBufferStudy::DepthPlanes;

/// The far plane is well behind the farthest surface, so that all of them are drawn whole.
constexpr double Far = 20000.0;
constexpr double NearPlanes[] = { 0.1, 1.0 };

/// Distances of 1 m to 10 km, `steps` for each power of ten.
std::vector<double> MakeDistances(int steps)
{
  std::vector<double> distances;
  for (int i = 0; i <= 4 * steps; ++i)
  {
    distances.push_back(std::pow(10.0, static_cast<double>(i) / steps));
  }
  return distances;
}

Json::Value MeasureResolutions(
  DepthMeasures& measures, const DepthFormat& format, const DepthPlanes& planes, int steps)
{
  Json::Value result(Json::arrayValue);
  for (const double distance : MakeDistances(steps))
  {
    const DepthMeasures::Resolution resolution = measures.MeasureResolution(distance);
    Json::Value entry;
    entry["distance"] = distance;
    entry["formula"] = format.GetResolution(planes, distance);
    if (resolution.Worst >= 0.0)
    {
      entry["median"] = resolution.Median;
      entry["worst"] = resolution.Worst;
    }
    result.append(entry);
  }
  return result;
}

Json::Value MeasureFights(DepthMeasures& measures, int steps)
{
  Json::Value result(Json::arrayValue);
  for (const double slope : { 0.02, 1.0 })
  {
    for (const double gap : { 0.001, 0.01, 0.1, 1.0, 0.0 })
    {
      for (const double distance : MakeDistances(steps))
      {
        DepthMeasures::Fight sum;
        for (int i = 0; i < steps; ++i)
        {
          // The last gap is a share of the distance.
          const double place = distance * (1.0 + 0.0137 * i);
          const DepthMeasures::Fight fight =
            measures.CountWrongPixels(slope, place, gap > 0.0 ? gap : 1e-4 * place);
          sum.Pixels += fight.Pixels;
          sum.Wrong += fight.Wrong;
        }
        Json::Value entry;
        entry["slope"] = slope;
        entry["gap"] = gap;
        entry["distance"] = distance;
        entry["pixels"] = static_cast<Json::Int64>(sum.Pixels);
        entry["wrong"] = static_cast<Json::Int64>(sum.Wrong);
        result.append(entry);
      }
    }
  }
  return result;
}

Json::Value MeasureOffsets(DepthMeasures& measures)
{
  constexpr double places[][3] = { { 0.0, 1.0, 2.0 }, { 1.0, 1.0, 2.0 }, { 0.5, 0.0, 2.0 },
    { 0.0, 1.0, 50.0 } };
  Json::Value result(Json::arrayValue);
  for (const double(&place)[3] : places)
  {
    const DepthMeasures::Offset offset = measures.MeasureOffset(place[0], place[1], place[2]);
    Json::Value entry;
    entry["slope_x"] = place[0];
    entry["slope_y"] = place[1];
    entry["distance"] = place[2];
    entry["r"] = offset.Unit;
    entry["expected_r"] = offset.ExpectedUnit;
    entry["moved_by_one"] = offset.MovedByOne;
    entry["m"] = offset.Slope;
    entry["larger_slope"] = offset.LargerSlope;
    entry["steepest_slope"] = offset.SteepestSlope;
    result.append(entry);
  }
  return result;
}
}

Json::Value MeasureDepth(Session& session, int steps)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(session.GetWindow());
  Json::Value result(Json::arrayValue);
  for (const double near : NearPlanes)
  {
    const DepthPlanes planes = { near, Far };
    for (const DepthFormat& format : NBufferStudy::GetDepthFormats())
    {
      ShowProgress("depth of " + format.GetName());
      Json::Value entry;
      entry["near"] = near;
      entry["far"] = Far;
      entry["format"] = format.GetName();
      window->MakeCurrent();
      DepthMeasures measures(window, format, planes);
      if (!measures.WhyNot().empty())
      {
        entry["skipped"] = measures.WhyNot();
      }
      else
      {
        entry["resolution"] = MeasureResolutions(measures, format, planes, steps);
        entry["fights"] = MeasureFights(measures, steps);
        if (near == 1.0) // The triangles are at depths in the middle of the range.
        {
          entry["offsets"] = MeasureOffsets(measures);
        }
      }
      result.append(entry);
    }
  }
  return result;
}

} // namespace NBufferBench
