// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Messages.h
 * @brief The errors and warnings of VTK, collected or passed on, whether windows can be opened, and
 * the messages of exceptions.
 */
#ifndef Messages_h
#define Messages_h

#include <stdexcept>
#include <string>

/// Returns the text of the errors and warnings that VTK has reported since the last call. The first
/// call begins to collect them.
std::string TakeMessages();

/// Returns how many warnings a text has that TakeMessages() has returned.
int CountWarnings(const std::string& messages);

/// From now on calls `report` with the text of each error of VTK at once, and prints warnings.
/// Neither is collected any more.
void ReportErrors(void (*report)(const char* text));

/// Returns why this VTK cannot use a window of the class that VTK_DEFAULT_OPENGL_WINDOW names, or
/// of VTK's default class; "" if it can. Clears the collected messages.
std::string FindWindowFault();

/// Returns the message of the std::runtime_error that a function throws; "" if it throws none.
template <typename Function>
std::string GetThrownMessage(const Function& function)
{
  try
  {
    function();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

#endif
