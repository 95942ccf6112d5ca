// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeClampPass.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferResourceCallback.h"
#include "vtkShadowFrameKey.h"
#include "vtkShadowLightDec.h"
#include "vtkShadowMaskMaker.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

/// The opaque stage of the steps, which is the pass itself.
class vtkShadowVolumeClampPass::OpaqueStage : public vtkRenderPass
{
public:
  static OpaqueStage* New();
  vtkTypeMacro(OpaqueStage, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->NumberOfRenderedProps = 0;
    if (this->Owner)
    {
      this->Owner->RenderOpaque(s);
      this->NumberOfRenderedProps = this->Owner->NumberOfRenderedProps;
    }
  }

  vtkShadowVolumeClampPass* Owner = nullptr;
};

vtkStandardNewMacro(vtkShadowVolumeClampPass);
vtkStandardNewMacro(vtkShadowVolumeClampPass::OpaqueStage);

class vtkShadowVolumeClampPass::Internals
{
public:
  using Callback = vtkOpenGLResourceFreeCallback<vtkShadowVolumeClampPass>;

  explicit Internals(vtkShadowVolumeClampPass* self)
    : ResourceCallback(new Callback(self, &vtkShadowVolumeClampPass::ReleaseGraphicsResources))
  {
    this->Stage->Owner = self;
    this->Steps->SetOpaquePass(this->Stage);
  }
  ~Internals() { this->Stage->Owner = nullptr; }

  void UseContext(vtkOpenGLRenderWindow* window);
  void SetShaderLights(const std::vector<vtkShadowLightSource>& lights);
  std::string GetDeclaration() const;

  vtkNew<OpaqueStage> Stage;
  vtkNew<vtkRenderStepsPass> Steps;
  vtkNew<vtkOpaquePass> Opaque;
  std::vector<vtkWeakPointer<vtkLight>> Excluded;
  vtkSmartPointer<vtkInformation> CasterKeys;
  vtkWeakPointer<vtkLight> DebugLight;
  vtkShadowMaskMaker Masks;
  vtkShadowStatistics Statistics;
  std::vector<vtkShadowLightSource> Lights; ///< Of the masks.
  std::vector<int> ShaderLights;            ///< Numbers of the lights that the shaders know.
  vtkTimeStamp ShaderTime;
  std::vector<int> TextureUnits;
  vtkShadowFrameKey Key; ///< Of the masks.
  int FailedFrames = 0;
  bool HasWarned = false;
  bool HasWarnedOfShader = false;
  vtkOpenGLRenderWindow* Window = nullptr; ///< Registered with; it says when it goes.
  std::unique_ptr<Callback> ResourceCallback;
};

void vtkShadowVolumeClampPass::Internals::UseContext(vtkOpenGLRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  // What another window holds is released by this, in its context.
  this->ResourceCallback->RegisterGraphicsResources(window);
  this->Window = window;
  window->MakeCurrent();
}

void vtkShadowVolumeClampPass::Internals::SetShaderLights(
  const std::vector<vtkShadowLightSource>& lights)
{
  std::vector<int> numbers;
  for (const vtkShadowLightSource& light : lights)
  {
    numbers.push_back(light.Number);
  }
  if (numbers != this->ShaderLights)
  {
    this->ShaderLights = numbers;
    this->ShaderTime.Modified();
  }
}

std::string vtkShadowVolumeClampPass::Internals::GetDeclaration() const
{
  const int lights = static_cast<int>(this->ShaderLights.size());
  constexpr int each = vtkShadowTarget::LightsPerMask;
  return "#define NBUFFER_SHADOW_LIGHTS " + std::to_string(lights) +
    "\n#define NBUFFER_SHADOW_MASKS " + std::to_string((lights + each - 1) / each) + "\n" +
    vtkShadowLightDec;
}

vtkShadowVolumeClampPass::vtkShadowVolumeClampPass()
  : Implementation(new Internals(this))
{
}

vtkShadowVolumeClampPass::~vtkShadowVolumeClampPass()
{
  this->Implementation->ResourceCallback->Release();
}

void vtkShadowVolumeClampPass::SetLightCasts(vtkLight* light, bool casts)
{
  if (!light || casts == this->GetLightCasts(light))
  {
    return;
  }
  std::vector<vtkWeakPointer<vtkLight>>& excluded = this->Implementation->Excluded;
  excluded.erase(std::remove_if(excluded.begin(), excluded.end(),
                   [light](vtkLight* other) { return !other || other == light; }),
    excluded.end());
  if (!casts)
  {
    excluded.emplace_back(light);
  }
  this->Modified();
}

bool vtkShadowVolumeClampPass::GetLightCasts(vtkLight* light) const
{
  const std::vector<vtkWeakPointer<vtkLight>>& excluded = this->Implementation->Excluded;
  return std::find(excluded.begin(), excluded.end(), light) == excluded.end();
}

void vtkShadowVolumeClampPass::SetCasterKeys(vtkInformation* keys)
{
  if (this->Implementation->CasterKeys != keys)
  {
    this->Implementation->CasterKeys = keys;
    this->Modified();
  }
}

vtkInformation* vtkShadowVolumeClampPass::GetCasterKeys()
{
  return this->Implementation->CasterKeys;
}

void vtkShadowVolumeClampPass::SetDebugLight(vtkLight* light)
{
  if (this->Implementation->DebugLight != light)
  {
    this->Implementation->DebugLight = light;
    this->Modified();
  }
}

vtkLight* vtkShadowVolumeClampPass::GetDebugLight()
{
  return this->Implementation->DebugLight;
}

vtkRenderStepsPass* vtkShadowVolumeClampPass::GetSteps()
{
  return this->Implementation->Steps;
}

const vtkShadowStatistics& vtkShadowVolumeClampPass::GetStatistics() const
{
  return this->Implementation->Statistics;
}

//------------------------------------------------------------------------------------------------
void vtkShadowVolumeClampPass::Render(const vtkRenderState* s)
{
  if (s->GetRenderer()->GetPass() == this)
  {
    this->Implementation->Steps->Render(s);
    this->NumberOfRenderedProps = this->Implementation->Steps->GetNumberOfRenderedProps();
    return;
  }
  this->RenderOpaque(s);
}

void vtkShadowVolumeClampPass::RenderOpaque(const vtkRenderState* s)
{
  Internals& self = *this->Implementation;
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkShadowStatistics statistics;
  statistics.FailedFrames = self.FailedFrames;
  self.Lights.clear();
  std::vector<vtkShadowLightSource> lights = vtkShadowLightSource::Find(
    renderer, [this](vtkLight* light) { return this->GetLightCasts(light); });
  statistics.Lights = static_cast<int>(lights.size());
  const auto drawPlain = [&](vtkShadowDecision decision)
  {
    statistics.Decision = decision;
    self.Opaque->Render(s);
    this->NumberOfRenderedProps = self.Opaque->GetNumberOfRenderedProps();
    self.Statistics = statistics;
  };
  if (lights.empty() || !window)
  {
    drawPlain(vtkShadowDecision::NoLight);
    return;
  }
  vtkNBufferClock clock;
  self.Masks.Casters.Update(renderer, self.CasterKeys);
  statistics.Casters = static_cast<int>(self.Masks.Casters.GetCasters().size());
  statistics.Skipped = self.Masks.Casters.GetSkipped();
  statistics.Updates = self.Masks.Casters.GetNumberOfUpdates();
  statistics.CasterTime = clock.Restart();
  if (statistics.Casters == 0)
  {
    drawPlain(vtkShadowDecision::NoCaster);
    return;
  }

  self.UseContext(window);
  self.Masks.Timers.Begin(this->MeasureDeviceTime);
  statistics.DeviceTimes = self.Masks.Timers.GetTimes();
  self.SetShaderLights(lights);
  const vtkShadowFrameKey key(s, lights, self.Masks.Casters, this->GetMTime());
  const bool still = statistics.Updates == 0 && !this->CountFragments && key == self.Key;
  bool done = true;
  // The depth is drawn by the shaders that will draw the colour: it is the same to the bit, and no
  // mapper has to rebuild one.
  this->PreRender(s);
  if (!still)
  {
    self.Key = vtkShadowFrameKey();
    done = this->MakeMasks(s, lights, statistics);
  }
  if (!done || self.Masks.GetNumberOfShadows() == 0)
  {
    this->PostRender(s);
    if (!done)
    {
      statistics.FailedFrames = ++self.FailedFrames;
      this->Warn("Drawn without shadows. " + self.Masks.GetError());
      self.Masks.DebugView.Clear();
    }
    {
      const vtkShadowTimers::Scope timed(self.Masks.Timers, vtkShadowStage::Color);
      drawPlain(done ? vtkShadowDecision::NoReceiver : vtkShadowDecision::Failed);
    }
    this->ShowDebugView(window, self.Statistics);
    self.Key = done ? key : vtkShadowFrameKey();
    return;
  }
  self.Lights = lights;
  this->DrawOpaque(s, vtkShadowStage::Color);
  this->PostRender(s);
  this->ShowDebugView(window, statistics);
  self.Key = key;
  statistics.Decision = still ? vtkShadowDecision::Still : vtkShadowDecision::Drawn;
  self.Statistics = statistics;
}

bool vtkShadowVolumeClampPass::MakeMasks(const vtkRenderState* s,
  const std::vector<vtkShadowLightSource>& lights, vtkShadowStatistics& statistics)
{
  Internals& self = *this->Implementation;
  vtkRenderer* renderer = s->GetRenderer();
  vtkNBufferClock clock;
  if (this->LitmapMethod == Rerendered && this->Mode != Unclamped)
  {
    self.Masks.Receivers.Update(renderer, nullptr);
    statistics.CasterTime += clock.Restart();
  }
  if (!self.Masks.BeginDepth(renderer, lights.size()))
  {
    return false;
  }
  // With the masks of the last frame bound: their samplers must not share a unit with textures of
  // another kind (buffers of edges or cell data), or OpenGL draws nothing.
  self.TextureUnits.assign(self.Masks.GetTarget().GetNumberOfMasks(), 0);
  this->DrawOpaque(s, vtkShadowStage::Depth);
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->PopFramebufferBindings();
  statistics.DepthTime = clock.GetMilliseconds();
  vtkShadowMaskMaker::Settings settings;
  settings.Mode = static_cast<vtkShadowMode>(this->Mode);
  settings.Resolution = this->LitmapResolution;
  settings.SlabGap = this->SlabGap;
  settings.CountFragments = this->CountFragments;
  settings.LitmapMethod = static_cast<vtkShadowLitmapMethod>(this->LitmapMethod);
  settings.Picture = static_cast<vtkShadowPicture>(this->DebugView);
  settings.PictureLight = self.DebugLight;
  return self.Masks.Make(renderer, lights, settings, statistics);
}

void vtkShadowVolumeClampPass::DrawOpaque(const vtkRenderState* s, vtkShadowStage stage)
{
  Internals& self = *this->Implementation;
  const vtkShadowTarget& target = self.Masks.GetTarget();
  for (int i = 0; i < target.GetNumberOfMasks(); ++i)
  {
    target.GetMask(i)->Activate();
    self.TextureUnits[i] = target.GetMask(i)->GetTextureUnit();
  }
  {
    const vtkShadowTimers::Scope timed(self.Masks.Timers, stage);
    self.Opaque->Render(s);
  }
  this->NumberOfRenderedProps = self.Opaque->GetNumberOfRenderedProps();
  for (int i = 0; i < target.GetNumberOfMasks(); ++i)
  {
    target.GetMask(i)->Deactivate();
  }
}

void vtkShadowVolumeClampPass::ShowDebugView(
  vtkOpenGLRenderWindow* window, vtkShadowStatistics& statistics)
{
  std::string why;
  if (!this->Implementation->Masks.DebugView.Show(window, statistics, why))
  {
    this->Warn("Drawn without a debug view. " + why);
  }
}

void vtkShadowVolumeClampPass::Warn(const std::string& what)
{
  if (!this->Implementation->HasWarned)
  {
    this->Implementation->HasWarned = true;
    vtkWarningMacro(<< what);
  }
}

//------------------------------------------------------------------------------------------------
bool vtkShadowVolumeClampPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  // Props that share their property keys hand a pass on once for each.
  if (fragmentShader.find("NBUFFER_SHADOW_LIGHTS") != std::string::npos)
  {
    return true;
  }
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Dec",
    this->Implementation->GetDeclaration() + "//VTK::Light::Dec", false);
  return true;
}

bool vtkShadowVolumeClampPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  Internals& self = *this->Implementation;
  for (std::size_t i = 0; i < self.ShaderLights.size(); ++i)
  {
    const std::string color = "lightColor" + std::to_string(self.ShaderLights[i]);
    constexpr std::size_t each = vtkShadowTarget::LightsPerMask;
    const std::string share = "NBUFFER_SHADOW_SHARE(" + std::to_string(i) + ", " +
      std::to_string(i / each) + ", " + std::to_string(i % each) + ")";
    bool replaced = fragmentShader.find(share) != std::string::npos;
    if (replaced)
    {
      continue;
    }
    const auto replace = [&](const std::string& before, const std::string& after)
    {
      const std::string old = before + color + after;
      replaced = vtkShaderProgram::Substitute(
                   fragmentShader, old, before + share + " * " + color + after, true) ||
        replaced;
    };
    replace("diffuse += (df * ", ");");
    replace("specular += (sf * ", ");");
    replace("radiance = ", ";");
    replace("radiance = ", " * attenuation;"); // positional lights before VTK 9.5
    const bool used = fragmentShader.find("* " + color) != std::string::npos ||
      fragmentShader.find("= " + color) != std::string::npos;
    if (!replaced && used && !self.HasWarnedOfShader)
    {
      self.HasWarnedOfShader = true;
      vtkErrorMacro(<< "A mapper's shader has lighting that this pass does not know, so that its "
                       "props receive no shadows. Use VTK's own lighting code, or report the "
                       "version of VTK.");
    }
  }
  return true;
}

bool vtkShadowVolumeClampPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  Internals& self = *this->Implementation;
  if (program->IsUniformUsed("shadowMasks"))
  {
    program->SetUniform1iv(
      "shadowMasks", static_cast<int>(self.TextureUnits.size()), self.TextureUnits.data());
  }
  if (program->IsUniformUsed("shadowAttenuations"))
  {
    std::vector<float> attenuations(self.ShaderLights.size(), 0.0f);
    for (std::size_t i = 0; i < self.Lights.size(); ++i)
    {
      attenuations[i] = self.Lights[i].Attenuation;
    }
    program->SetUniform1fv(
      "shadowAttenuations", static_cast<int>(attenuations.size()), attenuations.data());
  }
  return true;
}

vtkMTimeType vtkShadowVolumeClampPass::GetShaderStageMTime()
{
  return this->Implementation->ShaderTime.GetMTime();
}

//------------------------------------------------------------------------------------------------
std::vector<unsigned char> vtkShadowVolumeClampPass::GetMask(
  vtkLight* light, int& width, int& height)
{
  Internals& self = *this->Implementation;
  width = height = 0;
  const auto found = std::find_if(self.Lights.begin(), self.Lights.end(),
    [light](const vtkShadowLightSource& source) { return source.Source == light; });
  if (found == self.Lights.end())
  {
    return {};
  }
  const std::size_t slot = static_cast<std::size_t>(found - self.Lights.begin());
  constexpr std::size_t each = vtkShadowTarget::LightsPerMask;
  const int* viewport = self.Masks.GetViewport();
  const std::size_t count = static_cast<std::size_t>(viewport[2]) * viewport[3];
  std::vector<unsigned char> pixels(4 * count);
  {
    const vtkNBufferGL::ScopedReadback readback(
      self.Masks.GetTarget().GetMaskFramebuffer(static_cast<int>(slot / each)));
    glReadPixels(
      viewport[0], viewport[1], viewport[2], viewport[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
  std::string why;
  if (!vtkNBufferGL::CheckErrors("Reading a shadow mask", why))
  {
    vtkErrorMacro(<< why);
    return {};
  }
  std::vector<unsigned char> mask(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    mask[i] = pixels[4 * i + slot % each];
  }
  width = viewport[2];
  height = viewport[3];
  return mask;
}

std::vector<unsigned char> vtkShadowVolumeClampPass::GetDebugImage(int& width, int& height) const
{
  const vtkShadowDebugView& view = this->Implementation->Masks.DebugView;
  const bool shown = this->Implementation->Statistics.DebugDraws > 0;
  width = shown ? view.GetWidth() : 0;
  height = shown ? view.GetHeight() : 0;
  return shown ? view.GetImage() : std::vector<unsigned char>();
}

void vtkShadowVolumeClampPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& self = *this->Implementation;
  if (!self.ResourceCallback->IsReleasing())
  {
    self.Steps->ReleaseGraphicsResources(window);
    self.Opaque->ReleaseGraphicsResources(window);
    // VTK calls this for a window that is about to get its context, too.
    if (!window || window == self.Window)
    {
      self.ResourceCallback->Release();
    }
    return;
  }
  self.Masks.Release();
  if (auto* other = vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    // OSMesa sets them anew where a context is made current, behind the back of what remembers
    // them.
    other->GetState()->ResetGLViewportState();
    other->GetState()->ResetGLScissorState();
  }
  self.Lights.clear();
  self.Key = vtkShadowFrameKey();
  self.Window = nullptr;
}

void vtkShadowVolumeClampPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& self = *this->Implementation;
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "LitmapResolution: " << this->LitmapResolution << "\n";
  os << indent << "SlabGap: " << this->SlabGap << "\n";
  os << indent << "LitmapMethod: " << this->LitmapMethod << "\n";
  os << indent << "DebugView: " << this->DebugView << "\n";
  os << indent << "DebugLight: " << self.DebugLight.Get() << "\n";
  os << indent << "MeasureDeviceTime: " << (this->MeasureDeviceTime ? "On" : "Off") << "\n";
  os << indent << "CountFragments: " << (this->CountFragments ? "On" : "Off") << "\n";
  os << indent << "CasterKeys: " << self.CasterKeys.Get() << "\n";
  os << indent << "LightsThatDoNotCast: " << self.Excluded.size() << "\n";
  os << indent << "Steps:\n";
  self.Steps->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Statistics: " << self.Statistics.GetAsJSON() << "\n";
}
VTK_ABI_NAMESPACE_END
