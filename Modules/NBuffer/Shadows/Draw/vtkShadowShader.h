// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowShader.h
 * @brief What is written into the fragment shaders of VTK's mappers so that they receive shadows.
 *
 * Every term of a light, Phong's diffuse and specular and the radiance of PBR, is multiplied by the
 * share of the light that arrives (vtkShadowLightDec.glsl). VTK's lighting code is known from 9.1
 * to 9.7.
 */
#ifndef vtkShadowShader_h
#define vtkShadowShader_h

#include "vtkNBufferVTKVersion.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowShader
{
  std::vector<int> Lights; ///< Numbers of those with masks, as in the names of the uniforms.
  int Samples = 1;         ///< Of the masks.

  bool operator==(const vtkShadowShader& other) const
  {
    return this->Lights == other.Lights && this->Samples == other.Samples;
  }

  /// Before the mapper replaces what stands for its own code. A second time does nothing.
  void Declare(std::string& fragmentShader) const;

  /// When it has. A second time does nothing. False if the shader uses a light in a way that is not
  /// known: what it draws receives no shadow of it.
  bool Insert(std::string& fragmentShader) const;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowShader.h
