// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferLateDraws.h"

#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferDepthTest.h"
#include "vtkNBufferDivision.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferPartition.h"
#include "vtkNBufferScissor.h"
#include "vtkNBufferTieQuery.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <functional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
int vtkNBufferLateDraws::DrawWhole(vtkRenderer* renderer, int place)
{
  vtkProp* prop = this->Props.GetProp(place);
  vtkNBufferDividedProp* units = this->Division.FindActive(place);
  return this->Proxy->Draw(
    prop, [&]() { return units ? units->Render(renderer) : prop->RenderOpaqueGeometry(renderer); });
}

int vtkNBufferLateDraws::DrawAgain(vtkRenderer* renderer, int place)
{
  const auto drawWhole = [&]() { return this->DrawWhole(renderer, place); };
  vtkNBufferDividedProp* units = this->Division.FindActive(place);
  return units ? units->DrawAgain(drawWhole) : drawWhole();
}

void vtkNBufferLateDraws::DescribeNext(
  const vtkNBufferDividedProp* units, const vtkNBufferDrawnProp& whole)
{
  if (!units || !units->HasFresh())
  {
    this->Drawn.push_back(whole);
    return;
  }
  const vtkNBufferUnitCulling& culling = units->GetCulling();
  for (const vtkNBufferUnits::Box& group : culling.GetUnits().GetGroups(culling.GetFresh()))
  {
    vtkNBufferDrawnProp part = whole;
    // The box of a prop that is no candidate is an estimate of VTK.
    const bool isCandidate = this->Props.GetCandidate(whole.Index).IsCandidate();
    part.KeepsScissor = part.KeepsScissor || !isCandidate;
    units->SetPlace(group, !isCandidate, part.Box);
    part.Bounded =
      this->Props.GetProjection().Project(part.Box, part.Screen) == vtkNBufferPlacement::Inside;
    this->Drawn.push_back(part);
  }
}

int vtkNBufferLateDraws::Draw(vtkRenderer* renderer, int place, int round, double time)
{
  this->Props.GetProp(place)->SetAllocatedRenderTime(time, renderer);
  const auto drawWhole = [&]() { return this->DrawWhole(renderer, place); };
  vtkNBufferDividedProp* units = this->Division.FindActive(place);
  vtkNBufferDrawnProp whole = this->Props.GetDrawn(place, round);
  if (units && units->HasFewFresh())
  {
    // The boxes of units of one mesh touch each other everywhere, but fragments of equal depth are
    // few, and there are often none.
    whole.MayTie = vtkNBufferTieQuery::HasTies([&]() { units->TryFresh(drawWhole); });
    ++this->TieQueries;
  }
  const std::size_t first = this->Drawn.size();
  this->DescribeNext(units, whole);
  const int drawn = this->Division.Draw(place, drawWhole);
  if (units && units->HasDrawnAll())
  {
    this->Drawn.resize(first); // It may tie outside of its fresh units, too.
    whole.MayTie = true;
    this->Drawn.push_back(whole);
  }
  return drawn;
}

int vtkNBufferLateDraws::Repeat(vtkRenderer* renderer, const std::vector<int>& heldBack)
{
  // The props of the list have been drawn with all their visible units, and in their places.
  this->Drawn.erase(std::remove_if(this->Drawn.begin(), this->Drawn.end(),
                      [&](const vtkNBufferDrawnProp& prop)
                      {
                        return prop.Index != this->Division.GetPostponed() &&
                          !std::binary_search(heldBack.begin(), heldBack.end(), prop.Index);
                      }),
    this->Drawn.end());
  // The others follow in one round. They may tie with units that were drawn after them before.
  std::stable_sort(this->Drawn.begin(), this->Drawn.end(),
    [](const vtkNBufferDrawnProp& a, const vtkNBufferDrawnProp& b) { return a.Index < b.Index; });
  int drawn = 0;
  int last = -1;
  for (vtkNBufferDrawnProp& prop : this->Drawn)
  {
    prop.Round = 1;
    prop.MayTie = true;
    if (std::exchange(last, prop.Index) != prop.Index)
    {
      vtkProp* heldBackProp = this->Props.GetProp(prop.Index);
      heldBackProp->SetAllocatedRenderTime(heldBackProp->GetAllocatedRenderTime(), renderer);
      drawn += this->DrawAgain(renderer, prop.Index);
    }
  }
  return drawn;
}

std::vector<vtkNBufferDrawnProp> vtkNBufferLateDraws::GetAllDrawn(
  const vtkNBufferPartition& partition, bool screensAreValid, vtkInformation* requiredKeys) const
{
  const std::vector<int>& heldBack = partition.GetHeldBack();
  std::vector<vtkNBufferDrawnProp> all = this->Drawn;
  const int firstLate = std::min_element(all.begin(), all.end(),
    [](const auto& a, const auto& b) {
      return a.Index < b.Index;
    })->Index;
  // Props that blend, and those after them, have not been drawn yet.
  const int end = std::min(this->Props.GetSize(), partition.GetFirstBlended());
  for (int i = firstLate; i < end; ++i)
  {
    const vtkNBufferVerdict verdict = this->Props.GetState(i).Verdict;
    // Other cullers set a multiplier of 0 for the props that they remove from the list.
    if (verdict != vtkNBufferVerdict::Outside && verdict != vtkNBufferVerdict::Hidden &&
      !std::binary_search(heldBack.begin(), heldBack.end(), i) &&
      i != this->Division.GetPostponed() &&
      this->Props.GetProp(i)->GetRenderTimeMultiplier() > 0.0 &&
      this->Props.GetProp(i)->HasKeys(requiredKeys) && this->Props.GetCandidate(i).WritesDepth())
    {
      all.push_back(this->Props.GetDrawn(i, 0));
      // Units are triangles or points, also those of a prop that is no candidate.
      all.back().KeepsScissor = all.back().KeepsScissor || this->Division.FindActive(i);
    }
  }
  for (vtkNBufferDrawnProp& drawn : all)
  {
    drawn.Bounded = drawn.Bounded && screensAreValid;
    drawn.KeepsScissor = drawn.KeepsScissor && screensAreValid;
  }
  return all;
}

int vtkNBufferLateDraws::RestoreTieOrder(vtkRenderer* renderer,
  const vtkNBufferPartition& partition, bool screensAreValid, int samples,
  vtkNBufferDepthTest* test, vtkInformation* requiredKeys)
{
  if (this->Drawn.empty())
  {
    return 0;
  }
  std::vector<vtkNBufferDrawnProp> all =
    this->GetAllDrawn(partition, screensAreValid, requiredKeys);
  std::function<bool(const vtkNBufferContact&)> isHidden;
  if (test)
  {
    isHidden = [test](const vtkNBufferContact& tie) { return test->IsHidden(tie); };
  }
  int draws = 0;
  for (const vtkNBufferRedraw& redraw : vtkNBufferTieOrder::GetRedraws(
         this->Props.GetProjection(), all, vtkNBufferGL::KeepsToScissor(samples), isHidden))
  {
    // Render passes have set their keys only on the props of the list: neither on those that were
    // held back nor on translucent props, which have a proxy in the list.
    const int place = all[redraw.Position].Index;
    draws += vtkNBufferGL::DrawIn(redraw.Regions, [&]() { this->DrawAgain(renderer, place); });
  }
  return draws;
}
VTK_ABI_NAMESPACE_END
