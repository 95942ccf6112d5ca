// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTieOrder.h
 * @brief Which props to draw once more, and where, so that equal depths end as in the renderer's
 * order.
 *
 * VTK draws with GL_LEQUAL: of several fragments of the same depth in a sample the one drawn last
 * stays. Without a culler that is the prop that comes last in the renderer. A culler that holds
 * props back draws them in another order:
 *
 *     renderer:      A  B  C  D          C and D share a face.
 *     first draw:    A     .  D          D was visible, B and C are held back.
 *     after test:          C             C is visible now and wins the shared face: wrong.
 *     once more:                 D       D is drawn again and wins as it should.
 *
 * The final image is right if, among the props that tie in a sample, the last of the renderer's
 * order is drawn last. So, in the renderer's order, a prop is drawn again where an earlier prop
 * that it may tie with was drawn after it, or is drawn again itself. Drawing an opaque prop twice
 * with GL_LEQUAL changes nothing else.
 *
 * Two props can tie only where their depth intervals (slack included) overlap and in the rectangle
 * of pixels in which they touch (vtkNBufferProjection::GetContact). Drawn again by a scissor in
 * such rectangles alone, a prop bothers no other elsewhere; drawn again whole, it bothers all that
 * it touches, they what they touch, and where parts touch, as in machines and on boards, most of
 * what follows is drawn twice for a few that were held back:
 *
 *     first draw:    . B C D E           A is held back, touches B alone, and B touches C, C D, ...
 *     after test:    A
 *     whole:           B C D E
 *     in rectangles:   b                 C is not met by the part of B that touches A.
 */
#ifndef vtkNBufferTieOrder_h
#define vtkNBufferTieOrder_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * A prop that has been drawn in this frame.
 */
struct vtkNBufferDrawnProp
{
  int Index = 0;        ///< Place in the renderer's order.
  int Round = 0;        ///< Props of one round were drawn in the renderer's order.
  bool Bounded = false; ///< `Box` and `Screen` are known; otherwise it may tie with anything.
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen;
};

/**
 * A prop to draw once more.
 */
struct vtkNBufferRedraw
{
  int Position = 0; ///< In the list of the props drawn.
  /// Where, in pixels of the viewport: one to four rectangles; none: all of the prop.
  std::vector<vtkNBufferRectangle> Regions;
};

namespace vtkNBufferTieOrder
{
/// Whether two props may have fragments of equal depth in a sample, and within which pixels.
VTKNBUFFER_EXPORT bool GetTie(const vtkNBufferProjection& projection, const vtkNBufferDrawnProp& a,
  const vtkNBufferDrawnProp& b, vtkNBufferRectangle& pixels);

/**
 * What to draw once more, in that order. `inRegions`: rectangles will be kept to, to the sample;
 * otherwise props are drawn again whole. Sorts `drawn` by Index. Cost: for each drawn prop, the
 * props in the same part of the screen that were drawn after the first round.
 */
VTKNBUFFER_EXPORT std::vector<vtkNBufferRedraw> GetRedraws(
  const vtkNBufferProjection& projection, std::vector<vtkNBufferDrawnProp>& drawn, bool inRegions);
}

VTK_ABI_NAMESPACE_END
#endif
