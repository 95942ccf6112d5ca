// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LightRig.h
 * @brief The lights of a stage's renderers, and their passes with shadow volumes.
 */
#ifndef LightRig_h
#define LightRig_h

#include "Scenario.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace TestScene
{
/// Which passes draw the next frame of renderers with shadow volumes.
enum class ShadowPasses
{
  Absent,         ///< None: VTK's own stages.
  FreshUnclamped, ///< Made for this frame alone, with Unclamped whatever the scenario says.
  Fresh,          ///< Made for this frame alone.
  Lasting
};

vtkSmartPointer<vtkLight> MakeLight(const Light& light);

class LightRig
{
public:
  /// `renderers` and `scenario` must live until End().
  void Begin(const Scenario& scenario, const std::vector<vtkSmartPointer<vtkRenderer>>& renderers);
  void End();

  /// Changes of anything but lights and settings of shadows leave them as they are.
  void Apply(const Change& change);
  void SetPassKind(int renderer, PassKind kind);

  void UsePasses(ShadowPasses which);

  /// The key of Shadows::CasterKeys, as the pass or a prop that casts has it.
  static vtkSmartPointer<vtkInformation> MakeCasterKeys();
  static void SetCasts(vtkProp* prop, bool casts);

  bool HasShadows() const;
  ShadowMode GetMode() const { return this->Settings.Mode; }
  bool HasCasterKeys() const { return this->Settings.CasterKeys; }
  int GetNumberOfLights() const { return static_cast<int>(this->Descriptions.size()); }
  vtkLight* GetLight(int renderer, int light) const { return this->Places[renderer].Lights[light]; }
  /// Of the last frame; nullptr if it was drawn without.
  vtkShadowVolumeClampPass* GetPass(int renderer) const { return this->Places[renderer].Used; }

private:
  /// What belongs to a renderer.
  struct Place
  {
    vtkSmartPointer<vtkRenderer> Renderer;
    PassKind Kind = PassKind::None;
    std::vector<vtkSmartPointer<vtkLight>> Lights;
    vtkSmartPointer<vtkShadowVolumeClampPass> Lasting;
    vtkSmartPointer<vtkRenderPass> Outermost; ///< Of a sequence with Lasting.
    vtkSmartPointer<vtkShadowVolumeClampPass> Used;
  };
  void SetUp(vtkShadowVolumeClampPass* pass, ShadowMode mode) const;
  void AddLights(Place& place) const;

  Shadows Settings;
  std::vector<Light> Descriptions;
  std::vector<Place> Places;
};
}

#endif
