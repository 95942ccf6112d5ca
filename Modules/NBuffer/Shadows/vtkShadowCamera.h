// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowCamera.h
 * @brief What shadow volumes need of a renderer's camera, in world coordinates relative to the eye.
 */
#ifndef vtkShadowCamera_h
#define vtkShadowCamera_h

#include "vtkShadowPlan.h"
#include "vtkShadowReceivers.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct vtkShadowCamera
{
  /// Of the eye that the renderer draws. Plan lacks the viewport and what else the caller chooses.
  explicit vtkShadowCamera(vtkRenderer* renderer);

  /// Of an image of the size of Plan.Viewport, with one sample in the middle of each pixel.
  vtkShadowView GetView() const;

  double Eye[3];
  double EyeToClip[16]; ///< Row-major, of places relative to the eye; z in [-w, w].
  double NearBounds[6]; ///< World, of the near plane's rectangle.
  vtkShadowPlan::View Plan;

private:
  void SetNearBounds();
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowCamera.h
