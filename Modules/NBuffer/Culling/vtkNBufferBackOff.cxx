// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBackOff.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferBackOff::CountRestFrame()
{
  if (this->FramesToRest == 0)
  {
    return false;
  }
  --this->FramesToRest;
  this->Rested = true;
  return true;
}

bool vtkNBufferBackOff::CountIdleFrame()
{
  const bool rested = this->Rested;
  this->Rested = false;
  return ++this->IdleFrames % ShortestRest == 0 || rested;
}

void vtkNBufferBackOff::Learn(int saved, int inside)
{
  this->Rested = false;
  if (inside == 0)
  {
    return;
  }
  if (saved >= PoorNumber && saved >= PoorShare * inside)
  {
    this->PoorTests = 0;
    this->LastRest = 0;
    return;
  }
  if (++this->PoorTests >= PoorTestsToRest)
  {
    this->LastRest = std::min(std::max(2 * this->LastRest, +ShortestRest), +LongestRest);
    this->FramesToRest = this->LastRest;
  }
}
VTK_ABI_NAMESPACE_END
