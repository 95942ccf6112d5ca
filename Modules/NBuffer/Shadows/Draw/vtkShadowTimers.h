// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTimers
 * @brief How long the graphics device takes for the stages of a frame with shadows.
 *
 * Never waits: a frame is measured if the timers of the last one measured have been read, so that
 * what GetTimes() says is of an earlier frame, and not of every frame. Times of a stage that is in
 * several pieces add up; one that a frame does not have takes 0.
 */
#ifndef vtkShadowTimers_h
#define vtkShadowTimers_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowStatistics.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderTimer;

class VTKNBUFFER_EXPORT vtkShadowTimers
{
public:
  vtkShadowTimers();
  ~vtkShadowTimers();
  vtkShadowTimers(const vtkShadowTimers&) = delete;
  void operator=(const vtkShadowTimers&) = delete;

  /**
   * Begin a frame, and measure it if that is asked for and possible. Nothing is asked of OpenGL
   * unless it was asked for in this frame or the last one. The context must be current.
   */
  void Begin(bool measure);

  /// Milliseconds by vtkShadowStage; -1 before the first frame is known, or without timers.
  const vtkShadowStageTimes& GetTimes() const { return this->Times; }

  /// While it lives, what OpenGL is told belongs to a stage. They must not overlap.
  class Scope
  {
  public:
    Scope(vtkShadowTimers& timers, vtkShadowStage stage);
    ~Scope();
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkOpenGLRenderTimer* Timer = nullptr;
  };

  /// Times taken so far, of pieces of stages.
  int GetNumberOfIntervals() const { return this->NumberOfIntervals; }

  /// Delete everything; the context that made it must be current.
  void Release();

private:
  struct Interval
  {
    vtkShadowStage Stage;
    std::unique_ptr<vtkOpenGLRenderTimer> Timer;
  };

  void Read();

  bool Measuring = false;
  int NumberOfIntervals = 0;
  vtkShadowStageTimes Times = UnknownShadowStageTimes;
  std::vector<Interval> Intervals; ///< Of the frame that is measured or waited for.
};
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowTimers.h
