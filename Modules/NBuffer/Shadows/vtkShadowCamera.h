// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCamera.h
 * @brief What the shadow pass needs from a renderer's camera.
 */
#ifndef vtkShadowCamera_h
#define vtkShadowCamera_h

#include "vtkNBufferCamera.h"
#include "vtkShadowPlan.h"
#include "vtkShadowReceiverProjector.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct VTKNBUFFER_EXPORT vtkShadowCamera
{
  /// Reads the camera for the eye that the renderer draws. The caller sets Plan.Viewport and
  /// Plan.Boxes.
  explicit vtkShadowCamera(vtkRenderer* renderer);

  /// Returns the view of a depth image of the size of Plan.Viewport, with one sample in the middle
  /// of each pixel.
  vtkShadowView GetView() const;

  vtkShadowBlock NearBounds; ///< The box around the near plane's rectangle, in world coordinates.
  vtkShadowPlan::View Plan;  ///< What vtkShadowPlan needs.
};

VTK_ABI_NAMESPACE_END
#endif
