// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMaskMaker.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferForEachProp.h"
#include "vtkNBufferGL.h"
#include "vtkShadowCamera.h"
#include "vtkShadowCostMeasurement.h"
#include "vtkShadowLitmapSource.h"
#include "vtkShadowReceiverProjector.h"
#include "vtkShadowReceivers.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// So many casters are worth a thread: one of them may take as long as a hundred others.
constexpr vtkIdType CastersPerThread = 256;
}

/// A light of a frame, and what is needed to make its part of a mask.
struct vtkShadowMaskMaker::Work : vtkShadowMaskMaker::Frame
{
  const vtkShadowLight& GetLight() const { return this->Source.Geometry; }

  /// The light spaces of the light's litmaps.
  std::vector<vtkShadowLightSpace> MakeLitmapSpaces() const
  {
    return this->GetLight().Kind == vtkShadowLightKind::Point
      ? vtkShadowLightSpace::MakeFaces(this->GetLight())
      : std::vector<vtkShadowLightSpace>{ this->Space };
  }

  vtkOpenGLRenderWindow* Window;
  const vtkShadowCamera& Camera;
  const vtkShadowLightSource& Source;
  std::size_t Slot;
  vtkShadowLightSpace Space;
  Volumes& LightVolumes;
};

bool vtkShadowMaskMaker::Reserve(vtkOpenGLRenderWindow* window, std::size_t lights)
{
  if (!vtkNBufferGL::CheckVersion(this->Error))
  {
    return false;
  }
  glGetIntegerv(GL_VIEWPORT, this->Viewport);
  const int* viewport = this->Viewport;
  if (viewport[0] < 0 || viewport[1] < 0 || viewport[2] < 1 || viewport[3] < 1)
  {
    this->Error = "The viewport is empty or begins outside of the window. Move it inside.";
    return false;
  }
  const int masks = vtkShadowTarget::CountMasks(lights);
  return this->Target.Reserve(window, viewport[0] + viewport[2], viewport[1] + viewport[3], masks,
    vtkNBufferGL::GetSamplePlaces(), this->Error);
}

bool vtkShadowMaskMaker::Make(const Frame& frame)
{
  const std::vector<vtkShadowLightSource>& lights = frame.Lights;
  this->Shadows = 0;
  this->Error.clear();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  this->IsDepthRead = false;
  ++this->Coverage.Age;
  vtkShadowCamera camera(frame.Renderer);
  std::copy_n(this->Viewport, 4, camera.Plan.Viewport);
  camera.Plan.Boxes = frame.Settings.Mode != vtkShadowMode::Culled &&
    vtkNBufferGL::KeepsToScissor(static_cast<int>(this->Target.GetSamples().size()));
  frame.DebugView.Clear();
  const vtkShadowCounter::Scope scope(window, this->Viewport);
  for (int mask = 0; mask < vtkShadowTarget::CountMasks(lights.size()); ++mask)
  {
    this->Counter.ClearMask(this->Target, mask, this->Viewport);
  }
  if (frame.Settings.Tuning.CountFragments)
  {
    frame.Statistics.Fragments = 0;
  }
  this->LightVolumes.resize(std::max(this->LightVolumes.size(), lights.size()));
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const Work work = { frame, window, camera, lights[i], i,
      vtkShadowLightSpace(lights[i].Geometry), this->LightVolumes[i] };
    const vtkNBufferClock clock;
    vtkShadowLightCost& cost = frame.Statistics.LightCosts.emplace_back();
    if (!this->Shade(work, cost))
    {
      return false;
    }
    cost.Time = clock.GetMilliseconds();
  }
  return true;
}

std::size_t vtkShadowMaskMaker::GetNumberOfSamples() const
{
  return this->Target.GetSamples().size() * static_cast<std::size_t>(this->Viewport[2]) *
    static_cast<std::size_t>(this->Viewport[3]);
}

vtkShadowView vtkShadowMaskMaker::GetReceiverView(const Work& work) const
{
  vtkShadowView view = work.Camera.GetView();
  view.Samples = this->Target.GetSamples();
  view.LightingMargin = work.Casters.GetLightingMargin();
  view.Push = work.Camera.Plan.GetPush(this->Parts);
  return view;
}

bool vtkShadowMaskMaker::ReadReceivers(const Work& work)
{
  if (this->IsDepthRead)
  {
    return true;
  }
  const vtkNBufferClock clock;
  ++work.Statistics.ReadBacks;
  this->IsDepthRead = this->Target.ReadDepth(work.Window, this->Viewport, this->Depth, this->Error);
  if (this->IsDepthRead)
  {
    const auto covered =
      std::count_if(this->Depth.begin(), this->Depth.end(), vtkNBufferDepthConvention::IsDrawn);
    this->Coverage = { static_cast<std::size_t>(covered), this->Depth.size() };
  }
  work.Statistics.ReadTime += clock.GetMilliseconds();
  if (this->LitmapSource && this->LitmapSource != work.Settings.Tuning.LitmapSource)
  {
    this->LitmapSource->Release();
  }
  this->LitmapSource = work.Settings.Tuning.LitmapSource;
  this->IsDepthRead = this->IsDepthRead &&
    (!this->LitmapSource ||
      this->LitmapSource->BeginFrame(
        work.Renderer, this->Depth.data(), work.Camera.GetView(), this->Error));
  return this->IsDepthRead;
}

bool vtkShadowMaskMaker::MakeLitmaps(const Work& work,
  const std::vector<vtkShadowLightSpace>& spaces, std::vector<vtkShadowPlan::Face>& faces)
{
  if (!this->ReadReceivers(work))
  {
    return false;
  }
  const vtkNBufferClock clock;
  const int resolution = work.Settings.Tuning.LitmapResolution;
  const float* depth = this->Depth.data();
  const vtkShadowView view = this->GetReceiverView(work);
  this->Litmaps.resize(std::max(this->Litmaps.size(), spaces.size()));
  for (std::size_t i = 0; i < spaces.size(); ++i)
  {
    vtkShadowLitmap& litmap = this->Litmaps[i];
    if (this->LitmapSource)
    {
      const vtkShadowBlock range =
        vtkShadowReceivers::GetRange(depth, view, work.GetLight(), spaces[i]);
      if (!this->LitmapSource->Fill(spaces[i], range, resolution, litmap, this->Error))
      {
        return false;
      }
    }
    else
    {
      vtkShadowReceivers::Scatter(depth, view, work.GetLight(), spaces[i], resolution, litmap);
    }
    work.Statistics.Receivers += litmap.GetNumberOfReceivers();
    litmap.Build();
    faces.push_back({ &spaces[i], &litmap });
    ++work.Statistics.Litmaps;
  }
  work.Statistics.LitmapTime += clock.GetMilliseconds();
  return true;
}

void vtkShadowMaskMaker::FindParts(const Work& work)
{
  const std::vector<vtkShadowCaster*>& casters = work.Casters.GetCasters();
  const auto last = static_cast<vtkIdType>(casters.size()) - 1;
  std::vector<const std::vector<vtkShadowPart>*> partLists(casters.size());
  std::atomic<int> built(0);
  vtkNBufferForEachProp::RunAhead(
    casters.size(),
    [&](vtkIdType i)
    {
      casters[i]->PrefetchParts(work.Slot);
      casters[std::min(i + vtkNBufferForEachProp::PropsToFetchAhead, last)]->Prefetch();
    },
    [&](vtkIdType i)
    {
      if (casters[i]->UpdateParts(work.Slot, work.GetLight(), work.Space, work.Camera.NearBounds))
      {
        ++built;
      }
      partLists[i] = &casters[i]->GetParts(work.Slot);
    });
  work.Statistics.Silhouettes += built;
  if (built > 0)
  {
    work.LightVolumes.Whole.reset();
  }
  this->Parts.clear();
  for (const std::vector<vtkShadowPart>* parts : partLists)
  {
    std::transform(parts->begin(), parts->end(), std::back_inserter(this->Parts),
      [](const vtkShadowPart& part) { return &part; });
  }
}

void vtkShadowMaskMaker::AddCasters(const Work& work, vtkShadowPlan& plan)
{
  this->Choices.resize(this->Parts.size());
  vtkNBufferForEachProp::RunAhead(
    this->Parts.size(), [this](vtkIdType i) { this->Parts[i]->Prefetch(); },
    [this, &plan](vtkIdType i) { this->Choices[i] = plan.Decide(*this->Parts[i]); },
    CastersPerThread);
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    plan.Draw(this->Choices[i], *this->Parts[i], work.LightVolumes.Store);
  }
}

vtkShadowPlan::View vtkShadowMaskMaker::GetWholeView(const Work& work) const
{
  vtkShadowPlan::View view = work.Camera.Plan;
  if (work.Settings.Mode == vtkShadowMode::Automatic &&
    work.GetLight().Kind == vtkShadowLightKind::Spot)
  {
    const vtkShadowReceiverProjector receivers(
      this->GetReceiverView(work), work.GetLight(), work.Space);
    view.ConeReach = receivers.GetConeReach().RoundedUp();
  }
  return view;
}

vtkShadowPlan& vtkShadowMaskMaker::PlanWhole(const Work& work, const vtkShadowPlan::View& view)
{
  Volumes& volumes = work.LightVolumes;
  const vtkMTimeType version = work.Casters.GetVersion();
  const vtkMTimeType time = volumes.Store.GetTime();
  if (!volumes.Whole || volumes.CastersVersion != version || volumes.StoreTime != time ||
    !volumes.Whole->SetView(view))
  {
    volumes.Whole.emplace(work.GetLight(), view, vtkShadowMode::Unclamped,
      std::vector<vtkShadowPlan::Face>(), work.Settings.Tuning);
    this->AddCasters(work, *volumes.Whole);
    volumes.CastersVersion = version;
    volumes.StoreTime = time;
  }
  return *volumes.Whole;
}

long long vtkShadowMaskMaker::EstimateCovered(const Work& work)
{
  const std::size_t samples = this->GetNumberOfSamples();
  if (!this->IsDepthRead && !this->Coverage.IsKnown(samples) && !this->ReadReceivers(work))
  {
    // This is no failure: with full coverage the light gets no litmaps, which alone need the depth.
    this->Error.clear();
    this->Coverage = { samples, samples };
  }
  return static_cast<long long>(this->Coverage.Covered);
}

void vtkShadowMaskMaker::MeasureCosts(const Work& work)
{
  const vtkNBufferClock clock;
  this->Costs.AreMeasured = true;
  work.Statistics.ReadBacks += vtkShadowCostMeasurement::Repetitions;
  std::string why; // An OpenGL call that fails will fail again when the mask is made.
  vtkShadowCostMeasurement::Measure(
    { work.Window, this->Target, this->Counter, work.GetLight(), work.MakeLitmapSpaces(),
      this->Parts, this->GetWholeView(work), this->GetReceiverView(work),
      work.Settings.Tuning.LitmapResolution },
    this->Costs, why);
  work.Statistics.MeasureTime += clock.GetMilliseconds();
}

bool vtkShadowMaskMaker::IsLitmapWorthIt(const Work& work, vtkShadowLightCost& cost)
{
  const int resolution = work.Settings.Tuning.LitmapResolution;
  vtkShadowCostModel::Litmaps litmaps = { static_cast<long long>(this->GetNumberOfSamples()), 0,
    resolution * resolution, work.GetLight().Kind == vtkShadowLightKind::Point ? 6 : 1 };
  const vtkShadowCostModel::Volumes& volumes = work.LightVolumes.Estimate.GetVolumes();
  if (this->Costs.IsMeasurementDue(this->Costs.Estimate(volumes)))
  {
    this->MeasureCosts(work);
  }
  cost.WholeEstimate = this->Costs.Estimate(volumes);
  const auto isWorthIt = [&](long long covered)
  {
    litmaps.Covered = covered;
    cost.LitmapEstimate = this->Costs.Estimate(litmaps);
    return vtkShadowCostModel::IsLitmapWorthIt(cost.WholeEstimate, cost.LitmapEstimate);
  };
  return isWorthIt(litmaps.Samples) || (isWorthIt(0) && isWorthIt(this->EstimateCovered(work)));
}

bool vtkShadowMaskMaker::Shade(const Work& work, vtkShadowLightCost& cost)
{
  vtkNBufferClock clock;
  const vtkShadowLight& light = work.GetLight();
  this->FindParts(work);
  const vtkShadowPlan::View view = this->GetWholeView(work);
  std::vector<vtkShadowLightSpace> spaces; // of litmaps
  vtkShadowPlan* plan = nullptr;
  std::optional<vtkShadowPlan> planByLitmaps;
  const bool automatic = work.Settings.Mode == vtkShadowMode::Automatic;
  vtkShadowVolumeStore& store = work.LightVolumes.Store;
  store.BeginFrame();
  bool isWhole = work.Settings.Mode == vtkShadowMode::Unclamped;
  bool isEstimated = false;
  if (automatic)
  {
    isEstimated = work.LightVolumes.Estimate.BeginFrame(
      this->Parts, light, view.ConeReach, this->GetNumberOfSamples());
    isWhole = !this->IsLitmapWorthIt(work, cost);
  }
  if (isWhole)
  {
    plan = &this->PlanWhole(work, view);
    if (automatic && !isEstimated)
    {
      work.LightVolumes.Estimate.Measure(store.GetVolume(), *plan, view);
      if (this->IsLitmapWorthIt(work, cost))
      {
        plan = nullptr;
      }
    }
  }
  work.Statistics.PlanTime += clock.Restart();
  if (plan)
  {
    ++work.Statistics.UnclampedLights;
  }
  else
  {
    spaces = work.MakeLitmapSpaces();
    cost.HasLitmaps = true;
    std::vector<vtkShadowPlan::Face> litmaps;
    if (!this->MakeLitmaps(work, spaces, litmaps))
    {
      return false;
    }
    clock.Restart();
    plan =
      &planByLitmaps.emplace(light, view, automatic ? vtkShadowMode::Scissored : work.Settings.Mode,
        std::move(litmaps), work.Settings.Tuning);
    this->AddCasters(work, *plan);
    work.Statistics.PlanTime += clock.Restart();
  }
  std::transform(plan->GetVerdicts().begin(), plan->GetVerdicts().end(),
    work.Statistics.Verdicts.begin(), work.Statistics.Verdicts.begin(), std::plus<int>());
  work.Statistics.Slabs += plan->GetNumberOfSlabs();
  work.Statistics.Pieces += store.GetNumberOfPiecesMade();
  work.Statistics.Triangles += plan->GetNumberOfTriangles();
  const bool done = plan->GetDraws().empty() || this->Count(work, *plan);
  work.Statistics.DrawTime += clock.GetMilliseconds();
  const vtkLight* pictured = work.Settings.PictureLight;
  if (done && (pictured ? pictured == work.Source.Source : work.Slot == 0))
  {
    const vtkShadowDebugView::Subject subject = { this->Litmaps.data(),
      static_cast<int>(spaces.size()), work.LightVolumes.Buffer, plan->GetDraws(), view };
    return work.DebugView.Make(
      work.Window, work.Settings.Picture, subject, this->Counter, work.Statistics, this->Error);
  }
  return done;
}

bool vtkShadowMaskMaker::Count(const Work& work, const vtkShadowPlan& plan)
{
  const vtkShadowTimers::Scope timed(work.Timers, vtkShadowStage::Draw);
  const std::vector<vtkShadowDraw>& draws = plan.GetDraws();
  vtkShadowStatistics& statistics = work.Statistics;
  ++this->Shadows;
  statistics.Boxes += static_cast<int>(draws.size());
  for (const vtkShadowDraw& draw : draws)
  {
    statistics.Draws += !draw.Again;
    statistics.ZPass += draw.ZPass && !draw.Again;
  }
  vtkShadowVolumeBuffer& volume = work.LightVolumes.Buffer;
  if (!volume.Upload(work.LightVolumes.Store, this->Error))
  {
    return false;
  }
  const int mask = vtkShadowTarget::GetMaskIndex(work.Slot);
  const int channel = vtkShadowTarget::GetChannel(work.Slot);
  // Each turn counts as many volumes as the stencil can hold if a receiver is inside of them all.
  const bool allAtOnce = plan.IsCountWithin(vtkShadowCaster::MaximumCount);
  const vtkShadowDraw* first = draws.data();
  const vtkShadowDraw* const end = first + draws.size();
  while (first != end)
  {
    int count = first->MaximumCount;
    const vtkShadowDraw* last = first + 1;
    while (last != end &&
      (allAtOnce || last->Again || count + last->MaximumCount <= vtkShadowCaster::MaximumCount))
    {
      count += last->Again ? 0 : last->MaximumCount;
      ++last;
    }
    this->Counter.ClearStencil(this->Target, this->Viewport);
    ++statistics.StencilClears;
    if (!this->Counter.Count(work.Window, this->Target, volume, work.Camera.Plan, first, last,
          work.Settings.Tuning.CountFragments ? &statistics.Fragments : nullptr, this->Error) ||
      !this->Counter.Resolve(work.Window, this->Target, mask, channel, this->Viewport, this->Error))
    {
      return false;
    }
    first = last;
  }
  return true;
}

void vtkShadowMaskMaker::Release()
{
  this->Counter.Release();
  this->LightVolumes.clear();
  if (this->LitmapSource)
  {
    this->LitmapSource->Release();
  }
  this->Target.Release();
  this->Costs = vtkShadowCostModel::Costs();
}
VTK_ABI_NAMESPACE_END
