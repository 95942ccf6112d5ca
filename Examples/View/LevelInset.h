// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class LevelInset
 * @brief Shows a level of the N-buffer of the frame in the upper right quarter of the window.
 */
#ifndef LevelInset_h
#define LevelInset_h

#include "View.h"

#include "vtkActor2D.h"
#include "vtkImageMapper.h"
#include "vtkImageResize.h"

#include <string>

namespace NBufferView
{

class LevelInset
{
public:
  explicit LevelInset(View& view);
  LevelInset(const LevelInset&) = delete;
  void operator=(const LevelInset&) = delete;

  /// Shows level 0, then with each call the next level, and after the last one nothing.
  void ShowNext();

  /// Returns what is shown in a few words, or an empty text.
  std::string Describe() const;

private:
  /// Reads the depth. Is called when the scene has been drawn.
  void Update();

  View& Where;
  int Level = -1; ///< -1: nothing is shown.
  int Count = 1;  ///< Levels of the last frame that was read.
  vtkNew<vtkImageResize> Size;
  vtkNew<vtkImageMapper> Mapper;
  vtkNew<vtkActor2D> Inset;
};

} // namespace NBufferView

#endif
