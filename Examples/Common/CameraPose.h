// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CameraPose.h
 * @brief Where the camera is in a frame, and in all frames of a walk.
 */
#ifndef CameraPose_h
#define CameraPose_h

#include <vector>

namespace NBufferExamples
{

struct CameraPose
{
  double Eye[3] = { 0.0, 0.0, 1.0 };
  double Target[3] = { 0.0, 0.0, 0.0 };
  double Up[3] = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  /// Distances of the near and far plane; both 0: fitted to the scene.
  double Near = 0.0;
  double Far = 0.0;
};

using CameraPath = std::vector<CameraPose>;

} // namespace NBufferExamples

#endif
