// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTimers.h"

#include "vtkNBufferGL.h"

VTK_ABI_NAMESPACE_BEGIN
void vtkShadowTimers::Begin(bool measure)
{
  this->Log->SetLoggingEnabled(measure && vtkNBufferGL::HasFeature(3, 3, "GL_ARB_timer_query"));
  if (!this->Log->GetLoggingEnabled())
  {
    this->Release();
    return;
  }
  this->Log->MarkFrame();
  while (this->Log->FrameReady())
  {
    this->Times.fill(0.0);
    const vtkRenderTimerLog::Frame frame = this->Log->PopFirstReadyFrame();
    for (const vtkRenderTimerLog::Event& event : frame.Events)
    {
      for (int i = 0; i < NumberOfShadowStages; ++i)
      {
        if (event.Name == vtkShadowStatistics::GetName(static_cast<vtkShadowStage>(i)))
        {
          this->Times[i] += 1e-6 * static_cast<double>(event.ElapsedTimeNanoseconds());
        }
      }
    }
  }
}

vtkShadowTimers::Scope::Scope(vtkShadowTimers& timers, vtkShadowStage stage)
{
  if (timers.Log->GetLoggingEnabled())
  {
    ++timers.NumberOfIntervals;
    this->Log = timers.Log;
    this->Log->MarkStartEvent(vtkShadowStatistics::GetName(stage));
    glFlush();
  }
}

vtkShadowTimers::Scope::~Scope()
{
  if (this->Log)
  {
    this->Log->MarkEndEvent();
    glFlush();
  }
}

void vtkShadowTimers::Release()
{
  this->Log->ReleaseGraphicsResources();
  this->Times = UnknownShadowStageTimes;
}
VTK_ABI_NAMESPACE_END
