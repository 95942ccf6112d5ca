// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sun.h"

#include "Scene.h"

#include "vtkMath.h"
#include "vtkProperty.h"

#include <cmath>

namespace NBufferExamples
{

glm::dvec3 GetDirectionToSun(const SunTime& time, int upAxis)
{
  const double latitude = vtkMath::RadiansFromDegrees(time.Latitude);
  const double declination = vtkMath::RadiansFromDegrees(
    23.45 * std::sin(vtkMath::RadiansFromDegrees(360.0 * (284 + time.Day) / 365.0)));
  const double hour = vtkMath::RadiansFromDegrees(15.0 * (time.Hour - 12.0));
  const double east = -std::cos(declination) * std::sin(hour);
  const double north = std::cos(latitude) * std::sin(declination) -
    std::sin(latitude) * std::cos(declination) * std::cos(hour);
  const double up = std::sin(latitude) * std::sin(declination) +
    std::cos(latitude) * std::cos(declination) * std::cos(hour);
  return upAxis == 2 ? glm::dvec3(east, north, up)
    : upAxis == 1    ? glm::dvec3(east, up, -north)
                     : glm::dvec3(up, east, north);
}

vtkSmartPointer<vtkLight> MakeSun(const SunTime& time, int upAxis)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOff();
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(1.0, 0.97, 0.90);
  SetSun(time, light, upAxis);
  return light;
}

void SetSun(const SunTime& time, vtkLight* light, int upAxis)
{
  light->SetPosition(glm::value_ptr(GetDirectionToSun(time, upAxis)));
}

void LightGround(const Scene& scene, bool isLit)
{
  const std::size_t first = scene.Plan ? scene.Plan->Buildings.size() : scene.Actors.size();
  for (std::size_t i = first; i < scene.Actors.size(); ++i)
  {
    scene.Actors[i]->GetProperty()->SetLighting(isLit);
  }
}

} // namespace NBufferExamples
