// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class HoverName
 * @brief The name of the part under the pointer, once the pointer has been still for a moment.
 *
 * The part is found by rays, not by drawing, so that nothing of the scene has to be drawn or
 * compiled again for it.
 */
#ifndef HoverName_h
#define HoverName_h

#include "Panel.h"

#include "vtkCellPicker.h"

#include <string>
#include <unordered_map>

class vtkProp;
class vtkRenderWindowInteractor;

namespace NBufferView
{

class HoverName
{
public:
  HoverName(View& view, Panel& panel, const NBufferExamples::Scene& scene);
  HoverName(const HoverName&) = delete;
  void operator=(const HoverName&) = delete;

  /// From now on the pointer of an interactor is followed.
  void Follow(vtkRenderWindowInteractor* interactor);

  /// Returns the name of the part in a pixel, or an empty text.
  std::string Find(int x, int y);

private:
  void Move();
  /// Ends the waiting at the event of the timer, or at a timer event without a timer, as scripts
  /// send it.
  bool Wait(vtkObject* caller, unsigned long event, void* timer);
  void Hide();

  View& Where;
  Panel& Text;
  const NBufferExamples::Scene& Parts;
  std::unordered_map<vtkProp*, std::size_t> Places; ///< In the list of the scene's actors.
  vtkRenderWindowInteractor* Pointer = nullptr;
  int Timer = 0; ///< 0 in an interactor that has no timers.
  bool IsWaiting = false;
  bool IsShown = false;
  vtkNew<vtkCellPicker> Picker;
};

} // namespace NBufferView

#endif
