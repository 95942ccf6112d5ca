// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCamera.h
 * @brief What shadow volumes need of a renderer's camera, in world coordinates relative to the eye.
 */
#ifndef vtkShadowCamera_h
#define vtkShadowCamera_h

#include "vtkNBufferCamera.h"
#include "vtkShadowPlan.h"
#include "vtkShadowReceivers.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct vtkShadowCamera
{
  /// The camera for the eye that the renderer draws. The caller sets the viewport of Plan, and how
  /// boxes are used.
  explicit vtkShadowCamera(vtkRenderer* renderer);

  /// The view of an image of the size of Plan.Viewport, with one sample in the middle of each
  /// pixel.
  vtkShadowView GetView() const;

  glm::dvec3 Eye;            ///< The camera's position in the world.
  glm::dmat4 EyeToClip;      ///< From positions relative to Eye to clip coordinates.
  vtkShadowBlock NearBounds; ///< The box around the near plane's rectangle, world.
  vtkShadowPlan::View Plan;  ///< What vtkShadowPlan needs.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCamera.h
