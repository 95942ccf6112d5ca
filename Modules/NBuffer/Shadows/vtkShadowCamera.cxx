// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkShadowCamera::vtkShadowCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(this->Eye);
  camera->GetDirectionOfProjection(this->Plan.Direction);
  this->Plan.Parallel = camera->GetParallelProjection() != 0;
  // vtkCamera's composite matrix leaves the eyes' shear out.
  double worldToClip[16];
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(),
    camera->GetModelViewTransformMatrix()->GetData(), worldToClip);
  for (int row = 0; row < 4; ++row)
  {
    const double* m = worldToClip + 4 * row;
    std::copy_n(m, 3, this->EyeToClip + 4 * row);
    this->EyeToClip[4 * row + 3] =
      m[0] * this->Eye[0] + m[1] * this->Eye[1] + m[2] * this->Eye[2] + m[3];
  }
  for (int i = 0; i < 4; ++i)
  {
    this->Plan.NearPlane[i] = this->EyeToClip[8 + i] + this->EyeToClip[12 + i];
  }
  this->SetNearBounds();
}

void vtkShadowCamera::SetNearBounds()
{
  double clipToEye[16];
  vtkMatrix4x4::Invert(this->EyeToClip, clipToEye);
  for (int corner = 0; corner < 4; ++corner)
  {
    double x[4] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0, -1.0, 1.0 };
    vtkMatrix4x4::MultiplyPoint(clipToEye, x, x);
    for (int i = 0; i < 3; ++i)
    {
      const double place = this->Eye[i] + x[i] / x[3];
      double* bounds = this->NearBounds + 2 * i;
      bounds[0] = corner == 0 ? place : std::min(bounds[0], place);
      bounds[1] = corner == 0 ? place : std::max(bounds[1], place);
    }
  }
}

vtkShadowView vtkShadowCamera::GetView() const
{
  vtkShadowView view;
  vtkMatrix4x4::Invert(this->EyeToClip, view.ClipToWorld);
  std::copy_n(this->Eye, 3, view.Origin);
  view.Width = this->Plan.Viewport[2];
  view.Height = this->Plan.Viewport[3];
  return view;
}
VTK_ABI_NAMESPACE_END
