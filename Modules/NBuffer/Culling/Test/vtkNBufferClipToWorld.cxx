// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferClipToWorld.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferClipToWorld::Set(const double worldToClip[16])
{
  this->Matrix = vtkNBufferGLM::ToMatrix(worldToClip);
  this->Inverse = vtkNBufferGLM::Invert(this->Matrix);
}

double vtkNBufferClipToWorld::GetError(
  const glm::dvec4& face, int axis, double b, const vtkNBufferBox& box) const
{
  glm::dvec4 rest = this->ToWorld(face);
  rest[axis] -= 1.0;
  rest.w += b;
  return std::max(GetLargest(rest, box), GetLargest(-rest, box));
}

double vtkNBufferClipToWorld::GetLargestInverseW(const vtkNBufferBox& box) const
{
  // In view w = (N_3 q) / (N_3 ndc) >= (the least N_3 M p) / (the sum of |N_3|).
  const glm::dvec4 last = this->GetRow(3);
  const double inView = -GetLargest(-this->ToWorld(last), box) /
    (std::abs(last.x) + std::abs(last.y) + std::abs(last.z) + std::abs(last.w));
  const double w = std::max(-GetLargest(-glm::row(this->Matrix, 3), box), inView);
  return w > 0.0 ? 1.0 / w : std::numeric_limits<double>::infinity();
}
VTK_ABI_NAMESPACE_END
