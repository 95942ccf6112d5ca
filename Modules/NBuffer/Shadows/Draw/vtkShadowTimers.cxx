// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTimers.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLRenderTimer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkShadowTimers::vtkShadowTimers() = default;

vtkShadowTimers::~vtkShadowTimers() = default;

void vtkShadowTimers::Begin(bool measure)
{
  if (!measure)
  {
    this->Release();
    return;
  }
  this->Read();
  this->Measuring = this->Intervals.empty() && vtkNBufferGL::HasVersion(3, 3) &&
    vtkOpenGLRenderTimer::IsSupported();
}

void vtkShadowTimers::Read()
{
  if (this->Intervals.empty() ||
    !std::all_of(this->Intervals.begin(), this->Intervals.end(),
      [](const Interval& interval) { return interval.Timer->Ready(); }))
  {
    return;
  }
  this->Times.fill(0.0);
  for (const Interval& interval : this->Intervals)
  {
    this->Times[static_cast<std::size_t>(interval.Stage)] +=
      1e-6 * static_cast<double>(interval.Timer->GetElapsedNanoseconds());
  }
  this->Intervals.clear();
}

vtkShadowTimers::Scope::Scope(vtkShadowTimers& timers, vtkShadowStage stage)
{
  if (timers.Measuring)
  {
    ++timers.NumberOfIntervals;
    timers.Intervals.push_back({ stage, std::make_unique<vtkOpenGLRenderTimer>() });
    this->Timer = timers.Intervals.back().Timer.get();
    this->Timer->Start();
    // Rasterisers that collect draws before they begin would take the time of the last tile alone.
    glFlush();
  }
}

vtkShadowTimers::Scope::~Scope()
{
  if (this->Timer)
  {
    this->Timer->Stop();
    glFlush();
  }
}

void vtkShadowTimers::Release()
{
  this->Intervals.clear();
  this->Times = UnknownShadowStageTimes;
  this->Measuring = false;
}
VTK_ABI_NAMESPACE_END
