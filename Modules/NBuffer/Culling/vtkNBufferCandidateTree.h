// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateTree
 * @brief Finds where the candidates of a long list are in the view, by a hierarchy. No OpenGL.
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
 * precision, which is far smaller than the slack of the projection. A test over the hierarchy may
 * find more props hidden than a test of each prop: the texels that are read for the rectangle of a
 * prop may reach beyond those that are read for its node.
 *
 * The tree holds all props that have a placement in the view (candidates and translucent props). A
 * prop that has become one of them since the tree was built is projected one by one.
 *
 * When the tree is refit and built:
 *
 *  - It is refit to the boxes that have changed, in every frame in which some have. If many have
 *    changed (more than FewChanges and more than one in ChangesPerFrame), all props of this frame
 *    are projected one by one, which is cheaper.
 *  - It is built when the list has changed, but not before the list has stayed the same for a
 *    frame. Building takes about ten times as long as projecting all props one by one, and would
 *    never be worth its cost if the list changed in every frame.
 *  - It is built again if refits have made the leaves more than WorstGrowth times as large as they
 *    were when it was built, or if many props are not in it, but at most once in
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
  /// The constants of the rules above.
  static constexpr int ChangesPerFrame = 16;
  static constexpr int FewChanges = 1024;
  static constexpr double WorstGrowth = 2.0;
  static constexpr int FramesBetweenBuilds = 64;
  ///@}

  /// The projection is kept by reference and must outlive this object.
  explicit vtkNBufferCandidateTree(const vtkNBufferProjection& projection)
    : Projection(projection)
  {
  }

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
  /// To be called before Update() if the list has changed, or if the verdict or the box of the prop
  /// at `place` has changed.
  void ListHasChanged();
  void HasChanged(int place);
  ///@}

  /// Bring the tree up to date. Returns false if this frame must project all props one by one.
  bool Update(const std::vector<vtkNBufferCandidate>& candidates);

  /**
   * Find the placements of the candidates and translucent props, all of which must be Outside in
   * `states`. Appends to `places`, each once, the places of the props that the caller must project
   * one by one. The others stay Outside, or are Inside and deferred.
   */
  void FindPlacements(const std::vector<vtkNBufferCandidate>& candidates,
    std::vector<vtkNBufferState>& states, std::vector<int>& places);

  /// The number of levels that MarkHidden() needs, at least 1. `factor` is that of
  /// vtkNBufferOcclusionTest::GetLevelsNeeded().
  int GetLevelsNeeded(int factor) const;

  /// Set the Clearance of the deferred props below hidden nodes. Only the first call in a frame
  /// does this: what is hidden stays hidden, because depth only gets nearer while a frame is drawn.
  void MarkHidden(vtkNBufferOcclusionTest& test, std::vector<vtkNBufferState>& states);

private:
  void Build(const std::vector<vtkNBufferCandidate>& candidates);
  /// Whether any prop below a node is deferred.
  bool HasDeferred(
    const vtkNBufferHierarchy::Node& node, const std::vector<vtkNBufferState>& states) const;

  vtkNBufferHierarchy Tree;
  std::vector<int> Changed;             ///< The places given to HasChanged() since Update().
  std::vector<unsigned char> IsChanged; ///< For each place, whether it is in Changed.
  std::vector<int> Loose;               ///< Places of props that are not in the tree, sorted.
  std::vector<int> Roots;               ///< The nodes wholly inside that have deferred props.
  const vtkNBufferProjection& Projection;
  Work Done;
  bool Built = false;
  bool ListChanged = false;
  bool EverBuilt = false;
  int FramesSinceBuild = 0;
};

VTK_ABI_NAMESPACE_END
#endif
