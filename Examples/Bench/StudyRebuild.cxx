// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"
#include "Study.h"
#include "StudyFrames.h"
#include "VisibleProps.h"

#include "PaperMeasures.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::CameraPath;
using NBufferExamples::CameraPose;

/// The depth of a frame that draws only some props.
struct DrawnDepth
{
  DrawnDepth(Session& session, const CameraPose& pose, const std::vector<vtkProp*>& props)
  {
    vtkNew<OracleCuller> culler;
    culler->SetProps(&props);
    session.SetCuller(culler);
    RenderAndInspect(session, pose,
      [this](vtkOpenGLRenderWindow* window, const vtkNBufferDepthSource& source)
      {
        this->Width = source.Viewport[2];
        this->Height = source.Viewport[3];
        ReadDepth(window, source, this->Depth);
      });
    session.SetCuller();
  }

  vtkNBufferLevels MakeBase(int factor) const
  {
    vtkNBufferLevels levels;
    levels.BuildBase(
      this->Depth.data(), this->Width, this->Height, factor, vtkNBufferExtremum::Maximum);
    return levels;
  }

  int Width = 0;
  int Height = 0;
  std::vector<float> Depth;
};

bool AreEqual(const vtkNBufferLevels& a, const vtkNBufferLevels& b)
{
  const std::size_t bytes = sizeof(float) * static_cast<std::size_t>(a.GetWidth()) * a.GetHeight();
  for (int level = 0; level < a.GetNumberOfLevels(); ++level)
  {
    if (std::memcmp(a.GetLevelData(level), b.GetLevelData(level), bytes) != 0)
    {
      return false;
    }
  }
  return a.GetNumberOfLevels() == b.GetNumberOfLevels();
}

/// What the frames of a row add up to.
struct Sums
{
  double Changed = 0.0;
  double Base = 0.0;
  double Stale = 0.0;
  double Built = 0.0;
  double Texels = 0.0;
  std::vector<double> Whole;
  std::vector<double> Rebuilt;

  void Add(const DrawnDepth& first, const DrawnDepth& second, int factor, int repetitions);
};

void Sums::Add(const DrawnDepth& first, const DrawnDepth& second, int factor, int repetitions)
{
  vtkNBufferLevels before = first.MakeBase(factor);
  before.BuildLevels(AllLevels);
  const vtkNBufferLevels base = second.MakeBase(factor);
  vtkNBufferLevels whole = base;
  whole.BuildLevels(AllLevels);
  const NBufferStudy::StaleTexels stale(before, whole);
  const double texels = static_cast<double>(whole.GetWidth()) * whole.GetHeight();
  this->Changed += stale.Base > 0 ? 1.0 : 0.0;
  this->Base += static_cast<double>(stale.Base) / texels;
  this->Stale += static_cast<double>(stale.Stale);
  this->Texels += texels * (whole.GetNumberOfLevels() - 1);
  for (int i = 0; i < repetitions; ++i)
  {
    vtkNBufferLevels again = base;
    const vtkNBufferClock clock;
    again.BuildLevels(AllLevels);
    this->Whole.push_back(clock.GetMilliseconds());
  }
  for (int i = 0; i < repetitions; ++i)
  {
    vtkNBufferLevels levels = before;
    std::copy_n(base.GetLevelData(0), static_cast<std::size_t>(texels), levels.GetLevelData(0));
    const vtkNBufferClock clock;
    const long long built = stale.Base > 0 ? stale.Rebuild(levels) : 0;
    this->Rebuilt.push_back(clock.GetMilliseconds());
    this->Built += i == 0 ? static_cast<double>(built) : 0.0;
    if (!AreEqual(levels, whole))
    {
      throw std::runtime_error("levels that were built again in part differ from whole ones");
    }
  }
}
}

Json::Value MeasureRebuild(
  Session& session, const CameraPath& path, int step, int pairs, int repetitions)
{
  constexpr int factors[] = { 1, 4 };
  Sums sums[2];
  const std::size_t last = path.size() - 1 - static_cast<std::size_t>(step);
  for (int pair = 0; pair < pairs; ++pair)
  {
    const std::size_t from = last * static_cast<std::size_t>(pair) / std::max(pairs - 1, 1);
    const CameraPose& pose = path[from + static_cast<std::size_t>(step)];
    const std::vector<std::vector<vtkProp*>> visible =
      FindVisibleProps(session, { path[from], pose });
    // The second round adds what is visible now to what the first has drawn.
    std::set<vtkProp*> either(visible[0].begin(), visible[0].end());
    either.insert(visible[1].begin(), visible[1].end());
    std::vector<vtkProp*> both = session.GetProps(); // In this order.
    both.erase(std::remove_if(both.begin(), both.end(),
                 [&either](vtkProp* prop) { return either.count(prop) == 0; }),
      both.end());
    const DrawnDepth first(session, pose, visible[0]);
    const DrawnDepth second(session, pose, both);
    for (int k = 0; k < 2; ++k)
    {
      sums[k].Add(first, second, factors[k], repetitions);
    }
  }
  Json::Value result(Json::arrayValue);
  for (int k = 0; k < 2; ++k)
  {
    Json::Value entry;
    entry["step"] = step;
    entry["factor"] = factors[k];
    entry["frames"] = pairs;
    entry["changed_frames"] = static_cast<int>(sums[k].Changed);
    entry["changed_percent"] = Round(100.0 * sums[k].Base / pairs);
    entry["stale_percent"] = Round(100.0 * sums[k].Stale / sums[k].Texels);
    entry["built_percent"] = Round(100.0 * sums[k].Built / sums[k].Texels);
    entry["whole_ms"] = Summarize(sums[k].Whole);
    entry["rebuild_ms"] = Summarize(sums[k].Rebuilt);
    result.append(entry);
  }
  return result;
}

} // namespace NBufferBench
