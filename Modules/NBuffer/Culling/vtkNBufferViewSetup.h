// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferViewSetup
 * @brief All that a vtkNBufferProjection depends on.
 */
#ifndef vtkNBufferViewSetup_h
#define vtkNBufferViewSetup_h

#include "vtkNBufferCamera.h"
#include "vtkNBufferProjection.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferViewSetup
{
  vtkNBufferViewKey Key;
  double DepthQuantum = 0x1p-24; ///< The step of the depth buffer used last, in window depth.
  int SubpixelBits = 4;          ///< vtkNBufferGL::GetSubpixelBits() of the context used last.

  /// Set `projection` to one from the coordinates that `toWorld` takes to the world.
  void Apply(vtkNBufferProjection& projection, const glm::dmat4& toWorld = glm::dmat4(1.0)) const
  {
    const auto toClip =
      vtkNBufferGLM::ToRows(vtkNBufferGLM::ToMatrix(this->Key.WorldToClip.data()) * toWorld);
    const auto& viewport = this->Key.Viewport;
    projection.Set(toClip.data(), viewport[2], viewport[3], this->DepthQuantum,
      std::max(viewport[0] + viewport[2], viewport[1] + viewport[3]), this->SubpixelBits);
  }
};

VTK_ABI_NAMESPACE_END
#endif
