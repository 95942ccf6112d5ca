// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Study.h
 * @brief What accuracy costs in time: all depth structures on the same frames, and the figures of
 * the paper.
 */
#ifndef Study_h
#define Study_h

#include "StudyOptions.h"

namespace NBufferBench
{

/**
 * Measure, and write study.json, CSV, charts and documents. The scene can also be a part of the
 * study alone: shadows, settings or shadow-settings. Returns ImagesDiffer if anything visible was
 * hidden or lit wrongly. Throws std::runtime_error when a file cannot be read or written.
 */
int RunStudy(const StudyOptions& options);

} // namespace NBufferBench

#endif
