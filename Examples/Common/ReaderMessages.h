// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReaderMessages.h
 * @brief What VTK's readers say about a file, collected instead of printed.
 */
#ifndef ReaderMessages_h
#define ReaderMessages_h

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <sstream>
#include <string>

namespace NBufferExamples
{

/// Collects all messages of VTK, and what is written to std::cerr, while it lives.
class ReaderMessages
{
public:
  ReaderMessages();
  ~ReaderMessages();
  ReaderMessages(const ReaderMessages&) = delete;
  void operator=(const ReaderMessages&) = delete;

  /// Returns the first error on one line of moderate length, without the place in VTK's sources and
  /// the name of the class that reports it; an empty text if there was no error.
  std::string GetFirstError() const;

  /// Throws std::runtime_error with the first error, if there was one. To be called before damaged
  /// data are used for anything.
  void Check() const;

private:
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkSmartPointer<vtkOutputWindow> Collector;
  int Verbosity;             ///< What VTK's logger wrote to stderr before.
  std::ostringstream Errors; ///< The parser of VRML writes there.
  std::streambuf* PreviousErrors;
};

} // namespace NBufferExamples

#endif
