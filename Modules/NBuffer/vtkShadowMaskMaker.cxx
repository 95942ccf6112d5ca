// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMaskMaker.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"
#include "vtkShadowFill.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <functional>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What a colour of NBufferShadowReceiver (vtkShadowLightDec.glsl) has room for.
constexpr std::size_t FilteredLights = 24;
constexpr std::size_t BytesPerSample = 4;

/// The faces of a cube around a point light.
std::vector<vtkShadowFrame> MakeFaces(const vtkShadowLight& light)
{
  std::vector<vtkShadowFrame> faces;
  for (int i = 0; i < 6; ++i)
  {
    double axis[3] = { 0.0, 0.0, 0.0 };
    axis[i / 2] = i % 2 ? -1.0 : 1.0;
    faces.emplace_back(light, axis);
  }
  return faces;
}
}

/// The view of a frame, in world coordinates relative to the eye.
struct vtkShadowMaskMaker::Camera
{
  explicit Camera(vtkRenderer* renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->GetPosition(this->Eye);
    camera->GetDirectionOfProjection(this->Plan.Direction);
    this->Plan.Parallel = camera->GetParallelProjection() != 0;
    // vtkCamera's composite matrix leaves the eyes' shear out.
    double worldToClip[16];
    vtkMatrix4x4::Multiply4x4(
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(),
      camera->GetModelViewTransformMatrix()->GetData(), worldToClip);
    for (int row = 0; row < 4; ++row)
    {
      const double* m = worldToClip + 4 * row;
      std::copy_n(m, 3, this->EyeToClip + 4 * row);
      this->EyeToClip[4 * row + 3] =
        m[0] * this->Eye[0] + m[1] * this->Eye[1] + m[2] * this->Eye[2] + m[3];
    }
    for (int i = 0; i < 4; ++i)
    {
      this->Plan.NearPlane[i] = this->EyeToClip[8 + i] + this->EyeToClip[12 + i];
    }
    this->SetNearBounds();
  }

  void SetNearBounds()
  {
    double clipToEye[16];
    vtkMatrix4x4::Invert(this->EyeToClip, clipToEye);
    for (int corner = 0; corner < 4; ++corner)
    {
      double x[4] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0, -1.0, 1.0 };
      vtkMatrix4x4::MultiplyPoint(clipToEye, x, x);
      for (int i = 0; i < 3; ++i)
      {
        const double place = this->Eye[i] + x[i] / x[3];
        double* bounds = this->NearBounds + 2 * i;
        bounds[0] = corner == 0 ? place : std::min(bounds[0], place);
        bounds[1] = corner == 0 ? place : std::max(bounds[1], place);
      }
    }
  }

  vtkShadowView GetView() const
  {
    vtkShadowView view;
    vtkMatrix4x4::Invert(this->EyeToClip, view.ClipToWorld);
    std::copy_n(this->Eye, 3, view.Origin);
    view.Width = this->Plan.Viewport[2];
    view.Height = this->Plan.Viewport[3];
    return view;
  }

  double Eye[3];
  double EyeToClip[16];
  double NearBounds[6]; ///< World, of the near plane's rectangle.
  vtkShadowPlan::View Plan;
};

/// One light of a frame.
struct vtkShadowMaskMaker::Work
{
  const vtkShadowLight& GetLight() const { return this->Source.Geometry; }
  int GetNumberOfFaces() const
  {
    return this->GetLight().Kind == vtkShadowLightKind::Point ? 6 : 1;
  }

  vtkOpenGLRenderWindow* Window;
  const Camera& View;
  const Settings& How;
  vtkShadowStatistics& Statistics;
  const vtkShadowLightSource& Source;
  std::size_t Slot;
  vtkShadowFrame Frame;
};

bool vtkShadowMaskMaker::Reserve(vtkRenderer* renderer, std::size_t lights, bool skipUnlitReceivers)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!vtkNBufferGL::HasVersion(3, 2))
  {
    this->Error = "The OpenGL context is older than 3.2. Update the driver or use Mesa's software "
                  "renderer.";
    return false;
  }
  glGetIntegerv(GL_VIEWPORT, this->Viewport);
  const int* viewport = this->Viewport;
  if (viewport[0] < 0 || viewport[1] < 0 || viewport[2] < 1 || viewport[3] < 1)
  {
    this->Error = "The viewport is empty or begins outside of the window. Move it inside.";
    return false;
  }
  this->SkipUnlit = skipUnlitReceivers;
  constexpr int each = vtkShadowTarget::LightsPerMask;
  const int masks = static_cast<int>(lights + each - 1) / each;
  return this->Target.Reserve(window, viewport[0] + viewport[2], viewport[1] + viewport[3], masks,
           vtkShadowTarget::GetBoundSamples(), this->Error) &&
    (!skipUnlitReceivers || this->Target.ReserveLit(window, this->Error));
}

void vtkShadowMaskMaker::BeginDepth(vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER,
    this->SkipUnlit ? this->Target.GetLitFramebuffer() : this->Target.GetDepthFramebuffer());
  state->vtkglDepthMask(GL_TRUE);
  const float farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (this->SkipUnlit)
  {
    const float litByAll[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
    glClearBufferfv(GL_COLOR, 0, litByAll);
  }
}

bool vtkShadowMaskMaker::ReadDepth(vtkOpenGLRenderWindow* window, vtkShadowStatistics& statistics)
{
  const vtkNBufferClock clock;
  ++statistics.ReadBacks;
  if (this->Target.IsMultisampled())
  {
    const std::size_t pixels = static_cast<std::size_t>(this->Viewport[2]) * this->Viewport[3];
    const std::size_t samples = this->Target.GetSamples().size();
    this->Depth.resize(samples * pixels);
    bool done = true;
    for (std::size_t i = 0; i < samples && done; ++i)
    {
      done = this->SampleReader.Read(window, this->Target.GetDepth()->GetHandle(),
        static_cast<int>(i), 0, this->Viewport, this->Depth.data() + i * pixels, this->Error);
    }
    statistics.ReadTime += clock.GetMilliseconds();
    return done;
  }
  int bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.GetDepthFramebuffer());
  vtkNBufferDepthSource source;
  const bool done = source.Inspect(window, this->Error) &&
    source.Read(window, this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3],
      this->Depth, this->Error);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
  statistics.ReadTime += clock.GetMilliseconds();
  return done;
}

bool vtkShadowMaskMaker::ReadLights(vtkOpenGLRenderWindow* window)
{
  const int* viewport = this->Viewport;
  const std::size_t pixels = static_cast<std::size_t>(viewport[2]) * viewport[3];
  const std::size_t samples = this->Target.GetSamples().size();
  this->LitBits.resize(BytesPerSample * samples * pixels);
  if (!this->Target.IsMultisampled())
  {
    vtkNBufferGL::ClearErrors();
    const vtkNBufferGL::ScopedReadback readback(this->Target.GetLitFramebuffer());
    glReadPixels(viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE,
      this->LitBits.data());
    return vtkNBufferGL::CheckErrors("Reading which lights receivers have", this->Error);
  }
  std::vector<float> values(pixels);
  for (std::size_t i = 0; i < samples; ++i)
  {
    for (int channel = 0; channel < static_cast<int>(FilteredLights) / 8; ++channel)
    {
      if (!this->SampleReader.Read(window, this->Target.GetLit()->GetHandle(), static_cast<int>(i),
            channel, viewport, values.data(), this->Error))
      {
        return false;
      }
      unsigned char* bits = this->LitBits.data() + BytesPerSample * i * pixels + channel;
      for (std::size_t k = 0; k < pixels; ++k)
      {
        bits[BytesPerSample * k] = static_cast<unsigned char>(255.0f * values[k] + 0.5f);
      }
    }
  }
  return true;
}

bool vtkShadowMaskMaker::IsUnlit(std::size_t slot, std::size_t sample) const
{
  return this->Filtered[slot] &&
    (this->LitBits[BytesPerSample * sample + slot / 8] >> slot % 8 & 1) == 0;
}

bool vtkShadowMaskMaker::ReadMask(
  vtkOpenGLRenderWindow* window, std::size_t slot, int sample, std::vector<unsigned char>& mask)
{
  constexpr std::size_t each = vtkShadowTarget::LightsPerMask;
  const int number = static_cast<int>(slot / each);
  const std::size_t channel = slot % each;
  const int* viewport = this->Viewport;
  mask.resize(static_cast<std::size_t>(viewport[2]) * viewport[3]);
  if (!this->Target.IsMultisampled())
  {
    std::vector<unsigned char> pixels(each * mask.size());
    vtkNBufferGL::ClearErrors();
    const vtkNBufferGL::ScopedReadback readback(this->Target.GetMaskFramebuffer(number));
    glReadPixels(
      viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      mask[i] = this->IsUnlit(slot, i) ? 255 : pixels[each * i + channel];
    }
    return vtkNBufferGL::CheckErrors("Reading a shadow mask", this->Error);
  }
  const int samples = static_cast<int>(this->Target.GetSamples().size());
  const int first = std::max(sample, 0);
  const int last = sample < 0 ? samples : sample + 1;
  std::vector<float> values(mask.size());
  std::vector<float> sums(mask.size(), 0.0f);
  for (int i = first; i < last; ++i)
  {
    if (!this->SampleReader.Read(window, this->Target.GetMask(number)->GetHandle(), i,
          static_cast<int>(channel), viewport, values.data(), this->Error))
    {
      return false;
    }
    for (std::size_t k = 0; k < mask.size(); ++k)
    {
      sums[k] += this->IsUnlit(slot, i * mask.size() + k) ? 1.0f : values[k];
    }
  }
  std::transform(sums.begin(), sums.end(), mask.begin(), [&](float sum)
    { return static_cast<unsigned char>(255.0f * sum / static_cast<float>(last - first) + 0.5f); });
  return true;
}

bool vtkShadowMaskMaker::Make(vtkRenderer* renderer,
  const std::vector<vtkShadowLightSource>& lights, const Settings& settings,
  vtkShadowStatistics& statistics)
{
  this->Shadows = 0;
  this->Error.clear();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->HasReceivers = false;
  this->Filtered.assign(lights.size(), false);
  Camera camera(renderer);
  std::copy_n(this->Viewport, 4, camera.Plan.Viewport);
  camera.Plan.Boxes = this->Target.GetSamples().size() <= 1 || !vtkNBufferGL::GetSoftwareRenderer();
  camera.Plan.BoxCost = settings.BoxCost;
  this->DebugView.Clear();
  const vtkShadowCounter::Scope scope(window, this->Viewport);
  for (int mask = 0; mask < this->Target.GetNumberOfMasks(); ++mask)
  {
    this->Counter.ClearMask(this->Target, mask, this->Viewport);
  }
  if (settings.CountFragments)
  {
    statistics.Fragments = 0;
  }
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const Work work = { window, camera, settings, statistics, lights[i], i,
      vtkShadowFrame(lights[i].Geometry) };
    if (!this->Shade(work))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowMaskMaker::ReadReceivers(const Work& work)
{
  if (this->HasReceivers)
  {
    return true;
  }
  if (!this->ReadDepth(work.Window, work.Statistics) ||
    (this->SkipUnlit && !this->ReadLights(work.Window)))
  {
    return false;
  }
  if (work.How.LitmapMethod == vtkShadowLitmapMethod::Rerendered)
  {
    this->Rerendered.Begin(work.View.Eye);
    for (const vtkShadowCaster* receiver : this->Receivers.GetCasters())
    {
      this->Rerendered.AddReceiver(
        receiver->GetPoints().data(), receiver->GetNumberOfPoints(), receiver->GetTriangles());
    }
    if (!this->Rerendered.Upload(work.Window, this->Depth.data(), work.View.GetView(), this->Error))
    {
      return false;
    }
  }
  this->HasReceivers = true;
  return true;
}

const unsigned char* vtkShadowMaskMaker::FindLit(const Work& work)
{
  if (!this->SkipUnlit || work.Slot >= FilteredLights ||
    work.How.LitmapMethod == vtkShadowLitmapMethod::Rerendered)
  {
    return nullptr;
  }
  this->Filtered[work.Slot] = true;
  this->Lit.resize(this->Depth.size());
  for (std::size_t i = 0; i < this->Lit.size(); ++i)
  {
    this->Lit[i] = !this->IsUnlit(work.Slot, i);
  }
  return this->Lit.data();
}

bool vtkShadowMaskMaker::MakeLitmaps(const Work& work, const std::vector<vtkShadowFrame>& frames)
{
  if (!this->ReadReceivers(work))
  {
    return false;
  }
  const vtkNBufferClock clock;
  const int resolution = work.How.Resolution;
  const unsigned char* lit = this->FindLit(work);
  vtkShadowView view = work.View.GetView();
  view.Samples = this->Target.GetSamples();
  this->Litmaps.resize(std::max(this->Litmaps.size(), frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    vtkShadowLitmap& litmap = this->Litmaps[i];
    if (work.How.LitmapMethod == vtkShadowLitmapMethod::Rerendered)
    {
      double range[4];
      double depths[2];
      vtkShadowReceivers::GetRange(
        this->Depth.data(), lit, view, work.GetLight(), frames[i], range, depths);
      if (!this->Rerendered.Draw(
            work.Window, frames[i], range, depths, resolution, litmap, this->Error))
      {
        return false;
      }
    }
    else
    {
      vtkShadowReceivers::Scatter(
        this->Depth.data(), lit, view, work.GetLight(), frames[i], resolution, litmap);
    }
    work.Statistics.Receivers += litmap.GetNumberOfReceivers();
    litmap.Build();
    ++work.Statistics.Litmaps;
  }
  work.Statistics.LitmapTime += clock.GetMilliseconds();
  return true;
}

template <typename Functor>
void vtkShadowMaskMaker::ForEachPart(const Work& work, Functor&& functor)
{
  for (vtkShadowCaster* caster : this->Casters.GetCasters())
  {
    for (const vtkShadowCaster::Part& part : caster->GetParts(work.Slot, work.GetLight(),
           work.Frame, work.View.NearBounds, work.Statistics.Silhouettes))
    {
      functor(*caster, part);
    }
  }
}

vtkShadowMaskMaker::Verdicts vtkShadowMaskMaker::AddCasters(const Work& work, vtkShadowPlan& plan)
{
  Verdicts verdicts = {};
  this->Volume.Begin(work.View.Eye);
  this->ForEachPart(work,
    [&](const vtkShadowCaster& caster, const vtkShadowCaster::Part& part)
    {
      const vtkShadowVerdict verdict =
        plan.Add(part.Silhouette, vtkShadowCaster::GetPoints(caster, part),
          part.Topology->GetNumberOfPoints(), part.Footprint, this->Volume);
      ++verdicts[static_cast<std::size_t>(verdict)];
    });
  return verdicts;
}

bool vtkShadowMaskMaker::DoLitmapsPay(const Work& work, double fragments, long long triangles) const
{
  const long long samples = static_cast<long long>(this->Target.GetSamples().size()) *
    this->Viewport[2] * this->Viewport[3];
  return vtkShadowFill::DoLitmapsPay(fragments, triangles, samples, work.GetNumberOfFaces(),
    vtkNBufferGL::GetSoftwareRenderer() != nullptr);
}

bool vtkShadowMaskMaker::DoLitmapsPay(const Work& work)
{
  const bool positional = work.GetLight().Kind != vtkShadowLightKind::Directional;
  long long triangles = 0;
  this->ForEachPart(work, [&](const vtkShadowCaster&, const vtkShadowCaster::Part& part)
    { triangles += vtkShadowFill::CountTriangles(part.Silhouette, positional); });
  return this->DoLitmapsPay(work, 0.0, triangles);
}

bool vtkShadowMaskMaker::Shade(const Work& work)
{
  vtkNBufferClock clock;
  const vtkShadowLight& light = work.GetLight();
  const vtkShadowPlan::View& view = work.View.Plan;
  std::vector<vtkShadowFrame> frames; // of litmaps
  std::optional<vtkShadowPlan> plan;
  Verdicts verdicts = {};
  const bool automatic = work.How.Mode == vtkShadowMode::Automatic;
  if (work.How.Mode == vtkShadowMode::Unclamped || (automatic && !this->DoLitmapsPay(work)))
  {
    plan.emplace(light, work.Frame, view, vtkShadowMode::Unclamped, nullptr);
    verdicts = this->AddCasters(work, *plan);
    if (automatic &&
      this->DoLitmapsPay(work,
        vtkShadowFill::EstimateFragments(
          this->Volume, work.View.EyeToClip, this->Viewport[2], this->Viewport[3]),
        static_cast<long long>(this->Volume.GetIndices().size() / 3)))
    {
      plan.reset();
    }
  }
  work.Statistics.PlanTime += clock.Restart();
  if (plan)
  {
    ++work.Statistics.UnclampedLights;
  }
  else
  {
    frames = light.Kind == vtkShadowLightKind::Point ? MakeFaces(light)
                                                     : std::vector<vtkShadowFrame>{ work.Frame };
    if (!this->MakeLitmaps(work, frames))
    {
      return false;
    }
    clock.Restart();
    const bool isOne = frames.size() == 1;
    plan.emplace(light, work.Frame, view, automatic ? vtkShadowMode::Exact : work.How.Mode,
      isOne ? this->Litmaps.data() : nullptr, work.How.SlabGap);
    for (std::size_t i = 0; !isOne && i < frames.size(); ++i)
    {
      plan->AddFace(frames[i], this->Litmaps[i]);
    }
    verdicts = this->AddCasters(work, *plan);
    work.Statistics.PlanTime += clock.Restart();
  }
  std::transform(verdicts.begin(), verdicts.end(), work.Statistics.Verdicts.begin(),
    work.Statistics.Verdicts.begin(), std::plus<int>());
  work.Statistics.Slabs += plan->GetNumberOfSlabs();
  work.Statistics.Triangles += static_cast<long long>(this->Volume.GetIndices().size() / 3);
  const bool done = plan->GetDraws().empty() || this->Count(work, *plan);
  work.Statistics.DrawTime += clock.GetMilliseconds();
  const vtkLight* pictured = work.How.PictureLight;
  if (done && (pictured ? pictured == work.Source.Source : work.Slot == 0))
  {
    const vtkShadowDebugView::Subject subject = { this->Litmaps.data(),
      static_cast<int>(frames.size()), plan->GetDraws(), work.View.EyeToClip, this->Viewport };
    return this->DebugView.Make(
      work.Window, work.How.Picture, subject, this->Counter, work.Statistics, this->Error);
  }
  return done;
}

bool vtkShadowMaskMaker::Count(const Work& work, const vtkShadowPlan& plan)
{
  const vtkShadowTimers::Scope timed(this->Timers, vtkShadowStage::Draw);
  const std::vector<vtkShadowDraw>& draws = plan.GetDraws();
  vtkShadowStatistics& statistics = work.Statistics;
  ++this->Shadows;
  statistics.Boxes += static_cast<int>(draws.size());
  statistics.Draws += static_cast<int>(std::count_if(
    draws.begin(), draws.end(), [](const vtkShadowDraw& draw) { return !draw.Again; }));
  statistics.ZPass += static_cast<int>(std::count_if(draws.begin(), draws.end(),
    [](const vtkShadowDraw& draw) { return draw.ZPass && !draw.Again; }));
  if (!this->Counter.Upload(this->Volume, this->Error))
  {
    return false;
  }
  constexpr std::size_t each = vtkShadowTarget::LightsPerMask;
  const int mask = static_cast<int>(work.Slot / each);
  const int channel = static_cast<int>(work.Slot % each);
  // As many volumes at a time as the stencil can count, should a receiver be in all of them.
  const bool allAtOnce = plan.IsCountBelow(vtkShadowCaster::MaximumCount);
  const vtkShadowDraw* first = draws.data();
  const vtkShadowDraw* const end = first + draws.size();
  while (first != end)
  {
    int count = first->MaximumCount;
    int start = first->Start;
    const vtkShadowDraw* last = first + 1;
    while (last != end &&
      (allAtOnce || last->Again || count + last->MaximumCount <= vtkShadowCaster::MaximumCount))
    {
      count += last->Again ? 0 : last->MaximumCount;
      start += last->Start;
      ++last;
    }
    this->Counter.ClearStencil(this->Target, this->Viewport, start);
    if (!this->Counter.Count(work.Window, this->Target, work.View.EyeToClip, first, last,
          work.How.CountFragments ? &statistics.Fragments : nullptr, this->Error) ||
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
  this->Rerendered.Release();
  this->Timers.Release();
  this->DebugView.Release();
  this->Target.Release();
  this->SampleReader.Release();
}
VTK_ABI_NAMESPACE_END
