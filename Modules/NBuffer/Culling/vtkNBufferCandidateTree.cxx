// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidateTree.h"

#include "vtkNBufferCandidate.h"

#include <algorithm>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferCandidateTree::ListHasChanged()
{
  this->ListChanged = true;
  this->Built = false;
  this->Tree.Clear();
  this->Changed.clear();
  this->Loose.clear();
  this->Roots.clear();
}

void vtkNBufferCandidateTree::HasChanged(int place)
{
  // Without a tree there is nothing that could be out of date.
  if (this->Built && !this->IsChanged[place])
  {
    this->IsChanged[place] = 1;
    this->Changed.push_back(place);
  }
}

bool vtkNBufferCandidateTree::Update(const std::vector<vtkNBufferCandidate>& candidates)
{
  this->Roots.clear();
  ++this->FramesSinceBuild;
  const std::size_t few = std::max<std::size_t>(FewChanges, candidates.size() / ChangesPerFrame);
  if (!this->Built)
  {
    const bool wait = this->ListChanged && this->EverBuilt;
    this->ListChanged = false;
    if (wait)
    {
      return false;
    }
    this->Build(candidates);
    return true;
  }
  const bool many = this->Changed.size() > few;
  for (int place : this->Changed)
  {
    this->IsChanged[place] = 0;
    const vtkNBufferCandidate& candidate = candidates[place];
    if (!candidate.HasPlacement())
    {
      continue;
    }
    if (this->Tree.Has(place))
    {
      this->Tree.Move(place, candidate.GetBox());
      ++this->Done.Refits;
    }
    else if (!std::binary_search(this->Loose.begin(), this->Loose.end(), place))
    {
      this->Loose.insert(std::lower_bound(this->Loose.begin(), this->Loose.end(), place), place);
    }
  }
  this->Changed.clear();
  if (many)
  {
    // The nodes stay marked as changed and are fitted in a frame with fewer changes.
    return false;
  }
  this->Tree.Refit();
  if (this->FramesSinceBuild >= FramesBetweenBuilds &&
    (this->Tree.GetGrowth() > WorstGrowth || this->Loose.size() > few))
  {
    this->Build(candidates);
  }
  return true;
}

void vtkNBufferCandidateTree::Build(const std::vector<vtkNBufferCandidate>& candidates)
{
  std::vector<vtkNBufferBox> boxes(candidates.size());
  std::vector<int> places;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (candidates[i].HasPlacement())
    {
      boxes[i] = candidates[i].GetBox();
      places.push_back(static_cast<int>(i));
    }
  }
  this->Tree.Build(boxes, std::move(places));
  this->Loose.clear();
  this->Changed.clear();
  this->IsChanged.assign(candidates.size(), 0);
  this->Built = this->EverBuilt = true;
  this->FramesSinceBuild = 0;
  ++this->Done.Builds;
}

void vtkNBufferCandidateTree::FindPlacements(const std::vector<vtkNBufferCandidate>& candidates,
  std::vector<vtkNBufferState>& states, std::vector<int>& places)
{
  this->Roots.clear();
  const auto visit = [&](const vtkNBufferHierarchy::Node& node)
  {
    ++this->Done.Nodes;
    vtkNBufferScreenBox screen;
    const vtkNBufferPlacement placement = this->Projection.Place(node.Box, screen);
    if (placement == vtkNBufferPlacement::Outside)
    {
      return false;
    }
    const bool within =
      placement == vtkNBufferPlacement::Inside && this->Projection.IsWhollyInside(screen);
    if (!within && node.Left >= 0)
    {
      return true;
    }
    bool deferred = false;
    for (int slot = node.Begin; slot < node.End; ++slot)
    {
      const int place = this->Tree.GetOrder()[slot];
      vtkNBufferState& state = states[place];
      // In each frame a state begins with the verdict of its prop, which for a candidate is
      // Visible. Only candidates may be held back.
      if (within && state.Verdict == vtkNBufferVerdict::Visible && !state.WasVisible)
      {
        state.Placement = vtkNBufferPlacement::Inside;
        state.RectangleIsStale = deferred = true;
      }
      else
      {
        places.push_back(place);
      }
    }
    if (deferred)
    {
      this->Roots.push_back(this->Tree.GetIndex(node));
    }
    return false;
  };
  this->Tree.Visit(0, visit);
  std::copy_if(this->Loose.begin(), this->Loose.end(), std::back_inserter(places),
    [&](int place) { return candidates[place].HasPlacement(); });
}

int vtkNBufferCandidateTree::GetLevelsNeeded(int factor) const
{
  int levels = 1;
  for (int root : this->Roots)
  {
    vtkNBufferScreenBox screen;
    if (this->Projection.Project(this->Tree.GetNodes()[root].Box, screen) ==
      vtkNBufferPlacement::Inside)
    {
      levels = std::max(levels, vtkNBufferOcclusionTest::GetLevelsNeeded(screen.Pixels, factor));
    }
  }
  return levels;
}

bool vtkNBufferCandidateTree::HasDeferred(
  const vtkNBufferHierarchy::Node& node, const std::vector<vtkNBufferState>& states) const
{
  const auto order = this->Tree.GetOrder().begin();
  return std::any_of(order + node.Begin, order + node.End,
    [&states](int place) { return states[place].RectangleIsStale; });
}

void vtkNBufferCandidateTree::MarkHidden(
  vtkNBufferOcclusionTest& test, std::vector<vtkNBufferState>& states)
{
  const auto visit = [&](const vtkNBufferHierarchy::Node& node)
  {
    if (node.Left < 0 && !this->HasDeferred(node, states))
    {
      return false;
    }
    ++this->Done.Nodes;
    vtkNBufferScreenBox screen;
    const bool isInside = this->Projection.Project(node.Box, screen) == vtkNBufferPlacement::Inside;
    const auto clearance = static_cast<float>(isInside ? test.GetClearance(screen) : 0.0);
    if (!(clearance > 0.0F))
    {
      return true;
    }
    for (int slot = node.Begin; slot < node.End; ++slot)
    {
      vtkNBufferState& state = states[this->Tree.GetOrder()[slot]];
      state.Clearance = state.RectangleIsStale ? clearance : 0.0F;
    }
    return false;
  };
  for (int root : this->Roots)
  {
    if (this->HasDeferred(this->Tree.GetNodes()[root], states))
    {
      this->Tree.Visit(root, visit);
    }
  }
  this->Roots.clear();
}
VTK_ABI_NAMESPACE_END
