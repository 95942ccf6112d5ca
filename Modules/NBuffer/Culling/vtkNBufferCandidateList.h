// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateList
 * @brief The props of one view in the renderer's order, cached from frame to frame.
 *
 * In a long list a hierarchy finds where the props are in the view (vtkNBufferCandidateTree). The
 * rectangle of a prop may then be deferred until GetScreen() needs it.
 */
#ifndef vtkNBufferCandidateList_h
#define vtkNBufferCandidateList_h

#include "vtkNBufferCandidate.h"
#include "vtkNBufferCandidateTree.h"
#include "vtkNBufferMeshes.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferObservedObjects.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferPropList.h"
#include "vtkNBufferTieOrder.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKNBUFFER_EXPORT vtkNBufferCandidateList
{
public:
  /// Use a hierarchy for lists of at least this many props, see vtkNBufferTuning::HierarchySize.
  void SetHierarchySize(int size) { this->HierarchySize = size; }

  /// Observe props that have not changed for so many frames, see vtkNBufferTuning::ObserveAfter.
  void SetObserveAfter(int frames) { this->ObserveAfter = frames; }

  /// Follow the renderer's list of props. Returns whether it differs from the last one.
  bool Synchronize(vtkProp** props, int count);

  /**
   * Bring the caches up to date and, if there is a projection, do what Project() does. Both walk
   * the same memory, so that for a short list they cost little more together than one of them.
   * Returns the number of props that have changed.
   */
  int Refresh(const vtkNBufferProjection* projection);

  /**
   * Find the placement of every candidate and translucent prop in the view: outside, crossing, or
   * inside with its rectangle and depth interval. The projection is kept by reference until the
   * next call, for rectangles that are deferred.
   */
  void Project(const vtkNBufferProjection& projection);

  /// The number of levels that nodes of deferred props need over a base of the given factor.
  int GetLevelsNeeded(int factor) const { return this->Tree.GetLevelsNeeded(factor); }

  /// Mark the deferred props below hidden nodes as Behind. This must be called once in a frame,
  /// before its first test.
  void MarkHidden(vtkNBufferOcclusionTest& test) { this->Tree.MarkHidden(test, this->States); }

  /**
   * If no prop is known to reach into the view, draw the props that are outside all the same. VTK
   * does not touch a renderer whose list is empty, not even for image processing, and a culler that
   * follows may remove any other prop.
   */
  void KeepIfNoneIsInside();

  /// Whether the depth that any of the props writes may change without a trace.
  bool HasUntrackedDepth() const { return this->UntrackedDepth; }

  /// Whether any prop may blend in the opaque stage, given that the window smoothes lines or that
  /// there is ambient occlusion.
  bool HasBlending(bool smoothLines, bool ambientOcclusion) const;

  /// Count the verdicts, the props drawn before the first test, and the work of the hierarchy.
  void CountVerdicts(vtkNBufferStatistics& statistics) const;

  /// Prop i as drawn in a round, for the order of props with equal depth.
  vtkNBufferDrawnProp GetDrawn(int i, int round);

  /// The triangles of prop i, see vtkNBufferMeshes.
  std::vector<vtkNBufferMeshes::Placed> GetMeshes(int i);

  /// Whether a candidate that is Inside may be seen by its triangles, of which only those of small
  /// meshes are looked at (vtkNBufferMeshes::FindSmall). They are copied for props that the tests
  /// of `copyAfter` frames have found visible.
  bool MayBeSeen(int i, vtkNBufferPixelTest& test, int copyAfter);

  int GetSize() const { return static_cast<int>(this->Candidates.GetSize()); }
  vtkProp* GetProp(int i) const { return this->Candidates.GetProp(i); }
  const vtkNBufferCandidate& GetCandidate(int i) const { return this->Candidates[i]; }
  const vtkNBufferBox& GetBox(int i) const { return this->Candidates[i].GetBox(); }

  /// The rectangle of prop i. If it was deferred it is computed now, which may change the prop's
  /// placement.
  vtkNBufferScreenBox& GetScreen(int i)
  {
    if (this->States[i].RectangleIsStale)
    {
      this->ProjectDeferred(i);
    }
    return this->Screens[i];
  }
  vtkNBufferState& GetState(int i) { return this->States[i]; }
  const vtkNBufferState& GetState(int i) const { return this->States[i]; }

  /// The place of a prop in the list, or -1. Costs one hash look-up; the first one after a change
  /// of the list fills the table.
  int Find(vtkProp* prop) const { return this->Candidates.Find(prop); }

private:
  void ProjectOne(vtkIdType i, const vtkNBufferProjection& projection);
  void ProjectAll(const vtkNBufferProjection& projection);
  void ProjectOverTree(const vtkNBufferProjection& projection);
  void ProjectDeferred(int i);
  void ResetPlacement(vtkIdType i);
  /// ProjectOne(), or ResetPlacement() if the tree finds the placement later; nothing without a
  /// projection.
  void FindPlacement(vtkIdType i, const vtkNBufferProjection* projection);
  int RefreshStale(const vtkNBufferProjection* projection, bool globalStateChanged);
  /// Read what may change without a trace.
  void ReadParts();
  /// Tell all candidates whether a prop of the list uses their objects in another way.
  void FindSharedState(const vtkNBufferProjection* projection);
  bool RefreshOne(std::size_t i, bool globalStateChanged);
  /// Have some of the props observed that have not changed for a while, in turn.
  void ObserveSome();
  bool UsesTree() const { return this->GetSize() >= this->HierarchySize; }

  vtkNBufferPropList<vtkNBufferCandidate> Candidates;
  std::vector<vtkNBufferScreenBox> Screens;
  std::vector<vtkNBufferState> States;
  std::vector<unsigned char> Stale;
  vtkNBufferCandidateTree Tree;
  vtkNBufferMeshes Meshes;
  std::vector<int> Reached; ///< The places that the tree leaves to be projected one by one.
  vtkNBufferObservedObjects Observed;
  int HierarchySize = VTK_INT_MAX;
  int ObserveAfter = 0;
  int FramesOfTurn = 0;       ///< Frames since the current turn of ObserveSome() began.
  std::size_t NextOfTurn = 0; ///< The place of the prop that it comes to next.
  vtkNBufferPropWatch::GlobalState GlobalState{};
  bool ListChanged = false;
  bool UntrackedDepth = false;
  bool Blending = false;
  bool Lines = false;
  bool LackOfNormals = false;
  bool UsesChanged = false;
  bool SharesState = false;
  bool BlendedParts = false;
  std::vector<int> WithParts;                        ///< The places of the props that have parts.
  std::vector<vtkNBufferSharedState::Uses> PartUses; ///< Of all parts of these props.
};

VTK_ABI_NAMESPACE_END
#endif
