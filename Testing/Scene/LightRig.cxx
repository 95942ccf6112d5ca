// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightRig.h"

#include "ScenePasses.h"
#include "Tune.h"

#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <algorithm>

namespace TestScene
{
namespace
{
vtkInformationIntegerKey* GetCasterKey()
{
  static vtkInformationIntegerKey* key =
    vtkInformationIntegerKey::MakeKey("CASTS", "TestScene::Lights");
  return key;
}

glm::dvec3 GetVector(const Change& change)
{
  return { GetValue(change, 0), GetValue(change, 1), GetValue(change, 2) };
}

void SetUpLight(vtkLight* light, const Light& description)
{
  switch (description.Kind)
  {
    case LightKind::Headlight:
      light->SetLightTypeToHeadlight();
      break;
    case LightKind::Camera:
      light->SetLightTypeToCameraLight();
      break;
    default:
      light->SetLightTypeToSceneLight();
      break;
  }
  const bool spot = description.Kind == LightKind::Spot;
  light->SetPositional(spot || description.Kind == LightKind::Point);
  light->SetConeAngle(spot ? description.ConeAngle : 180.0);
  light->SetExponent(description.Exponent);
  light->SetPosition(glm::value_ptr(description.Position));
  light->SetFocalPoint(glm::value_ptr(description.FocalPoint));
  light->SetAttenuationValues(glm::value_ptr(description.Attenuation));
  light->SetColor(glm::value_ptr(description.Color));
  light->SetIntensity(description.Intensity);
  light->SetSwitch(description.On);
  light->SetShadowAttenuation(static_cast<float>(description.ShadowAttenuation));
}
}

vtkSmartPointer<vtkLight> MakeLight(const Light& light)
{
  auto result = vtkSmartPointer<vtkLight>::New();
  SetUpLight(result, light);
  return result;
}

vtkSmartPointer<vtkInformation> LightRig::MakeCasterKeys()
{
  auto keys = vtkSmartPointer<vtkInformation>::New();
  keys->Set(GetCasterKey(), 1);
  return keys;
}

void LightRig::SetCasts(vtkProp* prop, bool casts)
{
  vtkSmartPointer<vtkInformation> keys = prop->GetPropertyKeys();
  if (!keys)
  {
    keys = vtkSmartPointer<vtkInformation>::New();
    prop->SetPropertyKeys(keys);
  }
  if (casts)
  {
    keys->Set(GetCasterKey(), 1);
  }
  else
  {
    keys->Remove(GetCasterKey());
  }
}

void LightRig::Begin(
  const Scenario& scenario, const std::vector<vtkSmartPointer<vtkRenderer>>& renderers)
{
  this->Settings = scenario.Shadows;
  this->Descriptions = scenario.Lights;
  for (std::size_t i = 0; i < renderers.size(); ++i)
  {
    Place place;
    place.Renderer = renderers[i];
    this->AddLights(place);
    this->Places.push_back(place);
    this->SetPassKind(static_cast<int>(i), scenario.Renderers[i].Pass);
  }
}

void LightRig::End()
{
  this->Places.clear();
}

void LightRig::AddLights(Place& place) const
{
  place.Renderer->SetAutomaticLightCreation(this->Descriptions.empty());
  for (const Light& description : this->Descriptions)
  {
    vtkSmartPointer<vtkLight> light = MakeLight(description);
    place.Renderer->AddLight(light);
    place.Lights.push_back(light);
  }
}

void LightRig::SetUp(vtkShadowVolumeClampPass* pass, ShadowMode mode) const
{
  using Pass = vtkShadowVolumeClampPass;
  constexpr int modes[] = { Pass::Unclamped, Pass::Scissored, Pass::Clamped, Pass::Automatic,
    Pass::Culled };
  pass->SetMode(modes[static_cast<int>(mode)]);
  Tune(pass, &vtkShadowTuning::BoxCost, this->Settings.BoxCost);
  Tune(pass, &vtkShadowTuning::LitmapResolution, this->Settings.LitmapResolution);
  Tune(pass, &vtkShadowTuning::SlabGap, this->Settings.SlabGap);
  if (this->Settings.CasterKeys != (pass->GetCasterKeys() != nullptr))
  {
    pass->SetCasterKeys(this->Settings.CasterKeys ? MakeCasterKeys() : nullptr);
  }
  for (const Place& place : this->Places)
  {
    for (std::size_t i = 0; i < place.Lights.size(); ++i)
    {
      pass->SetLightCasts(place.Lights[i], this->Descriptions[i].Casts);
    }
  }
}

void LightRig::SetPassKind(int renderer, PassKind kind)
{
  Place& place = this->Places[renderer];
  place.Kind = kind;
  place.Lasting = nullptr;
  place.Outermost = nullptr;
  place.Used = nullptr;
  if (!HasShadowVolumes(kind))
  {
    place.Renderer->SetPass(MakePass(kind));
  }
}

bool LightRig::HasShadows() const
{
  return std::any_of(this->Places.begin(), this->Places.end(),
    [](const Place& place) { return HasShadowVolumes(place.Kind); });
}

void LightRig::UsePasses(ShadowPasses which)
{
  const auto getLasting = [this](Place& place)
  {
    if (!place.Lasting && this->Settings.OneForAll)
    {
      const auto other = std::find_if(this->Places.begin(), this->Places.end(),
        [](const Place& candidate) { return candidate.Lasting != nullptr; });
      place.Lasting = other == this->Places.end() ? nullptr : other->Lasting;
    }
    if (!place.Lasting)
    {
      place.Lasting = vtkSmartPointer<vtkShadowVolumeClampPass>::New();
    }
    if (!place.Outermost)
    {
      place.Outermost = MakePass(place.Kind, place.Lasting);
    }
    this->SetUp(place.Lasting, this->Settings.Mode);
    return place.Outermost;
  };
  for (Place& place : this->Places)
  {
    // Renderers share shader programs. VTK takes a program for up to date that another renderer's
    // lights have been given to since these have changed.
    for (std::size_t i = 0; this->Places.size() > 1 && i < place.Lights.size(); ++i)
    {
      place.Lights[i]->Modified();
    }
    if (!HasShadowVolumes(place.Kind))
    {
      continue;
    }
    vtkRenderPass* old = place.Renderer->GetPass();
    vtkSmartPointer<vtkRenderPass> pass;
    place.Used = nullptr;
    if (which == ShadowPasses::Lasting)
    {
      pass = getLasting(place);
      place.Used = place.Lasting;
    }
    else if (which == ShadowPasses::Absent)
    {
      pass = MakePass(place.Kind);
    }
    else
    {
      place.Used = vtkSmartPointer<vtkShadowVolumeClampPass>::New();
      this->SetUp(
        place.Used, which == ShadowPasses::Fresh ? this->Settings.Mode : ShadowMode::Unclamped);
      pass = MakePass(place.Kind, place.Used);
    }
    if (old && old != pass)
    {
      old->ReleaseGraphicsResources(place.Renderer->GetRenderWindow());
    }
    place.Renderer->SetPass(pass);
  }
}

void LightRig::Apply(const Change& change)
{
  const double value = GetValue(change, 0);
  const bool hasTarget = change.Target >= 0 && change.Target < this->GetNumberOfLights();
  Light none;
  Light& light = hasTarget ? this->Descriptions[change.Target] : none;
  switch (change.Kind)
  {
    case ChangeKind::ShadowMode:
      this->Settings.Mode = static_cast<ShadowMode>(std::clamp(static_cast<int>(value), 0, 4));
      return;
    case ChangeKind::LitmapResolution:
      this->Settings.LitmapResolution = static_cast<int>(value);
      return;
    case ChangeKind::SlabGap:
      this->Settings.SlabGap = static_cast<int>(value);
      return;
    case ChangeKind::BoxCost:
      this->Settings.BoxCost = static_cast<int>(value);
      return;
    case ChangeKind::CasterKeys:
      this->Settings.CasterKeys = value != 0.0;
      return;
    case ChangeKind::LightPosition:
      light.Position = GetVector(change);
      break;
    case ChangeKind::LightFocalPoint:
      light.FocalPoint = GetVector(change);
      break;
    case ChangeKind::LightCone:
      light.ConeAngle = value;
      break;
    case ChangeKind::LightOn:
      light.On = value != 0.0;
      break;
    case ChangeKind::LightCasts:
      light.Casts = value != 0.0;
      break;
    case ChangeKind::LightAttenuation:
      light.ShadowAttenuation = value;
      break;
    default:
      return;
  }
  for (std::size_t i = 0; hasTarget && i < this->Places.size(); ++i)
  {
    TestScene::SetUpLight(this->Places[i].Lights[change.Target], light);
  }
}
}
