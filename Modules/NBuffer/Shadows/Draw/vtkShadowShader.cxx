// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShader.h"

#include "vtkNBufferSharedText.h"
#include "vtkShadowLightDec.h"
#include "vtkShadowSampleDec.h"
#include "vtkShadowTarget.h"

#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
void vtkShadowShader::Declare(std::string& fragmentShader) const
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
    define("NBUFFER_SHADOW_LIGHTS", this->Lights.size()) +
      define("NBUFFER_SHADOW_MASKS", vtkShadowTarget::CountMasks(this->Lights.size())) +
      define("NBUFFER_SHADOW_SAMPLES", this->Samples));
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Light::Dec", declaration + "//VTK::Light::Dec", false);
  if (this->Samples > 1)
  {
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
      std::string("//VTK::System::Dec\n") + vtkShadowSampleDec, false);
  }
}

bool vtkShadowShader::Insert(std::string& fragmentShader) const
{
  bool isKnown = true;
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const std::string color = "lightColor" + std::to_string(this->Lights[i]);
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
VTK_ABI_NAMESPACE_END
