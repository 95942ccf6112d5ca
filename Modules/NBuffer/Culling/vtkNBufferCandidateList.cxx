// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidateList.h"

#include "vtkNBufferDrawPass.h"
#include "vtkNBufferFirstDraws.h"
#include "vtkNBufferForEachProp.h"

#include "vtkActor.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <unordered_set>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// In one frame ObserveSome() visits at most PropsToObserve props. It stops after the prop with
/// which it has observed at least ObjectsToObserve objects. That takes a millisecond.
constexpr std::size_t PropsToObserve = 1024;
constexpr std::size_t ObjectsToObserve = 2048;

/// An actor that has not changed since its uses were read keeps its mapper alive.
vtkMapper* GetMapper(const vtkNBufferSharedState::Uses& uses)
{
  return static_cast<vtkMapper*>(const_cast<void*>(uses.front().Object));
}
}

bool vtkNBufferCandidateList::Synchronize(vtkProp** props, int count)
{
  if (!this->Candidates.Synchronize(props, static_cast<std::size_t>(count), this->States,
        this->Screens, this->MeshesOfProps, this->FacesOfProps))
  {
    return false;
  }
  this->Meshes.ReleaseUnused();
  this->Faces.ReleaseUnused(this->FacesOfProps, 0.0);
  this->Tree.ListHasChanged();
  this->ListChanged = true;
  ++this->ListNumber;
  return true;
}

int vtkNBufferCandidateList::Refresh(int hierarchySize, int observeAfter)
{
  const vtkNBufferPropWatch::GlobalState state = vtkNBufferPropWatch::GetGlobalState();
  const bool all = state != this->GlobalState;
  this->GlobalState = state;
  this->Tree.BeginFrame();
  this->Meshes.BeginFrame(this->MeshesOfProps);
  this->UsesTree = this->GetSize() >= hierarchySize;
  if (!this->UsesTree)
  {
    this->Tree.ListHasChanged();
  }

  this->FindStale(all);
  this->Changed.clear();
  if (this->ListChanged || !this->Stale.empty())
  {
    this->RefreshStale(all);
  }
  this->ReadParts();
  if (this->UsesChanged ||
    std::any_of(
      this->OtherShaders.begin(), this->OtherShaders.end(), &vtkNBufferSharedState::HasNewShaders))
  {
    this->FindSharedState();
  }
  this->SharedChanged = std::any_of(this->Changed.begin(), this->Changed.end(),
    [this](int i) { return this->OtherShaders.count(GetMapper(this->Candidates[i].GetUses())); });
  this->ObserveSome(observeAfter);
  return static_cast<int>(this->Changed.size());
}

void vtkNBufferCandidateList::FindStale(bool globalStateChanged)
{
  const bool lostObject = this->Observed.TakeLoss();
  const bool lost = this->ObservedActors.TakeLoss() || lostObject;
  const bool unchanged = !this->Observed.TakeChange() && !lost;
  const bool actorsUnchanged =
    !this->ObservedActors.TakeChange() && unchanged && !globalStateChanged;
  for (std::size_t i = 0; lost && i < this->Candidates.GetSize(); ++i)
  {
    this->Candidates[i].GetWatch().Forget();
    this->States[i].Observed = false;
  }
  this->Polled.clear();
  for (int i = 0; i < this->GetSize(); ++i)
  {
    if (!(actorsUnchanged && this->States[i].Observed))
    {
      this->Polled.push_back(i);
    }
  }
  // Comparing times is most of the work and may run in parallel. Refreshing may run pipelines.
  this->PolledIsStale.assign(this->Polled.size(), globalStateChanged);
  if (!globalStateChanged)
  {
    vtkNBufferForEachProp::RunAhead(
      this->Polled.size(),
      [this, unchanged](vtkIdType n) { this->Candidates[this->Polled[n]].Prefetch(unchanged); },
      [this, unchanged](vtkIdType n)
      { this->PolledIsStale[n] = this->Candidates[this->Polled[n]].IsStale(unchanged); });
  }
  this->Stale.clear();
  for (std::size_t n = 0; n < this->Polled.size(); ++n)
  {
    if (this->PolledIsStale[n])
    {
      this->Stale.push_back(this->Polled[n]);
    }
  }
}

void vtkNBufferCandidateList::ObserveSome(int frames)
{
  if (frames == 0)
  {
    return;
  }
  const std::size_t size = this->Candidates.GetSize();
  if (++this->FramesOfTurn > frames && this->NextOfTurn >= size)
  {
    this->FramesOfTurn = 0;
    this->NextOfTurn = 0;
  }
  const std::size_t end = std::min(this->NextOfTurn + PropsToObserve, size);
  const std::size_t most = this->Observed.GetSize() + ObjectsToObserve;
  for (; this->NextOfTurn < end && this->Observed.GetSize() < most; ++this->NextOfTurn)
  {
    vtkNBufferState& state = this->States[this->NextOfTurn];
    if (!state.Observed)
    {
      vtkNBufferPropWatch& watch = this->Candidates[this->NextOfTurn].GetWatch();
      watch.Observe(this->Observed, this->ObservedActors);
      state.Observed = watch.IsWhollyObserved();
    }
  }
}

void vtkNBufferCandidateList::RefreshStale(bool globalStateChanged)
{
  this->UsesChanged = this->ListChanged;
  this->ListChanged = false;
  for (const int i : this->Stale)
  {
    vtkNBufferCandidate& candidate = this->Candidates[i];
    const vtkNBufferSharedState::Uses uses = candidate.GetUses();
    const vtkNBufferVerdict verdict = candidate.GetVerdict();
    const vtkNBufferBox box = candidate.GetBox();
    if (candidate.Refresh(globalStateChanged))
    {
      this->Changed.push_back(i);
      this->MeshesOfProps[i] = {};
      this->FacesOfProps[i] = {};
    }
    this->UsesChanged = this->UsesChanged || !(uses == candidate.GetUses());
    this->States[i].Observed = false;
    this->States[i].OwnVerdict = candidate.GetVerdict();
    if (verdict != candidate.GetVerdict() || !(box == candidate.GetBox()))
    {
      this->Tree.HasChanged(i);
    }
  }
  this->Traits = {};
  this->WithParts.clear();
  for (int i = 0; i < this->GetSize(); ++i)
  {
    const vtkNBufferCandidate& candidate = this->Candidates[i];
    if (candidate.HasParts())
    {
      this->WithParts.push_back(i);
    }
    this->Traits.Add(i, candidate);
  }
}

void vtkNBufferCandidateList::ReadParts()
{
  this->Traits.FirstBlendedPart = VTK_INT_MAX;
  std::vector<vtkNBufferSharedState::Uses> uses;
  for (const int i : this->WithParts)
  {
    if (this->Candidates[i].ReadParts(uses))
    {
      this->Traits.FirstBlendedPart = std::min(this->Traits.FirstBlendedPart, i);
    }
  }
  if (uses != this->PartUses)
  {
    this->PartUses = std::move(uses);
    this->UsesChanged = true;
  }
}

void vtkNBufferCandidateList::FindSharedState()
{
  this->UsesChanged = this->SharesState = false;
  const auto forEachUser = [this](const auto& function)
  {
    for (const vtkNBufferCandidate& candidate : this->Candidates.GetItems())
    {
      function(candidate.GetUses());
    }
    std::for_each(this->PartUses.begin(), this->PartUses.end(), function);
  };
  vtkNBufferSharedState state;
  forEachUser([&state](const auto& uses) { state.Add(uses); });
  forEachUser([&state](const auto& uses) { state.AddCommon(uses); });
  bool otherParameters = false;
  this->OtherShaders.clear();
  forEachUser(
    [this, &state, &otherParameters](const vtkNBufferSharedState::Uses& uses)
    {
      for (const std::size_t place :
        { vtkNBufferSharedState::Parameters, vtkNBufferSharedState::Shaders })
      {
        if (GetMapper(uses) &&
          vtkNBufferSharedState::HasOtherShaders(
            GetMapper(uses), place, state.IsMixed(uses, place)))
        {
          this->OtherShaders.insert(GetMapper(uses));
          otherParameters = otherParameters || place == vtkNBufferSharedState::Parameters;
        }
      }
      this->SharesState = this->SharesState || state.HasMixedData(uses);
    });
  std::unordered_set<const vtkMapper*> mappersOfParts;
  std::transform(this->PartUses.begin(), this->PartUses.end(),
    std::inserter(mappersOfParts, mappersOfParts.end()), GetMapper);
  for (std::size_t i = 0; i < this->Candidates.GetSize(); ++i)
  {
    vtkNBufferCandidate& candidate = this->Candidates[i];
    vtkMapper* mapper = GetMapper(candidate.GetUses());
    const bool isMixed = state.IsMixed(candidate.GetUses());
    candidate.SetSharesState(isMixed || otherParameters || this->OtherShaders.count(mapper) > 0);
    if (mapper && (isMixed || mappersOfParts.count(mapper) > 0))
    {
      vtkNBufferDrawPass::KeepWhole(mapper);
    }
    this->Traits.Translucent |= candidate.IsTranslucent();
    if (std::exchange(this->States[i].OwnVerdict, candidate.GetVerdict()) != candidate.GetVerdict())
    {
      this->Tree.HasChanged(static_cast<int>(i));
    }
  }
  vtkNBufferFirstDraws::Find(this->Candidates.GetItems(), mappersOfParts, this->States);
  this->SharesState = this->SharesState || otherParameters ||
    std::any_of(this->OtherShaders.begin(), this->OtherShaders.end(),
      [&mappersOfParts](const vtkMapper* mapper) { return mappersOfParts.count(mapper); });
}

void vtkNBufferCandidateList::ProjectOne(int i)
{
  const vtkNBufferCandidate& candidate = this->Candidates[i];
  if (candidate.HasPlacement())
  {
    this->States[i].Placement = this->Projection.Place(candidate.GetBox(), this->Screens[i]);
  }
}

void vtkNBufferCandidateList::Project()
{
  for (vtkNBufferState& state : this->States)
  {
    state.Verdict = state.OwnVerdict;
    state.Placement = vtkNBufferPlacement::Outside;
    state.RectangleIsStale = false;
    state.Clearance = 0.0F;
  }
  if (!this->UsesTree || !this->Tree.Update(this->Candidates.GetItems()))
  {
    vtkNBufferForEachProp::RunEach(
      this->Candidates.GetSize(), [this](vtkIdType i) { this->ProjectOne(static_cast<int>(i)); });
    return;
  }
  this->Reached.clear();
  this->Tree.FindPlacements(this->Candidates.GetItems(), this->States, this->Reached);
  vtkNBufferForEachProp::RunEach(
    this->Reached.size(), [this](vtkIdType n) { this->ProjectOne(this->Reached[n]); });
}

void vtkNBufferCandidateList::ProjectDeferred(int i)
{
  vtkNBufferState& state = this->States[i];
  state.RectangleIsStale = false;
  state.Placement = this->Projection.Project(this->GetBox(i), this->Screens[i]);
}

void vtkNBufferCandidateList::KeepIfNoneIsInside()
{
  vtkNBufferState* hidden = nullptr;
  for (std::size_t i = 0; i < this->States.size(); ++i)
  {
    const vtkNBufferVerdict verdict = this->States[i].Verdict;
    if (verdict == vtkNBufferVerdict::Hidden)
    {
      hidden = &this->States[i];
    }
    else if (this->Candidates[i].HasPlacement() && verdict != vtkNBufferVerdict::Outside)
    {
      return;
    }
  }
  if (hidden)
  {
    hidden->Verdict = vtkNBufferVerdict::Untested;
    return;
  }
  for (vtkNBufferState& state : this->States)
  {
    if (state.Verdict == vtkNBufferVerdict::Outside)
    {
      state.Verdict = vtkNBufferVerdict::Untested;
    }
  }
}

void vtkNBufferCandidateList::CountVerdicts(vtkNBufferStatistics& statistics) const
{
  const vtkNBufferCandidateTree::Work& work = this->Tree.GetWork();
  statistics.Nodes = work.Nodes;
  statistics.Refits = work.Refits;
  statistics.Builds = work.Builds;
  statistics.Verdicts.fill(0);
  for (const vtkNBufferState& state : this->States)
  {
    ++statistics.Verdicts[static_cast<int>(state.Verdict)];
  }
  std::array<int, vtkNBufferStatistics::MaximumNumberOfRounds + 1>& drawn = statistics.DrawnInRound;
  drawn[0] = statistics.GetCount(vtkNBufferVerdict::Visible) +
    statistics.GetCount(vtkNBufferVerdict::NearPlane) +
    statistics.GetCount(vtkNBufferVerdict::Untested) -
    std::accumulate(drawn.begin() + 1, drawn.end(), 0);
}

vtkNBufferDrawnProp vtkNBufferCandidateList::GetDrawn(int i, int round)
{
  const vtkNBufferScreenBox& screen = this->GetScreen(i);
  vtkNBufferDrawnProp drawn;
  drawn.Index = i;
  drawn.Round = round;
  drawn.KeepsScissor = this->Candidates[i].IsCandidate();
  drawn.Bounded = drawn.KeepsScissor && this->States[i].Placement == vtkNBufferPlacement::Inside;
  drawn.Box = this->GetBox(i);
  drawn.Screen = screen;
  return drawn;
}

void vtkNBufferCandidateList::ReadTriangles(int i, int limit)
{
  vtkNBufferMeshes::OfProp& kept = this->MeshesOfProps[i];
  const std::vector<vtkNBufferMeshes::Placed>& meshes =
    this->Meshes.Get(this->GetProp(i), limit, kept);
  if (this->FacesOfProps[i].Limit != limit)
  {
    this->Faces.Set(this->FacesOfProps[i], meshes, this->GetBox(i));
    this->FacesOfProps[i].Limit = kept.Limit;
  }
}

void vtkNBufferCandidateList::CopyTriangles(const std::vector<int>& places)
{
  const auto hasToCopy = [this](int i)
  {
    const vtkNBufferMeshes::OfProp& meshes = this->MeshesOfProps[i];
    return this->States[i].WasVisible && !meshes.Small && !meshes.IsTooLarge;
  };
  const auto copy = [&](int i)
  {
    if (hasToCopy(i))
    {
      this->Meshes.FindSmall(this->GetProp(i), this->MeshesOfProps[i]);
    }
  };
  if (std::any_of(places.begin(), places.end(), hasToCopy))
  {
    vtkNBufferForEachProp::RunInOneThread(
      [&]() { std::for_each(places.begin(), places.end(), copy); });
  }
}

std::optional<bool> vtkNBufferCandidateList::MayBeSeen(
  int i, vtkNBufferPixelTest& test, std::size_t count)
{
  vtkNBufferMeshes::OfProp& meshes = this->MeshesOfProps[i];
  // Wide lines and points stick out of the triangles.
  if (!meshes.Small || this->States[i].Placement != vtkNBufferPlacement::Inside ||
    this->GetBox(i).Margin > 0.0)
  {
    return {};
  }
  auto* actor = static_cast<vtkActor*>(this->GetProp(i));
  this->Meshes.FindSmall(actor, meshes);
  return test.MayBeSeen(
    *meshes.Small, actor->GetMatrix()->GetData(), this->GetScreen(i), meshes.First, count);
}
VTK_ABI_NAMESPACE_END
