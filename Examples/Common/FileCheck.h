// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileCheck.h
 * @brief Whether a file has all that it announces, where VTK's reader does not find that out.
 */
#ifndef FileCheck_h
#define FileCheck_h

#include <string>

namespace NBufferExamples
{

/// Throws std::runtime_error if a .ply file ends before the last element that its header announces.
/// Of such a file vtkPLYReader makes faces with points that do not exist. It reports nothing, and
/// VTK 9.1 crashes when it draws them. Files whose header is not understood pass: the reader
/// reports those itself.
void CheckPly(const std::string& path);

/// Throws std::runtime_error if a .vtk file ends within its points or cells, in which the reader of
/// VTK 9.1 crashes. Whatever else is wrong is left to the reader.
void CheckLegacy(const std::string& path);

} // namespace NBufferExamples

#endif
