// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowShader.h
 * @brief Writes shadows into the fragment shaders of VTK's mappers.
 *
 * Each term of a light (diffuse and specular of Phong shading, the radiance of PBR) is multiplied
 * by the share of the light that arrives, which vtkShadowLightDec.glsl declares. This file contains
 * what VTK's lighting code looks like, from VTK 9.1 to 9.7.
 */
#ifndef vtkShadowShader_h
#define vtkShadowShader_h

#include "vtkNBufferVTKVersion.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowShader
{
  std::vector<int> Lights; ///< The lights with masks, by their numbers in VTK's shaders.
  int Samples = 1;         ///< Samples of a pixel in the masks.

  bool operator==(const vtkShadowShader& other) const
  {
    return this->Lights == other.Lights && this->Samples == other.Samples;
  }

  /// Declare the masks. To be called before the mapper inserts its own code. Does nothing in a
  /// shader that declares them already.
  void Declare(std::string& fragmentShader) const;

  /// Multiply the terms of lights by their shares. To be called after the mapper has inserted its
  /// own code. Does nothing for terms that are multiplied already. Returns false if the shader uses
  /// a light in an unknown way, so that its props receive no shadow of that light.
  bool Insert(std::string& fragmentShader) const;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowShader.h
