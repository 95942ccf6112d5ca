// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidateTree
 * @brief Where the candidates of a long list lie in view, found over a hierarchy. No OpenGL.
 *
 *     node outside        all below are Outside, none is looked at
 *     node wholly inside  all below are Inside; those that nothing is known of are deferred
 *     any other           its children are asked, or each prop of a leaf
 *
 * The rectangle of a deferred prop is made when it is asked for, and never below a node that the
 * depth test hides.
 *
 * Placements are those that asking one by one would give (rounding of double precision apart, which
 * the slack of the projection exceeds by far). Of the props in view more may be found hidden: the
 * squares that answer the rectangle of a prop may reach beyond those that answer its node's.
 *
 * Which props are in the tree: all that have a place in the view (candidates and translucent ones).
 * Props of other kinds are none of its business, and those that have become candidates since it
 * was built are asked one by one.
 *
 * When it is built and refit:
 *
 *  - Refit to the boxes that have changed, in every frame in which some have. Where more than
 *    FewChanges and one in ChangesPerFrame have, the frame is done one by one, which is cheaper.
 *  - Built when the list has changed, but not before it has stayed the same for a frame: building
 *    takes some ten times as long as a frame one by one, which a list that changes in every frame
 *    would never earn. And where refits have made leaves more than twice as wide as they were built
 *    (WorstGrowth), at most every FramesBetweenBuilds frames.
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
  /// Of the rules above. Up to FewChanges are always refit.
  static constexpr int ChangesPerFrame = 16;
  static constexpr int FewChanges = 1024;
  static constexpr double WorstGrowth = 2.0;
  static constexpr int FramesBetweenBuilds = 64;
  ///@}

  /// Work since BeginFrame().
  struct Work
  {
    long long Nodes = 0; ///< Looked at, for the view and for the depth test.
    int Refits = 0;      ///< Boxes that had changed.
    int Builds = 0;
  };

  void BeginFrame() { this->Done = Work(); }
  const Work& GetWork() const { return this->Done; }

  ///@{
  /// What has changed since the last Update(): the list, or kind or box of the prop of a place.
  void ListHasChanged();
  void HasChanged(int place);
  ///@}

  /// Bring the tree up to date. False if this frame is to be done one by one.
  bool Update(const std::vector<vtkNBufferCandidate>& candidates);

  /**
   * Place the candidates. All of them must be Outside in `states`. Which are to be projected one by
   * one is appended to `places`, each once; others are deferred.
   */
  void Place(const vtkNBufferProjection& projection,
    const std::vector<vtkNBufferCandidate>& candidates, std::vector<vtkNBufferState>& states,
    std::vector<int>& places);

  /// Levels that the nodes of deferred props need, see vtkNBufferOcclusionTest; 1 without any.
  int GetLevelsNeeded(const vtkNBufferProjection& projection, int factor) const;

  /// Mark the deferred props below nodes that are hidden, once for all tests of a frame.
  void MarkHidden(const vtkNBufferProjection& projection, vtkNBufferOcclusionTest& test,
    std::vector<vtkNBufferState>& states);

private:
  void Build(const std::vector<vtkNBufferCandidate>& candidates);
  bool HasDeferred(
    const vtkNBufferHierarchy::Node& node, const std::vector<vtkNBufferState>& states) const;

  vtkNBufferHierarchy Tree;
  std::vector<int> Changed;
  std::vector<unsigned char> IsChanged; ///< By place.
  std::vector<int> Loose;               ///< Places of candidates that are not in the tree.
  std::vector<int> Roots;               ///< Nodes wholly inside with deferred props below.
  Work Done;
  bool Built = false;
  bool ListChanged = false;
  bool EverBuilt = false;
  int FramesSinceBuild = 0;
};

VTK_ABI_NAMESPACE_END
#endif
