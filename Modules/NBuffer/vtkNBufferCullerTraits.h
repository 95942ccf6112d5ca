// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCullerTraits
 * @brief What a culler may say about itself, so that vtkShadowVolumeClampPass can reuse its
 * shadows.
 *
 * vtkShadowVolumeClampPass reuses the shadow masks of the last frame while nothing that they depend
 * on has changed. Normally they depend on which props the renderer's cullers have left in the list.
 * They do not if the cullers remove only props that show in no pixel. vtkNBufferCuller derives from
 * this class to say so, and a culler of your own may do the same.
 */
#ifndef vtkNBufferCullerTraits_h
#define vtkNBufferCullerTraits_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferCullerTraits
{
public:
  /// Whether the image is the same, to the bit, as without this culler.
  virtual bool PreservesImage() const = 0;

protected:
  vtkNBufferCullerTraits() = default;
  ~vtkNBufferCullerTraits() = default;
};

VTK_ABI_NAMESPACE_END
#endif
