// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferExchangePlan.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferExchangePlan::BeginFrame(const std::vector<double>& view, bool mayBackOff)
{
  this->StillFrames = view == this->View ? this->StillFrames + 1 : 0;
  this->View = view;
  this->MayBackOff = mayBackOff;
  const bool isStill =
    this->StillFrames >= FramesToSettle && !this->Changed && this->StillFrames % FramesToProbe != 0;
  const bool isPaused = mayBackOff && this->BackOff.CountPausedFrame();
  this->Planned = isStill || isPaused ? 0 : 1;
}

void vtkNBufferExchangePlan::Learn(const vtkNBufferRankReply& reply, int number)
{
  this->Changed = reply.Changed;
  if (number > 0)
  {
    return;
  }
  if (reply.NewProps > FewNewProps)
  {
    this->Planned = 2;
  }
  if (this->HadTrial)
  {
    this->BackOff.Learn(reply.Gain, std::max(reply.Candidates, 1));
  }
  // The first exchange after a pause is a trial.
  this->HadTrial = this->IsTrial();
  this->SinceTrial = this->BackOff.IsPaused() ? 0 : (this->SinceTrial + 1) % ExchangesPerTrial;
}
VTK_ABI_NAMESPACE_END
