// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferListMaker.h"

#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferDivision.h"
#include "vtkNBufferPartition.h"

#include <algorithm>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

double vtkNBufferListMaker::Fill(bool isTestPending, vtkProp** props, int& count, int& initialized)
{
  const std::vector<int>& translucent = this->Partition.GetTranslucent();
  double total = 0.0;
  int kept = 0;
  double heldTotal = 0.0;
  this->Proxies.Clear();
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    const vtkNBufferVerdict verdict = this->Props.GetState(i).Verdict;
    // A translucent prop that an earlier test found hidden keeps its place, behind a closed proxy.
    const bool closed = verdict == vtkNBufferVerdict::Hidden && !isTestPending &&
      this->Props.GetCandidate(i).IsTranslucent();
    if (verdict == vtkNBufferVerdict::Outside || (verdict == vtkNBufferVerdict::Hidden && !closed))
    {
      continue;
    }
    vtkProp* prop = this->Props.GetProp(i);
    const double multiplier = initialized ? prop->GetRenderTimeMultiplier() : 1.0;
    if (verdict == vtkNBufferVerdict::Unknown && isTestPending)
    {
      heldTotal += multiplier;
      continue;
    }
    prop->SetRenderTimeMultiplier(multiplier);
    const bool tested =
      isTestPending && std::binary_search(translucent.begin(), translucent.end(), i);
    vtkProp* listed = closed || tested || this->Division.DrawsTranslucent(i)
      ? this->Proxies.Add(i, prop, !closed,
          [this, i](const std::function<int()>& drawWhole)
          { return this->Division.Draw(i, drawWhole); })
      : this->Division.GetInList(i);
    if (listed != prop)
    {
      listed->SetRenderTimeMultiplier(multiplier);
    }
    total += multiplier;
    props[kept++] = listed;
  }
  if (isTestPending)
  {
    // The list must not become longer. If no prop is missing, units of a prop are held back.
    const int postponed = kept == count ? this->Division.Postpone(props, kept) : -1;
    if (postponed >= 0)
    {
      std::copy(props + postponed + 1, props + kept, props + postponed);
      --kept;
    }
    // VTK does not draw what has a multiplier of 0.
    heldTotal = heldTotal > 0.0 ? heldTotal : 1.0;
    this->Proxy->SetRenderTimeMultiplier(heldTotal);
    total += heldTotal;
    props[kept++] = this->Proxy;
  }
  count = kept;
  initialized = 1;
  return total;
}

void vtkNBufferListMaker::HideTranslucent(int place)
{
  this->Proxies.Get(place)->SetOpen(false);
  this->Props.GetState(place).Verdict = vtkNBufferVerdict::Hidden;
}

void vtkNBufferListMaker::ShowTranslucent()
{
  this->Proxies.ForEach(
    [this](vtkNBufferTranslucentProxy* proxy)
    {
      proxy->SetOpen(true);
      this->Props.GetState(proxy->GetPlace()).Verdict = vtkNBufferVerdict::Translucent;
    });
}
VTK_ABI_NAMESPACE_END
