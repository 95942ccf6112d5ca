// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferListMaker.h"

#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferDepthTest.h"
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
  // Indices into the list that is made here.
  int lastDivided = -1;
  int firstBlended = VTK_INT_MAX;
  this->NumberOfProxies = 0;
  for (int i = 0; i < this->Props.GetSize(); ++i)
  {
    firstBlended = i == this->Partition.GetFirstBlended() ? kept : firstBlended;
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
    const bool divided = this->Division.Draws(i);
    props[kept] = prop;
    if (closed || tested || divided)
    {
      vtkNBufferPropProxy* proxy = this->AddProxy(i);
      proxy->SetOpen(!closed);
      proxy->SetRenderTimeMultiplier(multiplier);
      props[kept] = proxy;
      const bool isLate =
        this->Props.GetCandidate(i).IsTranslucent() || firstBlended != VTK_INT_MAX;
      lastDivided = isLate ? lastDivided : kept;
    }
    total += multiplier;
    ++kept;
  }
  if (isTestPending)
  {
    // The list must not become longer. If no prop is missing, units of a prop are held back.
    if (kept == count && lastDivided >= 0)
    {
      this->Division.Postpone(static_cast<vtkNBufferPropProxy*>(props[lastDivided])->GetPlace());
      std::copy(props + lastDivided + 1, props + kept, props + lastDivided);
      --kept;
      --firstBlended;
    }
    // VTK does not draw what has a multiplier of 0.
    heldTotal = heldTotal > 0.0 ? heldTotal : 1.0;
    this->Proxy->SetRenderTimeMultiplier(heldTotal);
    total += heldTotal;
    vtkProp** place = props + std::min(firstBlended, kept);
    std::copy_backward(place, props + kept, props + kept + 1);
    *place = this->Proxy;
    ++kept;
  }
  count = kept;
  initialized = 1;
  return total;
}

vtkNBufferPropProxy* vtkNBufferListMaker::AddProxy(int place)
{
  if (this->NumberOfProxies == this->Proxies.size())
  {
    this->Proxies.push_back(vtkSmartPointer<vtkNBufferPropProxy>::New());
  }
  vtkNBufferPropProxy* proxy = this->Proxies[this->NumberOfProxies++];
  proxy->SetProp(place, this->Props.GetProp(place), this->Props.GetCandidate(place).IsTranslucent(),
    [this, place](const std::function<int()>& drawWhole)
    { return this->Division.Draw(place, drawWhole); });
  return proxy;
}

vtkNBufferPropProxy* vtkNBufferListMaker::FindProxy(int place) const
{
  return *std::lower_bound(this->Proxies.begin(),
    this->Proxies.begin() + static_cast<std::ptrdiff_t>(this->NumberOfProxies), place,
    [](const auto& proxy, int wanted) { return proxy->GetPlace() < wanted; });
}

void vtkNBufferListMaker::TestTranslucent(vtkNBufferDepthTest& test)
{
  const auto hasDrawn = [this](int i) { return this->FindProxy(i)->HasDrawn(); };
  const auto hide = [this](int i)
  {
    this->FindProxy(i)->SetOpen(false);
    this->Props.GetState(i).Verdict = vtkNBufferVerdict::Hidden;
  };
  std::vector<int> visible = this->Partition.GetTranslucent();
  test.RemoveHidden(visible);
  for (const int i : this->Partition.GetTranslucent())
  {
    if (!hasDrawn(i) && !std::binary_search(visible.begin(), visible.end(), i))
    {
      hide(i);
    }
  }
  this->Division.TestTranslucent(test.GetDepthOfUnits(), hasDrawn, hide);
}

void vtkNBufferListMaker::ShowTranslucent()
{
  for (std::size_t n = 0; n < this->NumberOfProxies; ++n)
  {
    vtkNBufferPropProxy* proxy = this->Proxies[n];
    if (this->Props.GetCandidate(proxy->GetPlace()).IsTranslucent())
    {
      proxy->SetOpen(true);
      this->Props.GetState(proxy->GetPlace()).Verdict = vtkNBufferVerdict::Translucent;
    }
  }
}
VTK_ABI_NAMESPACE_END
