// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTieOrder.h
 * @brief Which props to draw once more so that equal depths end as in the renderer's order.
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
 * order is drawn last. So, in the renderer's order, a prop is drawn again if an earlier prop that
 * it may tie with was drawn after it, or is drawn again itself. Drawing an opaque prop twice with
 * GL_LEQUAL changes nothing else.
 *
 * Two props can tie only where their pixels and their depth intervals (slack included) overlap,
 * and no plane between them keeps them apart (vtkNBufferProjection::AreApart).
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

namespace vtkNBufferTieOrder
{
/// Whether two props may have fragments of equal depth in a sample.
VTKNBUFFER_EXPORT bool CanTie(const vtkNBufferProjection& projection, const vtkNBufferDrawnProp& a,
  const vtkNBufferDrawnProp& b);

/**
 * Positions in `drawn` of the props to draw once more, in the order in which to draw them. Sorts
 * `drawn` by Index. Cost: number of drawn props times those drawn after the first round.
 */
VTKNBUFFER_EXPORT std::vector<int> GetRedraws(
  const vtkNBufferProjection& projection, std::vector<vtkNBufferDrawnProp>& drawn);
}

VTK_ABI_NAMESPACE_END
#endif
