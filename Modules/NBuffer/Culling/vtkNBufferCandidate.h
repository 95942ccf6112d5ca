// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCandidate
 * @brief One prop as the culler knows it: whether it may be culled, its box, and until when.
 *
 * This is the one place that says which props are tested. A prop is a candidate if what it draws
 * in the opaque stage lies inside its bounds, at the depths of its surface, and if it draws
 * nothing in the other stages. All others are drawn as usual, with the reason as verdict.
 *
 * Lines are no surface: fragments lie up to half a pixel beyond a line's ends, at depths that go on
 * as steeply as the line does. Seen end-on, there is no bound to that.
 *
 * What is cached stays valid as long as the modification times of everything that it came from do
 * not change (vtkNBufferSources). VTK's times come from one global counter, so that any change
 * makes the largest of them grow. A prop with a pipeline upstream of its mapper is volatile: its
 * pipeline is asked in every frame (vtkNBufferPipeline), and where the answer says nothing it is
 * looked at anew, pipeline update included, as VTK itself would do.
 */
#ifndef vtkNBufferCandidate_h
#define vtkNBufferCandidate_h

#include "vtkNBufferPipeline.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferSources.h"
#include "vtkNBufferStatistics.h"
#include "vtkType.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkMapper;
class vtkProp;

class VTKNBUFFER_EXPORT vtkNBufferCandidate
{
public:
  explicit vtkNBufferCandidate(vtkProp* prop = nullptr)
    : Prop(prop)
  {
  }

  vtkProp* GetProp() const { return this->Prop; }
  bool IsCandidate() const { return this->Verdict == vtkNBufferVerdict::Visible; }

  /// A candidate but for its translucency: never held back, but left out where it is hidden.
  bool IsTranslucent() const { return this->Verdict == vtkNBufferVerdict::Translucent; }

  /// Visible for a candidate, otherwise the reason why it is none.
  vtkNBufferVerdict GetVerdict() const { return this->Verdict; }

  /// World box of a candidate, and of other actors whose bounds are usable.
  const vtkNBufferBox& GetBox() const { return this->Box; }
  bool HasBox() const { return this->BoxIsUsable; }

  /// Whether it may write to the depth buffer in the opaque stage.
  bool WritesDepth() const { return this->DepthWriter; }

  ///@{
  /**
   * Whether it blends in the opaque stage, where the order of drawing then shows: because it is
   * opaque by force but translucent by itself; if the window smoothes lines and points; or if
   * ambient occlusion wants its normals (see vtkNBufferCompatibility.h).
   */
  bool IsBlended() const { return this->Blended; }
  bool MayDrawLines() const
  {
    return this->DepthWriter && (!this->IsCandidate() || this->Box.Margin > 0.0);
  }
  bool MayLackNormals() const { return this->Unlit || this->MayDrawLines(); }
  ///@}

  /**
   * Whether a change of what it draws shows in modification times. What does not (custom props,
   * level-of-detail actors, shader uniforms) may differ from frame to frame.
   */
  bool IsTracked() const { return this->Tracked; }

  /// Whether Refresh() is due. Only reads times; safe in parallel for different props.
  bool IsStale() const { return this->Volatile || (this->Actor && this->Sources.HasChanged()); }

  /// Have the processor fetch what IsStale() will read.
  void Prefetch() const
  {
    if (!this->Volatile && this->Actor)
    {
      this->Sources.Prefetch();
    }
  }

  /**
   * Look at the prop again, unless its pipeline says that nothing changed and GetGlobalState() did
   * not either. May run its pipeline. Returns whether anything changed since the last time that may
   * change what it draws. Costs what vtkProp::GetBounds() costs.
   */
  bool Refresh(bool globalStateChanged);

  /// Global settings of VTK on which verdicts depend; every prop is refreshed when they change.
  using GlobalState = std::array<double, 6>;
  static GlobalState GetGlobalState();

private:
  vtkNBufferVerdict Classify(vtkActor* actor) const;
  void TakeBounds(vtkActor* actor);
  void TakeSources(vtkActor* actor);

  vtkProp* Prop = nullptr;
  vtkActor* Actor = nullptr;
  vtkMapper* Mapper = nullptr;
  vtkNBufferSources Sources;
  vtkNBufferPipeline Pipeline;
  vtkMTimeType Time = 0;
  vtkNBufferBox Box;
  vtkNBufferVerdict Verdict = vtkNBufferVerdict::Unknown;
  bool BoxIsUsable = false;
  bool BufferIsKnown = true;
  bool HasLines = false;
  bool DepthWriter = true;
  bool Blended = false;
  bool Unlit = false;
  bool Tracked = false;
  bool Volatile = true;
  bool PipelineTaken = false;
};

VTK_ABI_NAMESPACE_END
#endif
