// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShading.h"

#include "vtkNBufferSharedText.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkShadowLightDec.h"
#include "vtkShadowSampleDec.h"
#include "vtkShadowTarget.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include VTKNBUFFER_GL_HEADER

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
void vtkShadowShading::Declare(std::string& fragmentShader) const
{
  // Where props share their property keys, VTK calls a pass once for each of them.
  if (fragmentShader.find("NBUFFER_SHADOW_LIGHTS") != std::string::npos)
  {
    return;
  }
  const auto define = [](const char* name, std::size_t value)
  { return std::string("#define ") + name + " " + std::to_string(value) + "\n"; };
  std::string declaration = vtkShadowLightDec;
  vtkShaderProgram::Substitute(declaration, "//VTK::NBuffer::Shared", vtkNBufferSharedText);
  vtkShaderProgram::Substitute(declaration, "//VTK::NBuffer::Dec",
    define("NBUFFER_SHADOW_LIGHTS", this->ShaderLights.size()) +
      define("NBUFFER_SHADOW_MASKS", vtkShadowTarget::CountMasks(this->ShaderLights.size())) +
      define("NBUFFER_SHADOW_SAMPLES", this->Samples));
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Light::Dec", declaration + "//VTK::Light::Dec", false);
  if (this->Samples > 1)
  {
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
      std::string("//VTK::System::Dec\n") + vtkShadowSampleDec, false);
  }
}

bool vtkShadowShading::Insert(std::string& fragmentShader) const
{
  // Volumes begin in the surfaces themselves. A surface that was pushed away from the eye, so that
  // lines on it show, would be in its own shadow.
  for (const std::string offset : { "cFactor*cscale", "cOffset/65000" })
  {
    if (fragmentShader.find("shadowOffsets*" + offset) == std::string::npos)
    {
      vtkShaderProgram::Substitute(fragmentShader, offset, "shadowOffsets*" + offset);
    }
  }
  bool isKnown = true;
  for (std::size_t i = 0; i < this->ShaderLights.size(); ++i)
  {
    const std::string color = "lightColor" + std::to_string(this->ShaderLights[i]);
    const std::string share = "NBUFFER_SHADOW_SHARE(" + std::to_string(i) + ")";
    bool replaced = fragmentShader.find(share) != std::string::npos;
    if (replaced)
    {
      continue;
    }
    const auto replace = [&](const std::string& before, const std::string& after)
    {
      replaced = vtkShaderProgram::Substitute(fragmentShader, before + color + after,
                   before + share + " * " + color + after, true) ||
        replaced;
    };
    replace("diffuse += (df * ", ");");
    replace("specular += (sf * ", ");");
    replace("radiance = ", ";");
    replace("radiance = ", " * attenuation;"); // positional lights before VTK 9.5
    const bool used = fragmentShader.find("* " + color) != std::string::npos ||
      fragmentShader.find("= " + color) != std::string::npos;
    isKnown = isKnown && (replaced || !used);
  }
  return isKnown;
}

void vtkShadowShading::SetUp(const std::vector<vtkShadowLightSource>& lights, int samples)
{
  std::vector<int> numbers;
  for (const vtkShadowLightSource& light : lights)
  {
    numbers.push_back(light.Number);
  }
  if (numbers != this->ShaderLights || samples != this->Samples)
  {
    this->ShaderLights = numbers;
    this->Samples = samples;
    this->Time.Modified();
  }
}

void vtkShadowShading::SetParameters(vtkShaderProgram* program)
{
  if (this->DrawnFor == Purpose::Depth)
  {
    // For each prop vtkSSAOPass makes the draw buffers of its own framebuffer those of the one that
    // is bound. This one has only depth, and would be incomplete before OpenGL 4.1.
    this->State->vtkglDrawBuffer(GL_NONE);
  }
  const std::pair<const void*, int> current = { program, program->GetHandle() };
  if (current == this->LastProgram)
  {
    return;
  }
  this->LastProgram = current;
  if (program->IsUniformUsed("shadowMasks"))
  {
    program->SetUniform1iv(
      "shadowMasks", static_cast<int>(this->TextureUnits.size()), this->TextureUnits.data());
  }
  if (program->IsUniformUsed("shadowDepth"))
  {
    program->SetUniformi("shadowDepth", this->DepthUnit);
    program->SetUniform2fv("shadowSamples", static_cast<int>(this->SampleOffsets.size() / 2),
      this->SampleOffsets.data());
  }
  if (program->IsUniformUsed("shadowOffsets"))
  {
    program->SetUniformf("shadowOffsets", this->DrawnFor == Purpose::Color ? 1.0f : 0.0f);
  }
  if (program->IsUniformUsed("shadowAttenuations"))
  {
    program->SetUniform1fv(
      "shadowAttenuations", static_cast<int>(this->Attenuations.size()), this->Attenuations.data());
  }
}

vtkShadowShading::Scope::Scope(vtkShadowShading& shading, vtkOpenGLRenderWindow* window,
  const vtkShadowTarget& target, Purpose purpose)
  : ActiveUnit(window->GetState())
{
  // The masks are bound even if depth alone is drawn, because samplers of two kinds must not share
  // a texture unit.
  const int masks = vtkShadowTarget::CountMasks(shading.ShaderLights.size());
  for (int i = 0; i < masks; ++i)
  {
    this->Textures.push_back(target.GetMask(i));
  }
  if (purpose == Purpose::Color && target.GetDepth())
  {
    this->Textures.push_back(target.GetDepth());
  }
  std::vector<int> units;
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->Activate();
    units.push_back(texture->GetTextureUnit());
  }
  shading.State = window->GetState();
  shading.DrawnFor = purpose;
  shading.DepthUnit = units.back();
  units.resize(masks);
  shading.TextureUnits = std::move(units);
  shading.LastProgram = {};
  shading.SampleOffsets.clear();
  for (const auto& place : target.GetSamples())
  {
    shading.SampleOffsets.push_back(static_cast<float>(place[0] - 0.5));
    shading.SampleOffsets.push_back(static_cast<float>(place[1] - 0.5));
  }
  shading.Attenuations.assign(shading.ShaderLights.size(), 0.0f);
  std::transform(shading.Lights.begin(), shading.Lights.end(), shading.Attenuations.begin(),
    [](const vtkShadowLightSource& light) { return light.Attenuation; });
}

vtkShadowShading::Scope::~Scope()
{
  for (vtkTextureObject* texture : this->Textures)
  {
    texture->Deactivate();
  }
}
VTK_ABI_NAMESPACE_END
