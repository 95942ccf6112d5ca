// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sun.h"

#include "Scene.h"

#include "vtkMath.h"
#include "vtkProperty.h"

#include <cmath>

namespace NBufferExamples
{

glm::dvec3 GetDirectionToSun(const SunTime& time)
{
  const double latitude = vtkMath::RadiansFromDegrees(time.Latitude);
  const double declination = vtkMath::RadiansFromDegrees(
    23.45 * std::sin(vtkMath::RadiansFromDegrees(360.0 * (284 + time.Day) / 365.0)));
  const double hour = vtkMath::RadiansFromDegrees(15.0 * (time.Hour - 12.0));
  return { -std::cos(declination) * std::sin(hour),
    std::cos(latitude) * std::sin(declination) -
      std::sin(latitude) * std::cos(declination) * std::cos(hour),
    std::sin(latitude) * std::sin(declination) +
      std::cos(latitude) * std::cos(declination) * std::cos(hour) };
}

vtkSmartPointer<vtkLight> MakeSun(const SunTime& time)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(1.0, 0.97, 0.90);
  SetSun(time, light);
  return light;
}

void SetSun(const SunTime& time, vtkLight* light)
{
  light->SetPosition(glm::value_ptr(GetDirectionToSun(time)));
}

void LightGround(const Scene& city)
{
  for (std::size_t i = city.Plan->Buildings.size(); i < city.Actors.size(); ++i)
  {
    city.Actors[i]->GetProperty()->LightingOn();
  }
}

} // namespace NBufferExamples
