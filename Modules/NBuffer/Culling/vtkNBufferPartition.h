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
 * Each list contains indices of the list of candidates, in ascending order. Classify() fills them.
 * After that either HoldBack() or KeepAll() has to be called, as vtkNBufferCullingPolicy decides.
 */
#ifndef vtkNBufferPartition_h
#define vtkNBufferPartition_h

#include "vtkNBufferCullingPolicy.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidateList;
class vtkNBufferProjection;

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

  /// Divide the props by their placements in view, and set the verdicts of those that need no test.
  vtkNBufferFrustumCounts Classify();

  /// Set the verdicts for a frame with a test. If no prop is held back so far, the farthest of the
  /// kept ones is held back, because it hides least.
  void HoldBack();

  /// Set the verdicts for a frame without a test: all props are drawn.
  void KeepAll();

  /// Place all props in view anew, for a projection that has changed since Classify().
  void Project(const vtkNBufferProjection& projection);

  /// Remove those of the nearest props from `places` that probably hide the others, at most `limit`
  /// of them, and return them. See vtkNBufferOccluderChoice.h.
  std::vector<int> RemoveOccluders(
    std::vector<int>& places, std::size_t limit, const vtkNBufferProjection& projection);

  /// Whether the view is new: no prop is kept, and most of those held back have not been tested
  /// since they came into the frustum. Without kept props a view is not new if all candidates are
  /// hidden by other props.
  bool IsNew() const;

  /// Get the props held back that have not been found visible and drawn so far.
  std::vector<int> GetNotDrawn() const;

  /// Tell the next frame which of the kept props the test has found visible: those of `visible`.
  /// Returns how many it has found hidden.
  int SetVisibleKept(const std::vector<int>& visible);

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
  vtkNBufferCandidateList& Props;
  std::vector<int> Kept;
  std::vector<int> HeldBack;
  std::vector<int> Translucent;
};

VTK_ABI_NAMESPACE_END
#endif
