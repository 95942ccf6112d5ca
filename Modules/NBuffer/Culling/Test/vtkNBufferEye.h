// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferEye
 * @brief From where a camera looks, and whether another one sees a point from elsewhere. No OpenGL.
 *
 * What was visible from one side of a scene says little about what is visible from another side:
 *
 *     eye 1  -->   A   B   C   D   <--  eye 2
 *
 * From the first eye, A hides the others. From the second one, A is hidden, and hides nothing.
 */
#ifndef vtkNBufferEye_h
#define vtkNBufferEye_h

#include "vtkNBufferProjection.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferEye
{
public:
  /// No eye, which sees every point from elsewhere.
  vtkNBufferEye() = default;

  /// The eye of a camera, in the coordinates from which it projects.
  explicit vtkNBufferEye(const vtkNBufferProjection& projection)
  {
    const vtkNBufferProjection::Rows& rows = projection.GetWorldToClip();
    const glm::dmat4 toClip = glm::transpose(glm::dmat4(rows[0], rows[1], rows[2], rows[3]));
    this->Position = vtkNBufferGLM::Invert(toClip)[2]; // In clip coordinates x, y and w are 0.
  }

  /// Whether the two eyes see a point from directions that are more than 30 degrees apart. On a
  /// path around a scene in 30 frames, each frame turns it by 12 degrees.
  bool SeesFromElsewhere(const glm::dvec3& point, const vtkNBufferEye& other) const
  {
    constexpr double cosine = 0.866;
    return glm::dot(this->GetDirection(point), other.GetDirection(point)) < cosine;
  }

private:
  /// The direction to the eye.
  glm::dvec3 GetDirection(const glm::dvec3& point) const
  {
    return vtkNBufferGLM::Normalize(glm::dvec3(this->Position) - this->Position.w * point);
  }

  /// Homogeneous coordinates; of a parallel camera they are the direction to it.
  glm::dvec4 Position = glm::dvec4(0.0);
};

VTK_ABI_NAMESPACE_END
#endif
