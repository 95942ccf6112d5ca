// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPartition
 * @brief Divides the candidates in the frustum of one frame into those to draw first and those to
 * hold back.
 *
 * - kept: The last test found them visible. The renderer draws them, and their depth hides others.
 * - held back: The last test found them hidden, or there was none. They are drawn after the test of
 *   this frame if they may be visible.
 * - translucent: They keep their places in the renderer's list, and are left out if this frame's
 *   test finds them hidden.
 *
 * Each list contains indices into the list of candidates, in ascending order. Classify() fills the
 * lists. After that the view calls HoldBack() or KeepAll(), as vtkNBufferCullingPolicy decides.
 */
#ifndef vtkNBufferPartition_h
#define vtkNBufferPartition_h

#include "vtkNBufferCullingPolicy.h"
#include "vtkNBufferEye.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;

class vtkNBufferPartition
{
public:
  /// The list of candidates is kept by reference and must outlive this object.
  explicit vtkNBufferPartition(vtkNBufferCandidateList& props)
    : Props(props)
  {
  }

  /// Begin a frame without props.
  void Clear();

  /// Divide the props by their placements in the view, and set the verdicts of those that need no
  /// test. `firstBlended` is that of vtkNBufferListTraits: the opaque candidates from there on are
  /// in none of the lists. If most of the kept props are seen from elsewhere now, all that earlier
  /// tests have found out is forgotten, and no prop is kept. Returns the number of props of each
  /// kind.
  vtkNBufferFrustumCounts Classify(int firstBlended);

  /// The `firstBlended` of the last Classify().
  int GetFirstBlended() const { return this->FirstBlended; }

  /// Set the verdicts for a frame with a test. The proxy that tests needs a place in the renderer's
  /// list, which must not become longer. If no prop is held back or outside of the frustum and
  /// `needsOne` is true, the farthest kept prop, if there is any, becomes the one that is held
  /// back, because it hides least. Its depth is missing from the test.
  void HoldBack(bool needsOne);

  /// Neither draw nor test a prop with the verdict of HoldBack(), because all of its units are
  /// outside of the frustum.
  void SetOutside(int place);

  /// Prepare a frame without a test: empty the lists. All props are drawn, and the next frame keeps
  /// them.
  void KeepAll();

  /// Compute the placements and rectangles of the props in the three lists again, after the
  /// projection has changed.
  void Project();

  /// How many props may be drawn before the first test, if `props` are held back: `roundSize` or,
  /// if that is more, one in 512. Each round tests all props that are left, so that it has to draw
  /// more where a great many are.
  static std::size_t GetLimit(int roundSize, std::size_t props)
  {
    return std::max<std::size_t>(roundSize, props / 512);
  }

  /// Choose at most `limit` of the props in `places` that probably hide the others: the nearest of
  /// those that are not behind others in a coarse depth image (vtkNBufferCoarseDepth.h) of the
  /// largest props on the screen, `limit` of them or 256. Remove them from `places` and return
  /// them. The choice need not be right: every prop that is not chosen is tested.
  std::vector<int> RemoveOccluders(std::vector<int>& places, std::size_t limit);

  /// Whether the view is new: most of the props that the last test found visible have left the
  /// frustum, or most of those held back have not been tested since they came into it.
  bool IsNew() const;

  /// Get those of the props held back that have not been drawn in this frame so far.
  std::vector<int> GetNotDrawn() const;

  /// Get the same props, after forgetting what tests have found out of them and of the translucent
  /// props, so that they can be tested by a depth that is farther than the one before.
  std::vector<int> TestAgain();

  /// `drawn` are props that were drawn before a test, and `visible` begins with those of them, in
  /// their order, that it has found visible. Store for the next frame which of them are visible and
  /// which are hidden, and remove them from `visible`. Returns the number of the hidden ones.
  int RemoveDrawn(const std::vector<int>& drawn, std::vector<int>& visible);

  ///@{
  const std::vector<int>& GetKept() const { return this->Kept; }
  const std::vector<int>& GetHeldBack() const { return this->HeldBack; }
  const std::vector<int>& GetTranslucent() const { return this->Translucent; }
  ///@}

  /// Get the number of props in the three lists.
  int GetSize() const
  {
    return static_cast<int>(this->Kept.size() + this->HeldBack.size() + this->Translucent.size());
  }

private:
  void Forget();

  vtkNBufferCandidateList& Props;
  std::vector<int> Kept;
  std::vector<int> HeldBack;
  std::vector<int> Translucent;
  std::size_t Lost = 0; ///< The props that were visible and have left the frustum.
  bool IsAnyOutside = false;
  int FirstBlended = VTK_INT_MAX;
  vtkNBufferEye Eye; ///< Of the last Classify().
};

VTK_ABI_NAMESPACE_END
#endif
