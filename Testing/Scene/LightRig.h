// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LightRig.h
 * @brief The lights and the shadow passes (vtkShadowVolumeClampPass) of a stage's renderers.
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
/// Which shadow passes draw the next frame of the renderers that have one.
enum class ShadowPasses
{
  Absent,         ///< None. The frame has no shadows.
  FreshUnclamped, ///< Passes that are made for this frame alone, with the mode Unclamped.
  Fresh,          ///< Passes that are made for this frame alone, with the scenario's mode.
  Lasting         ///< The same passes in all frames, with the scenario's mode.
};

/// Makes the light that a scenario describes.
vtkSmartPointer<vtkLight> MakeLight(const Light& light);

class LightRig
{
public:
  /// Adds the lights of a scenario to its renderers, and sets their render passes, except for those
  /// with shadows, which UsePasses() sets.
  void Begin(const Scenario& scenario, const std::vector<vtkSmartPointer<vtkRenderer>>& renderers);
  /// Forgets the renderers, lights and passes.
  void End();

  /// Applies a change of lights or of settings of shadows, and ignores other changes.
  void Apply(const Change& change);
  /// Replaces the render pass of a renderer. A pass with shadows is set by the next UsePasses().
  void SetPassKind(int renderer, PassKind kind);

  /// Gives the renderers with shadows their passes for the next frame.
  void UsePasses(ShadowPasses which);

  /// Returns the caster keys of a pass with Shadows::CasterKeys. Props that cast have the same key.
  static vtkSmartPointer<vtkInformation> MakeCasterKeys();
  /// Adds this key to the property keys of a prop, or removes it.
  static void SetCasts(vtkProp* prop, bool casts);

  bool HasShadows() const;
  ShadowMode GetMode() const { return this->Settings.Mode; }
  bool HasCasterKeys() const { return this->Settings.CasterKeys; }
  int GetNumberOfLights() const { return static_cast<int>(this->Descriptions.size()); }
  vtkLight* GetLight(int renderer, int light) const { return this->Places[renderer].Lights[light]; }
  /// Returns the shadow pass of the last frame; nullptr if there was none.
  vtkShadowVolumeClampPass* GetPass(int renderer) const { return this->Places[renderer].Used; }

private:
  /// What belongs to a renderer.
  struct Place
  {
    vtkSmartPointer<vtkRenderer> Renderer;
    PassKind Kind = PassKind::None;
    std::vector<vtkSmartPointer<vtkLight>> Lights;
    vtkSmartPointer<vtkShadowVolumeClampPass> Lasting;
    vtkSmartPointer<vtkRenderPass> Outermost; ///< The renderer's pass, which is or holds Lasting.
    vtkSmartPointer<vtkShadowVolumeClampPass> Used; ///< The shadow pass of the last frame.
  };
  void SetUp(vtkShadowVolumeClampPass* pass, ShadowMode mode) const;
  void AddLights(Place& place) const;

  Shadows Settings;
  std::vector<Light> Descriptions;
  std::vector<Place> Places;
};
}

#endif
