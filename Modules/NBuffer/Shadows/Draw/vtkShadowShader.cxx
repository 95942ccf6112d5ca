// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShader.h"

#include "vtkShadowLightDec.h"
#include "vtkShadowSampleDec.h"
#include "vtkShadowTarget.h"

#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr std::size_t LightsPerMask = vtkShadowTarget::LightsPerMask;
}

void vtkShadowShader::Declare(std::string& fragmentShader) const
{
  // Props that share their property keys hand a pass on once for each.
  if (fragmentShader.find("NBUFFER_SHADOW_LIGHTS") != std::string::npos)
  {
    return;
  }
  const std::size_t masks = (this->Lights.size() + LightsPerMask - 1) / LightsPerMask;
  const std::string declaration = "#define NBUFFER_SHADOW_LIGHTS " +
    std::to_string(this->Lights.size()) + "\n#define NBUFFER_SHADOW_MASKS " +
    std::to_string(masks) + "\n#define NBUFFER_SHADOW_SAMPLES " + std::to_string(this->Samples) +
    "\n" + vtkShadowLightDec;
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
    const std::string share = "NBUFFER_SHADOW_SHARE(" + std::to_string(i) + ", " +
      std::to_string(i / LightsPerMask) + ", " + std::to_string(i % LightsPerMask) + ")";
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
