// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyOptions.h
 * @brief What is asked of a study.
 */
#ifndef StudyOptions_h
#define StudyOptions_h

#include "Command.h"

#include <string>

namespace NBufferBench
{

struct StudyOptions
{
  ViewOptions View;
  std::string Folder = "out/study"; ///< For all that is written.
  std::string Links = ".";          ///< That folder as seen from the documents.
  std::string Scenes = "out/scenes";
  bool IsQuick = false;
  bool IsTiny = false;
  bool LeavesOutSettings = false;
  int Repetitions = 0;      ///< Of each frame; 0: as many as the extent says.
  double Megabytes = 120.0; ///< Larger structures are left out.

  /// Of three things, the one for the extent of this run.
  template <typename T>
  const T& Choose(const T& full, const T& quick, const T& tiny) const
  {
    return this->IsTiny ? tiny : this->IsQuick ? quick : full;
  }
};

} // namespace NBufferBench

#endif
