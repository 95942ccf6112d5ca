// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CameraPose.h
 * @brief The camera of a frame, and the cameras of all frames of a walk.
 */
#ifndef CameraPose_h
#define CameraPose_h

#include "vtkNBufferGLM.h"

#include <vector>

namespace NBufferExamples
{

struct CameraPose
{
  glm::dvec3 Eye = { 0.0, 0.0, 1.0 };
  glm::dvec3 Target = { 0.0, 0.0, 0.0 };
  glm::dvec3 Up = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0; ///< The vertical view angle in degrees.
  ///@{
  /// The distances of the near and the far plane. If both are 0, they are fitted to the scene.
  double Near = 0.0;
  double Far = 0.0;
  ///@}
};

using CameraPath = std::vector<CameraPose>;

} // namespace NBufferExamples

#endif
