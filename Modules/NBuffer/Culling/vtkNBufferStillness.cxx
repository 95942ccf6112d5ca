// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStillness.h"

#include "vtkNBufferSharedDepth.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferStillness::BeginFrame(vtkRenderer* renderer, const vtkNBufferSettings& settings,
  const vtkNBufferListTraits& traits, bool changed, bool frozen)
{
  const auto drawing =
    std::exchange(this->Drawing, vtkNBufferCompatibility::GetDrawingSettings(renderer));
  const auto slivers = std::exchange(this->TestSlivers, settings.TestSlivers);
  const bool wasShared = std::exchange(this->IsShared, settings.Shared != nullptr);
  const bool erased =
    std::exchange(this->ErasesDepth, vtkNBufferCompatibility::ErasesDepth(renderer));
  const int first =
    std::exchange(this->FirstBlended, traits.GetFirstBlended(this->Drawing.SmoothLines));
  changed = changed || this->FirstBlended != first || !(this->Drawing == drawing) ||
    this->TestSlivers != slivers || this->IsShared != wasShared || this->ErasesDepth != erased ||
    this->ChangedWhileFrozen ||
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
