// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMode.h"

#include "ModeSettings.h"
#include "RerenderedLitmap.h"

#include "vtkNBufferGL.h"

#include "vtkCameraPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkShadowVolumeClampPass.h"

#include <cstdio>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
struct VolumeKind
{
  const char* Name;
  int Mode;
  int SlabGap;
};
using Pass = vtkShadowVolumeClampPass;
constexpr VolumeKind VolumeKinds[] = { { "unclamped", Pass::Unclamped, 4 },
  { "cull", Pass::Culled, 4 }, { "auto", Pass::Automatic, 4 }, { "exact", Pass::Scissored, 4 },
  { "clamp", Pass::Clamped, 64 }, { "slabs", Pass::Clamped, 4 }, { "paper", Pass::Clamped, 64 } };

/// Draws another pass with a polygon offset: the bias of a shadow map whose baker has none.
class PolygonOffsetPass : public vtkRenderPass
{
public:
  static PolygonOffsetPass* New() { VTK_STANDARD_NEW_BODY(PolygonOffsetPass); }
  vtkTypeMacro(PolygonOffsetPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    // VTK neither switches offsets of polygons on nor keeps this state in its cache.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(this->Factor, this->Units);
    this->Delegate->Render(state);
    glPolygonOffset(0.0f, 0.0f);
    glDisable(GL_POLYGON_OFFSET_FILL);
    this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkRenderPass> Delegate;
  ///@{
  /// The parameters of glPolygonOffset().
  float Factor = 0.0f;
  float Units = 0.0f;
  ///@}
};

vtkSmartPointer<vtkRenderPass> MakeShadowMaps(int resolution, const ShadowMapSettings& settings)
{
  vtkNew<vtkShadowMapPass> shadows;
  vtkShadowMapBakerPass* baker = shadows->GetShadowMapBakerPass();
  if (resolution > 0)
  {
    baker->SetResolution(static_cast<unsigned int>(resolution));
  }
  SetExponent(baker, settings.Exponent);
  if (settings.OffsetFactor > 0 || settings.OffsetUnits > 0)
  {
    vtkNew<PolygonOffsetPass> offset;
    offset->Delegate = baker->GetOpaqueSequence();
    offset->Factor = static_cast<float>(settings.OffsetFactor);
    offset->Units = static_cast<float>(settings.OffsetUnits);
    baker->SetOpaqueSequence(offset);
  }
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(baker);
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}
}

ShadowMode::ShadowMode(const std::string& name, vtkShadowVolumeClampPass* volumes)
  : Name(name)
  , Kind(name.substr(0, name.find_first_of("@:")))
  , IsVolumes(FindNamed(VolumeKinds, Kind) != nullptr)
{
  const std::string sized = GetModeKind(name);
  const bool isSized = this->Kind != sized;
  int used = 0;
  const bool hasSize = isSized &&
    std::sscanf(sized.c_str() + this->Kind.size(), "@%4d%n", &this->Resolution, &used) == 1 &&
    this->Kind.size() + static_cast<std::size_t>(used) == sized.size() && this->Resolution > 0;
  const bool canHaveSize = this->Kind != "none" && this->Kind != "unclamped";
  const bool isKnown = this->IsVolumes || this->Kind == "vtk" || name == "none";
  if (!isKnown || (isSized && !(hasSize && canHaveSize)))
  {
    throw std::runtime_error("no mode " + name +
      "; there are none, unclamped, cull, auto, exact, clamp, slabs, paper and vtk, all but the "
      "first two also with a resolution of 1 to 9999, such as exact@64, and those of volumes and "
      "vtk with settings, such as slabs@64:SlabGap=2 or vtk@1024:Exponent=80");
  }
  if (this->IsVolumes)
  {
    ApplySettings(name, vtkNew<vtkShadowVolumeClampPass>().Get()); // Throws if they are wrong.
    this->Pass = volumes;
    if (this->Kind == "paper")
    {
      this->LitmapSource = std::make_shared<NBufferPeers::RerenderedLitmap>();
    }
  }
  else if (this->Kind == "vtk")
  {
    ShadowMapSettings settings;
    ApplySettings(name, &settings);
    this->Pass = MakeShadowMaps(this->Resolution, settings);
    this->IsEachFrame = settings.EachFrame != 0;
  }
}

void ShadowMode::Enter(vtkRenderer* renderer) const
{
  if (const VolumeKind* kind = FindNamed(VolumeKinds, this->Kind))
  {
    auto* volumes = static_cast<vtkShadowVolumeClampPass*>(this->Pass.GetPointer());
    volumes->SetMode(kind->Mode);
    vtkShadowTuning tuning = volumes->GetTuning();
    tuning.SlabGap = kind->SlabGap;
    const vtkShadowTuning usual;
    tuning.LitmapResolution = this->Resolution > 0 ? this->Resolution : usual.LitmapResolution;
    tuning.BoxCost = usual.BoxCost;
    tuning.LitmapSource = this->LitmapSource;
    volumes->SetTuning(tuning);
    ApplySettings(this->Name, volumes);
  }
  renderer->SetPass(this->Pass);
}

void ShadowMode::Release(vtkRenderer* renderer) const
{
  renderer->SetPass(nullptr);
  if (this->Pass)
  {
    this->Pass->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
}

} // namespace NBufferBench
