// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateList
 * @brief The props of one view in the renderer's order, cached from frame to frame.
 *
 * In a long list a hierarchy finds where the props are in the view (vtkNBufferCandidateTree). The
 * rectangle of a prop may then be deferred: it is computed when GetScreen() is called for the prop.
 */
#ifndef vtkNBufferCandidateList_h
#define vtkNBufferCandidateList_h

#include "vtkNBufferCandidate.h"
#include "vtkNBufferCandidateTree.h"
#include "vtkNBufferFaces.h"
#include "vtkNBufferListTraits.h"
#include "vtkNBufferMeshes.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferObservedObjects.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferPropList.h"
#include "vtkNBufferTieOrder.h"

#include <optional>
#include <unordered_set>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKNBUFFER_EXPORT vtkNBufferCandidateList
{
public:
  /// The projection of the view is kept by reference and must outlive this object.
  explicit vtkNBufferCandidateList(const vtkNBufferProjection& projection)
    : Projection(projection)
    , Tree(projection)
  {
  }

  /// Follow the renderer's list of props. Returns whether it differs from the last one.
  bool Synchronize(vtkProp** props, int count);

  /// Grows whenever Synchronize() finds another list.
  int GetListNumber() const { return this->ListNumber; }

  /// Bring the caches up to date. Returns the number of props that have changed. Project() has to
  /// be called before the next test if any prop has changed. The arguments are HierarchySize and
  /// ObserveAfter of vtkNBufferTuning.
  int Refresh(int hierarchySize = VTK_INT_MAX, int observeAfter = 0);

  /// The places of the props that the last Refresh() has found changed, in ascending order.
  const std::vector<int>& GetChanged() const { return this->Changed; }

  /// Find the placement of every candidate and translucent prop in the view: outside, crossing, or
  /// inside with its rectangle and depth interval.
  void Project();
  const vtkNBufferProjection& GetProjection() const { return this->Projection; }

  /// The number of levels that MarkHidden() needs, at least 1. `factor` is the side of a texel of
  /// level 0 in pixels.
  int GetLevelsNeeded(int factor) const { return this->Tree.GetLevelsNeeded(factor); }

  /// Set the Clearance of the deferred props below hidden nodes. This must be called before the
  /// first test of a frame; further calls in the frame do nothing.
  void MarkHidden(vtkNBufferOcclusionTest& test) { this->Tree.MarkHidden(test, this->States); }

  /**
   * If all candidates and translucent props are hidden or outside, let the renderer draw a hidden
   * one or, if there is none, those that are outside. VTK skips a renderer whose list is empty,
   * image processing included. (A prop that owns no sample is hidden or outside wherever it is.)
   * Props of other kinds are not enough to prevent this: a culler that runs later may remove them.
   */
  void KeepIfNoneIsInside();

  /// What some of the props are.
  const vtkNBufferListTraits& GetTraits() const { return this->Traits; }

  /// Whether the image may depend on the order in which the opaque stage draws any of the props,
  /// because some share an object that they use in different ways (vtkNBufferSharedState), or
  /// because normals blend where `ambientOcclusion` (that of vtkNBufferCompatibility) is on.
  bool HasBlending(bool ambientOcclusion) const
  {
    return this->SharesState || this->SharedChanged ||
      (ambientOcclusion && this->Traits.LackOfNormals);
  }

  /// Set the counts of verdicts, of props drawn before the first test, and of the hierarchy's work.
  void CountVerdicts(vtkNBufferStatistics& statistics) const;

  /// Describe prop i for vtkNBufferTieOrder. `round` is 0 for props that the renderer draws.
  vtkNBufferDrawnProp GetDrawn(int i, int round);

  /// Read the triangles and faces of prop i; none if it has `limit` polygons or more.
  void ReadTriangles(int i, int limit);

  /// Release what was read of props that have changed since. To be called after ReadTriangles().
  void ReleaseUnusedFaces() { this->Faces.ReleaseUnused(this->FacesOfProps, 0.125); }

  ///@{
  /// What ReadTriangles() has read. The triangles are released if they are not read for some time,
  /// and then empty. The faces of composite data are never known, because blocks may change without
  /// a newer time: they have to be read in each frame.
  const std::vector<vtkNBufferMeshes::Placed>& GetMeshes(int i) const
  {
    return this->MeshesOfProps[i].Meshes;
  }
  const vtkNBufferFaces& GetFaces() const { return this->Faces; }
  const vtkNBufferFaces::OfProp& GetFaces(int i) const { return this->FacesOfProps[i]; }
  ///@}

  /// Copy the triangles that MayBeSeen() needs: those of small meshes
  /// (vtkNBufferMeshes::FindSmall), for props that the last test found visible, and only of a few
  /// props in a frame.
  void CopyTriangles(const std::vector<int>& places);

  /// Whether one of `count` triangles of candidate i may be visible
  /// (vtkNBufferPixelTest::MayBeSeen()), or nullopt if its triangles are not known. May run in
  /// parallel for different candidates.
  std::optional<bool> MayBeSeen(int i, vtkNBufferPixelTest& test, std::size_t count);

  int GetSize() const { return static_cast<int>(this->Candidates.GetSize()); }
  vtkProp* GetProp(int i) const { return this->Candidates.GetProp(i); }
  const vtkNBufferCandidate& GetCandidate(int i) const { return this->Candidates[i]; }
  const vtkNBufferBox& GetBox(int i) const { return this->Candidates[i].GetBox(); }

  /// The rectangle of prop i. If it was deferred, it is computed now, which may change the prop's
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
  void ProjectOne(int i);
  void ProjectDeferred(int i);
  /// Find the props that have to be read again: all if vtkNBufferPropWatch::GetGlobalState() has
  /// changed, otherwise those with a newer time. Only compares times.
  void FindStale(bool globalStateChanged);
  void RefreshStale(bool globalStateChanged);
  /// Call vtkNBufferCandidate::ReadParts() for the props that have parts.
  void ReadParts();
  /// Find out for each candidate whether another prop uses one of its objects in another way.
  void FindSharedState();
  /// Visit the next few props in turn, and observe those that have not changed since the last one.
  /// A turn takes at least `frames` frames. With 0 frames nothing is observed.
  void ObserveSome(int frames);

  const vtkNBufferProjection& Projection;
  vtkNBufferPropList<vtkNBufferCandidate> Candidates;
  std::vector<vtkNBufferScreenBox> Screens;
  std::vector<vtkNBufferState> States;
  std::vector<int> Polled;                  ///< The places of the props whose times are compared.
  std::vector<unsigned char> PolledIsStale; ///< For each of these, whether it is in Stale.
  std::vector<int> Stale;   ///< The places of the props that RefreshStale() has to read.
  std::vector<int> Changed; ///< The places of those that have changed.
  vtkNBufferCandidateTree Tree;
  bool UsesTree = false; ///< Whether the list is long enough for it.
  vtkNBufferMeshes Meshes;
  std::vector<vtkNBufferMeshes::OfProp> MeshesOfProps; ///< One element for each prop.
  vtkNBufferFaces Faces;
  std::vector<vtkNBufferFaces::OfProp> FacesOfProps; ///< One element for each prop.
  std::vector<int> Reached; ///< The places of the props that the tree leaves to ProjectOne().
  /// The objects of props, except for actors. VTK replaces some of them without a newer time of
  /// their owner: vtkPolyData::RemoveDeletedCells() deletes arrays of cells.
  vtkNBufferObservedObjects Observed;
  /// A deleted actor counts as changed, because another prop may have been made at its address.
  vtkNBufferObservedObjects ObservedActors;
  int FramesOfTurn = 0;       ///< Frames since the current turn of ObserveSome() began.
  std::size_t NextOfTurn = 0; ///< The place of the prop that the turn visits next.
  vtkNBufferPropWatch::GlobalState GlobalState{};
  int ListNumber = 0;
  bool ListChanged = false;   ///< Since the last RefreshStale().
  bool UsesChanged = false;   ///< FindSharedState() has to be called.
  bool SharesState = false;   ///< For its sake the order of all props matters.
  bool SharedChanged = false; ///< Some prop in OtherShaders has changed.
  vtkNBufferListTraits Traits;
  std::vector<int> WithParts;                        ///< The places of the props that have parts.
  std::vector<vtkNBufferSharedState::Uses> PartUses; ///< The uses of all parts of these props.
  std::unordered_set<vtkMapper*> OtherShaders;       ///< Those for which HasOtherShaders() is true.
};

VTK_ABI_NAMESPACE_END
#endif
