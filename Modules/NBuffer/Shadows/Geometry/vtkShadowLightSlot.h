// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowLightSlot
 * @brief The number of a shadow-casting light in a frame, and where its shadow is stored. No
 * OpenGL.
 *
 * The lights that cast are numbered 0, 1, 2, ... in the order of the renderer's lights. Masks are
 * textures with four channels, and each channel holds the shadow of one light:
 *
 *     slot      0  1  2  3    4  5  6  7    8 ...
 *     mask      0  0  0  0    1  1  1  1    2
 *     channel   r  g  b  a    r  g  b  a    r
 */
#ifndef vtkShadowLightSlot_h
#define vtkShadowLightSlot_h

#include "vtkNBufferVTKVersion.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowLightSlot
{
  /// The channels of a mask.
  static constexpr int LightsPerMask = 4;

  /// The number of masks that hold the shadows of so many lights.
  static constexpr int CountMasks(std::size_t lights)
  {
    return static_cast<int>((lights + LightsPerMask - 1) / LightsPerMask);
  }

  /// The mask that holds this light's shadow.
  constexpr int GetMask() const { return static_cast<int>(this->Number / LightsPerMask); }

  /// The channel of that mask: 0 red, 1 green, 2 blue, 3 alpha.
  constexpr int GetChannel() const { return static_cast<int>(this->Number % LightsPerMask); }

  /// The number of the light.
  std::size_t Number = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowLightSlot.h
