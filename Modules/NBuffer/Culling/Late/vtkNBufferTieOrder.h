// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTieOrder.h
 * @brief Which props to draw once more, and where, so that equal depths end as in the renderer's
 * order.
 *
 * VTK draws with GL_LEQUAL: of several fragments that have the same depth in a sample, the one
 * drawn last stays. Without a culler that is the fragment of the prop that comes last in the
 * renderer. A culler that holds props back until it has tested them draws in another order:
 *
 *     renderer:      A  B  C  D          C and D share a face.
 *     first draw:    A  .  .  D          D was visible, B and C are held back.
 *     after test:          C             C is visible now and wins the shared face: wrong.
 *     redrawn:                   D       D is drawn again and wins as it should.
 *
 * The final image is right if, of the props that tie in a sample, the last one in the renderer's
 * order is drawn last. So the props are looked at in the renderer's order, and a prop is drawn
 * again wherever it may tie with an earlier prop that was drawn after it or that is itself drawn
 * again. Drawing an opaque prop twice with GL_LEQUAL changes nothing else.
 *
 * Two props can tie only where their depth intervals (slack included) overlap, and only in the
 * rectangle of pixels in which they touch (vtkNBufferProjection::GetContact). If a prop is drawn
 * again only inside such rectangles, by a scissor, no other prop has to follow elsewhere. If it is
 * drawn again whole, all later props that touch it have to follow, then those that touch these.
 * Where parts touch, as in machines and on circuit boards, most of what follows is then drawn twice
 * for a few props that were held back:
 *
 *     first draw:    . B C D E           A is held back, touches B alone, and B touches C, C D, ...
 *     after test:    A
 *     whole:           B C D E
 *     in rectangles:   b                 The part of B that touches A does not reach C.
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
  int Index = 0; ///< The place of the prop in the renderer's order.
  int Round = 0; ///< The round in which it was drawn; within one, the renderer's order was kept.
  /// Whether Box and Screen are known. A prop for which they are not may tie with any other.
  bool Bounded = false;
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen;
};

/**
 * A prop to draw once more.
 */
struct vtkNBufferRedraw
{
  int Position = 0; ///< The place of the prop in the list that was given to GetRedraws().
  /// The one to four rectangles of the viewport in which to draw it, in pixels. If there are none,
  /// it has to be drawn whole.
  std::vector<vtkNBufferRectangle> Regions;
};

namespace vtkNBufferTieOrder
{
/// The pixels in which two props may have fragments of equal depth; empty if there are none.
VTKNBUFFER_EXPORT vtkNBufferRectangle GetTie(const vtkNBufferProjection& projection,
  const vtkNBufferDrawnProp& a, const vtkNBufferDrawnProp& b);

/**
 * The props to draw once more, in the order in which to draw them. With `inRegions` they are
 * redrawn only inside rectangles, which needs a driver that clips exactly to the sample; otherwise
 * whole. Sorts `drawn` by Index. For each drawn prop, the props in the same part of the screen that
 * were drawn after the first round are looked at.
 */
VTKNBUFFER_EXPORT std::vector<vtkNBufferRedraw> GetRedraws(
  const vtkNBufferProjection& projection, std::vector<vtkNBufferDrawnProp>& drawn, bool inRegions);
}

VTK_ABI_NAMESPACE_END
#endif
