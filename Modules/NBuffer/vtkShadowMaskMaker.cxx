// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMaskMaker.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthSource.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <functional>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
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

bool vtkShadowMaskMaker::Reserve(vtkRenderer* renderer, std::size_t lights)
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
  constexpr int each = vtkShadowTarget::LightsPerMask;
  const int masks = static_cast<int>(lights + each - 1) / each;
  return this->Target.Reserve(window, viewport[0] + viewport[2], viewport[1] + viewport[3], masks,
    vtkShadowTarget::GetBoundSamples(), this->Error);
}

void vtkShadowMaskMaker::BeginDepth(vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Target.GetDepthFramebuffer());
  state->vtkglDepthMask(GL_TRUE);
  const float farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
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
      mask[i] = pixels[each * i + channel];
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
    std::transform(sums.begin(), sums.end(), values.begin(), sums.begin(), std::plus<float>());
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
  if (settings.Mode != vtkShadowMode::Unclamped && !this->ReadDepth(window, statistics))
  {
    return false;
  }
  Camera camera(renderer);
  std::copy_n(this->Viewport, 4, camera.Plan.Viewport);
  camera.Plan.Boxes = this->Target.GetSamples().size() <= 1 || !vtkNBufferGL::GetSoftwareRenderer();
  this->DebugView.Clear();
  if (settings.Mode != vtkShadowMode::Unclamped &&
    settings.LitmapMethod == vtkShadowLitmapMethod::Rerendered &&
    !this->UploadReceivers(window, camera))
  {
    return false;
  }
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
    if (!this->Shade(window, lights[i], i, camera, settings, statistics))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowMaskMaker::UploadReceivers(vtkOpenGLRenderWindow* window, const Camera& camera)
{
  this->Rerendered.Begin(camera.Eye);
  for (const vtkShadowCaster* receiver : this->Receivers.GetCasters())
  {
    this->Rerendered.AddReceiver(
      receiver->GetPoints().data(), receiver->GetNumberOfPoints(), receiver->GetTriangles());
  }
  return this->Rerendered.Upload(window, this->Depth.data(), camera.GetView(), this->Error);
}

bool vtkShadowMaskMaker::MakeLitmaps(vtkOpenGLRenderWindow* window, const vtkShadowLight& light,
  const std::vector<vtkShadowFrame>& frames, const Camera& camera, const Settings& settings,
  vtkShadowStatistics& statistics)
{
  vtkShadowView view = camera.GetView();
  view.Samples = this->Target.GetSamples();
  this->Litmaps.resize(std::max(this->Litmaps.size(), frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    vtkShadowLitmap& litmap = this->Litmaps[i];
    if (settings.LitmapMethod == vtkShadowLitmapMethod::Rerendered)
    {
      double range[4];
      double depths[2];
      vtkShadowReceivers::GetRange(
        this->Depth.data(), nullptr, view, light, frames[i], range, depths);
      if (!this->Rerendered.Draw(
            window, frames[i], range, depths, settings.Resolution, litmap, this->Error))
      {
        return false;
      }
    }
    else
    {
      vtkShadowReceivers::Scatter(
        this->Depth.data(), nullptr, view, light, frames[i], settings.Resolution, litmap);
    }
    statistics.Receivers += litmap.GetNumberOfReceivers();
    litmap.Build();
    ++statistics.Litmaps;
  }
  return true;
}

bool vtkShadowMaskMaker::Shade(vtkOpenGLRenderWindow* window, const vtkShadowLightSource& light,
  std::size_t slot, const Camera& camera, const Settings& settings, vtkShadowStatistics& statistics)
{
  vtkNBufferClock clock;
  const vtkShadowLight& geometry = light.Geometry;
  const vtkShadowFrame frame(geometry);
  // What the rays of the plan's litmaps go round: the light's axis, or those of a cube.
  std::vector<vtkShadowFrame> frames;
  if (settings.Mode != vtkShadowMode::Unclamped)
  {
    frames = geometry.Kind == vtkShadowLightKind::Point ? MakeFaces(geometry)
                                                        : std::vector<vtkShadowFrame>{ frame };
    if (!this->MakeLitmaps(window, geometry, frames, camera, settings, statistics))
    {
      return false;
    }
    statistics.LitmapTime += clock.Restart();
  }
  vtkShadowPlan plan(geometry, frame, camera.Plan, settings.Mode,
    frames.size() == 1 ? this->Litmaps.data() : nullptr, settings.SlabGap);
  for (std::size_t i = 0; frames.size() > 1 && i < frames.size(); ++i)
  {
    plan.AddFace(frames[i], this->Litmaps[i]);
  }
  this->Volume.Begin(camera.Eye);
  for (vtkShadowCaster* caster : this->Casters.GetCasters())
  {
    for (const vtkShadowCaster::Part& part :
      caster->GetParts(slot, geometry, frame, camera.NearBounds, statistics.Silhouettes))
    {
      const vtkShadowVerdict verdict =
        plan.Add(part.Silhouette, vtkShadowCaster::GetPoints(*caster, part),
          part.Topology->GetNumberOfPoints(), part.Footprint, this->Volume);
      ++statistics.Verdicts[static_cast<int>(verdict)];
    }
  }
  statistics.Slabs += plan.GetNumberOfSlabs();
  statistics.Triangles += static_cast<long long>(this->Volume.GetIndices().size() / 3);
  statistics.PlanTime += clock.Restart();
  const bool done = plan.GetDraws().empty() ||
    this->Count(window, plan, slot, camera, settings.CountFragments, statistics);
  statistics.DrawTime += clock.GetMilliseconds();
  if (done && (settings.PictureLight ? settings.PictureLight == light.Source : slot == 0))
  {
    const vtkShadowDebugView::Subject subject = { this->Litmaps.data(),
      static_cast<int>(frames.size()), plan.GetDraws(), camera.EyeToClip, this->Viewport };
    return this->DebugView.Make(
      window, settings.Picture, subject, this->Counter, statistics, this->Error);
  }
  return done;
}

bool vtkShadowMaskMaker::Count(vtkOpenGLRenderWindow* window, const vtkShadowPlan& plan,
  std::size_t slot, const Camera& camera, bool countFragments, vtkShadowStatistics& statistics)
{
  const vtkShadowTimers::Scope timed(this->Timers, vtkShadowStage::Draw);
  const std::vector<vtkShadowDraw>& draws = plan.GetDraws();
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
  constexpr int each = vtkShadowTarget::LightsPerMask;
  const int mask = static_cast<int>(slot) / each;
  const int channel = static_cast<int>(slot) % each;
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
    if (!this->Counter.Count(window, this->Target, camera.EyeToClip, first, last,
          countFragments ? &statistics.Fragments : nullptr, this->Error) ||
      !this->Counter.Resolve(window, this->Target, mask, channel, this->Viewport, this->Error))
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
