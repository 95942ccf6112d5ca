// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferView.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferCompatibility.h"
#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN

vtkNBufferView::vtkNBufferView(vtkNBufferBackend& backend, const vtkNBufferTuning& tuning)
  : Backend(backend)
  , Tuning(tuning)
  , Draws(this->Props, this->Projection, this->Proxy)
{
  this->Proxy->SetView(this);
}

vtkNBufferView::~vtkNBufferView()
{
  this->Proxy->SetView(nullptr);
}

void vtkNBufferView::StepAside(vtkNBufferDecision reason, vtkProp** props, int count)
{
  this->Props.Synchronize(props, count);
  this->ResetStatistics();
  this->Statistics.Decision = reason;
  this->Statistics.Props = count;
  this->Statistics.Verdicts[static_cast<int>(vtkNBufferVerdict::Untested)] = count;
  this->Pending = this->DrawnOnce = this->Settled = false;
  this->Aside = true;
}

double vtkNBufferView::Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized,
  const vtkNBufferSettings& settings)
{
  const vtkNBufferClock clock;
  const bool wasFrozen = this->Statistics.Decision == vtkNBufferDecision::Frozen;
  const bool complete = this->Settled && !this->Pending;
  this->Settings = settings;
  this->ResetStatistics();
  this->Statistics.Props = count;
  this->Pending = this->DrawnOnce = this->Aside = false;
  this->Kept.clear();
  this->Held.clear();
  this->Gated.clear();
  this->Draws.Clear();

  vtkNBufferClock part;
  this->Props.SetHierarchySize(this->Tuning.HierarchySize);
  const bool listChanged = this->Props.Synchronize(props, count);
  const vtkNBufferViewKey key = vtkNBufferViewKey::Make(renderer);
  const bool frozen = settings.Freeze && (wasFrozen || complete);
  const bool moved = !frozen && !(key == this->LastKey);
  if (moved)
  {
    this->SetProjection(key);
  }
  this->Statistics.Refreshed = this->Props.Refresh(moved ? &this->Projection : nullptr);
  this->Statistics.RefreshTime = part.Restart();

  const bool changed = listChanged || this->Statistics.Refreshed > 0 || moved;
  if (frozen)
  {
    this->Statistics.Decision = vtkNBufferDecision::Frozen;
  }
  else if (complete && !changed && this->Tuning.ReuseWhenStill && this->MayReuse(renderer))
  {
    this->Statistics.Decision = vtkNBufferDecision::Still;
  }
  else
  {
    if (!moved)
    {
      this->Props.Project(this->Projection);
    }
    const bool blending = this->Props.HasBlending(vtkNBufferCompatibility::SmoothesLines(renderer),
      vtkNBufferCompatibility::HasAmbientOcclusion(renderer));
    this->Statistics.Decision = this->Decide(blending);
    this->Settled = this->Statistics.Decision == vtkNBufferDecision::Culled;
    this->Pending = this->Settled;
  }
  this->Statistics.FrustumTime = part.GetMilliseconds();

  if (vtkNBufferCompatibility::ProcessesImage(renderer))
  {
    this->Props.KeepIfNoneIsInside();
  }
  const double total = this->Emit(props, count, initialized);
  this->Props.CountVerdicts(this->Statistics);
  this->Statistics.CullTime = clock.GetMilliseconds();
  return total;
}

void vtkNBufferView::SetProjection(const vtkNBufferViewKey& key)
{
  this->LastKey = key;
  const auto& viewport = key.Viewport;
  this->Projection.Set(key.WorldToClip.data(), viewport[2], viewport[3], this->DepthQuantum,
    std::max(viewport[0] + viewport[2], viewport[1] + viewport[3]));
}

bool vtkNBufferView::MayReuse(vtkRenderer* renderer) const
{
  // Another test saves what the last one found hidden too late. What was in the buffers before, and
  // depth that changes without a trace, may differ.
  return !this->Improves && !this->Props.HasUntrackedDepth() && renderer->GetErase() &&
    renderer->GetRenderWindow()->GetErase() && !renderer->GetPreserveDepthBuffer();
}

vtkNBufferDecision vtkNBufferView::Decide(bool blending)
{
  int candidates = 0;
  int inside = 0;
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    vtkNBufferState& state = this->Props.GetState(i);
    if (state.Verdict == vtkNBufferVerdict::Translucent &&
      state.Placement == vtkNBufferPlacement::Inside)
    {
      this->Gated.push_back(i);
    }
    candidates += state.Verdict == vtkNBufferVerdict::Translucent ? 1 : 0;
    if (state.Verdict != vtkNBufferVerdict::Visible)
    {
      continue; // not a candidate
    }
    ++candidates;
    switch (state.Placement)
    {
      case vtkNBufferPlacement::Outside:
        state.Verdict = vtkNBufferVerdict::Outside;
        state.WasVisible = false;
        break;
      case vtkNBufferPlacement::Crossing:
        ++inside;
        state.Verdict = vtkNBufferVerdict::NearPlane;
        state.WasVisible = true;
        break;
      case vtkNBufferPlacement::Inside:
        ++inside;
        state.Verdict = vtkNBufferVerdict::Untested;
        (state.WasVisible ? this->Kept : this->Held).push_back(i);
        break;
    }
  }
  this->Statistics.Candidates = candidates;

  vtkNBufferDecision decision = vtkNBufferDecision::Culled;
  if (blending)
  {
    decision = vtkNBufferDecision::Blending;
  }
  else if (inside < this->Tuning.MinimumNumberOfCandidates)
  {
    decision = vtkNBufferDecision::FewCandidates;
  }
  else if (this->Tuning.BackOff && this->BackOff.CountRestFrame())
  {
    decision = vtkNBufferDecision::BackedOff;
  }
  else if (this->Held.empty())
  {
    // What became hidden since is only found by a test: now and then one prop is held back so
    // that there is one, the farthest, which hides least.
    const bool manyGated =
      static_cast<int>(this->Gated.size()) >= this->Tuning.MinimumNumberOfCandidates;
    if (this->Tuning.BackOff && !manyGated && !this->BackOff.CountIdleFrame())
    {
      decision = vtkNBufferDecision::NothingHeld;
    }
    else if (!this->Kept.empty())
    {
      const auto farthest = std::max_element(this->Kept.begin(), this->Kept.end(),
        [this](int a, int b)
        { return this->Props.GetScreen(a).Nearest < this->Props.GetScreen(b).Nearest; });
      this->Held.push_back(*farthest);
      this->Kept.erase(farthest);
    }
  }
  if (decision != vtkNBufferDecision::Culled || this->Held.empty())
  {
    // All of them are drawn now, so that the next test begins with all of them in the depth.
    for (int i : this->Held)
    {
      this->Props.GetState(i).WasVisible = true;
    }
    this->Held.clear();
    this->Gated.clear();
    return decision == vtkNBufferDecision::Culled ? vtkNBufferDecision::NothingHeld : decision;
  }
  for (int i : this->Kept)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Visible;
  }
  for (int i : this->Held)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Unknown;
  }
  this->Statistics.HeldBack = static_cast<int>(this->Held.size() + this->Gated.size());
  return decision;
}

double vtkNBufferView::Emit(vtkProp** props, int& count, int& initialized)
{
  double total = 0.0;
  int kept = 0;
  double heldTotal = 0.0;
  this->Gates.Clear();
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    const vtkNBufferVerdict verdict = this->Props.GetState(i).Verdict;
    const bool closed = verdict == vtkNBufferVerdict::Hidden && !this->Pending &&
      this->Props.GetCandidate(i).IsTranslucent();
    if (verdict == vtkNBufferVerdict::Outside || (verdict == vtkNBufferVerdict::Hidden && !closed))
    {
      continue;
    }
    vtkProp* prop = this->Props.GetProp(i);
    const double multiplier = initialized ? prop->GetRenderTimeMultiplier() : 1.0;
    if (verdict == vtkNBufferVerdict::Unknown && this->Pending)
    {
      heldTotal += multiplier;
      continue;
    }
    const bool gated =
      this->Pending && std::binary_search(this->Gated.begin(), this->Gated.end(), i);
    if (gated || closed)
    {
      prop = this->Gates.Add(prop, !closed);
    }
    prop->SetRenderTimeMultiplier(multiplier);
    total += multiplier;
    props[kept++] = prop;
  }
  if (this->Pending)
  {
    // In the place of the held ones, so that the list never grows.
    this->Proxy->SetRenderTimeMultiplier(heldTotal);
    total += heldTotal;
    props[kept++] = this->Proxy;
  }
  count = kept;
  initialized = 1;
  return total;
}

void vtkNBufferView::CloseGates(vtkNBufferDepthTest& test)
{
  // Gate n stands for the n-th of Gated.
  std::vector<int> visible = this->Gated;
  test.RemoveHidden(visible);
  for (std::size_t n = 0; n < this->Gated.size(); ++n)
  {
    if (!this->Gates.HasDrawn(n) &&
      !std::binary_search(visible.begin(), visible.end(), this->Gated[n]))
    {
      this->Gates.SetOpen(n, false);
      this->Props.GetState(this->Gated[n]).Verdict = vtkNBufferVerdict::Hidden;
    }
  }
}

vtkNBufferVerdict vtkNBufferView::GetVerdict(vtkProp* prop) const
{
  const int i = this->Props.Find(prop);
  if (i < 0)
  {
    return vtkNBufferVerdict::Unknown;
  }
  // In a frame that is drawn as usual the list is not even looked at.
  return this->Aside ? vtkNBufferVerdict::Untested : this->Props.GetState(i).Verdict;
}

bool vtkNBufferView::HasHeldPropWithKeys(vtkInformation* requiredKeys) const
{
  return std::any_of(this->Held.begin(), this->Held.end(),
    [&](int i) { return this->Props.GetProp(i)->HasKeys(requiredKeys); });
}

int vtkNBufferView::DrawHeldProps(vtkRenderer* renderer, vtkInformation* requiredKeys)
{
  if (!this->Pending && !this->DrawnOnce)
  {
    return 0;
  }
  vtkNBufferDepthSource source;
  if (!requiredKeys && this->MayRepeat(renderer, source))
  {
    return this->Repeat(renderer);
  }
  // Only some of the props, or the same props once more: VTK has its reasons, draw what it says.
  if (requiredKeys || this->DrawnOnce)
  {
    this->DrawnOnce = true;
    return this->DrawAll(renderer, requiredKeys, vtkNBufferDecision::OtherView);
  }
  this->DrawnOnce = true;
  const vtkNBufferDecision obstacle = this->PrepareTest(renderer, source);
  if (obstacle != vtkNBufferDecision::None)
  {
    return this->DrawAll(renderer, nullptr, obstacle);
  }
  this->TestedBits = source.DepthBits;
  this->TestedSamples = source.Samples;
  const int drawn = this->DrawRounds(renderer, source);
  const vtkNBufferClock clock;
  this->Statistics.Redrawn +=
    this->Draws.RestoreTieOrder(renderer, this->Held, true, this->TestedSamples);
  this->Statistics.DrawTime += clock.GetMilliseconds();
  this->Pending = false;
  // Mappers return early from an aborted frame: its depth and verdicts are worth nothing.
  this->Settled = this->Settled && !renderer->GetRenderWindow()->GetAbortRender();
  this->Props.CountVerdicts(this->Statistics);
  const auto keptHidden = std::count_if(this->Kept.begin(), this->Kept.end(),
    [this](int i) { return !this->Props.GetState(i).WasVisible; });
  this->Improves = keptHidden > 0;
  this->BackOff.Learn(this->Statistics.GetCount(vtkNBufferVerdict::Hidden) +
      static_cast<int>(keptHidden) - this->Statistics.Redrawn,
    static_cast<int>(this->Kept.size() + this->Held.size() + this->Gated.size()));
  return drawn;
}

bool vtkNBufferView::MayRepeat(vtkRenderer* renderer, vtkNBufferDepthSource& source)
{
  // Depth that is coarser than that of the test holds other ties, other samples see past others.
  return this->DrawnOnce && !this->Pending && this->Settled &&
    vtkNBufferCompatibility::DrawsOpaquePropsTwice(renderer) &&
    this->PrepareTest(renderer, source) == vtkNBufferDecision::None &&
    std::max(source.Samples, 1) == std::max(this->TestedSamples, 1) &&
    std::min(source.DepthBits, 24) >= std::min(this->TestedBits, 24);
}

int vtkNBufferView::Repeat(vtkRenderer* renderer)
{
  const vtkNBufferClock clock;
  const int drawn = this->Draws.Repeat(renderer);
  // Statistics are of one drawing.
  this->Draws.RestoreTieOrder(renderer, this->Held, true, this->TestedSamples);
  this->Statistics.DrawTime += clock.GetMilliseconds();
  return drawn;
}

vtkNBufferDecision vtkNBufferView::PrepareTest(vtkRenderer* renderer, vtkNBufferDepthSource& source)
{
  if (!(vtkNBufferViewKey::Make(renderer) == this->LastKey))
  {
    return vtkNBufferDecision::OtherView;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  std::string why;
  if (!vtkNBufferGL::CheckVersion(why))
  {
    this->Fail(renderer, vtkNBufferDecision::OldContext, why);
    return vtkNBufferDecision::OldContext;
  }
  if (!source.Inspect(window, why))
  {
    this->Fail(renderer, vtkNBufferDecision::NoDepth, why);
    return vtkNBufferDecision::NoDepth;
  }
  if (source.Viewport[2] != this->LastKey.Viewport[2] ||
    source.Viewport[3] != this->LastKey.Viewport[3] || !source.HoldsViewport() ||
    !vtkNBufferBackend::DrawsOrdinaryDepth(source))
  {
    return vtkNBufferDecision::OtherView;
  }
  const double quantum = std::ldexp(1.0, -std::min(source.DepthBits, 24));
  if (quantum != this->DepthQuantum)
  {
    this->DepthQuantum = quantum;
    this->SetProjection(this->LastKey);
    for (const std::vector<int>* list : { &this->Kept, &this->Held, &this->Gated })
    {
      for (int i : *list)
      {
        this->Props.GetState(i).Placement =
          this->Projection.Project(this->Props.GetBox(i), this->Props.GetScreen(i));
      }
    }
  }
  return vtkNBufferDecision::None;
}

void vtkNBufferView::TestKept(vtkNBufferDepthTest& test)
{
  // They are drawn already; which of them are visible decides what the next frame begins with.
  for (int i : this->Kept)
  {
    this->Props.GetState(i).WasVisible = false;
  }
  std::vector<int> visible = this->Kept;
  this->Statistics.PassedCoarseTest += test.RemoveHidden(visible);
  for (int i : visible)
  {
    this->Props.GetState(i).WasVisible = true;
  }
}

int vtkNBufferView::DrawRounds(vtkRenderer* renderer, const vtkNBufferDepthSource& source)
{
  int drawn = 0;
  int round = 1;
  std::vector<int> held = this->Held;
  const auto nearer = [this](int a, int b)
  { return this->Props.GetScreen(a).Nearest < this->Props.GetScreen(b).Nearest; };
  const auto drawNearest = [&](std::size_t limit)
  {
    std::vector<int> nearest = held;
    if (limit < held.size())
    {
      std::nth_element(held.begin(), held.begin() + limit, held.end(), nearer);
      nearest.assign(held.begin(), held.begin() + limit);
    }
    held.erase(held.begin(), held.begin() + nearest.size());
    drawn += this->DrawRound(renderer, std::move(nearest), round++);
  };

  // Where nothing is known, the nearest props are the best guess at what hides the others.
  if (this->Kept.empty())
  {
    drawNearest(this->Tuning.RoundSize);
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkNBufferDepthTest test(this->Backend, this->Levels, this->Projection, this->Props,
    this->Statistics, { this->Settings.Backend, this->Settings.TestSlivers, this->Tuning });
  for (;;)
  {
    std::string why;
    const vtkNBufferDecision failure =
      test.Build(window, source, { &this->Kept, &held, &this->Gated }, why);
    if (failure != vtkNBufferDecision::None)
    {
      this->Fail(renderer, failure, why);
      this->Statistics.Decision = failure;
      this->Settled = false;
      // What earlier rounds found hidden as well.
      held.clear();
      std::copy_if(this->Held.begin(), this->Held.end(), std::back_inserter(held),
        [this](int i) { return this->Props.GetState(i).Verdict != vtkNBufferVerdict::Visible; });
      drawNearest(held.size());
      return drawn;
    }
    if (this->Statistics.Rounds == 0)
    {
      this->Statistics.Tested =
        static_cast<int>(this->Kept.size() + held.size() + this->Gated.size());
      this->TestKept(test);
    }
    for (int i : held)
    {
      this->Props.GetState(i).Verdict = vtkNBufferVerdict::Hidden;
      this->Props.GetState(i).WasVisible = false;
    }
    const int doubtful = test.RemoveHidden(held);
    this->Statistics.PassedCoarseTest += this->Statistics.Rounds == 0 ? doubtful : 0;

    // Another round must save more props than it draws to be worth its read-back.
    const std::size_t limit = static_cast<std::size_t>(this->Tuning.RoundSize)
      << this->Statistics.Rounds;
    ++this->Statistics.Rounds;
    if (held.size() <= 2 * limit || this->Statistics.Rounds >= this->Tuning.MaximumNumberOfRounds)
    {
      this->CloseGates(test);
      drawNearest(held.size());
      return drawn;
    }
    drawNearest(limit);
  }
}

int vtkNBufferView::DrawRound(vtkRenderer* renderer, std::vector<int> props, int round)
{
  const vtkNBufferClock clock;
  const double time =
    this->Proxy->GetAllocatedRenderTime() / std::max<std::size_t>(this->Held.size(), 1);
  int drawn = 0;
  std::sort(props.begin(), props.end());
  for (int i : props)
  {
    vtkNBufferState& state = this->Props.GetState(i);
    state.Verdict = vtkNBufferVerdict::Visible;
    state.WasVisible = true;
    drawn += this->Draws.Draw(renderer, i, round, time);
  }
  this->Statistics.DrawnInRound[std::min(round, vtkNBufferStatistics::MaximumNumberOfRounds)] +=
    static_cast<int>(props.size());
  this->Statistics.DrawTime += clock.GetMilliseconds();
  return drawn;
}

int vtkNBufferView::DrawAll(
  vtkRenderer* renderer, vtkInformation* requiredKeys, vtkNBufferDecision reason)
{
  int drawn = 0;
  for (std::size_t n = 0; n < this->Gated.size(); ++n)
  {
    this->Gates.SetOpen(n, true);
    this->Props.GetState(this->Gated[n]).Verdict = vtkNBufferVerdict::Translucent;
  }
  this->Draws.Clear();
  for (int i : this->Held)
  {
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Untested;
    if (this->Props.GetProp(i)->HasKeys(requiredKeys))
    {
      drawn += this->Draws.Draw(renderer, i, 1, this->Proxy->GetAllocatedRenderTime());
    }
  }
  // In another view boxes are elsewhere; without a depth test the last one wins at any depth.
  this->Statistics.Redrawn +=
    this->Draws.RestoreTieOrder(renderer, this->Held, false, this->TestedSamples);
  this->Statistics.Decision = reason;
  this->Pending = this->Settled = false;
  this->Props.CountVerdicts(this->Statistics);
  return drawn;
}

void vtkNBufferView::Fail(vtkRenderer* renderer, vtkNBufferDecision failure, const std::string& why)
{
  if (this->Backend.CountFailure(failure))
  {
    vtkWarningWithObjectMacro(renderer, << "vtkNBufferCuller draws everything ("
                                        << vtkNBufferStatistics::GetName(failure) << "). " << why);
  }
  this->Statistics.FailedFrames = this->Backend.GetFailedFrames();
}

void vtkNBufferView::ResetStatistics()
{
  this->Statistics = vtkNBufferStatistics();
  this->Statistics.FailedFrames = this->Backend.GetFailedFrames();
}
VTK_ABI_NAMESPACE_END
