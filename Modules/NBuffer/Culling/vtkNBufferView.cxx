// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferView.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferSharedDepth.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferView::vtkNBufferView(std::shared_ptr<vtkNBufferBackend> backend)
  : Backend(std::move(backend))
  , Props(this->Projection)
  , Partition(this->Props)
  , Division(this->Props)
  , Draws(this->Props, this->Division, this->Proxy)
  , List(this->Props, this->Partition, this->Division, this->Proxy)
{
  this->Proxy->SetOwner(this);
}

vtkNBufferView::~vtkNBufferView()
{
  this->Proxy->SetOwner(nullptr);
}

void vtkNBufferView::StepAside(vtkNBufferDecision reason, vtkProp** props, int count)
{
  this->Props.Synchronize(props, count);
  this->ResetStatistics();
  this->Statistics.Decision = reason;
  this->Statistics.Props = count;
  this->Statistics.Verdicts[static_cast<int>(vtkNBufferVerdict::Untested)] = count;
  this->State = Phase::Aside;
}

double vtkNBufferView::Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized,
  const vtkNBufferSettings& settings)
{
  const vtkNBufferClock clock;
  const Phase before = this->State;
  const bool complete = before == Phase::Tested || before == Phase::Reused;
  this->Settings = settings;
  this->ResetStatistics();
  this->Statistics.Props = count;
  this->Partition.Clear();
  this->Draws.Clear();
  this->HiddenButDrawn = 0;

  vtkNBufferClock part;
  const bool listChanged = this->Props.Synchronize(props, count);
  const vtkNBufferViewKey key = vtkNBufferViewKey::Make(renderer);
  const bool frozen = settings.Freeze && complete;
  const bool moved = !frozen && !(key == this->Setup.Key);
  if (moved)
  {
    this->Setup.Key = key;
    this->Setup.Apply(this->Projection);
  }
  this->Statistics.Refreshed = this->Props.Refresh(settings.HierarchySize, settings.ObserveAfter);
  this->Division.Update(renderer, this->Settings);
  this->Statistics.RefreshTime = part.Restart();

  const bool isSame = this->Stillness.BeginFrame(renderer, settings, this->Props.GetTraits(),
    listChanged || this->Statistics.Refreshed > 0 || moved, frozen);
  const bool mayReuse = complete && isSame && this->Settings.ReuseWhenStill && !this->DrawsInVain;
  bool reuses = frozen || mayReuse;
  if (!reuses)
  {
    this->Classify(renderer);
  }
  const bool repeats = mayReuse || (isSame && before == Phase::Untested && this->State == before);
  if (settings.Shared &&
    !settings.Shared->Poll(!repeats, this->Props.GetTraits().UntrackedPicture) && reuses && !frozen)
  {
    reuses = false;
    this->Classify(renderer);
  }
  if (reuses)
  {
    this->Statistics.Decision = frozen ? vtkNBufferDecision::Frozen : vtkNBufferDecision::Still;
    this->State = Phase::Reused;
  }
  this->Statistics.FrustumTime = part.GetMilliseconds();

  if (this->State != Phase::AwaitingProxy && vtkNBufferCompatibility::ProcessesImage(renderer))
  {
    this->Props.KeepIfNoneIsInside();
  }
  const double total =
    this->List.Fill(this->State == Phase::AwaitingProxy, props, count, initialized);
  this->Props.CountVerdicts(this->Statistics);
  if (this->State == Phase::Reused)
  {
    this->Division.Count(this->Statistics);
  }
  this->Statistics.CullTime = clock.GetMilliseconds();
  return total;
}

void vtkNBufferView::Classify(vtkRenderer* renderer)
{
  this->Props.Project();
  this->Division.SetView(this->Setup);
  this->Statistics.Decision = this->Divide(renderer);
  this->State = this->Statistics.Decision == vtkNBufferDecision::Culled ? Phase::AwaitingProxy
                                                                        : Phase::Untested;
}

vtkNBufferDecision vtkNBufferView::Divide(vtkRenderer* renderer)
{
  const vtkNBufferCompatibility::DrawingSettings& drawing = this->Stillness.GetDrawing();
  const int firstBlended = this->Stillness.GetFirstBlended();
  vtkNBufferFrustumCounts counts = this->Partition.Classify(firstBlended);
  counts.Blending = this->Props.HasBlending(drawing.AmbientOcclusion);
  this->Statistics.Candidates = counts.Candidates;
  this->BackOff =
    &this->BackOffs[this->Division.Classify(renderer, this->Settings, firstBlended, counts)];
  *this->BackOff = this->Settings.BackOff ? *this->BackOff : vtkNBufferBackOff();
  const vtkNBufferDecision decision = vtkNBufferCullingPolicy::ChooseDecision(counts,
    this->Settings.MinimumNumberOfCandidates, this->Settings.BackOff ? this->BackOff : nullptr);
  if (decision != vtkNBufferDecision::Culled)
  {
    this->Partition.KeepAll();
    this->Division.Reset();
    return decision;
  }
  this->Partition.HoldBack(!this->Division.HoldsUnits());
  this->Division.MarkOutside(this->Partition);
  this->Statistics.HeldBack = this->Division.CountTranslucentByUnits() +
    static_cast<int>(
      this->Partition.GetHeldBack().size() + this->Partition.GetTranslucent().size());
  return decision;
}

vtkNBufferVerdict vtkNBufferView::GetVerdict(vtkProp* prop, std::optional<int> part)
{
  const int i = this->Props.Find(prop);
  if (i < 0)
  {
    return vtkNBufferVerdict::Unknown;
  }
  return this->State == Phase::Aside ? vtkNBufferVerdict::Untested
                                     : this->Division.GetVerdict(i, part);
}

bool vtkNBufferView::GetVisiblePixels(vtkProp* prop, vtkNBufferRectangle& pixels)
{
  const int i = this->Props.Find(prop);
  return i >= 0 && (this->State == Phase::Tested || this->State == Phase::Reused) &&
    this->Props.GetState(i).Verdict == vtkNBufferVerdict::Visible &&
    vtkNBufferOcclusionTest(this->Levels, this->Tested.Places.GetDistanceFromMiddle())
      .FindVisiblePixels(this->Props.GetScreen(i), pixels);
}

bool vtkNBufferView::HasHeldPropWithKeys(vtkInformation* requiredKeys) const
{
  const std::vector<int>& heldBack = this->Partition.GetHeldBack();
  const int postponed = this->Division.GetPostponed();
  return (postponed >= 0 && this->Props.GetProp(postponed)->HasKeys(requiredKeys)) ||
    std::any_of(heldBack.begin(), heldBack.end(),
      [&](int i) { return this->Props.GetProp(i)->HasKeys(requiredKeys); });
}

int vtkNBufferView::DrawHeldProps(vtkRenderer* renderer, vtkInformation* requiredKeys)
{
  if (this->State == Phase::AwaitingProxy && !requiredKeys)
  {
    return this->TestAndDraw(renderer);
  }
  if (this->State == Phase::Tested && !requiredKeys && this->PrepareRepeat(renderer))
  {
    return this->Repeat(renderer);
  }
  // VTK draws only some of the props, or draws them again for a reason that is not known here.
  const bool isAnyHeldBack = this->State == Phase::AwaitingProxy || this->State == Phase::Tested ||
    this->State == Phase::Incomplete;
  return isAnyHeldBack ? this->DrawAll(renderer, requiredKeys, vtkNBufferDecision::OtherView) : 0;
}

int vtkNBufferView::TestAndDraw(vtkRenderer* renderer)
{
  this->State = Phase::Incomplete;
  vtkNBufferDepthSource source;
  const vtkNBufferDecision obstacle = this->PrepareTest(renderer, source);
  if (obstacle != vtkNBufferDecision::None)
  {
    return this->DrawAll(renderer, nullptr, obstacle);
  }
  // The device begins to draw the kept props now, and not when their depth is read.
  glFlush();
  this->Tested = source;
  int drawn = 0;
  vtkNBufferDepthTest test(
    *this->Backend, this->Levels, this->Props, this->Statistics, this->Settings);
  const bool tested = this->DrawRounds(renderer, test, drawn);
  this->DrawsInVain = this->HiddenButDrawn > 0 || this->Division.HasKeptInVain() ||
    (!this->Stillness.IsSame() && !this->Draws.Get().empty());
  const vtkNBufferClock clock;
  this->Statistics.Redrawn += this->Draws.RestoreTieOrder(
    renderer, this->Partition, true, this->Tested.Samples, tested ? &test : nullptr);
  this->Statistics.TieQueries = this->Draws.GetTieQueries();
  this->Statistics.DrawTime += clock.GetMilliseconds();
  // When rendering is aborted mappers return early, so that depth and verdicts are not complete.
  if (tested && !renderer->GetRenderWindow()->GetAbortRender())
  {
    this->State = Phase::Tested;
  }
  this->Props.CountVerdicts(this->Statistics);
  this->Division.Count(this->Statistics);
  this->BackOff->Learn(this->Statistics.GetCount(vtkNBufferVerdict::Hidden) + this->HiddenButDrawn +
      this->Statistics.UnitsHidden - this->Statistics.Redrawn,
    this->Partition.GetSize() + this->Statistics.Units - this->Statistics.UnitsOutside);
  return drawn;
}

bool vtkNBufferView::PrepareRepeat(vtkRenderer* renderer)
{
  // With coarser depth other props have equal depths; with other samples other props are visible.
  vtkNBufferDepthSource source;
  return vtkNBufferCompatibility::DrawsOpaquePropsTwice(renderer) &&
    this->PrepareTest(renderer, source) == vtkNBufferDecision::None &&
    std::max(source.Samples, 1) == std::max(this->Tested.Samples, 1) &&
    source.Stored == this->Tested.Stored && source.GetPrecision() >= this->Tested.GetPrecision();
}

int vtkNBufferView::Repeat(vtkRenderer* renderer)
{
  // The statistics do not count what is drawn as it was before.
  vtkNBufferClock clock;
  const int drawn = this->Draws.Repeat(renderer, this->Partition.GetHeldBack());
  this->Statistics.DrawTime += clock.Restart();
  if (this->Props.GetTraits().DepthOffset)
  {
    // The depth is farther now where the first drawing has left out an offset.
    this->Settings.Shared = nullptr; // Ranks share the depth of one drawing.
    return drawn + this->TestAndDraw(renderer);
  }
  this->Draws.RestoreTieOrder(renderer, this->Partition, true, this->Tested.Samples, nullptr);
  this->Statistics.DrawTime += clock.GetMilliseconds();
  return drawn;
}

vtkNBufferDecision vtkNBufferView::PrepareTest(vtkRenderer* renderer, vtkNBufferDepthSource& source)
{
  std::string why;
  const vtkNBufferDecision obstacle = vtkNBufferCompatibility::WhyNotHere(
    renderer, this->Props, this->Setup.Key, this->Settings.Backend, source, why);
  if (obstacle != vtkNBufferDecision::None)
  {
    if (!why.empty())
    {
      this->Fail(renderer, obstacle, why);
    }
    return obstacle;
  }
  if (this->Setup.SetDepth(
        this->Settings.GetStep(source), source.Stored, vtkNBufferGL::GetSubpixelBits()))
  {
    this->Setup.Apply(this->Projection);
    this->Division.SetView(this->Setup);
    this->Partition.Project();
  }
  return vtkNBufferDecision::None;
}

bool vtkNBufferView::DrawRounds(vtkRenderer* renderer, vtkNBufferDepthTest& test, int& drawn)
{
  const bool isRepeated = this->Statistics.Rounds > 0; // Repeat() has drawn what was drawn before.
  int round = this->Statistics.Rounds + 1;
  std::vector<int> left = isRepeated ? this->Partition.TestAgain() : this->Partition.GetHeldBack();
  std::vector<int> untested = // but drawn
    isRepeated ? std::vector<int>() : this->Partition.GetKept();
  const auto draw = [&](std::vector<int> props)
  {
    // Among ranks they are not tested and count as visible in the next frame, in which IsNew()
    // notices a cut by the many visible props that have left the frustum.
    untested.insert(
      untested.end(), this->Settings.Shared ? props.end() : props.begin(), props.end());
    const std::vector<int> fresh = this->Division.GetFresh();
    props.insert(props.end(), fresh.begin(), fresh.end());
    drawn += this->DrawRound(renderer, std::move(props), round++);
  };
  if (isRepeated)
  {
    this->List.ShowTranslucent();
    this->Division.TestAgain();
  }
  else if (this->Division.GetPostponed() >= 0)
  {
    drawn += this->Draws.Draw(
      renderer, this->Division.GetPostponed(), 1, this->Proxy->GetAllocatedRenderTime());
  }
  const auto limit = vtkNBufferPartition::GetLimit(this->Settings.RoundSize, left.size());
  const bool isNew = !isRepeated && this->Partition.IsNew();
  this->Division.Count(this->Statistics);
  test.SetCounts(this->Partition.GetSize() + this->Statistics.Units - this->Statistics.UnitsOutside,
    isNew ? static_cast<int>(left.size()) : 0);
  if (isNew)
  {
    draw(this->Partition.RemoveOccluders(left, limit));
  }
  const int levels = this->Division.GetLevelsNeeded(this->Settings.BaseFactor);
  for (;;)
  {
    std::string why;
    const vtkNBufferDecision failure = test.Build(
      renderer, this->Tested, { &untested, &left, &this->Partition.GetTranslucent() }, levels,
      [&]() { return this->Division.CountHidden(test.GetDepthOfUnits()); }, why);
    if (failure != vtkNBufferDecision::None)
    {
      this->Fail(renderer, failure, why);
      this->Statistics.Decision = failure;
      // Draw what earlier rounds found hidden, too.
      std::vector<int> all = this->Partition.GetNotDrawn();
      this->Division.AddMissing(all);
      draw(all);
      return false;
    }
    for (int i : left)
    {
      this->Props.GetState(i).Verdict = vtkNBufferVerdict::Hidden;
      this->Props.GetState(i).WasVisible = false;
      this->Props.GetState(i).WasTested = true;
    }
    // How many props are left decides whether pixels are read. The props that are drawn already are
    // tested with the others, so that this does not change the verdict on a prop.
    left.insert(left.begin(), untested.begin(), untested.end());
    const auto size = static_cast<int>(left.size() + this->Partition.GetTranslucent().size());
    const int passed = test.RemoveHidden(left);
    if (this->Statistics.Rounds == 0)
    {
      this->Statistics.Tested = size;
      this->Statistics.PassedCoarseTest = passed;
    }
    this->HiddenButDrawn += this->Partition.RemoveDrawn(untested, left);
    untested.clear();
    ++this->Statistics.Rounds;
    const bool isLast = this->Statistics.Rounds >= this->Settings.MaximumNumberOfRounds;
    const bool areAllUnits = this->Division.Test(
      test.GetDepthOfUnits(), left, isLast ? VTK_INT_MAX : this->Settings.RoundSize);
    // Another round is worth its read-back if many props may be hidden by others.
    std::vector<int> visible = isLast || left.size() <= 2 * limit
      ? std::exchange(left, {})
      : this->Partition.RemoveOccluders(left, left.size());
    if (left.empty() && areAllUnits)
    {
      if (vtkNBufferCompatibility::KeepsOpaqueDepth(renderer))
      {
        this->List.TestTranslucent(test);
      }
      draw(std::move(visible));
      return true;
    }
    draw(std::move(visible));
  }
}

int vtkNBufferView::DrawRound(vtkRenderer* renderer, std::vector<int> props, int round)
{
  const vtkNBufferClock clock;
  const double time = this->Proxy->GetAllocatedRenderTime() /
    std::max<std::size_t>(this->Partition.GetHeldBack().size(), 1);
  int drawn = 0;
  std::sort(props.begin(), props.end());
  for (int i : props)
  {
    vtkNBufferState& state = this->Props.GetState(i);
    if (state.Verdict == vtkNBufferVerdict::Visible ||
      state.Verdict == vtkNBufferVerdict::NearPlane ||
      state.Verdict == vtkNBufferVerdict::NotAPlainMapper)
    {
      ++this->Statistics.FreshDraws; // Some of its units have been drawn before.
    }
    else
    {
      state.Verdict = vtkNBufferVerdict::Visible;
      state.WasVisible = true;
      ++this->Statistics.DrawnInRound[std::min(round, vtkNBufferStatistics::MaximumNumberOfRounds)];
    }
    // Round 1 is reserved for a prop for which the renderer's list had no room.
    drawn += this->Draws.Draw(renderer, i, round + 1, time);
  }
  this->Statistics.DrawTime += clock.GetMilliseconds();
  return drawn;
}

int vtkNBufferView::DrawAll(
  vtkRenderer* renderer, vtkInformation* requiredKeys, vtkNBufferDecision reason)
{
  int drawn = 0;
  this->List.ShowTranslucent();
  this->Draws.Clear();
  std::vector<int> all = this->Partition.GetHeldBack();
  this->Division.AddMissing(all);
  for (int i : all)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Untested;
    if (this->Props.GetProp(i)->HasKeys(requiredKeys))
    {
      drawn += this->Draws.Draw(renderer, i, 1, this->Proxy->GetAllocatedRenderTime());
    }
  }
  // In another view the boxes cover other pixels, and without a depth test the last prop wins.
  this->Statistics.Redrawn += this->Draws.RestoreTieOrder(
    renderer, this->Partition, false, this->Tested.Samples, nullptr, requiredKeys);
  this->Statistics.Decision = reason;
  this->State = Phase::Incomplete;
  this->Props.CountVerdicts(this->Statistics);
  return drawn;
}

void vtkNBufferView::Fail(vtkRenderer* renderer, vtkNBufferDecision failure, const std::string& why)
{
  if (this->Backend->CountFailure(failure))
  {
    vtkWarningWithObjectMacro(renderer, << "vtkNBufferCuller draws everything ("
                                        << vtkNBufferStatistics::GetName(failure) << "). " << why);
  }
  this->Statistics.FailedFrames = this->Backend->GetFailedFrames();
}

void vtkNBufferView::ResetStatistics()
{
  this->Statistics = vtkNBufferStatistics();
  this->Statistics.FailedFrames = this->Backend->GetFailedFrames();
}
VTK_ABI_NAMESPACE_END
