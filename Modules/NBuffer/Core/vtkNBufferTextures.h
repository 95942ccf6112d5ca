// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTextures.h
 * @brief The textures with which VTK draws an actor.
 */
#ifndef vtkNBufferTextures_h
#define vtkNBufferTextures_h

#include "vtkActor.h"
#include "vtkNBufferVTKVersion.h"
#include "vtkProperty.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkTexture;

/// The textures of an actor and of its property, which is created if it is missing.
inline std::vector<vtkTexture*> vtkNBufferGetTextures(vtkActor* actor)
{
  std::vector<vtkTexture*> textures;
  if (actor->GetTexture())
  {
    textures.push_back(actor->GetTexture());
  }
  for (const auto& [name, texture] : actor->GetProperty()->GetAllTextures())
  {
    if (texture)
    {
      textures.push_back(texture);
    }
  }
  return textures;
}

VTK_ABI_NAMESPACE_END
#endif
