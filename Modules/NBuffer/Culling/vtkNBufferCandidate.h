// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidate
 * @brief What the culler knows of one prop: whether it may be culled, and its box.
 *
 * This class alone decides which props are tested. A prop is a candidate if everything that it
 * draws in the opaque stage lies inside its bounds, at the depths of its surface, and if it draws
 * nothing in the other stages. Every other prop is drawn as usual, and its verdict says why it is
 * no candidate.
 *
 * Props that draw lines are no candidates. A device draws fragments up to half a pixel beyond the
 * ends of a line, and their depths continue the slope of the line. Nothing bounds these depths for
 * a line that is seen end-on.
 *
 * vtkNBufferSurface knows what an actor draws. vtkNBufferPropWatch finds out whether this has
 * changed since it was read.
 */
#ifndef vtkNBufferCandidate_h
#define vtkNBufferCandidate_h

#include "vtkNBufferBlocks.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSharedState.h"
#include "vtkNBufferStatistics.h"
#include "vtkProp.h"

#include <memory>
#include <typeinfo>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;

class VTKNBUFFER_EXPORT vtkNBufferCandidate
{
public:
  explicit vtkNBufferCandidate(vtkProp* prop = nullptr)
    : Prop(prop)
  {
  }

  vtkProp* GetProp() const { return this->Prop; }
  bool IsCandidate() const { return this->GetVerdict() == vtkNBufferVerdict::Visible; }

  /// Whether translucency is the only reason why the prop is no candidate. Such a prop is never
  /// held back, but it is not drawn if it is hidden.
  bool IsTranslucent() const { return this->GetVerdict() == vtkNBufferVerdict::Translucent; }

  /// Whether the prop is tested as a whole, so that it has a box and, in each view, a
  /// vtkNBufferPlacement. Of translucent instances, which have no box, only units are tested.
  bool HasPlacement() const
  {
    return this->IsCandidate() || (this->IsTranslucent() && !this->HasInstances);
  }

  /// Visible for a candidate, otherwise the reason why the prop is no candidate.
  vtkNBufferVerdict GetVerdict() const
  {
    const bool mayBeLeftOut = this->Verdict == vtkNBufferVerdict::Visible ||
      this->Verdict == vtkNBufferVerdict::Translucent;
    return this->SharesState && mayBeLeftOut ? vtkNBufferVerdict::SharedMapper : this->Verdict;
  }

  /// The objects that a plain actor may share with others. For other props see ReadParts().
  const vtkNBufferSharedState::Uses& GetUses() const { return this->Uses; }

  /// Set whether another prop uses one of these objects in another way. Only the list of all props
  /// knows this.
  void SetSharesState(bool shares) { this->SharesState = shares; }
  bool GetSharesState() const { return this->SharesState; }

  /// The box of a prop with a placement, in world coordinates.
  const vtkNBufferBox& GetBox() const { return this->Box; }

  /// Whether the prop may write to the depth buffer in the opaque stage.
  bool WritesDepth() const { return this->DepthWriter; }

  ///@{
  /**
   * Whether the prop may blend in the opaque stage, so that the image depends on the order of
   * drawing. If IsBlended(), it always does, or it reads the depth there
   * (vtkNBufferDrawOrder::MattersTo()). If MayDrawLines(), it does if the window smooths lines. If
   * MayLackNormals(), it does if there is ambient occlusion, which needs normals (see
   * vtkNBufferCompatibility::DrawingSettings).
   */
  bool IsBlended() const { return this->Blended; }
  bool MayDrawLines() const
  {
    return this->DepthWriter && (!this->IsCandidate() || this->Box.Margin > 0.0);
  }
  bool MayLackNormals() const { return this->Unlit || this->MayDrawLines(); }

  /// Whether its depth is offset, in either direction (vtkNBufferSurface::HasOffset()).
  bool HasOffset() const { return this->Offset; }
  ///@}

  ///@{
  /**
   * HasParts() says whether the prop is an assembly, or any other prop that is no plain actor,
   * except volumes. The parts of such a prop, which may be its only part itself, may change without
   * a newer modification time, so that ReadParts() has to be called in each frame. ReadParts()
   * returns whether any part is blended (see IsBlended()), and appends the objects that the parts
   * use to `uses`.
   */
  bool HasParts() const;
  bool ReadParts(std::vector<vtkNBufferSharedState::Uses>& uses) const;
  ///@}

  /// Whether every change of the depth that the prop writes shows in modification times. Custom
  /// props, 2-D props, level-of-detail actors and shader uniforms may differ from frame to frame
  /// without a newer time.
  bool IsTracked() const { return this->Watch.SeesAllChanges(); }

  /// Whether Refresh() must be called. Only reads modification times, and may run in parallel for
  /// different props. `observedAreUnchanged` is that of vtkNBufferPropWatch::MayHaveChanged().
  bool IsStale(bool observedAreUnchanged = false) const
  {
    // If the prop is no plain actor, only its class is compared, to notice another prop at the
    // address of a deleted one.
    return this->Verdict == vtkNBufferVerdict::NotAPlainActor
      ? this->Class != &typeid(*this->Prop)
      : this->Watch.MayHaveChanged(observedAreUnchanged);
  }

  /// Prefetch the memory that IsStale() will read into the processor's cache.
  void Prefetch(bool observedAreUnchanged) const { this->Watch.Prefetch(observedAreUnchanged); }

  vtkNBufferPropWatch& GetWatch() { return this->Watch; }

  /**
   * Read the prop again if it has changed, or if `globalStateChanged` is true, because
   * vtkNBufferPropWatch::GetGlobalState() has changed. May run the prop's pipeline, and takes as
   * long as vtkProp::GetBounds(). Returns whether what the prop draws may have changed since the
   * last call.
   */
  bool Refresh(bool globalStateChanged);

private:
  /// Read the box. Returns Visible, or the verdict of a prop whose box cannot be known.
  vtkNBufferVerdict ReadBox(vtkActor* actor);
  void ReadBlocks(vtkActor* actor); ///< The part of ReadBox() for composite data and grids.
  /// The verdict of the prop, where `box` is the result of ReadBox().
  vtkNBufferVerdict Classify(vtkActor* actor, vtkNBufferVerdict box) const;

  // What is read of each prop in each frame comes first, to share a cache line.
  alignas(64) vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  bool SharesState = false;
  bool DepthWriter = true;
  bool Blended = false;
  bool Unlit = false;
  vtkNBufferPropWatch Watch;
  vtkProp* Prop = nullptr;
  const std::type_info* Class = nullptr; ///< The class of a prop that is no plain actor.
  vtkNBufferBox Box;
  std::unique_ptr<vtkNBufferBlocks> Blocks; ///< Of composite data and grids only.
  vtkNBufferSharedState::Uses Uses;
  bool Offset = false;
  bool HasInstances = false; ///< Whether these are translucent instances.
};

/// What a view knows of a prop in one frame. It is small and not a part of vtkNBufferCandidate,
/// because every frame reads the states of all props several times.
struct vtkNBufferState
{
  /// The verdict of the prop itself (vtkNBufferCandidate::GetVerdict()), with which a frame begins.
  vtkNBufferVerdict OwnVerdict = vtkNBufferVerdict::Unknown;
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Crossing;

  /// Whether the last depth test that included the prop found it visible.
  bool WasVisible = false;

  /// Whether a depth test has included the prop since it was last outside the frustum.
  bool WasTested = false;

  /// Whether the prop is deferred: it is Inside, but its rectangle has not been computed yet.
  bool RectangleIsStale = false;

  bool FirstDrawIsDue = false; ///< See vtkNBufferFirstDraws.

  /// Whether every change of the prop invokes an event (vtkNBufferPropWatch::IsWhollyObserved()).
  bool Observed = false;

  /// If the levels hide the prop, or its rectangle is stale and they hide a node of the hierarchy
  /// above it, how much nearer than it they are at least (vtkNBufferOcclusionTest::GetClearance());
  /// otherwise not positive.
  float Clearance = 0.0F;
};

VTK_ABI_NAMESPACE_END
#endif
