// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferLateDraws
 * @brief The props that were held back and have been drawn in this frame, in the order of drawing.
 *
 * ## What drawing late breaks, and which class repairs it
 *
 * This text is about the whole folder. The culler holds props back: it removes them from the
 * renderer's list and draws some of them later than their places in the renderer say. One frame of
 * a renderer with the opaque props A to E and the translucent prop T, where A, C and D are held
 * back:
 *
 *     the renderer's props       A   B   C   D   T   E
 *     list after Cull()              B           t   E   P
 *
 *     P                          a vtkNBufferDeferredProxy, which represents A, C and D
 *     t                          a vtkNBufferTranslucentProxy, which represents T
 *
 *     opaque stage               The renderer draws B and E, and then P, which is last.
 *       P tests against depth    A and D may be visible, C is hidden.
 *       P draws                  A and D
 *       P repairs ties           B and E once more, but only where they may have the same depth as
 *                                a prop that precedes them in the renderer and was drawn by P
 *       P closes t               if T is hidden
 *     translucent stage          The renderer draws t, which draws T if it is open.
 *
 * The image must be the same, to the bit, as if the renderer had drawn A, B, C, D, E and T itself.
 * Four things break this if nobody repairs them:
 *
 *  1. The order of equal depths. VTK draws with GL_LEQUAL, so of several fragments with the same
 *     depth the one drawn last stays. A, which is first in the renderer, would win against B.
 *     vtkNBufferTieOrder computes which props have to be drawn once more, and where; this class
 *     keeps the order of drawing from which that follows, and draws them.
 *  2. The order of blending. Translucent props are blended in the renderer's order, so a
 *     translucent prop must never be drawn later than its place. It does not have to be: the
 *     translucent stage comes after the opaque one, when the verdicts of this frame are known.
 *     vtkNBufferTranslucentProxy keeps the place of its prop and leaves the prop out if it is
 * hidden.
 *  3. The keys of render passes. A pass sets keys on the props of the list, and these keys change
 *     the shaders of the props. Props that are held back are not in the list. Both proxies are a
 *     vtkNBufferStandIn (folder Core), which forwards the keys.
 *     A pass may also draw its list a second time in the same frame. If the pass says so
 *     (vtkNBufferRenderPassTraits), this class repeats the same draws in the same order; otherwise
 *     the view draws everything that was held back (vtkNBufferView).
 *  4. The lifetime of props. The culler and the renderer know the props of a frame by plain
 *     pointers, and they use these pointers later in the frame than VTK does. vtkNBufferFrameGuard
 *     keeps the props, and the culler, alive until the end of the frame.
 */
#ifndef vtkNBufferLateDraws_h
#define vtkNBufferLateDraws_h

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
  /// The three arguments are kept by reference and must outlive this object.
  vtkNBufferLateDraws(vtkNBufferCandidateList& props, const vtkNBufferProjection& projection,
    vtkNBufferDeferredProxy* proxy);

  /// Begin a frame without draws.
  void Clear() { this->Drawn.clear(); }

  /// Draw the prop at index `place` of the list of candidates, with `time` seconds allocated to it.
  /// The first round is number 1. The props of one round must come in ascending order of their
  /// places. Returns the number of props drawn.
  int Draw(vtkRenderer* renderer, int place, int round, double time);

  /// Draw all props of this frame again, in the same order. Returns the number of props drawn.
  int Repeat(vtkRenderer* renderer);

  /**
   * Draw props once more, so that equal depths end as in the renderer's order.
   *
   * `heldBack` are the places of the props that were held back, in ascending order. `samples` is
   * the number of samples of a pixel, as in vtkNBufferDepthSource. With `screensAreValid` set to
   * false the frame is drawn from another view than the boxes were projected with, so that any two
   * props may have equal depths. Returns the number of draws.
   */
  int RestoreTieOrder(
    vtkRenderer* renderer, const std::vector<int>& heldBack, bool screensAreValid, int samples);

  /// Get the draws of this frame, in the order of drawing.
  const std::vector<vtkNBufferDrawnProp>& Get() const { return this->Drawn; }

private:
  std::vector<vtkNBufferDrawnProp> GetAllDrawn(
    const std::vector<int>& heldBack, bool screensAreValid) const;

  vtkNBufferCandidateList& Props;
  const vtkNBufferProjection& Projection;
  vtkNBufferDeferredProxy* Proxy;
  std::vector<vtkNBufferDrawnProp> Drawn;
};

VTK_ABI_NAMESPACE_END
#endif
