// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Once.h
 * @brief Observes an event of VTK one time.
 */
#ifndef Once_h
#define Once_h

#include "vtkCommand.h"
#include "vtkNew.h"

#include <functional>
#include <utility>

/// Calls a function on the first event that it hears.
class Once : public vtkCommand
{
public:
  static Once* New() { return new Once; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    if (std::function<void()> action = std::move(this->Action))
    {
      this->Action = nullptr;
      action();
    }
  }

  std::function<void()> Action;
};

/// Calls `action` when `object` invokes the event the next time.
inline void Observe(
  vtkObject* object, unsigned long event, std::function<void()> action, float priority = 0.0F)
{
  vtkNew<Once> once;
  once->Action = std::move(action);
  object->AddObserver(event, once, priority);
}

#endif
