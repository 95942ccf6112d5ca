// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeClampPass.h"

#include "vtkNBufferProtectedRenderer.h"
#include "vtkShadowOpaqueStage.h"
#include "vtkShadowRendererStages.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

/// The opaque stage of GetSteps(). It calls the pass that owns it.
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

  /// The stage calls no other passes: its owner draws.
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return {}; }

  vtkShadowVolumeClampPass* Owner = nullptr;
};

vtkStandardNewMacro(vtkShadowVolumeClampPass);
vtkStandardNewMacro(vtkShadowVolumeClampPass::OpaqueStage);

class vtkShadowVolumeClampPass::Internals
{
public:
  explicit Internals(vtkShadowVolumeClampPass* self)
    : Shadows(self)
  {
    this->Stage->Owner = self;
    this->Steps->SetOpaquePass(this->Stage);
    this->Steps->SetTranslucentPass(vtkNew<vtkShadowTranslucentStage>());
    this->Steps->SetVolumetricPass(vtkNew<vtkShadowVolumetricStage>());
  }
  ~Internals() { this->Stage->Owner = nullptr; }

  vtkNew<OpaqueStage> Stage;
  vtkNew<vtkRenderStepsPass> Steps;
  vtkShadowOpaqueStage Shadows;
  std::vector<vtkWeakPointer<vtkLight>> Excluded; ///< The lights that do not cast.
  vtkSmartPointer<vtkInformation> CasterKeys;
  vtkWeakPointer<vtkLight> DebugLight;
  bool HasWarnedOfShader = false;
};

vtkShadowVolumeClampPass::vtkShadowVolumeClampPass()
  : Implementation(new Internals(this))
{
}

vtkShadowVolumeClampPass::~vtkShadowVolumeClampPass() = default;

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
  return !light || std::find(excluded.begin(), excluded.end(), light) == excluded.end();
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
  if (!(tuning == this->Tuning))
  {
    this->Tuning = tuning;
    this->Modified();
  }
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
  return this->Implementation->Shadows.GetStatistics();
}

//------------------------------------------------------------------------------------------------
void vtkShadowVolumeClampPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  // An observer may take the pass from the renderer while it draws.
  const vtkSmartPointer<vtkShadowVolumeClampPass> keepAlive = this;
  if (renderer->GetPass() == this && renderer->GetSelector())
  {
    this->NumberOfRenderedProps = vtkNBufferProtectedMembers::DrawWithoutPass(renderer);
    return;
  }
  if (renderer->GetPass() == this)
  {
    // vtkCamera::Render() finds out from the window whether there are two eyes, and VTK's camera
    // pass does not. Modified() makes the camera compute its cached matrices again.
    vtkCamera* camera = renderer->GetActiveCamera();
    if (camera->GetStereo() != renderer->GetRenderWindow()->GetStereoRender())
    {
      camera->Render(renderer);
      camera->Modified();
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
  const vtkShadowOpaqueStage::Settings settings = {
    { static_cast<vtkShadowMode>(this->Mode), this->Tuning,
      static_cast<vtkShadowPicture>(this->DebugView), self.DebugLight },
    self.CasterKeys, [this](vtkLight* light) { return this->GetLightCasts(light); },
    this->GetMTime()
  };
  this->NumberOfRenderedProps = self.Shadows.Render(s, settings);
}

//------------------------------------------------------------------------------------------------
bool vtkShadowVolumeClampPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  this->Implementation->Shadows.GetShading().Declare(fragmentShader);
  return true;
}

bool vtkShadowVolumeClampPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  Internals& self = *this->Implementation;
  if (!self.Shadows.GetShading().Insert(fragmentShader) && !self.HasWarnedOfShader)
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
  this->Implementation->Shadows.GetShading().SetParameters(program);
  return true;
}

vtkMTimeType vtkShadowVolumeClampPass::GetShaderStageMTime()
{
  return this->Implementation->Shadows.GetShading().GetMTime();
}

//------------------------------------------------------------------------------------------------
std::vector<unsigned char> vtkShadowVolumeClampPass::GetMask(
  vtkLight* light, int& width, int& height, int sample)
{
  std::string why;
  const auto mask = this->Implementation->Shadows.ReadMask(light, sample, width, height, why);
  if (!why.empty())
  {
    vtkErrorMacro(<< why);
  }
  return mask;
}

std::vector<unsigned char> vtkShadowVolumeClampPass::GetDebugImage(int& width, int& height) const
{
  const vtkShadowDebugView* view = this->Implementation->Shadows.GetDebugView();
  width = view ? view->GetWidth() : 0;
  height = view ? view->GetHeight() : 0;
  return view ? view->GetImage() : std::vector<unsigned char>();
}

void vtkShadowVolumeClampPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Implementation->Steps->ReleaseGraphicsResources(window);
  this->Implementation->Shadows.ReleaseGraphicsResources(window);
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
  const auto living = std::count_if(
    self.Excluded.begin(), self.Excluded.end(), [](vtkLight* light) { return light != nullptr; });
  os << indent << "LightsThatDoNotCast: " << living << "\n";
  os << indent << "Steps:\n";
  self.Steps->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Statistics: " << self.Shadows.GetStatistics().GetAsJSON() << "\n";
}
VTK_ABI_NAMESPACE_END
