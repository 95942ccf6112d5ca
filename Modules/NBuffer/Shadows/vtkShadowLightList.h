// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowLightList.h
 * @brief Finds the lights of a renderer that cast shadows.
 *
 * A light casts if it is switched on, its intensity is above 0, and it is not a headlight. (A
 * headlight shines from the eye, which cannot see shadows of it.) A positional light is a spot if
 * its cone angle is below 90 degrees, as in VTK's shaders; otherwise it is a point light.
 * Directional lights and spots cast only if their position and focal point differ.
 */
#ifndef vtkShadowLightList_h
#define vtkShadowLightList_h

#include "vtkShadowLight.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkLight;
class vtkRenderer;

/// A light that casts shadows in a frame.
struct VTKNBUFFER_EXPORT vtkShadowLightSource
{
  vtkLight* Source = nullptr;
  int Number = 0; ///< The index among the lights that are on, as in the names of VTK's uniforms.
  float Attenuation = 1.0f; ///< The share of the light that its shadow takes away.
  vtkShadowLight Geometry;

  bool operator==(const vtkShadowLightSource& other) const
  {
    return this->Source == other.Source && this->Number == other.Number &&
      this->Attenuation == other.Attenuation && this->Geometry == other.Geometry;
  }

  /// The lights of a renderer that cast, in its order. `casts` is the user's choice (see
  /// vtkShadowVolumeClampPass): a light for which it returns false does not cast.
  static std::vector<vtkShadowLightSource> Find(
    vtkRenderer* renderer, const std::function<bool(vtkLight*)>& casts);
};
VTK_ABI_NAMESPACE_END
#endif
