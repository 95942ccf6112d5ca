// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowOpaqueStage.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferPropertyKeys.h"
#include "vtkShadowLightList.h"

#include "vtkActor2D.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkShadowOpaqueStage::vtkShadowOpaqueStage(vtkOpenGLRenderPass* pass)
  : Pass(pass)
  , ResourceCallback(new Callback(this, &vtkShadowOpaqueStage::ReleaseObjects))
{
}

vtkShadowOpaqueStage::~vtkShadowOpaqueStage()
{
  this->ResourceCallback->Release();
}

int vtkShadowOpaqueStage::Render(const vtkRenderState* state, const Settings& settings)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShadowStatistics& statistics = this->Statistics;
  const vtkShadowStatistics before = std::exchange(statistics, {});
  statistics.FailedFrames = before.FailedFrames;
  statistics.PixelFrames = before.PixelFrames;
  this->Shading.SetLights({});
  const std::vector<vtkShadowLightSource> lights =
    vtkShadowLightSource::Find(renderer, settings.DoesLightCast);
  statistics.Lights = static_cast<int>(lights.size());
  if (lights.empty() || !window)
  {
    return this->DrawPlain(state, vtkShadowDecision::NoLight);
  }
  glm::ivec2 size;
  glm::ivec2 origin;
  renderer->GetTiledSizeAndOrigin(&size.x, &size.y, &origin.x, &origin.y);
  if (size.x < 1 || size.y < 1)
  {
    return this->DrawPlain(state, vtkShadowDecision::NoReceiver);
  }
  const vtkNBufferClock clock;
  this->Casters.Update(renderer, settings.CasterKeys);
  statistics.Casters = static_cast<int>(this->Casters.GetCasters().size());
  statistics.Skipped = this->Casters.GetSkipped();
  statistics.Updates = this->Casters.GetNumberOfUpdates();
  statistics.CasterTime = clock.GetMilliseconds();
  if (statistics.Casters == 0)
  {
    return this->DrawPlain(state, vtkShadowDecision::NoCaster);
  }

  this->UseContext(window);
  this->Timers.Begin(settings.Masks.Tuning.MeasureDeviceTime);
  statistics.DeviceTimes = this->Timers.GetTimes();
  const vtkShadowFrameKey key(state, lights, this->Casters, settings.Time);
  const bool still =
    statistics.Updates == 0 && !settings.Masks.Tuning.CountFragments && key == this->Key;
  bool done = still || this->Masks.Reserve(window, lights.size());
  if (done && this->GetTarget().HasRefusedSamples())
  {
    ++statistics.PixelFrames;
    this->WarnOnce(this->HasWarnedOfSamples,
      "Shadows have one sample for each pixel. " + this->Masks.GetError());
  }
  statistics.Samples = static_cast<int>(this->GetTarget().GetSamples().size());
  this->Shading.SetUp(lights, statistics.Samples);
  // The shaders that will draw the colour also draw the depth, so that both have the same depth to
  // the bit, and no mapper has to build its shaders twice.
  this->JoinProps(state);
  std::optional<vtkNBufferGL::Scope> leave(std::in_place);
  leave->AtEnd([&] { this->LeaveProps(state); });
  if (!still)
  {
    this->Key = vtkShadowFrameKey();
    done = done && this->MakeMasks(state, settings, lights);
  }
  if (done && this->Masks.GetNumberOfShadows() > 0)
  {
    this->Shading.SetLights(lights);
    const vtkShadowTimers::Scope timed(this->Timers, vtkShadowStage::Color);
    this->Draw(state, vtkShadowShading::Purpose::Color);
    leave.reset();
    statistics.Decision = still ? vtkShadowDecision::Still : vtkShadowDecision::Drawn;
  }
  else
  {
    leave.reset();
    if (!done && !window->GetAbortRender())
    {
      ++statistics.FailedFrames;
      this->WarnOnce(this->HasWarned, "Drawn without shadows. " + this->Masks.GetError());
      this->DebugView.Clear();
    }
    const vtkShadowTimers::Scope timed(this->Timers, vtkShadowStage::Color);
    this->DrawPlain(state, done ? vtkShadowDecision::NoReceiver : vtkShadowDecision::Failed);
  }
  std::string why;
  if (!this->DebugView.Show(window, this->Statistics, why))
  {
    this->WarnOnce(this->HasWarnedOfDebugView, "Drawn without a debug view. " + why);
  }
  this->Key = done ? key : vtkShadowFrameKey();
  return this->Opaque->GetNumberOfRenderedProps();
}

int vtkShadowOpaqueStage::DrawPlain(const vtkRenderState* state, vtkShadowDecision decision)
{
  this->Statistics.Decision = decision;
  this->Opaque->Render(state);
  return this->Opaque->GetNumberOfRenderedProps();
}

bool vtkShadowOpaqueStage::MakeMasks(const vtkRenderState* state, const Settings& settings,
  const std::vector<vtkShadowLightSource>& lights)
{
  const vtkNBufferClock clock;
  // Labels may read the depth of the window while they are drawn (vtkNBufferDrawOrder.h), in which
  // nothing has been drawn yet. No 2-D actor receives shadows.
  std::vector<vtkProp*> props;
  std::copy_if(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount(),
    std::back_inserter(props), [](vtkProp* prop) { return !vtkActor2D::SafeDownCast(prop); });
  vtkRenderState receivers(state->GetRenderer());
  receivers.SetFrameBuffer(state->GetFrameBuffer());
  receivers.SetRequiredKeys(state->GetRequiredKeys());
  receivers.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  {
    vtkOpenGLState* gl = this->Window->GetState();
    gl->PushFramebufferBindings();
    vtkNBufferGL::Scope pop;
    pop.AtEnd([gl] { gl->PopFramebufferBindings(); });
    gl->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->GetTarget().GetDepthFramebuffer());
    gl->vtkglDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &vtkNBufferDepthConvention::Background);
    const vtkShadowTimers::Scope timed(this->Timers, vtkShadowStage::Depth);
    this->Draw(&receivers, vtkShadowShading::Purpose::Depth);
  }
  this->Statistics.DepthTime = clock.GetMilliseconds();
  // In a frame that is aborted, mappers leave out receivers.
  return !this->Window->GetAbortRender() &&
    this->Masks.Make({ settings.Masks, state->GetRenderer(), lights, this->Casters, this->Timers,
      this->DebugView, this->Statistics });
}

void vtkShadowOpaqueStage::Draw(const vtkRenderState* state, vtkShadowShading::Purpose purpose)
{
  const vtkShadowShading::Scope scope(this->Shading, this->Window, this->GetTarget(), purpose);
  this->Opaque->Render(state);
}

void vtkShadowOpaqueStage::JoinProps(const vtkRenderState* state)
{
  // vtkOpenGLRenderPass::PreRender() does the same, but once for each prop: where props share their
  // property keys, the pass would be among them several times.
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkNBufferPropertyKeys::AddPass(
      vtkNBufferPropertyKeys::Get(state->GetPropArray()[i]), this->Pass);
  }
}

void vtkShadowOpaqueStage::LeaveProps(const vtkRenderState* state)
{
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkNBufferPropertyKeys::RemovePass(state->GetPropArray()[i]->GetPropertyKeys(), this->Pass);
  }
}

void vtkShadowOpaqueStage::WarnOnce(bool& hasWarned, const std::string& what)
{
  if (!hasWarned)
  {
    hasWarned = true;
    vtkWarningWithObjectMacro(this->Pass, << what);
  }
}

std::vector<unsigned char> vtkShadowOpaqueStage::ReadMask(
  vtkLight* light, int sample, int& width, int& height, std::string& why)
{
  width = height = 0;
  const std::vector<vtkShadowLightSource>& lights = this->Shading.GetLights();
  const auto found = std::find_if(lights.begin(), lights.end(),
    [light](const vtkShadowLightSource& source) { return source.Source == light; });
  const auto slot = static_cast<std::size_t>(found - lights.begin());
  const int* viewport = this->Masks.GetViewport();
  std::vector<unsigned char> mask;
  if (found == lights.end() || sample >= this->Statistics.Samples ||
    !this->Masks.GetTarget().ReadMask(this->Window, viewport, slot, sample, mask, why))
  {
    return {};
  }
  width = viewport[2];
  height = viewport[3];
  return mask;
}

const vtkShadowDebugView* vtkShadowOpaqueStage::GetDebugView() const
{
  const bool isShown = this->Statistics.DebugDraws > 0 && !this->DebugView.GetImage().empty();
  return isShown ? &this->DebugView : nullptr;
}

void vtkShadowOpaqueStage::UseContext(vtkOpenGLRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  // This releases what another window holds, in that window's context.
  this->ResourceCallback->RegisterGraphicsResources(window);
  this->Window = window;
  window->MakeCurrent();
}

void vtkShadowOpaqueStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Opaque->ReleaseGraphicsResources(window);
  // VTK also calls this for a window that is about to get its context.
  if (!window || window == this->Window)
  {
    this->ResourceCallback->Release();
  }
}

void vtkShadowOpaqueStage::ReleaseObjects(vtkWindow* window)
{
  this->Masks.Release();
  this->Timers.Release();
  this->DebugView.Release();
  if (auto* other = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    // OSMesa changes both when a context is made current, and vtkOpenGLState does not notice.
    other->GetState()->ResetGLViewportState();
    other->GetState()->ResetGLScissorState();
  }
  this->Shading.SetLights({});
  this->Key = vtkShadowFrameKey();
  this->Window = nullptr;
}

VTK_ABI_NAMESPACE_END
