// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferLateDraws
 * @brief Which held props have been drawn in a frame, in which order, and what that asks for.
 *
 * After the rounds some props are drawn once more, so that equal depths end as in the renderer's
 * order (vtkNBufferTieOrder): held ones, and kept ones that the renderer itself has drawn. A pass
 * that draws its list once more gets the same draws in the same order.
 */
#ifndef vtkNBufferHeldDraws_h
#define vtkNBufferHeldDraws_h

#include "vtkNBufferTieOrder.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;
class vtkNBufferDeferredProxy;
class vtkNBufferProjection;
class vtkRenderer;

class vtkNBufferLateDraws
{
public:
  /// All three belong to a view and outlive this object.
  vtkNBufferLateDraws(vtkNBufferCandidateList& props, const vtkNBufferProjection& projection,
    vtkNBufferDeferredProxy* proxy);

  /// Begin a frame without draws.
  void Clear() { this->Drawn.clear(); }

  /// Draw the held prop of a place in a round, the first of which is 1, with `time` seconds
  /// allocated to it. Props of one round in ascending order. Returns how many props that drew.
  int Draw(vtkRenderer* renderer, int place, int round, double time);

  /// Draw all of them again. Returns how many props that drew.
  int Repeat(vtkRenderer* renderer);

  /**
   * Draw once more what ties need. `held`: the places of the props held back, ascending. Without
   * `screensHold` boxes are elsewhere than the projection says, and any two props may tie.
   * `samples`: of a pixel drawn to, as in vtkNBufferDepthSource. Returns the number of draws.
   */
  int RestoreTieOrder(
    vtkRenderer* renderer, const std::vector<int>& held, bool screensHold, int samples);

  const std::vector<vtkNBufferDrawnProp>& Get() const { return this->Drawn; }

private:
  std::vector<vtkNBufferDrawnProp> GetAllDrawn(
    const std::vector<int>& held, bool screensHold) const;

  vtkNBufferCandidateList& Props;
  const vtkNBufferProjection& Projection;
  vtkNBufferDeferredProxy* Proxy;
  std::vector<vtkNBufferDrawnProp> Drawn;
};

VTK_ABI_NAMESPACE_END
#endif
