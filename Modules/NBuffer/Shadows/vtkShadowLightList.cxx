// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLightList.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
std::vector<vtkShadowLightSource> vtkShadowLightSource::Find(
  vtkRenderer* renderer, const std::function<bool(vtkLight*)>& casts)
{
  std::vector<vtkShadowLightSource> result;
  int number = 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    vtkShadowLightSource source;
    source.Source = light;
    source.Number = number++;
    source.Attenuation = light->GetShadowAttenuation();
    vtkShadowLight& geometry = source.Geometry;
    light->GetTransformedPosition(geometry.Position);
    double focalPoint[3];
    light->GetTransformedFocalPoint(focalPoint);
    vtkMath::Subtract(focalPoint, geometry.Position, geometry.Direction);
    const bool directed = vtkMath::Normalize(geometry.Direction) > 0.0;
    const bool spot = light->GetPositional() && light->GetConeAngle() < 90.0;
    if (light->GetPositional())
    {
      geometry.Kind = spot ? vtkShadowLightKind::Spot : vtkShadowLightKind::Point;
      geometry.ConeAngle = light->GetConeAngle();
    }
    if (!directed)
    {
      const double down[3] = { 0.0, 0.0, -1.0 };
      std::copy_n(down, 3, geometry.Direction);
    }
    if (!light->LightTypeIsHeadlight() && light->GetIntensity() > 0.0 &&
      (directed || geometry.Kind == vtkShadowLightKind::Point) && casts(light))
    {
      result.push_back(source);
    }
  }
  return result;
}
VTK_ABI_NAMESPACE_END
