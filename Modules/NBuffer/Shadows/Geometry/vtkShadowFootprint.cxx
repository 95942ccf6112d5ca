// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFootprint.h"

VTK_ABI_NAMESPACE_BEGIN
vtkShadowFootprint vtkShadowFootprint::Make(
  vtkShadowPoints points, const vtkShadowLightSpace& space)
{
  vtkShadowFootprint result;
  for (const glm::dvec3& point : points)
  {
    result.Block.Add(space.ToLight(point));
    result.Bounds.Add(point);
  }
  return result;
}

vtkShadowFootprint vtkShadowFootprint::Make(
  const vtkShadowSilhouette& silhouette, vtkShadowPoints points, const vtkShadowLightSpace& space)
{
  vtkShadowFootprint result;
  for (const int corner : silhouette.GetTriangles())
  {
    result.Block.Add(space.ToLight(points[corner]));
    result.Bounds.Add(points[corner]);
  }
  return result;
}

std::array<glm::dvec3, 8> vtkShadowFootprint::GetCorners() const
{
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { (i & 1 ? this->Bounds.High : this->Bounds.Low)[0],
      (i & 2 ? this->Bounds.High : this->Bounds.Low)[1],
      (i & 4 ? this->Bounds.High : this->Bounds.Low)[2] };
  }
  return corners;
}
VTK_ABI_NAMESPACE_END
