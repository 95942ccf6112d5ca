// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLErrors.h
 * @brief The errors of OpenGL in the current context.
 */
#ifndef GLErrors_h
#define GLErrors_h

#include <string>

/// Makes OpenGL call `report` with the text of each error of this context at once (debug output).
/// Does nothing before OpenGL 4.3, which has no debug output.
void ReportGLErrors(void (*report)(const char* text));

/// Makes OpenGL collect the texts of errors of this context in the same way, for TakeGLErrors().
void CollectGLErrors();

/// Returns and clears the collected texts and the errors of glGetError(); "" if there was no error.
/// Sets `isPending`, if given, to whether glGetError() returned an error.
std::string TakeGLErrors(bool* isPending = nullptr);

#endif
