// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeClampPass.h"

#include "vtkNBufferClock.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferResourceCallback.h"
#include "vtkShadowFrameKey.h"
#include "vtkShadowMaskMaker.h"
#include "vtkShadowShader.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
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
class vtkShadowVolumeClampPass::OpaqueStage
  : public vtkRenderPass
  , public vtkNBufferRenderPassTraits
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

  /// The stage has no parts: its owner draws.
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return {}; }

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
  void SetShader(const std::vector<vtkShadowLightSource>& lights, int samples);

  vtkNew<OpaqueStage> Stage;
  vtkNew<vtkRenderStepsPass> Steps;
  vtkNew<vtkOpaquePass> Opaque;
  std::vector<vtkWeakPointer<vtkLight>> Excluded;
  vtkSmartPointer<vtkInformation> CasterKeys;
  vtkWeakPointer<vtkLight> DebugLight;
  vtkShadowMaskMaker Masks;
  vtkShadowStatistics Statistics;
  std::vector<vtkShadowLightSource> Lights; ///< Of the masks.
  vtkShadowShader Shader;                   ///< Of the mappers.
  vtkTimeStamp ShaderTime;
  std::vector<int> TextureUnits;
  int DepthUnit = 0;
  vtkShadowFrameKey Key; ///< Of the masks.
  int FailedFrames = 0;
  int PixelFrames = 0;
  bool HasWarned = false;
  bool HasWarnedOfSamples = false;
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

void vtkShadowVolumeClampPass::Internals::SetShader(
  const std::vector<vtkShadowLightSource>& lights, int samples)
{
  vtkShadowShader shader;
  for (const vtkShadowLightSource& light : lights)
  {
    shader.Lights.push_back(light.Number);
  }
  shader.Samples = samples;
  if (!(shader == this->Shader))
  {
    this->Shader = shader;
    this->ShaderTime.Modified();
  }
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

void vtkShadowVolumeClampPass::SetTuning(const vtkShadowTuning& tuning)
{
  const std::string fault = tuning.FindFault();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << "; the tuning stays as it was.");
    return;
  }
  this->Tuning = tuning;
  this->Modified();
}

void vtkShadowVolumeClampPass::SetDebugView(int view, vtkLight* light)
{
  view = std::clamp(view, static_cast<int>(NoDebugView), static_cast<int>(Counts));
  if (this->DebugView != view || this->Implementation->DebugLight != light)
  {
    this->DebugView = view;
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

std::vector<vtkRenderPass*> vtkShadowVolumeClampPass::GetDelegatePasses()
{
  return { this->GetSteps() };
}

const vtkShadowStatistics& vtkShadowVolumeClampPass::GetStatistics() const
{
  return this->Implementation->Statistics;
}

//------------------------------------------------------------------------------------------------
void vtkShadowVolumeClampPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetPass() == this)
  {
    // VTK's camera pass leaves out what vtkCamera::Render() asks the window: whether there are two
    // eyes.
    vtkCamera* camera = renderer->GetActiveCamera();
    if (camera->GetStereo() != renderer->GetRenderWindow()->GetStereoRender())
    {
      camera->Render(renderer);
    }
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
  self.Masks.Timers.Begin(this->Tuning.MeasureDeviceTime);
  statistics.DeviceTimes = self.Masks.Timers.GetTimes();
  const vtkShadowFrameKey key(s, lights, self.Masks.Casters, this->GetMTime());
  const bool still = statistics.Updates == 0 && !this->Tuning.CountFragments && key == self.Key;
  const vtkShadowTarget& target = self.Masks.GetTarget();
  bool done = still || self.Masks.Reserve(renderer, lights.size());
  statistics.Samples = static_cast<int>(target.GetSamples().size());
  if (done && target.HasRefusedSamples())
  {
    ++self.PixelFrames;
    if (!self.HasWarnedOfSamples)
    {
      self.HasWarnedOfSamples = true;
      vtkWarningMacro(<< "Shadows have one sample for each pixel. " << self.Masks.GetError());
    }
  }
  statistics.PixelFrames = self.PixelFrames;
  self.SetShader(lights, statistics.Samples);
  // The depth is drawn by the shaders that will draw the colour: it is the same to the bit, and no
  // mapper has to rebuild one.
  this->NoteInProps(s);
  if (!still)
  {
    self.Key = vtkShadowFrameKey();
    done = done && this->MakeMasks(s, lights, statistics);
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
  {
    const vtkShadowTimers::Scope timed(self.Masks.Timers, vtkShadowStage::Color);
    this->DrawOpaque(s, target.GetDepth());
  }
  this->PostRender(s);
  this->ShowDebugView(window, statistics);
  self.Key = key;
  statistics.Decision = still ? vtkShadowDecision::Still : vtkShadowDecision::Drawn;
  self.Statistics = statistics;
}

void vtkShadowVolumeClampPass::NoteInProps(const vtkRenderState* s)
{
  // As PreRender(), but once in keys that props share: PostRender() gives back one reference only.
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    if (!prop->GetPropertyKeys())
    {
      prop->SetPropertyKeys(vtkSmartPointer<vtkInformation>::New());
    }
    vtkInformation* keys = prop->GetPropertyKeys();
    bool noted = false;
    for (int k = 0; k < keys->Length(RenderPasses()); ++k)
    {
      noted = noted || keys->Get(RenderPasses(), k) == this;
    }
    if (!noted)
    {
      keys->Append(RenderPasses(), this);
    }
  }
}

bool vtkShadowVolumeClampPass::MakeMasks(const vtkRenderState* s,
  const std::vector<vtkShadowLightSource>& lights, vtkShadowStatistics& statistics)
{
  Internals& self = *this->Implementation;
  vtkRenderer* renderer = s->GetRenderer();
  vtkNBufferClock clock;
  self.Masks.BeginDepth(renderer);
  {
    const vtkShadowTimers::Scope timed(self.Masks.Timers, vtkShadowStage::Depth);
    this->DrawOpaque(s, nullptr);
  }
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->PopFramebufferBindings();
  statistics.DepthTime = clock.GetMilliseconds();
  const vtkShadowMaskMaker::Settings settings = { static_cast<vtkShadowMode>(this->Mode),
    this->Tuning, static_cast<vtkShadowPicture>(this->DebugView), self.DebugLight };
  return self.Masks.Make(renderer, lights, settings, statistics);
}

void vtkShadowVolumeClampPass::DrawOpaque(const vtkRenderState* s, vtkTextureObject* depth)
{
  Internals& self = *this->Implementation;
  const vtkShadowTarget& target = self.Masks.GetTarget();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  const vtkOpenGLState::ScopedglActiveTexture activeUnit(window->GetState());
  // Also where only depth is drawn: samplers of two kinds must not share a texture unit.
  self.TextureUnits.resize(target.GetNumberOfMasks());
  for (int i = 0; i < target.GetNumberOfMasks(); ++i)
  {
    target.GetMask(i)->Activate();
    self.TextureUnits[i] = target.GetMask(i)->GetTextureUnit();
  }
  self.DepthUnit = self.TextureUnits[0];
  if (depth)
  {
    depth->Activate();
    self.DepthUnit = depth->GetTextureUnit();
  }
  self.Opaque->Render(s);
  this->NumberOfRenderedProps = self.Opaque->GetNumberOfRenderedProps();
  for (int i = 0; i < target.GetNumberOfMasks(); ++i)
  {
    target.GetMask(i)->Deactivate();
  }
  if (depth)
  {
    depth->Deactivate();
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
  this->Implementation->Shader.Declare(fragmentShader);
  return true;
}

bool vtkShadowVolumeClampPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  Internals& self = *this->Implementation;
  if (!self.Shader.Insert(fragmentShader) && !self.HasWarnedOfShader)
  {
    self.HasWarnedOfShader = true;
    vtkErrorMacro(<< "A mapper's shader has lighting that this pass does not know, so that its "
                     "props receive no shadows. Use VTK's own lighting code, or report the "
                     "version of VTK.");
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
  if (program->IsUniformUsed("shadowDepth"))
  {
    std::vector<float> offsets;
    for (const std::array<double, 2>& place : self.Masks.GetTarget().GetSamples())
    {
      offsets.push_back(static_cast<float>(place[0] - 0.5));
      offsets.push_back(static_cast<float>(place[1] - 0.5));
    }
    program->SetUniformi("shadowDepth", self.DepthUnit);
    program->SetUniform2fv("shadowSamples", static_cast<int>(offsets.size() / 2), offsets.data());
  }
  if (program->IsUniformUsed("shadowAttenuations"))
  {
    std::vector<float> attenuations(self.Shader.Lights.size(), 0.0f);
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
  vtkLight* light, int& width, int& height, int sample)
{
  Internals& self = *this->Implementation;
  width = height = 0;
  const auto found = std::find_if(self.Lights.begin(), self.Lights.end(),
    [light](const vtkShadowLightSource& source) { return source.Source == light; });
  if (found == self.Lights.end() || sample >= self.Statistics.Samples)
  {
    return {};
  }
  const std::size_t slot = static_cast<std::size_t>(found - self.Lights.begin());
  std::vector<unsigned char> mask;
  if (!self.Masks.ReadMask(self.Window, slot, sample, mask))
  {
    vtkErrorMacro(<< self.Masks.GetError());
    return {};
  }
  width = self.Masks.GetViewport()[2];
  height = self.Masks.GetViewport()[3];
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
  this->Tuning.PrintSelf(os, indent);
  os << indent << "DebugView: " << this->DebugView << "\n";
  os << indent << "DebugLight: " << self.DebugLight.Get() << "\n";
  os << indent << "CasterKeys: " << self.CasterKeys.Get() << "\n";
  os << indent << "LightsThatDoNotCast: " << self.Excluded.size() << "\n";
  os << indent << "Steps:\n";
  self.Steps->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Statistics: " << self.Statistics.GetAsJSON() << "\n";
}
VTK_ABI_NAMESPACE_END
