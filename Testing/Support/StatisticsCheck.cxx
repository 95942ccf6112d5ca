// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsCheck.h"

#include <algorithm>
#include <numeric>

std::string FindInconsistency(
  const vtkNBufferStatistics& s, int maximumNumberOfRounds, bool mayReadPixels)
{
  std::string faults;
  const auto demand = [&faults](bool fulfilled, const char* what)
  {
    if (!fulfilled)
    {
      faults += std::string("Not so: ") + what + "\n";
    }
  };
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
  return faults;
}

std::string FindInconsistency(const vtkShadowStatistics& statistics)
{
  const auto count = [&](vtkShadowVerdict verdict) { return statistics.GetCount(verdict); };
  std::string result;
  const auto demand = [&](bool holds, const char* what)
  {
    if (!holds)
    {
      result += std::string(result.empty() ? "" : "; ") + what;
    }
  };
  const int verdicts = std::accumulate(statistics.Verdicts.begin(), statistics.Verdicts.end(), 0);
  const int whole = count(vtkShadowVerdict::Whole) + count(vtkShadowVerdict::Boxed) +
    count(vtkShadowVerdict::ThroughLightPlane);
  const int clamped = count(vtkShadowVerdict::Clamped);
  demand(statistics.ZPass <= statistics.Draws, "more z-pass than draws");
  demand(statistics.Slabs >= clamped, "a clamped caster without a slab");
  if (statistics.Decision == vtkShadowDecision::Drawn)
  {
    demand(verdicts >= statistics.Lights * statistics.Casters, "casters without a verdict");
    demand(statistics.Draws > 0 && statistics.Triangles >= statistics.Draws, "nothing was drawn");
    demand(statistics.Draws <= whole + statistics.Slabs, "more draws than casters and slabs");
    demand(statistics.Litmaps <= 6 * statistics.Lights, "more litmaps than six for a light");
    const int measured = statistics.MeasureTime > 0.0 ? 3 : 0;
    const int readBacks = statistics.ReadBacks - measured;
    demand(readBacks <= 1 && readBacks >= (statistics.Litmaps > 0 ? 1 : 0),
      "litmaps without the receivers' depth, or more than one read-back");
    demand(statistics.StencilClears >= 1 && statistics.StencilClears <= statistics.Draws,
      "counted into nothing");
    demand((statistics.Litmaps > 0) || statistics.Receivers == 0, "receivers without litmaps");
  }
  else
  {
    demand(statistics.Draws == 0 && statistics.Triangles == 0, "volumes were drawn");
  }
  return result.empty() ? result : result + ": " + statistics.GetAsJSON();
}
