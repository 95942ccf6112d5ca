// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLight.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

int vtkShadowLight::GetFacing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const
{
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double side = this->IsPositional() ? glm::dot(normal, this->Position - a)
                                           : -glm::dot(normal, this->Direction);
  return side > 0.0 ? 1 : (side < 0.0 ? -1 : 0);
}

double vtkShadowLight::GetConeCosine() const
{
  if (this->Kind != vtkShadowLightKind::Spot)
  {
    return -1.0;
  }
  constexpr double margin = 0.01;
  return std::cos(vtkMath::RadiansFromDegrees(std::min(this->ConeAngle + margin, 180.0)));
}

vtkShadowLightSpace::vtkShadowLightSpace(const vtkShadowLight& light, const glm::dvec3& axis)
  : Positional(light.IsPositional())
  , Apex(light.IsPositional() ? light.Position : glm::dvec3(0.0))
  , Axis(vtkNBufferGLM::Normalize(axis))
{
  vtkMath::Perpendiculars(
    glm::value_ptr(this->Axis), glm::value_ptr(this->U), glm::value_ptr(this->V), 0.0);
}

glm::dvec3 vtkShadowLightSpace::Extrude(const glm::dvec3& x, double s) const
{
  const double depth = this->GetDepth(x);
  return this->Positional ? this->Apex + (x - this->Apex) * (s / depth)
                          : x + (s - depth) * this->Axis;
}

std::vector<vtkShadowLightSpace> vtkShadowLightSpace::MakeFaces(const vtkShadowLight& light)
{
  std::vector<vtkShadowLightSpace> faces;
  for (int i = 0; i < 6; ++i)
  {
    glm::dvec3 axis(0.0);
    axis[i / 2] = i % 2 ? -1.0 : 1.0;
    faces.emplace_back(light, axis);
  }
  return faces;
}
VTK_ABI_NAMESPACE_END
