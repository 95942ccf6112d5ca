// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsCheck.h"

#include <algorithm>
#include <numeric>

namespace
{
/// Collects the conditions that do not hold.
class Demand
{
public:
  void operator()(bool holds, const char* condition)
  {
    if (!holds)
    {
      this->Faults += std::string("Not so: ") + condition + "\n";
    }
  }

  /// Returns them with the statistics, or "" if there are none.
  template <typename Statistics>
  std::string GetFaults(const Statistics& statistics) const
  {
    return this->Faults.empty() ? "" : this->Faults + statistics.GetAsJSON() + "\n";
  }

private:
  std::string Faults;
};
}

std::string FindInconsistency(
  const vtkNBufferStatistics& s, int maximumNumberOfRounds, bool mayReadPixels)
{
  Demand demand;
  const int hidden = s.GetCount(vtkNBufferVerdict::Hidden);
  demand(
    std::accumulate(s.Verdicts.begin(), s.Verdicts.end(), 0) == s.Props, "Props = sum of Verdicts");
  demand(s.GetNumberOfPropsDrawn() + hidden + s.GetCount(vtkNBufferVerdict::Outside) == s.Props,
    "Props = drawn + hidden + outside");
  demand(std::all_of(s.Verdicts.begin(), s.Verdicts.end(), [](int count) { return count >= 0; }),
    "no count is negative");
  demand(s.GetCount(vtkNBufferVerdict::Unknown) == 0, "every prop has a verdict");
  demand(s.Candidates <= s.Props, "Candidates <= Props");
  demand(s.HeldBack <= s.Candidates, "HeldBack <= Candidates");
  demand(s.Rounds <= maximumNumberOfRounds, "Rounds <= MaximumNumberOfRounds");
  demand(s.Tested <= s.Candidates * std::max(s.Rounds, 1), "Tested <= Candidates * Rounds");
  demand(
    s.PassedCoarseTest <= s.Tested * std::max(s.Rounds, 1), "PassedCoarseTest <= Tested * Rounds");
  if (s.Decision == vtkNBufferDecision::Culled)
  {
    demand(s.Rounds >= 1, "a culled frame has a round");
    demand((s.ReadBacks > 0) == (s.BytesRead > 0), "a read-back has pixels");
    demand(s.Lookups >= s.Queries, "Lookups >= Queries");
    demand(s.Lookups <= 4 * s.Queries || mayReadPixels, "at most four lookups for a rectangle");
    demand(hidden <= s.HeldBack, "only what is held back can be hidden");
  }
  else if (s.Decision < vtkNBufferDecision::OtherView)
  {
    // The decisions from OtherView on are found out while the held props are drawn.
    demand(s.Levels == 0 && s.Texels == 0 && s.Queries == 0 && s.Lookups == 0 && s.ReadBacks == 0 &&
        s.BytesRead == 0 && s.Tested == 0,
      "a frame without a test does no work");
  }
  demand(s.UnitsOutside >= 0 && s.UnitsKept >= 0 && s.UnitsFresh >= 0 && s.UnitsHidden >= 0 &&
      s.UnitsOutside + s.UnitsKept + s.UnitsFresh + s.UnitsHidden == s.Units,
    "Units = outside + kept + fresh + hidden");
  demand(s.UnitsOnDevice >= 0 && s.UnitsOnDevice <= s.Units, "UnitsOnDevice <= Units");
  demand(s.Decision <= vtkNBufferDecision::BackedOff || hidden == 0,
    "nothing is hidden where the culler steps aside");
  return demand.GetFaults(s);
}

std::string FindInconsistency(const vtkShadowStatistics& s)
{
  Demand demand;
  const int whole = s.GetCount(vtkShadowVerdict::Whole) + s.GetCount(vtkShadowVerdict::Boxed) +
    s.GetCount(vtkShadowVerdict::ThroughLightPlane);
  demand(s.ZPass <= s.Draws, "ZPass <= Draws");
  demand(s.Slabs >= s.GetCount(vtkShadowVerdict::Clamped), "a clamped caster has a slab");
  if (s.Decision == vtkShadowDecision::Drawn)
  {
    demand(std::accumulate(s.Verdicts.begin(), s.Verdicts.end(), 0) >= s.Lights * s.Casters,
      "every caster has a verdict for each light");
    demand(s.Draws > 0 && s.Triangles >= s.Draws, "something is drawn");
    demand(s.Draws <= whole + s.Slabs, "Draws <= casters drawn whole + Slabs");
    demand(s.Litmaps <= 6 * s.Lights, "Litmaps <= 6 * Lights");
    const int measured = s.MeasureTime > 0.0 ? 3 : 0;
    const int readBacks = s.ReadBacks - measured;
    demand(readBacks <= 1 && readBacks >= (s.Litmaps > 0 ? 1 : 0),
      "the receivers' depth of litmaps is read back, once");
    demand(s.StencilClears >= 1 && s.StencilClears <= s.Draws, "1 <= StencilClears <= Draws");
    demand(s.Litmaps > 0 || s.Receivers == 0, "there are receivers only with litmaps");
  }
  else
  {
    demand(s.Draws == 0 && s.Triangles == 0, "a frame without shadows draws no volumes");
  }
  return demand.GetFaults(s);
}
