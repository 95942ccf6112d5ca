// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferProtectedRenderer.h
 * @brief The protected functions of vtkRenderer that this module calls (see
 * vtkNBufferProtectedMembers.h).
 */
#ifndef vtkNBufferProtectedRenderer_h
#define vtkNBufferProtectedRenderer_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferProtectedMembers
{
/// Draw what a renderer without a pass draws. While it has a vtkHardwareSelector, that is only what
/// may be selected. Returns the number of props drawn.
inline int DrawWithoutPass(vtkRenderer* renderer)
{
  struct Access : vtkRenderer
  {
    static int Draw(vtkRenderer* renderer)
    {
      (renderer->*&Access::UpdateCamera)();
      (renderer->*&Access::UpdateLightGeometry)();
      (renderer->*&Access::UpdateLights)();
      return (renderer->*&Access::UpdateGeometry)(nullptr);
    }
  };
  return Access::Draw(renderer);
}
}

VTK_ABI_NAMESPACE_END
#endif
