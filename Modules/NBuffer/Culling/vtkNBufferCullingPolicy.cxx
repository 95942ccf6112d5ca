// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCullingPolicy.h"

#include "vtkNBufferBackOff.h"

VTK_ABI_NAMESPACE_BEGIN
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
    return vtkNBufferDecision::FewCandidates;
  }
  if (backOff && backOff->CountRestFrame())
  {
    return vtkNBufferDecision::BackedOff;
  }
  if (counts.HeldBack == 0)
  {
    // Only a test finds props that have become hidden, so that one is due every few frames. Many
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
