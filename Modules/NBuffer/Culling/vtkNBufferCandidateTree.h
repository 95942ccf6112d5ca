// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateTree
 * @brief Places the candidates of a long list in the view over a hierarchy. No OpenGL.
 *
 *     node outside        All props below it are Outside. None of them is read.
 *     node wholly inside  All props below it are Inside. Those that were not visible in the last
 *                         test are deferred: their rectangles are not computed yet.
 *     any other node      Its children are tested, or each prop of a leaf is projected.
 *
 * The rectangle of a deferred prop is computed when it is needed, and never if the prop lies below
 * a node that the depth test hides.
 *
 * Props get the placements that projecting each of them would give, apart from rounding in double
 * precision, which the slack of the projection exceeds by far. More of the props in view may be
 * found hidden: the texels that are read for the rectangle of a prop may reach beyond those that
 * are read for its node.
 *
 * The tree holds all props that have a place in the view (candidates and translucent props). A prop
 * that has become one of them since the tree was built is projected one by one.
 *
 * When the tree is refit and built:
 *
 *  - It is refit to the boxes that have changed, in every frame in which some have. If more than
 *    FewChanges and more than one in ChangesPerFrame have changed, all props of this frame are
 *    projected one by one, which is cheaper.
 *  - It is built when the list has changed, but not before the list has stayed the same for a
 *    frame. Building takes some ten times as long as projecting all props one by one, which would
 *    never be worth its cost if the list changed in every frame. It is also built again where
 * refits have made leaves more than WorstGrowth times as wide as they were built, at most every
 *    FramesBetweenBuilds frames.
 */
#ifndef vtkNBufferCandidateTree_h
#define vtkNBufferCandidateTree_h

#include "vtkNBufferHierarchy.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferProjection.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCandidate;
struct vtkNBufferState;

class VTKNBUFFER_EXPORT vtkNBufferCandidateTree
{
public:
  ///@{
  /// The constants of the rules above. Up to FewChanges changes are always refit.
  static constexpr int ChangesPerFrame = 16;
  static constexpr int FewChanges = 1024;
  static constexpr double WorstGrowth = 2.0;
  static constexpr int FramesBetweenBuilds = 64;
  ///@}

  /// The work since BeginFrame().
  struct Work
  {
    long long Nodes = 0; ///< Nodes that were tested against the view or the depth.
    int Refits = 0;      ///< Boxes that had changed.
    int Builds = 0;      ///< How often the tree was built.
  };

  void BeginFrame() { this->Done = Work(); }
  const Work& GetWork() const { return this->Done; }

  ///@{
  /// Tell the tree before Update() that the list has changed, or the verdict or box of the prop at
  /// a place.
  void ListHasChanged();
  void HasChanged(int place);
  ///@}

  /// Bring the tree up to date. Returns false if this frame must project all props one by one.
  bool Update(const std::vector<vtkNBufferCandidate>& candidates);

  /**
   * Place the candidates, all of which must be Outside in `states`. The places of props that must
   * be projected one by one are appended to `places`, each once. The others are deferred.
   */
  void Place(const vtkNBufferProjection& projection,
    const std::vector<vtkNBufferCandidate>& candidates, std::vector<vtkNBufferState>& states,
    std::vector<int>& places);

  /// The number of levels that the depth test of the nodes of deferred props needs, at least 1 (see
  /// vtkNBufferOcclusionTest).
  int GetLevelsNeeded(const vtkNBufferProjection& projection, int factor) const;

  /// Mark the deferred props below hidden nodes as Behind. This serves all tests of a frame.
  void MarkHidden(const vtkNBufferProjection& projection, vtkNBufferOcclusionTest& test,
    std::vector<vtkNBufferState>& states);

private:
  void Build(const std::vector<vtkNBufferCandidate>& candidates);
  /// Whether any prop below a node is deferred.
  bool HasDeferred(
    const vtkNBufferHierarchy::Node& node, const std::vector<vtkNBufferState>& states) const;

  vtkNBufferHierarchy Tree;
  std::vector<int> Changed;
  std::vector<unsigned char> IsChanged; ///< By place.
  std::vector<int> Loose;               ///< Places of props that are not in the tree, sorted.
  std::vector<int> Roots;               ///< Nodes wholly inside that have deferred props below.
  Work Done;
  bool Built = false;
  bool ListChanged = false;
  bool EverBuilt = false;
  int FramesSinceBuild = 0;
};

VTK_ABI_NAMESPACE_END
#endif
