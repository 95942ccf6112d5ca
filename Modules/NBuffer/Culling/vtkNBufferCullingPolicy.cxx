// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCullingPolicy.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferBackOff::CountPausedFrame()
{
  if (this->FramesLeft == 0)
  {
    return false;
  }
  --this->FramesLeft;
  this->WasPaused = true;
  return true;
}

bool vtkNBufferBackOff::CountIdleFrame()
{
  const bool wasPaused = this->WasPaused;
  this->WasPaused = false;
  return ++this->IdleFrames % ShortestPause == 0 || wasPaused;
}

void vtkNBufferBackOff::Learn(int saved, int inside)
{
  this->WasPaused = false;
  if (inside == 0)
  {
    return;
  }
  if (!IsPoor(saved, inside))
  {
    this->PoorTests = 0;
    this->LastPause = 0;
    return;
  }
  if (++this->PoorTests >= PoorTestsBeforePause)
  {
    this->LastPause = std::min(std::max(2 * this->LastPause, +ShortestPause), +LongestPause);
    this->FramesLeft = this->LastPause;
  }
}

namespace vtkNBufferCullingPolicy
{
vtkNBufferDecision ChooseDecision(
  const vtkNBufferFrustumCounts& counts, int minimumNumberOfCandidates, vtkNBufferBackOff* backOff)
{
  if (counts.Blending)
  {
    return vtkNBufferDecision::Blending;
  }
  if (counts.Inside < minimumNumberOfCandidates)
  {
    return counts.Blended > 0 ? vtkNBufferDecision::Blending : vtkNBufferDecision::FewCandidates;
  }
  if (backOff && backOff->CountPausedFrame())
  {
    return vtkNBufferDecision::BackedOff;
  }
  if (counts.HeldBack == 0)
  {
    // Only a test finds the props that have become hidden, so a test is due every few frames. Many
    // translucent props are worth a test in every frame.
    const bool isTestDue =
      !backOff || counts.Translucent >= minimumNumberOfCandidates || backOff->CountIdleFrame();
    if (!isTestDue || counts.Kept == 0)
    {
      return vtkNBufferDecision::NothingHeld;
    }
  }
  return vtkNBufferDecision::Culled;
}
}
VTK_ABI_NAMESPACE_END
