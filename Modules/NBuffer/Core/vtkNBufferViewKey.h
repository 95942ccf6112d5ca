// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferViewKey
 * @brief Everything but the props on which the verdicts of a frame depend.
 *
 * Two frames with equal keys project boxes alike and draw into the same buffers.
 */
#ifndef vtkNBufferViewKey_h
#define vtkNBufferViewKey_h

#include "vtkNBufferVTKVersion.h"
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkRenderer;

struct vtkNBufferViewKey
{
  std::array<double, 16> WorldToClip{}; ///< Row-major, as the mappers get it.
  std::array<int, 4> Viewport{};        ///< x, y, width, height in pixels of the window.
  vtkCamera* Camera = nullptr;          ///< Compared, never used.
  vtkMTimeType ContextTime = 0;
  int MultiSamples = 0;

  /// The key of a renderer that has a camera and an OpenGL window.
  static vtkNBufferViewKey Make(vtkRenderer* renderer);

  bool operator==(const vtkNBufferViewKey& other) const
  {
    return this->WorldToClip == other.WorldToClip && this->Viewport == other.Viewport &&
      this->Camera == other.Camera && this->ContextTime == other.ContextTime &&
      this->MultiSamples == other.MultiSamples;
  }
};

VTK_ABI_NAMESPACE_END
#endif
