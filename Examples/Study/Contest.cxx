// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Contest.h"

#include "vtkNBufferClock.h"

#include <algorithm>

namespace NBufferStudy
{
namespace
{
/// Builds the structure and tests the boxes; the verdicts go to `hidden`.
void RunTurn(Contender& contender, const DepthFrame& frame, ContestResult& result,
  ContestCounts& counts, std::vector<char>& hidden)
{
  hidden.resize(frame.Boxes.size());
  vtkNBufferClock clock;
  contender.Build(frame);
  result.BuildTimes.push_back(clock.Restart());
  for (std::size_t i = 0; i < frame.Boxes.size(); ++i)
  {
    hidden[i] = contender.IsHidden(frame, frame.Boxes[i], counts) ? 1 : 0;
  }
  result.QueryTimes.push_back(clock.Restart());
}

void Judge(const Contender& contender, const DepthFrame& frame, const std::vector<char>& hidden,
  ContestResult& result)
{
  for (std::size_t i = 0; i < frame.Boxes.size(); ++i)
  {
    const DepthBox& box = frame.Boxes[i];
    ++result.Boxes;
    result.Hidden += box.Visible ? 0 : 1;
    result.FalseVisible += !box.Visible && !hidden[i] ? 1 : 0;
    result.FalseHidden += box.Visible && hidden[i] ? 1 : 0;
    result.Area +=
      static_cast<double>(box.Screen.Pixels.GetWidth()) * box.Screen.Pixels.GetHeight();
    result.CoveredArea += static_cast<double>(contender.GetCoveredArea(box));
  }
  result.Texels = std::max(result.Texels, contender.GetNumberOfTexels());
  result.Memory = std::max(result.Memory, contender.GetMemory());
}
}

std::vector<double> ContestResult::GetTimes() const
{
  std::vector<double> times(this->BuildTimes.size());
  std::transform(this->BuildTimes.begin(), this->BuildTimes.end(), this->QueryTimes.begin(),
    times.begin(), [](double build, double query) { return build + query; });
  return times;
}

std::vector<ContestResult> RunContest(const std::vector<DepthFrame>& frames,
  const std::vector<ContenderPointer>& contenders, int repetitions,
  const std::function<void(int, int)>& progress)
{
  std::vector<ContestResult> results(contenders.size());
  std::vector<char> hidden;
  const int turns = repetitions * static_cast<int>(frames.size());
  // The first turn, untimed, finds memory and counts.
  for (const DepthFrame& frame : frames)
  {
    for (std::size_t i = 0; i < contenders.size(); ++i)
    {
      results[i].Name = contenders[i]->GetName();
      RunTurn(*contenders[i], frame, results[i], results[i].Counts, hidden);
      Judge(*contenders[i], frame, hidden, results[i]);
      results[i].BuildTimes.clear();
      results[i].QueryTimes.clear();
    }
  }
  for (int turn = 0; turn < turns; ++turn)
  {
    const DepthFrame& frame = frames[static_cast<std::size_t>(turn) % frames.size()];
    if (progress)
    {
      progress(turn + 1, turns);
    }
    for (std::size_t n = 0; n < contenders.size(); ++n)
    {
      // Everyone comes after somebody else each time.
      const std::size_t i = (n + static_cast<std::size_t>(turn)) % contenders.size();
      ContestCounts counts;
      RunTurn(*contenders[i], frame, results[i], counts, hidden);
    }
  }
  return results;
}

} // namespace NBufferStudy
