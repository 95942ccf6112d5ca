// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDivision.h"

#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDepthTest.h"
#include "vtkNBufferLargeProps.h"
#include "vtkNBufferPartition.h"
#include "vtkNBufferViewSetup.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferDivision::Entry* vtkNBufferDivision::Find(int place)
{
  const auto found = std::lower_bound(this->Entries.begin(), this->Entries.end(), place,
    [](const Entry& entry, int wanted) { return entry.Place < wanted; });
  return found != this->Entries.end() && found->Place == place ? &*found : nullptr;
}

vtkNBufferDividedProp* vtkNBufferDivision::FindActive(int place)
{
  const Entry* entry = this->Find(place);
  return entry && entry->IsActive ? entry->Prop.get() : nullptr;
}

vtkNBufferVerdict vtkNBufferDivision::GetVerdict(int place, std::optional<int> part)
{
  const vtkNBufferVerdict whole = this->Props.GetState(place).Verdict;
  vtkNBufferDividedProp* prop = this->FindActive(place);
  const bool isInParts = part && prop && prop->IsReady() && whole != vtkNBufferVerdict::Outside &&
    whole != vtkNBufferVerdict::Hidden;
  return isInParts ? prop->GetVerdict(*part) : whole;
}

void vtkNBufferDivision::FindLarge(const std::vector<int>& places)
{
  for (const int i : places)
  {
    vtkProp* prop = this->Props.GetProp(i);
    const vtkNBufferCandidate& candidate = this->Props.GetCandidate(i);
    const bool isPlain = candidate.GetVerdict() != vtkNBufferVerdict::NotAPlainActor;
    auto* actor = isPlain ? static_cast<vtkActor*>(prop) : vtkActor::SafeDownCast(prop);
    if (!actor || this->Find(i) ||
      (isPlain && !vtkNBufferLargeProps::IsLarge(actor, this->Minimum)))
    {
      continue;
    }
    if (vtkNBufferLargeProps::MayBeDivided(candidate) || this->Pass->IsUsedBy(actor->GetMapper()))
    {
      Entry entry;
      entry.Place = i;
      entry.Prop = std::make_unique<vtkNBufferDividedProp>(actor, this->Pass);
      this->Entries.insert(std::lower_bound(this->Entries.begin(), this->Entries.end(), i,
                             [](const Entry& other, int place) { return other.Place < place; }),
        std::move(entry));
      this->Trial.Restart();
    }
  }
}

void vtkNBufferDivision::Update(vtkRenderer* renderer, const vtkNBufferSettings& settings)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Postponed = -1;
  const int minimum = settings.DivideProps ? settings.MinimumNumberOfPrimitives : VTK_INT_MAX;
  vtkSmartPointer<vtkNBufferDrawPass> pass = vtkNBufferDrawPass::Get(window);
  const bool hasOtherPass = std::exchange(this->Pass, pass) != pass;
  const bool isNew = std::exchange(this->Minimum, minimum) != minimum || hasOtherPass;
  if (isNew)
  {
    this->Entries.clear();
  }
  if (!settings.DivideProps)
  {
    return;
  }
  const bool isOtherList =
    std::exchange(this->ListNumber, this->Props.GetListNumber()) != this->Props.GetListNumber();
  for (Entry& entry : this->Entries)
  {
    // A new actor may have the address of a deleted one, and so its place in the same list. An
    // actor that shows another mapper is found again if it is still large.
    vtkActor* actor = entry.Prop->GetActor();
    const int place = isOtherList && actor ? this->Props.Find(actor) : entry.Place;
    entry.Place = actor && !this->Pass->HasOtherMapper(actor) ? place : -1;
  }
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const Entry& entry) { return entry.Place < 0; }),
    this->Entries.end());
  std::sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b) { return a.Place < b.Place; });
  std::vector<int> changed = this->Props.GetChanged();
  if (isNew)
  {
    changed.resize(static_cast<std::size_t>(this->Props.GetSize()));
    std::iota(changed.begin(), changed.end(), 0);
  }
  this->FindLarge(changed);
  const bool hasDevice = !this->Entries.empty() && this->Device.Begin(window, settings.Backend);
  for (Entry& entry : this->Entries)
  {
    if (!vtkNBufferLargeProps::MayBeDivided(this->Props.GetCandidate(entry.Place)))
    {
      entry.IsActive = entry.IsPending = false;
      entry.Prop->Release();
      continue;
    }
    const bool hasChanged = std::binary_search(changed.begin(), changed.end(), entry.Place);
    entry.Prop->BeginFrame(hasChanged, window, hasDevice ? &this->Device : nullptr, settings);
    entry.IsActive = entry.IsActive && !hasChanged && entry.Prop->IsReady();
  }
}

void vtkNBufferDivision::SetView(const vtkNBufferViewSetup& view)
{
  for (Entry& entry : this->Entries)
  {
    // GetBounds() does not compute the matrix of splats without cells.
    vtkActor* actor = entry.Prop->GetActor();
    actor->ComputeMatrix();
    view.Apply(entry.Projection, vtkNBufferGLM::ToMatrix(actor->GetMatrix()->GetData()));
  }
}

bool vtkNBufferDivision::Classify(vtkRenderer* renderer, const vtkNBufferSettings& settings,
  int firstBlended, vtkNBufferFrustumCounts& counts)
{
  for (Entry& entry : this->Entries)
  {
    if (!settings.BackOff)
    {
      entry.BackOff = {};
    }
    const vtkNBufferState& state = this->Props.GetState(entry.Place);
    entry.IsHeldBack = state.Verdict == vtkNBufferVerdict::Untested && !state.WasVisible;
    // A prop of instances or splats is no candidate, but its units are tested.
    const bool isKept = entry.Place < firstBlended &&
      (state.Verdict == vtkNBufferVerdict::NearPlane ||
        state.Verdict == vtkNBufferVerdict::NotAPlainMapper ||
        (state.Verdict == vtkNBufferVerdict::Untested && state.WasVisible));
    const bool isTranslucent = state.Verdict == vtkNBufferVerdict::Translucent &&
      (state.Placement != vtkNBufferPlacement::Outside ||
        !this->Props.GetCandidate(entry.Place).HasPlacement());
    const bool isTested = (entry.IsHeldBack || isKept || isTranslucent) && entry.Prop->IsReady() &&
      !entry.BackOff.CountPausedFrame();
    entry.IsActive = isTested && !isTranslucent;
    entry.IsPending = isTested && isTranslucent;
  }
  vtkNBufferStatistics last;
  this->Count(last);
  const bool isAnyTested = std::any_of(this->Entries.begin(), this->Entries.end(),
    [](const Entry& entry) { return entry.IsActive || entry.IsPending; });
  if (isAnyTested && !this->Trial.DrawsUnits(renderer, settings, last))
  {
    this->Reset();
    return false;
  }
  for (Entry& entry : this->Entries)
  {
    if (entry.IsActive || entry.IsPending)
    {
      entry.Prop->FindKept(entry.Projection);
      const vtkNBufferUnitCulling::Counts& units = entry.Prop->GetCulling().GetCounts();
      const int inside = units.Units - units.Outside;
      const int kept = entry.IsActive && !entry.IsHeldBack ? units.Kept : 0;
      counts.Inside += inside;
      counts.Kept += kept;
      (entry.IsPending ? counts.Translucent : counts.HeldBack) += inside - kept;
    }
  }
  return true;
}

int vtkNBufferDivision::CountTranslucentByUnits() const
{
  return static_cast<int>(std::count_if(this->Entries.begin(), this->Entries.end(),
    [this](const Entry& entry)
    {
      return entry.IsPending &&
        this->Props.GetState(entry.Place).Placement != vtkNBufferPlacement::Inside;
    }));
}

bool vtkNBufferDivision::HoldsUnits() const
{
  return std::any_of(this->Entries.begin(), this->Entries.end(),
    [](const Entry& entry)
    {
      const vtkNBufferUnitCulling::Counts& units = entry.Prop->GetCulling().GetCounts();
      return entry.IsActive && !entry.IsHeldBack && units.Units > units.Outside + units.Kept;
    });
}

bool vtkNBufferDivision::HasKeptInVain() const
{
  return std::any_of(this->Entries.begin(), this->Entries.end(),
    [](const Entry& entry)
    { return entry.IsActive && entry.Prop->GetCulling().CountKeptInVain() > 0; });
}

int vtkNBufferDivision::CountHidden(const vtkNBufferDividedProp::Depth& depth) const
{
  return std::accumulate(this->Entries.begin(), this->Entries.end(), 0,
    [&depth](int count, const Entry& entry)
    {
      return entry.IsActive ? count + entry.Prop->GetCulling().CountHidden(entry.Projection, depth)
                            : count;
    });
}

void vtkNBufferDivision::MarkOutside(vtkNBufferPartition& partition)
{
  for (Entry& entry : this->Entries)
  {
    const vtkNBufferUnitCulling::Counts& units = entry.Prop->GetCulling().GetCounts();
    if (entry.IsActive && units.Units == units.Outside &&
      this->Props.GetCandidate(entry.Place).IsCandidate())
    {
      entry.IsActive = false;
      if (!entry.Prop->HasChangedBlocks())
      {
        partition.SetOutside(entry.Place);
      }
    }
  }
}

void vtkNBufferDivision::Reset()
{
  for (Entry& entry : this->Entries)
  {
    entry.IsActive = entry.IsPending = false;
  }
}

bool vtkNBufferDivision::Draws(int place)
{
  const Entry* entry = this->Find(place);
  return entry && (entry->IsPending || entry->IsDrawnHere());
}

bool vtkNBufferDivision::Test(
  const vtkNBufferDividedProp::Depth& depth, std::vector<int>& heldBack, int limit)
{
  bool isAll = true;
  for (Entry& entry : this->Entries)
  {
    const auto left = std::find(heldBack.begin(), heldBack.end(), entry.Place);
    const bool isLeft = left != heldBack.end();
    if (!entry.IsActive || entry.Prop->IsSettled() || (!entry.Prop->IsBegun() && !isLeft))
    {
      continue;
    }
    const int fresh = entry.Prop->Test(entry.Projection, depth, limit);
    if (entry.Prop->HasPostponed())
    {
      isAll = false;
      continue;
    }
    const vtkNBufferUnitCulling::Counts& units = entry.Prop->GetCulling().GetCounts();
    // A unit outside saves work as well: without division it is sent to the device.
    entry.BackOff.Learn(units.Units - units.Kept - units.Fresh, units.Units);
    if (fresh == 0 && isLeft)
    {
      entry.IsActive = !entry.Prop->HasChangedBlocks();
      if (entry.IsActive)
      {
        heldBack.erase(left);
      }
    }
  }
  return isAll;
}

void vtkNBufferDivision::TestTranslucent(const vtkNBufferDividedProp::Depth& depth,
  const std::function<bool(int)>& hasDrawn, const std::function<void(int)>& hide)
{
  for (Entry& entry : this->Entries)
  {
    if (!entry.IsPending || hasDrawn(entry.Place) ||
      this->Props.GetState(entry.Place).Verdict != vtkNBufferVerdict::Translucent)
    {
      continue;
    }
    entry.Prop->TestAll(entry.Projection, depth);
    const vtkNBufferUnitCulling::Counts& units = entry.Prop->GetCulling().GetCounts();
    entry.BackOff.Learn(units.Units - units.Fresh, units.Units);
    entry.IsActive = true; // Its units count, so that the tests of a hidden prop are worth it.
    if (units.Fresh == 0)
    {
      hide(entry.Place);
    }
  }
}

void vtkNBufferDivision::TestAgain()
{
  for (Entry& entry : this->Entries)
  {
    entry.Prop->TestAgain();
  }
}

std::vector<int> vtkNBufferDivision::GetFresh() const
{
  std::vector<int> places;
  for (const Entry& entry : this->Entries)
  {
    if (entry.IsActive && entry.Prop->IsBegun() && entry.Prop->HasFresh())
    {
      places.push_back(entry.Place);
    }
  }
  return places;
}

void vtkNBufferDivision::AddMissing(std::vector<int>& places)
{
  for (Entry& entry : this->Entries)
  {
    if (entry.IsActive && !this->Props.GetCandidate(entry.Place).IsTranslucent() &&
      entry.Prop->IsDrawnInPart())
    {
      places.push_back(entry.Place);
    }
    entry.IsActive = false;
  }
  if (this->Postponed >= 0)
  {
    places.push_back(this->Postponed);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

int vtkNBufferDivision::Draw(int place, const std::function<int()>& drawWhole)
{
  Entry* entry = this->Find(place);
  return entry && entry->IsDrawnHere() ? entry->Prop->Draw(drawWhole) : drawWhole();
}

int vtkNBufferDivision::GetLevelsNeeded(int factor) const
{
  const vtkNBufferProjection& view = this->Props.GetProjection();
  const bool hasUnits = std::any_of(this->Entries.begin(), this->Entries.end(),
    [](const Entry& entry) { return entry.IsActive || entry.IsPending; });
  return hasUnits ? vtkNBufferOcclusionTest::GetLevelsNeeded(
                      { 0, 0, view.GetWidth() / 2, view.GetHeight() / 2 }, factor)
                  : 1;
}

void vtkNBufferDivision::Count(vtkNBufferStatistics& statistics) const
{
  statistics.Units = statistics.UnitsOutside = statistics.UnitsKept = statistics.UnitsFresh =
    statistics.UnitsOnDevice = 0;
  for (const Entry& entry : this->Entries)
  {
    if (entry.IsActive)
    {
      entry.Prop->AddTo(statistics);
    }
  }
  statistics.UnitsHidden =
    statistics.Units - statistics.UnitsOutside - statistics.UnitsKept - statistics.UnitsFresh;
}
VTK_ABI_NAMESPACE_END
