// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidate
 * @brief What the culler knows of one prop: whether it may be culled, its box, and until when.
 *
 * This class alone decides which props are tested. A prop is a candidate if everything that it
 * draws in the opaque stage lies inside its bounds, at the depths of its surface, and if it draws
 * nothing in the other stages. Every other prop is drawn as usual, and its verdict says why it is
 * no candidate.
 *
 * Lines are no surface: fragments lie up to half a pixel beyond a line's ends, at depths that go on
 * as steeply as the line does. For a line that is seen end-on, there is no bound to that.
 *
 * What an actor draws is answered by vtkNBufferSurface, and whether it has changed since by
 * vtkNBufferPropWatch.
 */
#ifndef vtkNBufferCandidate_h
#define vtkNBufferCandidate_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSharedState.h"
#include "vtkNBufferStatistics.h"
#include "vtkProp.h"

#include <typeinfo>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;

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
  /// held back, but it is not drawn where it is hidden.
  bool IsTranslucent() const { return this->GetVerdict() == vtkNBufferVerdict::Translucent; }

  /// Whether the prop has a placement in the view, as candidates and translucent props have.
  bool HasPlacement() const { return this->IsCandidate() || this->IsTranslucent(); }

  /// Visible for a candidate, otherwise the reason why the prop is no candidate.
  vtkNBufferVerdict GetVerdict() const
  {
    const bool mayBeLeftOut = this->Verdict == vtkNBufferVerdict::Visible ||
      this->Verdict == vtkNBufferVerdict::Translucent;
    return this->SharesState && mayBeLeftOut ? vtkNBufferVerdict::SharedMapper : this->Verdict;
  }

  /// What a plain actor uses. ReadParts() reads it of other props.
  const vtkNBufferSharedState::Uses& GetUses() const { return this->Uses; }

  /// Set whether another prop uses the same objects in another way. Only the list of all props can
  /// know.
  void SetSharesState(bool shares) { this->SharesState = shares; }

  /// The box of a prop with a placement, in world coordinates.
  const vtkNBufferBox& GetBox() const { return this->Box; }

  /// Whether the prop may write to the depth buffer in the opaque stage.
  bool WritesDepth() const { return this->DepthWriter; }

  ///@{
  /**
   * Whether the prop may blend in the opaque stage, where the order of drawing then shows. It does
   * if it is opaque by force but translucent by itself; if it draws lines, and the window smoothes
   * them; or if it lacks normals, and ambient occlusion needs them (see vtkNBufferCompatibility.h).
   */
  bool IsBlended() const { return this->Blended; }
  bool MayDrawLines() const
  {
    return this->DepthWriter && (!this->IsCandidate() || this->Box.Margin > 0.0);
  }
  bool MayLackNormals() const { return this->Unlit || this->MayDrawLines(); }
  ///@}

  ///@{
  /**
   * The parts of an assembly or another prop that is no plain actor may change without a trace, so
   * that ReadParts() has to be called in each frame. It returns whether any part blends in the
   * opaque stage, and appends what the parts use.
   */
  bool HasParts() const
  {
    return this->Verdict == vtkNBufferVerdict::NotAPlainActor && this->DepthWriter;
  }
  bool ReadParts(std::vector<vtkNBufferSharedState::Uses>& uses) const;
  ///@}

  /**
   * Whether every change of the depth that the prop writes shows in modification times. Custom
   * props, level-of-detail actors and shader uniforms may differ from frame to frame without a
   * trace.
   */
  bool IsTracked() const
  {
    return this->Watch.SeesAllChanges() ||
      (this->Verdict == vtkNBufferVerdict::NotAPlainActor && !this->DepthWriter);
  }

  /// Whether Refresh() must be called. Only reads times; may run in parallel for different props.
  /// See vtkNBufferPropWatch::MayHaveChanged().
  bool IsStale(bool observedAreUnchanged = false) const
  {
    // Of a prop that is no plain actor only the class is known here. It is another one if another
    // prop has been made at the address of a deleted one.
    return this->Verdict == vtkNBufferVerdict::NotAPlainActor
      ? this->Class != &typeid(*this->Prop)
      : this->Watch.MayHaveChanged(observedAreUnchanged);
  }

  /// Have the processor fetch what IsStale() will read.
  void Prefetch(bool observedAreUnchanged) const { this->Watch.Prefetch(observedAreUnchanged); }

  vtkNBufferPropWatch& GetWatch() { return this->Watch; }

  /**
   * Read the prop again, unless neither it nor the global state has changed (see
   * vtkNBufferPropWatch::GetGlobalState()). May run the prop's pipeline, and costs what
   * vtkProp::GetBounds() costs. Returns whether anything has changed since the last call that may
   * change what the prop draws.
   */
  bool Refresh(bool globalStateChanged);

private:
  /// Read the box. Returns Visible, or the verdict of a prop whose box cannot be known.
  vtkNBufferVerdict ReadBox(vtkActor* actor);
  /// The verdict, given that of ReadBox().
  vtkNBufferVerdict Classify(vtkActor* actor, vtkNBufferVerdict box) const;

  // What is read of each prop in each frame comes first, to share a cache line.
  alignas(64) vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  bool SharesState = false;
  bool DepthWriter = true;
  bool Blended = false;
  bool Unlit = false;
  vtkNBufferPropWatch Watch;
  vtkProp* Prop = nullptr;
  vtkMapper* Mapper = nullptr;
  const std::type_info* Class = nullptr; ///< The class of a prop that is no plain actor.
  vtkNBufferBox Box;
  vtkNBufferSharedState::Uses Uses;
};

/// What a view knows of a prop in one frame. It is kept apart from the caches and small, because
/// every frame walks the states of all props several times.
struct vtkNBufferState
{
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  vtkNBufferPlacement Placement = vtkNBufferPlacement::Crossing;

  /// Whether the last depth test that included the prop found it visible.
  bool WasVisible = false;

  /// Whether a depth test has included the prop since it was outside the frustum the last time.
  bool WasTested = false;

  /// Whether the prop is Inside, but its rectangle has not been computed in this frame yet.
  bool RectangleIsStale = false;

  /// Whether the rectangle is stale and the prop lies below a node of the hierarchy that this
  /// frame's depth test has hidden.
  bool Behind = false;
};

VTK_ABI_NAMESPACE_END
#endif
