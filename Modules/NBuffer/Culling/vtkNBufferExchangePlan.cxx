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
  const int unhidden = std::max(reply.Unhidden, 1);
  if (this->HadTrial && !(this->WasNew && vtkNBufferBackOff::IsPoor(reply.Gain, unhidden)))
  {
    this->BackOff.Learn(reply.Gain, unhidden);
  }
  // The first exchange after a pause is a trial, and the verdicts from before the pause are not
  // used again.
  this->HadTrial = this->IsTrial();
  this->WasNew = isNew;
  this->IsQuiet = this->IsQuiet && !this->BackOff.IsPaused();
  this->SinceTrial = this->BackOff.IsPaused() ? 0 : (this->SinceTrial + 1) % ExchangesPerTrial;
}
VTK_ABI_NAMESPACE_END
