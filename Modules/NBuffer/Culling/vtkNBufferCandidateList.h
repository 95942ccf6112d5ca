// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateList
 * @brief The props of one view in the renderer's order, cached from frame to frame.
 *
 * Renderers hand over the same props in the same order in most frames, so that the list is
 * compared with the one before pointer by pointer, and only a difference costs look-ups. A prop
 * made at the address of a deleted one is told by its newer modification time.
 *
 * Long lists are placed in view over a hierarchy (vtkNBufferCandidateTree), where a rectangle may
 * be deferred until it is asked for.
 */
#ifndef vtkNBufferCandidateList_h
#define vtkNBufferCandidateList_h

#include "vtkNBufferCandidate.h"
#include "vtkNBufferCandidateTree.h"
#include "vtkNBufferMeshes.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferTieOrder.h"

#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * What a view knows of a prop in one frame. Small and apart from the caches: every frame walks all
 * of these several times.
 */
struct vtkNBufferState
{
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Crossing;
  bool WasVisible = false;       ///< Found visible by the last test.
  bool RectangleIsStale = false; ///< Inside, but its rectangle has not been made yet.
  bool Behind = false; ///< RectangleIsStale, and below a node that this frame's test has hidden.
};

class VTKNBUFFER_EXPORT vtkNBufferCandidateList
{
public:
  /// Candidates from which on a hierarchy is used, see vtkNBufferCuller::SetHierarchySize.
  void SetHierarchySize(int size) { this->HierarchySize = size; }

  /// Take over a renderer's list. Returns whether it differs from the last one.
  bool Synchronize(vtkProp** props, int count);

  /**
   * Bring the caches up to date and, given a projection, do what Project() does: both walk the same
   * memory, so that in short lists they cost little more than one. Returns how many props changed.
   */
  int Refresh(const vtkNBufferProjection* projection);

  /// Place every candidate and translucent prop with respect to the view: outside, crossing, or
  /// inside with its rectangle and depth interval. The projection is kept by reference for
  /// rectangles that are deferred, until the next call.
  void Project(const vtkNBufferProjection& projection);

  /// Levels that nodes of deferred props need over a base of the given factor.
  int GetLevelsNeeded(int factor) const;

  /// Have deferred props that lie below hidden nodes marked as Behind. To be called before the
  /// first test of a frame; once only.
  void MarkHidden(vtkNBufferOcclusionTest& test);

  /// Where no prop is known to reach into the view, take none for outside: VTK leaves a renderer
  /// whose list is empty alone, image processing included, and a culler behind may remove any.
  void KeepIfNoneIsInside();

  /// Whether the depth that any of the props writes may change without a trace.
  bool HasUntrackedDepth() const { return this->UntrackedDepth; }

  /// Whether any prop blends in the opaque stage, with smooth lines or ambient occlusion or not.
  bool HasBlending(bool smoothLines, bool ambientOcclusion) const
  {
    return this->Blending || (smoothLines && this->Lines) ||
      (ambientOcclusion && this->LackOfNormals);
  }

  /// Verdicts, from them how many props were drawn before the first test, and the work of the
  /// hierarchy.
  void CountVerdicts(vtkNBufferStatistics& statistics) const;

  /// Prop i as drawn in a round, for the order of equal depths.
  vtkNBufferDrawnProp GetDrawn(int i, int round);

  /// The triangles of prop i, see vtkNBufferMeshes.
  const std::vector<const vtkNBufferMesh*>& GetMeshes(int i);

  int GetSize() const { return static_cast<int>(this->Candidates.size()); }
  vtkProp* GetProp(int i) const { return this->Candidates[i].GetProp(); }
  const vtkNBufferCandidate& GetCandidate(int i) const { return this->Candidates[i]; }
  const vtkNBufferBox& GetBox(int i) const { return this->Candidates[i].GetBox(); }
  /// Its rectangle, made now if it was deferred; then its placement may turn out another one.
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
  const std::vector<vtkNBufferState>& GetStates() const { return this->States; }

  /// Place of a prop in the list, or -1. One hash look-up; the first one after a change of the list
  /// fills the table.
  int Find(vtkProp* prop) const;

private:
  void ProjectOne(vtkIdType i, const vtkNBufferProjection& projection);
  void ProjectAll(const vtkNBufferProjection& projection);
  void ProjectOverTree(const vtkNBufferProjection& projection);
  void ProjectDeferred(int i);
  void Unplace(vtkIdType i);
  int RefreshStale(const vtkNBufferProjection* projection, bool globalStateChanged);
  bool RefreshOne(std::size_t i, bool globalStateChanged);
  bool UsesTree() const { return this->GetSize() >= this->HierarchySize; }

  std::vector<vtkNBufferCandidate> Candidates;
  std::vector<vtkNBufferScreenBox> Screens;
  std::vector<vtkNBufferState> States;
  std::vector<vtkProp*> Order; ///< The renderer's list as it came last.
  std::vector<unsigned char> Stale;
  mutable std::unordered_map<vtkProp*, int> Index;
  vtkNBufferCandidateTree Tree;
  vtkNBufferMeshes Meshes;
  std::vector<int> Reached; ///< Places that the tree leaves to be asked one by one.
  const vtkNBufferProjection* Projection = nullptr;
  int HierarchySize = VTK_INT_MAX;
  vtkNBufferCandidate::GlobalState GlobalState{};
  bool ListChanged = false;
  bool UntrackedDepth = false;
  bool Blending = false;
  bool Lines = false;
  bool LackOfNormals = false;
};

VTK_ABI_NAMESPACE_END
#endif
