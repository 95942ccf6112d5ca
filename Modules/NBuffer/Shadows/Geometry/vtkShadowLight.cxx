// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLight.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

bool vtkShadowLight::operator==(const vtkShadowLight& other) const
{
  return this->Kind == other.Kind && this->ConeAngle == other.ConeAngle &&
    std::equal(this->Position, this->Position + 3, other.Position) &&
    std::equal(this->Direction, this->Direction + 3, other.Direction);
}

int vtkShadowLight::GetFacing(const double a[3], const double b[3], const double c[3]) const
{
  double ab[3];
  double ac[3];
  double normal[3];
  vtkMath::Subtract(b, a, ab);
  vtkMath::Subtract(c, a, ac);
  vtkMath::Cross(ab, ac, normal);
  double side;
  if (this->IsPositional())
  {
    double toLight[3];
    vtkMath::Subtract(this->Position, a, toLight);
    side = vtkMath::Dot(normal, toLight);
  }
  else
  {
    side = -vtkMath::Dot(normal, this->Direction);
  }
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

bool vtkShadowLight::IsInCone(const double x[3]) const
{
  if (this->Kind != vtkShadowLightKind::Spot)
  {
    return true;
  }
  double ray[3];
  vtkMath::Subtract(x, this->Position, ray);
  return vtkMath::Dot(ray, this->Direction) >= this->GetConeCosine() * vtkMath::Norm(ray);
}

vtkShadowLightSpace::vtkShadowLightSpace(const vtkShadowLight& light)
  : Positional(light.IsPositional())
{
  std::copy_n(light.Position, this->Positional ? 3 : 0, this->Apex);
  this->SetAxis(light.Direction);
}

vtkShadowLightSpace::vtkShadowLightSpace(const vtkShadowLight& light, const double axis[3])
  : Positional(light.IsPositional())
{
  std::copy_n(light.Position, this->Positional ? 3 : 0, this->Apex);
  this->SetAxis(axis);
}

void vtkShadowLightSpace::SetAxis(const double axis[3])
{
  std::copy_n(axis, 3, this->Axis);
  vtkMath::Normalize(this->Axis);
  vtkMath::Perpendiculars(this->Axis, this->U, this->V, 0.0);
}

double vtkShadowLightSpace::GetDepth(const double x[3]) const
{
  double ray[3];
  vtkMath::Subtract(x, this->Apex, ray);
  return vtkMath::Dot(ray, this->Axis);
}

void vtkShadowLightSpace::ToLight(const double x[3], double pqs[3]) const
{
  double ray[3];
  vtkMath::Subtract(x, this->Apex, ray);
  const double s = vtkMath::Dot(ray, this->Axis);
  const double divisor = this->Positional ? s : 1.0;
  pqs[0] = vtkMath::Dot(ray, this->U) / divisor;
  pqs[1] = vtkMath::Dot(ray, this->V) / divisor;
  pqs[2] = s;
}

void vtkShadowLightSpace::ToWorld(const double pqs[3], double x[3]) const
{
  const double factor = this->Positional ? pqs[2] : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    x[i] =
      this->Apex[i] + factor * (pqs[0] * this->U[i] + pqs[1] * this->V[i]) + pqs[2] * this->Axis[i];
  }
}

void vtkShadowLightSpace::Extrude(const double x[3], double s, double result[3]) const
{
  const double depth = this->GetDepth(x);
  if (this->Positional)
  {
    for (int i = 0; i < 3; ++i)
    {
      result[i] = this->Apex[i] + (x[i] - this->Apex[i]) * (s / depth);
    }
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    result[i] = x[i] + (s - depth) * this->Axis[i];
  }
}
VTK_ABI_NAMESPACE_END
