// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferLateDraws
 * @brief The props that were held back and have been drawn in this frame, in the order of drawing.
 *
 * This class records the order in which the view draws them, and draws them again for a pass that
 * draws its list twice. Where depths are equal, it draws those props once more that have to be
 * drawn last. Late/README.md says what drawing late breaks, and which class repairs it.
 */
#ifndef vtkNBufferLateDraws_h
#define vtkNBufferLateDraws_h

#include "vtkNBufferTieOrder.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkNBufferCandidateList;
class vtkNBufferDeferredProxy;
class vtkNBufferDepthTest;
class vtkNBufferDividedProp;
class vtkNBufferDivision;
class vtkNBufferPartition;
class vtkRenderer;

class vtkNBufferLateDraws
{
public:
  /// The arguments are kept by reference and must outlive this object.
  vtkNBufferLateDraws(
    vtkNBufferCandidateList& props, vtkNBufferDivision& division, vtkNBufferDeferredProxy* proxy)
    : Props(props)
    , Division(division)
    , Proxy(proxy)
  {
  }

  /// Begin a frame without draws.
  void Clear()
  {
    this->Drawn.clear();
    this->TieQueries = 0;
  }

  /// Draw the prop at index `place` of the list of candidates, with `time` seconds allocated to it.
  /// The first round is number 1. The props of one round must come in ascending order of their
  /// places. Returns the number of props drawn.
  int Draw(vtkRenderer* renderer, int place, int round, double time);

  /**
   * Draw the props of this frame that are not in the renderer's list again, after VTK has drawn
   * this list again. Returns the number of props drawn. `heldBack` are the places of the props that
   * were held back, in ascending order. RestoreTieOrder() has to be called afterwards.
   */
  int Repeat(vtkRenderer* renderer, const std::vector<int>& heldBack);

  /**
   * Draw props once more where this is needed so that, of the props that have the same depth in a
   * sample, the last one in the renderer's order is the one that stays (vtkNBufferTieOrder.h).
   *
   * `partition` is that of this frame. `samples` is the number of samples of a pixel, as in
   * vtkNBufferDepthSource. `screensAreValid` is false if the frame is drawn from another view than
   * that of Cull(), so that the rectangles of the props are wrong and any two props may have equal
   * depths. `test` knows the depth of a part of the draws of this frame, or is nullptr. If
   * `requiredKeys` is not nullptr, only props that have these keys are drawn (see
   * vtkProp::HasKeys). Returns the number of draws.
   */
  int RestoreTieOrder(vtkRenderer* renderer, const vtkNBufferPartition& partition,
    bool screensAreValid, int samples, vtkNBufferDepthTest* test,
    vtkInformation* requiredKeys = nullptr);

  /// Get the draws of this frame, in the order of drawing.
  const std::vector<vtkNBufferDrawnProp>& Get() const { return this->Drawn; }

  /// Get the number of draws of this frame that only looked for equal depths.
  int GetTieQueries() const { return this->TieQueries; }

private:
  int DrawWhole(vtkRenderer* renderer, int place);
  /// Draw what has been drawn of a prop already.
  int DrawAgain(vtkRenderer* renderer, int place);
  /// Describe the next draw of a prop by its fresh units, in groups, or as a whole if `units` is
  /// nullptr or has none.
  void DescribeNext(const vtkNBufferDividedProp* units, const vtkNBufferDrawnProp& whole);
  std::vector<vtkNBufferDrawnProp> GetAllDrawn(
    const vtkNBufferPartition& partition, bool screensAreValid, vtkInformation* requiredKeys) const;

  vtkNBufferCandidateList& Props;
  vtkNBufferDivision& Division;
  vtkNBufferDeferredProxy* Proxy;
  std::vector<vtkNBufferDrawnProp> Drawn;
  int TieQueries = 0;
};

VTK_ABI_NAMESPACE_END
#endif
