// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLErrors.h
 * @brief Errors of OpenGL in the context that is current.
 */
#ifndef GLErrors_h
#define GLErrors_h

#include <string>

/// From now on `report` gets the text of each error that OpenGL makes in this context, at once, by
/// debug output. Nothing happens before OpenGL 4.3, which has none.
void ReportGLErrors(void (*report)(const char* text));

/// The same, for TakeGLErrors().
void CollectGLErrors();

/// What was collected, and what glGetError() says, which is cleared; "" if there was no error.
/// `isPending`: whether glGetError() said anything.
std::string TakeGLErrors(bool* isPending = nullptr);

#endif
