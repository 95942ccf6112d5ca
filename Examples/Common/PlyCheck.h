// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlyCheck.h
 * @brief Whether a .ply file has all the elements that its header announces.
 *
 * Of a file that was cut short vtkPLYReader makes faces with points that do not exist. It reports
 * nothing, and VTK 9.1 crashes when it draws them.
 */
#ifndef PlyCheck_h
#define PlyCheck_h

#include <string>

namespace NBufferExamples
{

/// Throws std::runtime_error if the file ends too early. Files whose header is not understood pass:
/// the reader reports those itself.
void CheckPly(const std::string& path);

} // namespace NBufferExamples

#endif
