// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPartition.h"

#include "vtkNBufferCandidateList.h"
#include "vtkNBufferCoarseDepth.h"
#include "vtkNBufferFirstDraws.h"

#include <algorithm>
#include <iterator>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferPartition::Clear()
{
  this->Kept.clear();
  this->HeldBack.clear();
  this->Translucent.clear();
  this->Lost = 0;
  this->IsAnyOutside = false;
}

vtkNBufferFrustumCounts vtkNBufferPartition::Classify(int firstBlended)
{
  this->Clear();
  this->FirstBlended = firstBlended;
  vtkNBufferFrustumCounts counts;
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    vtkNBufferState& state = this->Props.GetState(i);
    const bool isTranslucent = state.Verdict == vtkNBufferVerdict::Translucent;
    if (!isTranslucent && state.Verdict != vtkNBufferVerdict::Visible)
    {
      continue; // It is drawn for another reason.
    }
    if (vtkNBufferFirstDraws::IsDue(state, this->Props.GetProp(i)))
    {
      state.Verdict = vtkNBufferVerdict::SharedMapper;
      state.WasVisible = true;
      continue;
    }
    if (isTranslucent)
    {
      ++counts.Candidates;
      if (state.Placement == vtkNBufferPlacement::Inside)
      {
        this->Translucent.push_back(i);
      }
      continue;
    }
    if (i >= firstBlended && state.Placement != vtkNBufferPlacement::Outside)
    {
      ++counts.Blended;
      state.Verdict = vtkNBufferVerdict::Blended;
      state.WasVisible = true;
      continue;
    }
    ++counts.Candidates;
    switch (state.Placement)
    {
      case vtkNBufferPlacement::Outside:
        state.Verdict = vtkNBufferVerdict::Outside;
        this->IsAnyOutside = true;
        this->Lost += state.WasVisible ? 1 : 0;
        state.WasVisible = state.WasTested = false;
        break;
      case vtkNBufferPlacement::Crossing:
        ++counts.Inside;
        state.Verdict = vtkNBufferVerdict::NearPlane;
        state.WasVisible = true;
        break;
      case vtkNBufferPlacement::Inside:
        ++counts.Inside;
        state.Verdict = vtkNBufferVerdict::Untested;
        (state.WasVisible ? this->Kept : this->HeldBack).push_back(i);
        break;
    }
  }
  const vtkNBufferEye eye(this->Props.GetProjection());
  const auto fromElsewhere = std::count_if(this->Kept.begin(), this->Kept.end(),
    [&](int i) { return eye.SeesFromElsewhere(this->Props.GetBox(i).Center, this->Eye); });
  if (2 * static_cast<std::size_t>(fromElsewhere) > this->Kept.size())
  {
    this->Forget();
  }
  this->Eye = eye;
  counts.Kept = static_cast<int>(this->Kept.size());
  counts.HeldBack = static_cast<int>(this->HeldBack.size());
  counts.Translucent = static_cast<int>(this->Translucent.size());
  return counts;
}

void vtkNBufferPartition::Forget()
{
  std::vector<int> all;
  std::merge(this->Kept.begin(), this->Kept.end(), this->HeldBack.begin(), this->HeldBack.end(),
    std::back_inserter(all));
  for (int i : all)
  {
    this->Props.GetState(i).WasVisible = this->Props.GetState(i).WasTested = false;
  }
  this->HeldBack = std::move(all);
  this->Kept.clear();
}

void vtkNBufferPartition::HoldBack(bool needsOne)
{
  if (needsOne && !this->IsAnyOutside && this->HeldBack.empty() && !this->Kept.empty())
  {
    const auto isNearer = [this](int a, int b)
    { return this->Props.GetScreen(a).Nearest < this->Props.GetScreen(b).Nearest; };
    const auto farthest = std::max_element(this->Kept.begin(), this->Kept.end(), isNearer);
    this->HeldBack.push_back(*farthest);
    // It was drawn, so that the view is not new, even if it is the only candidate.
    this->Props.GetState(*farthest).WasTested = true;
    this->Kept.erase(farthest);
  }
  for (int i : this->Kept)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Visible;
  }
  for (int i : this->HeldBack)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Unknown;
  }
}

void vtkNBufferPartition::SetOutside(int place)
{
  this->Props.GetState(place).Verdict = vtkNBufferVerdict::Outside;
  this->HeldBack.erase(
    std::remove(this->HeldBack.begin(), this->HeldBack.end(), place), this->HeldBack.end());
}

void vtkNBufferPartition::KeepAll()
{
  // All of them are drawn from now on, so the next test begins with the depth of all of them.
  for (int i : this->HeldBack)
  {
    this->Props.GetState(i).WasVisible = true;
  }
  this->Clear();
}

void vtkNBufferPartition::Project()
{
  for (const std::vector<int>* places : { &this->Kept, &this->HeldBack, &this->Translucent })
  {
    for (int i : *places)
    {
      this->Props.GetState(i).Placement =
        this->Props.GetProjection().Project(this->Props.GetBox(i), this->Props.GetScreen(i));
    }
  }
}

std::vector<int> vtkNBufferPartition::RemoveOccluders(std::vector<int>& places, std::size_t limit)
{
  const auto getScreen = [this](int i) -> const vtkNBufferScreenBox&
  { return this->Props.GetScreen(i); };
  const auto isLarger = [&](int a, int b)
  {
    const vtkNBufferRectangle& pixels = getScreen(a).Pixels;
    const vtkNBufferRectangle& others = getScreen(b).Pixels;
    return pixels.GetWidth() * pixels.GetHeight() > others.GetWidth() * others.GetHeight();
  };
  const auto isNearer = [&](int a, int b) { return getScreen(a).Nearest < getScreen(b).Nearest; };
  // Many of the nearest props are small and hide little, so that the choice is among the largest.
  constexpr std::size_t enough = 256;
  const std::size_t size = std::min(places.size(), std::max(limit, enough));
  const auto end = places.begin() + static_cast<std::ptrdiff_t>(size);
  std::nth_element(places.begin(), end, places.end(), isLarger);
  const vtkNBufferProjection& projection = this->Props.GetProjection();
  vtkNBufferCoarseDepth depth(projection.GetWidth(), projection.GetHeight());
  std::for_each(
    places.begin(), end, [&](int i) { depth.Add(getScreen(i).Pixels, getScreen(i).Farthest); });
  // With an eighth, as of units, a wall of many small props leaves open what is behind it: the
  // middles of these props have gaps between them.
  constexpr int openShare = 4;
  const auto isOpen = [&](int i)
  { return depth.IsOpen(getScreen(i).Pixels, getScreen(i).Nearest, openShare); };
  auto last = std::partition(places.begin(), end, isOpen);
  if (static_cast<std::size_t>(last - places.begin()) > limit)
  {
    const auto nearest = places.begin() + static_cast<std::ptrdiff_t>(limit);
    std::nth_element(places.begin(), nearest, last, isNearer);
    last = nearest;
  }
  std::vector<int> occluders(places.begin(), last);
  places.erase(places.begin(), last);
  return occluders;
}

bool vtkNBufferPartition::IsNew() const
{
  const auto tested = std::count_if(this->HeldBack.begin(), this->HeldBack.end(),
    [this](int i) { return this->Props.GetState(i).WasTested; });
  return this->Lost > this->Kept.size() ||
    2 * static_cast<std::size_t>(tested) < this->HeldBack.size();
}

std::vector<int> vtkNBufferPartition::GetNotDrawn() const
{
  std::vector<int> places;
  std::copy_if(this->HeldBack.begin(), this->HeldBack.end(), std::back_inserter(places),
    [this](int i) { return this->Props.GetState(i).Verdict != vtkNBufferVerdict::Visible; });
  return places;
}

std::vector<int> vtkNBufferPartition::TestAgain()
{
  std::vector<int> notDrawn = this->GetNotDrawn();
  for (const std::vector<int>* places : { &notDrawn, &this->Translucent })
  {
    for (int i : *places)
    {
      this->Props.GetScreen(i); // Computes it if that was deferred: nodes are not tested again.
      this->Props.GetState(i).Clearance = 0.0F;
    }
  }
  return notDrawn;
}

int vtkNBufferPartition::RemoveDrawn(const std::vector<int>& drawn, std::vector<int>& visible)
{
  auto next = visible.begin();
  for (int i : drawn)
  {
    vtkNBufferState& state = this->Props.GetState(i);
    state.WasTested = true;
    state.WasVisible = next != visible.end() && *next == i;
    next += state.WasVisible ? 1 : 0;
  }
  const auto found = static_cast<int>(next - visible.begin());
  visible.erase(visible.begin(), next);
  return static_cast<int>(drawn.size()) - found;
}
VTK_ABI_NAMESPACE_END
