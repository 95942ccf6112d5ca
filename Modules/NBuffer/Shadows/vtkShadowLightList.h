// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowLightList.h
 * @brief Which of a renderer's lights cast, as geometry.
 *
 * A light casts if it is switched on with an intensity above 0, is no headlight (it stands in the
 * eye, where no shadow can be seen) and `casts` says so. Positional lights are spots if their cone
 * angle is below 90 degrees, as in VTK's shaders, else they shine in all directions.
 */
#ifndef vtkShadowLightList_h
#define vtkShadowLightList_h

#include "vtkShadowLight.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderer;

struct vtkShadowLightSource
{
  vtkLight* Source = nullptr;
  int Number = 0; ///< As in the names of the mappers' uniforms: counts lights that are on.
  float Attenuation = 1.0f;
  vtkShadowLight Geometry;

  bool operator==(const vtkShadowLightSource& other) const
  {
    return this->Source == other.Source && this->Number == other.Number &&
      this->Attenuation == other.Attenuation && this->Geometry == other.Geometry;
  }

  static std::vector<vtkShadowLightSource> Find(
    vtkRenderer* renderer, const std::function<bool(vtkLight*)>& casts);
};
VTK_ABI_NAMESPACE_END
#endif
