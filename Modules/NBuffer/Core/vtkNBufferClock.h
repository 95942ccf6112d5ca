// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferClock
 * @brief A stopwatch in milliseconds for the times in the statistics. It starts when it is
 * constructed.
 */
#ifndef vtkNBufferClock_h
#define vtkNBufferClock_h

#include "vtkNBufferVTKVersion.h"

#include <chrono>

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferClock
{
public:
  /// The time since the construction or the last Restart().
  double GetMilliseconds() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - this->Start).count();
  }

  /// Return what GetMilliseconds() returns, and start again from zero.
  double Restart()
  {
    const double milliseconds = this->GetMilliseconds();
    this->Start = Clock::now();
    return milliseconds;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Start = Clock::now();
};

VTK_ABI_NAMESPACE_END
#endif
