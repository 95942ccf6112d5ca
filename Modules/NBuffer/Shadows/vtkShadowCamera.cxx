// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCamera.h"

#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkShadowCamera::vtkShadowCamera(vtkRenderer* renderer)
{
  const vtkNBufferCamera camera(renderer);
  this->Plan.Eye = camera.Eye;
  this->Plan.EyeToClip = camera.GetEyeToClip();
  const glm::dmat4 clipToEye = vtkNBufferGLM::Invert(this->Plan.EyeToClip);
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      const auto getCorner = [&](double z)
      {
        const glm::dvec4 corner = vtkNBufferGLM::Multiply(clipToEye, glm::dvec4(x, y, z, 1.0));
        return camera.Eye + glm::dvec3(corner) / corner.w;
      };
      this->NearBounds.Add(getCorner(-1.0));
      if (camera.IsParallel)
      {
        this->Plan.ParallelView.Add(getCorner(-1.0));
        this->Plan.ParallelView.Add(getCorner(1.0));
      }
    }
  }
}

vtkShadowView vtkShadowCamera::GetView() const
{
  vtkShadowView view;
  view.ClipToWorld = vtkNBufferGLM::Invert(this->Plan.EyeToClip);
  view.Origin = this->Plan.Eye;
  view.Width = this->Plan.Viewport[2];
  view.Height = this->Plan.Viewport[3];
  return view;
}
VTK_ABI_NAMESPACE_END
