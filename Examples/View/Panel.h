// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Panel
 * @brief Text over a view: lines at the bottom, a list at the top, and a label anywhere.
 */
#ifndef Panel_h
#define Panel_h

#include "View.h"

#include "vtkTextActor.h"

#include <string>

namespace NBufferView
{

class Panel
{
public:
  explicit Panel(View& view);

  /// Set the text at the bottom and the list at the top. A text may have several lines; an empty
  /// one is not drawn.
  void SetLines(const std::string& text);
  void SetList(const std::string& text);
  /// Sets the label at a place of the window, in pixels from its lower left corner.
  void SetLabel(const std::string& text, int x, int y);

private:
  View& Where;
  vtkNew<vtkTextActor> Lines;
  vtkNew<vtkTextActor> List;
  vtkNew<vtkTextActor> Label;
};

} // namespace NBufferView

#endif
