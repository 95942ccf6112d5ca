// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTimers
 * @brief Measures how long the graphics device takes for the stages of a frame with shadows.
 *
 * The times come from VTK's vtkOpenGLRenderTimerLog, which reads time stamps of the device when
 * they have arrived and never waits for them. This class has a log of its own, because the log of
 * the render window belongs to the application. The class also does what the log does not do: it
 * requires OpenGL 3.3 or ARB_timer_query, adds up the pieces of a stage, and flushes around each
 * piece. Renderers that collect draws before they execute them (llvmpipe, tiled devices) would
 * otherwise report the time of the last tile only.
 */
#ifndef vtkShadowTimers_h
#define vtkShadowTimers_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowStatistics.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderTimerLog.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowTimers
{
public:
  /**
   * Begins a frame, which is measured if `measure` is true and the device has timers. Without
   * `measure` OpenGL is not called, unless queries of an earlier frame remain to be deleted. The
   * context must be current.
   */
  void Begin(bool measure);

  /// See vtkShadowStatistics::DeviceTimes. The time of a stage that the frame did not have is 0.
  const vtkShadowStageTimes& GetTimes() const { return this->Times; }

  /// Measures the OpenGL calls of its lifetime as a piece of a stage. Scopes must not overlap.
  class VTKNBUFFER_EXPORT Scope
  {
  public:
    Scope(vtkShadowTimers& timers, vtkShadowStage stage);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkOpenGLRenderTimerLog* Log = nullptr; ///< Null if nothing is measured.
  };

  /// How many pieces of stages were measured since construction.
  int GetNumberOfIntervals() const { return this->NumberOfIntervals; }

  /// Deletes all queries. Their context must be current.
  void Release();

private:
  int NumberOfIntervals = 0;
  vtkShadowStageTimes Times = UnknownShadowStageTimes;
  vtkNew<vtkOpenGLRenderTimerLog> Log;
};
VTK_ABI_NAMESPACE_END
#endif
