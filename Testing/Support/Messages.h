// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Messages.h
 * @brief What VTK reports, kept for programs that compare it, or passed on; and whether there are
 * windows at all.
 */
#ifndef Messages_h
#define Messages_h

#include <string>

/// Text of the errors and warnings that VTK reported since the last call. They are collected from
/// the first call on.
std::string TakeMessages();

/// From now on `report` gets the text of each error of VTK at once, and warnings are printed.
/// Neither is collected any more.
void ReportErrors(void (*report)(const char* text));

/// Empty, or why a window of the class that the environment selects does not work in this VTK.
std::string FindWindowFault();

#endif
