// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LegacyCheck.h
 * @brief Whether a .vtk file has all the points and cells that it announces.
 *
 * The reader of VTK 9.1 crashes in the cells of a file that was cut short.
 */
#ifndef LegacyCheck_h
#define LegacyCheck_h

#include <string>

namespace NBufferExamples
{

/// Throws std::runtime_error if the file ends within its points or cells. Whatever else is wrong is
/// left to the reader.
void CheckLegacy(const std::string& path);

} // namespace NBufferExamples

#endif
