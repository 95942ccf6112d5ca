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
#include <functional>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferViewSetup
{
  vtkNBufferViewKey Key;
  double DepthQuantum = 0x1p-24; ///< The step of the depth buffer used last, in window depth.
  vtkNBufferStoredDepth Stored = vtkNBufferStoredDepth::Ordinary; ///< What it stored.
  int SubpixelBits = 4; ///< vtkNBufferGL::GetSubpixelBits() of the context used last.

  /// Set what is known of the depth buffer. Returns whether anything has changed.
  bool SetDepth(double quantum, vtkNBufferStoredDepth stored, int subpixelBits)
  {
    auto known = std::tie(this->DepthQuantum, this->Stored, this->SubpixelBits);
    const auto found = std::tie(quantum, stored, subpixelBits);
    const bool hasChanged = known != found;
    known = found;
    return hasChanged;
  }

  /// Set `projection` to one from the coordinates that `toWorld` takes to the world.
  void Apply(vtkNBufferProjection& projection, const glm::dmat4& toWorld = glm::dmat4(1.0)) const
  {
    auto toClip =
      vtkNBufferGLM::ToRows(vtkNBufferGLM::ToMatrix(this->Key.WorldToClip.data()) * toWorld);
    if (this->Stored == vtkNBufferStoredDepth::Reversed)
    {
      std::transform(toClip.begin() + 8, toClip.begin() + 12, toClip.begin() + 8, std::negate<>());
    }
    const auto& viewport = this->Key.Viewport;
    projection.Set(toClip.data(), viewport[2], viewport[3],
      vtkNBufferDepthFormat::FromQuantum(this->DepthQuantum, this->Stored),
      glm::ivec2(viewport[0], viewport[1]), this->SubpixelBits);
  }
};

VTK_ABI_NAMESPACE_END
#endif
