// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTieOrder.h
 * @brief Which props to draw once more, and where, so that ties end as without the culler.
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
 * order is drawn last. GetRedraws() therefore visits the props in the renderer's order. A prop is
 * drawn again wherever it may tie with an earlier prop (in that order) that was drawn after it, or
 * that is itself drawn again. Drawing an opaque prop twice with GL_LEQUAL changes nothing else.
 *
 * Two props can tie only where their depth intervals (slack included) overlap, and only in the
 * rectangle of pixels in which they touch (vtkNBufferProjection::GetContact). If a prop is drawn
 * again whole, all later props that touch it have to be drawn again, then those that touch these,
 * and so on. Where parts touch, as in machines and on circuit boards, a few props that were held
 * back then cause most of the later props to be drawn twice. If a prop is drawn again only inside
 * such rectangles, with a scissor, only props that touch it there have to be drawn again:
 *
 *     first draw:    . B C D E           A is held back, touches B alone, and B touches C, C D, ...
 *     after test:    A
 *     whole:           B C D E
 *     in rectangles:   b                 The part of B that touches A does not reach C.
 *
 * A tie does not matter where it lies behind what has been drawn: most parts of a machine touch
 * inside of it.
 */
#ifndef vtkNBufferTieOrder_h
#define vtkNBufferTieOrder_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * A prop that has been drawn in this frame, or a part of one. A prop that was drawn in several
 * rounds has an entry for each round. Any of them stands for the whole prop when it is drawn once
 * more.
 */
struct vtkNBufferDrawnProp
{
  int Index = 0; ///< The place of the prop in the renderer's order.
  /// The round in which the prop was drawn, from 1 on; 0 if the renderer drew it, which is before
  /// all rounds. In a round the renderer's order is kept.
  int Round = 0;
  /// Whether the prop, drawn in a round, may have had fragments with the depth of an earlier draw.
  /// If not, no prop has to be drawn once more because of it.
  bool MayTie = true;
  /// Whether Box and Screen are known. If not, the prop may tie with any other.
  bool Bounded = false;
  /// Whether the prop leaves the scissor alone, so that it can be drawn inside of rectangles.
  bool KeepsScissor = false;
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen;
};

/**
 * A prop to draw once more.
 */
struct vtkNBufferRedraw
{
  int Position = 0; ///< The place of the prop in the list that was given to GetRedraws().
  /// The rectangles of the viewport in which to draw the prop, in pixels, at most four. If there
  /// are none, it has to be drawn whole.
  std::vector<vtkNBufferRectangle> Regions;
};

namespace vtkNBufferTieOrder
{
/// Where two props may have fragments of equal depth.
VTKNBUFFER_EXPORT vtkNBufferContact GetTie(const vtkNBufferProjection& projection,
  const vtkNBufferDrawnProp& a, const vtkNBufferDrawnProp& b);

/**
 * The props to draw once more, in the order in which to draw them. `drawn` are all props that were
 * drawn and may tie; the function sorts them by Index. If `inRegions` is true, props are redrawn
 * inside rectangles only, which needs a driver that never draws a sample outside the scissor box;
 * otherwise they are redrawn whole. Ties of which `isHidden` says that nothing of them can be seen
 * do not count. The time for each prop depends on how many props in the same part of the screen
 * were drawn late (Round > 0) or are drawn again.
 */
VTKNBUFFER_EXPORT std::vector<vtkNBufferRedraw> GetRedraws(const vtkNBufferProjection& projection,
  std::vector<vtkNBufferDrawnProp>& drawn, bool inRegions,
  const std::function<bool(const vtkNBufferContact&)>& isHidden = {});
}

VTK_ABI_NAMESPACE_END
#endif
