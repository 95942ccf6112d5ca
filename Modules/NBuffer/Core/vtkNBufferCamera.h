// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCamera
 * @brief The camera of a renderer for the eye that is drawn, as culler and shadows use it.
 *
 * vtkCamera::GetCompositeProjectionTransformMatrix() leaves out the shear of a stereo pair's eyes.
 * The mappers multiply projection and model-view matrix, and so does this class.
 */
#ifndef vtkNBufferCamera_h
#define vtkNBufferCamera_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;

struct VTKNBUFFER_EXPORT vtkNBufferCamera
{
  /// The active camera of a renderer that has one, for the eye that the renderer draws.
  explicit vtkNBufferCamera(vtkRenderer* renderer);

  /// From positions relative to Eye to clip coordinates: without the large numbers that cancel
  /// where the world's origin is far away.
  glm::dmat4 GetEyeToClip() const;

  glm::dmat4 WorldToClip;  ///< From world to clip coordinates, in which -w <= z <= w is seen.
  glm::dvec3 Eye;          ///< The camera's position in the world.
  glm::dvec3 Direction;    ///< The direction of projection in the world, with unit length.
  bool IsParallel = false; ///< True for parallel projection.
};

VTK_ABI_NAMESPACE_END
#endif
