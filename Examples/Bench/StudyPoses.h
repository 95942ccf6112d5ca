// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyPoses.h
 * @brief Which poses of a long path are measured.
 */
#ifndef StudyPoses_h
#define StudyPoses_h

#include "CameraPath.h"

namespace NBufferBench
{

/// Poses far enough apart to be different work.
NBufferExamples::CameraPath Spread(const NBufferExamples::CameraPath& path, int frames);

/// As the camera moves on, ten poses in a row, at several places of a path.
NBufferExamples::CameraPath MakeRuns(const NBufferExamples::CameraPath& path, int frames);

} // namespace NBufferBench

#endif
