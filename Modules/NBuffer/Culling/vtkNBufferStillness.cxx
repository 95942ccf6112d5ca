// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStillness.h"

#include "vtkNBufferSharedDepth.h"

VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferStillness::BeginFrame(vtkRenderer* renderer, const vtkNBufferSettings& settings,
  const vtkNBufferListTraits& traits, bool changed, bool frozen)
{
  const auto set = [&changed](auto& kept, const auto& value)
  {
    changed = changed || !(kept == value);
    kept = value;
  };
  set(this->Drawing, vtkNBufferCompatibility::GetDrawingSettings(renderer));
  set(this->TestSlivers, settings.TestSlivers);
  set(this->IsShared, settings.Shared != nullptr);
  set(this->ErasesDepth, vtkNBufferCompatibility::ErasesDepth(renderer));
  set(this->FirstBlended, traits.GetFirstBlended(this->Drawing.SmoothLines));
  changed = changed || this->ChangedWhileFrozen ||
    (settings.Shared && settings.Shared->HasExchangedSince(this->SharedTime));
  if (settings.Shared && !frozen)
  {
    this->SharedTime = settings.Shared->GetFrameTime();
  }
  this->ChangedWhileFrozen = frozen && changed;
  this->Same = !changed && this->ErasesDepth && !traits.UntrackedDepth;
  return this->Same;
}
VTK_ABI_NAMESPACE_END
