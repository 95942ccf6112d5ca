// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLightList.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <cmath>

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
    light->GetTransformedPosition(glm::value_ptr(geometry.Position));
    glm::dvec3 focalPoint;
    light->GetTransformedFocalPoint(glm::value_ptr(focalPoint));
    const bool directed = glm::length(focalPoint - geometry.Position) > 0.0;
    if (directed)
    {
      geometry.Direction = vtkNBufferGLM::Normalize(focalPoint - geometry.Position);
    }
    if (light->GetPositional())
    {
      geometry.ConeAngle = std::abs(light->GetConeAngle()); // VTK compares cosines.
      geometry.Kind =
        geometry.ConeAngle < 90.0 ? vtkShadowLightKind::Spot : vtkShadowLightKind::Point;
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
