// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShading.h"

#include "vtkShadowTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

VTK_ABI_NAMESPACE_BEGIN

void vtkShadowShading::SetUp(const std::vector<vtkShadowLightSource>& lights, int samples)
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
    this->Time.Modified();
  }
}

void vtkShadowShading::SetParameters(vtkShaderProgram* program, const vtkShadowTarget& target) const
{
  if (program->IsUniformUsed("shadowMasks"))
  {
    program->SetUniform1iv(
      "shadowMasks", static_cast<int>(this->TextureUnits.size()), this->TextureUnits.data());
  }
  if (program->IsUniformUsed("shadowDepth"))
  {
    std::vector<float> offsets;
    for (const auto& place : target.GetSamples())
    {
      offsets.push_back(static_cast<float>(place[0] - 0.5));
      offsets.push_back(static_cast<float>(place[1] - 0.5));
    }
    program->SetUniformi("shadowDepth", this->DepthUnit);
    program->SetUniform2fv("shadowSamples", static_cast<int>(offsets.size() / 2), offsets.data());
  }
  if (program->IsUniformUsed("shadowAttenuations"))
  {
    std::vector<float> attenuations(this->Shader.Lights.size(), 0.0f);
    for (std::size_t i = 0; i < this->Lights.size(); ++i)
    {
      attenuations[i] = this->Lights[i].Attenuation;
    }
    program->SetUniform1fv(
      "shadowAttenuations", static_cast<int>(attenuations.size()), attenuations.data());
  }
}

vtkShadowShading::Scope::Scope(vtkShadowShading& shading, vtkOpenGLRenderWindow* window,
  const vtkShadowTarget& target, vtkTextureObject* depth)
  : ActiveUnit(window->GetState())
  , Target(target)
  , Depth(depth)
{
  // The masks are bound even where depth alone is drawn: samplers of two kinds must not share a
  // texture unit.
  shading.TextureUnits.resize(target.GetNumberOfMasks());
  for (int i = 0; i < target.GetNumberOfMasks(); ++i)
  {
    target.GetMask(i)->Activate();
    shading.TextureUnits[i] = target.GetMask(i)->GetTextureUnit();
  }
  shading.DepthUnit = shading.TextureUnits[0];
  if (depth)
  {
    depth->Activate();
    shading.DepthUnit = depth->GetTextureUnit();
  }
}

vtkShadowShading::Scope::~Scope()
{
  for (int i = 0; i < this->Target.GetNumberOfMasks(); ++i)
  {
    this->Target.GetMask(i)->Deactivate();
  }
  if (this->Depth)
  {
    this->Depth->Deactivate();
  }
}

VTK_ABI_NAMESPACE_END
