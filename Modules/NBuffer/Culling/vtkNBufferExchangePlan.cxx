// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferExchangePlan.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferExchangePlan::BeginFrame(bool mayBackOff)
{
  this->MayBackOff = mayBackOff;
  this->Planned = mayBackOff && this->BackOff.CountPausedFrame() ? 0 : 1;
}

void vtkNBufferExchangePlan::LearnPoll(bool changed)
{
  this->Planned = changed ? 1 : 0;
  this->IsQuiet = !changed;
}

void vtkNBufferExchangePlan::Learn(const vtkNBufferRankReply& reply, int number)
{
  this->IsQuiet = !reply.Changed;
  if (number > 0)
  {
    return;
  }
  const bool isNew = reply.NewProps > FewNewProps;
  if (isNew)
  {
    this->Planned = 2;
  }
  const bool isTrial = this->IsTrial();
  this->UntilTrial = isTrial ? ExchangesPerTrial - 1 : std::max(this->UntilTrial - 1, 0);
  if (this->HadTrial)
  {
    const int unhidden = std::max(reply.Unhidden, 1);
    const bool isPoor = vtkNBufferBackOff::IsPoor(reply.Gain, unhidden);
    this->Gains = isPoor ? 0 : this->Gains + 1;
    if (this->Gains > 1)
    {
      this->UntilTrial = ExchangesAfterGain - 1; // This exchange was the first one without a trial.
    }
    if (!isPoor || !this->WasNew)
    {
      this->BackOff.Learn(reply.Gain, unhidden);
    }
  }
  this->HadTrial = isTrial;
  this->WasNew = isNew;
  if (this->BackOff.IsPaused())
  {
    // The first exchange after a pause is a trial, and the verdicts from before the pause are not
    // used again.
    this->UntilTrial = 0;
    this->IsQuiet = false;
  }
}
VTK_ABI_NAMESPACE_END
