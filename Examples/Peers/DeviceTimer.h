// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DeviceTimer
 * @brief The time that the graphics device takes for a row of commands, by a timer query.
 */
#ifndef DeviceTimer_h
#define DeviceTimer_h

#include <memory>

class vtkOpenGLRenderTimer;

namespace NBufferPeers
{

class DeviceTimer
{
public:
  DeviceTimer();
  ~DeviceTimer();

  ///@{
  /// Are called before and after the commands, with their context current.
  void Start();
  void Stop();
  ///@}

  /// Waits for the commands, and returns the milliseconds that the device took for them, or -1
  /// where there are no timers.
  double GetMilliseconds();

private:
  std::unique_ptr<vtkOpenGLRenderTimer> Timer;
};

} // namespace NBufferPeers

#endif
