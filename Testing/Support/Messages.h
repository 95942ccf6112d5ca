// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Messages.h
 * @brief What VTK reports, kept for programs that compare it; and whether there are windows at all.
 */
#ifndef Messages_h
#define Messages_h

#include <string>

/// Text of the errors and warnings that VTK reported since the last call. They are collected from
/// the first call on.
std::string TakeMessages();

/// Empty, or why a window of the class that the environment selects does not work in this VTK.
std::string FindWindowFault();

#endif
