// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidateList.h"

#include "vtkNBufferForEachProp.h"

#include "vtkActor.h"

#include <algorithm>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// ObserveSome() visits at most this many props, and observes at most this many objects and those
/// of one prop more. That takes a millisecond.
constexpr std::size_t PropsToObserve = 1024;
constexpr std::size_t ObjectsToObserve = 2048;
}

bool vtkNBufferCandidateList::Synchronize(vtkProp** props, int count)
{
  if (!this->Candidates.Synchronize(props, static_cast<std::size_t>(count), this->States))
  {
    return false;
  }
  this->Screens.resize(static_cast<std::size_t>(count));
  this->Tree.ListHasChanged();
  this->ListChanged = true;
  return true;
}

int vtkNBufferCandidateList::Refresh(const vtkNBufferProjection* projection)
{
  const vtkNBufferPropWatch::GlobalState state = vtkNBufferPropWatch::GetGlobalState();
  const bool all = state != this->GlobalState;
  this->GlobalState = state;
  this->Tree.BeginFrame();
  this->Meshes.BeginFrame();
  const bool overTree = this->UsesTree();
  if (!overTree)
  {
    this->Tree.ListHasChanged();
  }

  const bool lostObject = this->Observed.TakeLoss();
  const bool lost = this->ObservedActors.TakeLoss() || lostObject;
  const bool unchanged = !this->Observed.TakeChange() && !lost;
  const bool actorsUnchanged = !this->ObservedActors.TakeChange() && unchanged && !all;
  for (std::size_t i = 0; lost && i < this->Candidates.GetSize(); ++i)
  {
    this->Candidates[i].GetWatch().Forget();
    this->States[i].Observed = false;
  }
  // Comparing times is most of the work and may run in parallel. Refreshing may run pipelines.
  this->Stale.assign(this->Candidates.GetSize(), 0);
  vtkNBufferForEachProp::RunAhead(
    this->Candidates.GetSize(),
    [this, unchanged, actorsUnchanged](vtkIdType i)
    {
      if (actorsUnchanged && this->States[i].Observed)
      {
        vtkNBufferForEachProp::Fetch(&this->Candidates[i]);
        return;
      }
      this->Candidates[i].Prefetch(unchanged);
    },
    [this, all, unchanged, actorsUnchanged, projection](vtkIdType i)
    {
      this->Stale[i] = !(actorsUnchanged && this->States[i].Observed) &&
        (all || this->Candidates[i].IsStale(unchanged));
      if (!this->Stale[i])
      {
        this->FindPlacement(i, projection);
      }
    });
  int changed = 0;
  if (this->ListChanged ||
    std::find(this->Stale.begin(), this->Stale.end(), 1) != this->Stale.end())
  {
    changed = this->RefreshStale(projection, all);
  }
  this->ReadParts();
  if (this->UsesChanged)
  {
    this->FindSharedState(projection);
  }
  this->ObserveSome();
  if (projection && overTree)
  {
    this->ProjectOverTree(*projection);
  }
  return changed;
}

void vtkNBufferCandidateList::ObserveSome()
{
  if (this->ObserveAfter == 0)
  {
    return;
  }
  const std::size_t size = this->Candidates.GetSize();
  if (++this->FramesOfTurn > this->ObserveAfter && this->NextOfTurn >= size)
  {
    this->FramesOfTurn = 0;
    this->NextOfTurn = 0;
  }
  const std::size_t end = std::min(this->NextOfTurn + PropsToObserve, size);
  const std::size_t most = this->Observed.GetSize() + ObjectsToObserve;
  for (; this->NextOfTurn < end && this->Observed.GetSize() < most; ++this->NextOfTurn)
  {
    vtkNBufferPropWatch& watch = this->Candidates[this->NextOfTurn].GetWatch();
    watch.Observe(this->Observed, this->ObservedActors);
    this->States[this->NextOfTurn].Observed = watch.IsWhollyObserved();
  }
}

void vtkNBufferCandidateList::FindPlacement(vtkIdType i, const vtkNBufferProjection* projection)
{
  if (projection)
  {
    this->UsesTree() ? this->ResetPlacement(i) : this->ProjectOne(i, *projection);
  }
}

int vtkNBufferCandidateList::RefreshStale(
  const vtkNBufferProjection* projection, bool globalStateChanged)
{
  this->UsesChanged = this->ListChanged;
  this->ListChanged = false;
  int changed = 0;
  for (std::size_t i = 0; i < this->Candidates.GetSize(); ++i)
  {
    if (!this->Stale[i])
    {
      continue;
    }
    const vtkNBufferSharedState::Uses uses = this->Candidates[i].GetUses();
    changed += this->RefreshOne(i, globalStateChanged) ? 1 : 0;
    this->UsesChanged = this->UsesChanged || !(uses == this->Candidates[i].GetUses());
    this->FindPlacement(static_cast<vtkIdType>(i), projection);
  }
  this->UntrackedDepth = this->Blending = this->Lines = this->LackOfNormals = false;
  this->WithParts.clear();
  for (std::size_t i = 0; i < this->Candidates.GetSize(); ++i)
  {
    const vtkNBufferCandidate& candidate = this->Candidates[i];
    if (candidate.HasParts())
    {
      this->WithParts.push_back(static_cast<int>(i));
    }
    this->UntrackedDepth =
      this->UntrackedDepth || (candidate.WritesDepth() && !candidate.IsTracked());
    this->Blending = this->Blending || candidate.IsBlended();
    this->Lines = this->Lines || candidate.MayDrawLines();
    this->LackOfNormals = this->LackOfNormals || candidate.MayLackNormals();
  }
  return changed;
}

bool vtkNBufferCandidateList::HasBlending(bool smoothLines, bool ambientOcclusion) const
{
  return this->Blending || this->BlendedParts || this->SharesState ||
    (smoothLines && this->Lines) || (ambientOcclusion && this->LackOfNormals);
}

void vtkNBufferCandidateList::ReadParts()
{
  this->BlendedParts = false;
  std::vector<vtkNBufferSharedState::Uses> uses;
  for (const int i : this->WithParts)
  {
    this->BlendedParts = this->Candidates[i].ReadParts(uses) || this->BlendedParts;
  }
  if (uses != this->PartUses)
  {
    this->PartUses = std::move(uses);
    this->UsesChanged = true;
  }
}

void vtkNBufferCandidateList::FindSharedState(const vtkNBufferProjection* projection)
{
  this->UsesChanged = this->SharesState = false;
  vtkNBufferSharedState state;
  for (const auto add : { &vtkNBufferSharedState::Add, &vtkNBufferSharedState::AddCommon })
  {
    for (const vtkNBufferCandidate& candidate : this->Candidates.GetItems())
    {
      (state.*add)(candidate.GetUses());
    }
    for (const vtkNBufferSharedState::Uses& uses : this->PartUses)
    {
      (state.*add)(uses);
    }
  }
  for (std::size_t i = 0; i < this->Candidates.GetSize(); ++i)
  {
    vtkNBufferCandidate& candidate = this->Candidates[i];
    const vtkNBufferVerdict before = candidate.GetVerdict();
    candidate.SetSharesState(state.IsMixed(candidate.GetUses()));
    if (candidate.GetVerdict() != before)
    {
      this->Tree.HasChanged(static_cast<int>(i));
      this->FindPlacement(static_cast<vtkIdType>(i), projection);
    }
  }
  this->SharesState = state.HasMixed();
}

bool vtkNBufferCandidateList::RefreshOne(std::size_t i, bool globalStateChanged)
{
  vtkNBufferCandidate& candidate = this->Candidates[i];
  const vtkNBufferVerdict verdict = candidate.GetVerdict();
  const vtkNBufferBox box = candidate.GetBox();
  const bool changed = candidate.Refresh(globalStateChanged);
  this->States[i].Observed = false;
  this->Meshes.Forget(this->GetProp(static_cast<int>(i)));
  if (verdict != candidate.GetVerdict() || !(box == candidate.GetBox()))
  {
    this->Tree.HasChanged(static_cast<int>(i));
  }
  return changed;
}

void vtkNBufferCandidateList::ResetPlacement(vtkIdType i)
{
  const vtkNBufferCandidate& candidate = this->Candidates[i];
  vtkNBufferState& state = this->States[i];
  state.Verdict = candidate.GetVerdict();
  state.RectangleIsStale = state.Behind = false;
  if (candidate.HasPlacement())
  {
    state.Placement = vtkNBufferPlacement::Outside;
  }
}

void vtkNBufferCandidateList::ProjectOne(vtkIdType i, const vtkNBufferProjection& projection)
{
  this->ResetPlacement(i);
  const vtkNBufferCandidate& candidate = this->Candidates[i];
  if (candidate.HasPlacement() && !projection.IsOutside(candidate.GetBox()))
  {
    this->States[i].Placement = projection.Project(candidate.GetBox(), this->Screens[i]);
  }
}

void vtkNBufferCandidateList::Project(const vtkNBufferProjection& projection)
{
  if (!this->UsesTree())
  {
    this->ProjectAll(projection);
    return;
  }
  vtkNBufferForEachProp::RunEach(
    this->Candidates.GetSize(), [this](vtkIdType i) { this->ResetPlacement(i); });
  this->ProjectOverTree(projection);
}

void vtkNBufferCandidateList::ProjectOverTree(const vtkNBufferProjection& projection)
{
  if (!this->Tree.Update(this->Candidates.GetItems()))
  {
    this->ProjectAll(projection);
    return;
  }
  this->Reached.clear();
  this->Tree.FindPlacements(projection, this->Candidates.GetItems(), this->States, this->Reached);
  vtkNBufferForEachProp::RunEach(this->Reached.size(),
    [this, &projection](vtkIdType i) { this->ProjectOne(this->Reached[i], projection); });
}

void vtkNBufferCandidateList::ProjectDeferred(int i)
{
  vtkNBufferState& state = this->States[i];
  state.RectangleIsStale = false;
  state.Placement = this->Tree.GetProjection().Project(this->GetBox(i), this->Screens[i]);
}

void vtkNBufferCandidateList::ProjectAll(const vtkNBufferProjection& projection)
{
  vtkNBufferForEachProp::RunEach(this->Candidates.GetSize(),
    [this, &projection](vtkIdType i) { this->ProjectOne(i, projection); });
}

void vtkNBufferCandidateList::KeepIfNoneIsInside()
{
  for (std::size_t i = 0; i < this->States.size(); ++i)
  {
    if (this->Candidates[i].HasPlacement() &&
      this->States[i].Placement != vtkNBufferPlacement::Outside)
    {
      return;
    }
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
  drawn.Bounded =
    this->Candidates[i].IsCandidate() && this->States[i].Placement == vtkNBufferPlacement::Inside;
  drawn.Box = this->GetBox(i);
  drawn.Screen = screen;
  return drawn;
}

std::vector<vtkNBufferMeshes::Placed> vtkNBufferCandidateList::GetMeshes(int i)
{
  return this->Meshes.Get(vtkActor::SafeDownCast(this->GetProp(i)));
}

bool vtkNBufferCandidateList::MayBeSeen(int i, vtkNBufferPixelTest& test)
{
  // Wide lines and points stick out of the triangles.
  const vtkNBufferState& state = this->States[i];
  if (state.Placement != vtkNBufferPlacement::Inside || this->GetBox(i).Margin > 0.0)
  {
    return true;
  }
  vtkActor* actor = vtkActor::SafeDownCast(this->GetProp(i));
  vtkNBufferMeshes::Small* small =
    actor ? this->Meshes.FindSmall(actor, state.WasVisible) : nullptr;
  return !small ||
    test.MayBeSeen(*small->Mesh, actor->GetMatrix()->GetData(), this->GetScreen(i), small->First);
}
VTK_ABI_NAMESPACE_END
