// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCuller
 * @brief Draws only the props that can be seen; the image stays the same to the bit.
 *
 * @code
 * vtkNew<vtkNBufferCuller> culler;
 * renderer->AddCuller(culler);
 * @endcode
 *
 * That is all. The culler may be added before or after the first Render(), to several renderers
 * of several windows, and removed at any time.
 *
 * ## How it decides
 *
 * Cull() lets through what was visible in the last frame and every prop that it does not test,
 * and holds the other candidates back behind one proxy at the end of the list. When the renderer
 * reaches the proxy, this frame's depth is in the framebuffer. It is reduced to an N-buffer
 * (vtkNBufferMath.h), the boxes of all candidates are tested against it with at most four
 * lookups each, and what may be visible is drawn. Where little is known (first frame, camera
 * cut) near props that probably hide the others are drawn first, and the others are tested in
 * rounds. Nothing is carried over from an older depth buffer, so that nothing pops in late.
 *
 * Candidates are plain opaque surface actors: vtkOpenGLActor itself with a polydata, composite
 * or dataset mapper. All other props are drawn as without the culler; vtkNBufferVerdict says why.
 * Translucent actors keep their places in the order of blending; those behind opaque props are left
 * out, and none of them hides anything.
 *
 * The culler takes over the work of a vtkFrustumCoverageCuller with default settings by moving
 * itself in front of it (vtkNBufferTuning::TakeOverFrustumCulling): its own frustum test costs a
 * fraction.
 *
 * Where two props have exactly the same depth in a pixel, the one drawn last wins. A prop that
 * had been held back is drawn later than its place in the renderer says, so that those that come
 * after it in the renderer are drawn once more where they can touch it (vtkNBufferTieOrder.h).
 *
 * ## Cost
 *
 * A frame costs about 0.1 microseconds per prop for cached bounds and the frustum test (for long
 * lists over a hierarchy, see vtkNBufferTuning::HierarchySize); what a prop without a pipeline is
 * made of gets observers for that, once the prop has not changed for a while (300 bytes for each
 * object, see vtkNBufferTuning::ObserveAfter). A prop with a pipeline costs one microsecond or two.
 * A test costs one read-back of a reduced depth image (with software renderers, of the whole one)
 * and the levels that the rectangles of this frame need. There is no test in a frame with fewer
 * candidates than vtkNBufferTuning::MinimumNumberOfCandidates, and none with a still camera and
 * unchanged props. Where recent frames hid next to nothing, only a probe now and then is tested.
 *
 * ## Lifetime
 *
 * Observers may remove and delete props, and the culler itself, while a frame is drawn: what the
 * frame was begun with is drawn, as in VTK, but lives until its end (vtkNBufferFrameGuard.h).
 *
 * ## Limits
 *
 * It steps aside, and all is drawn as usual, where props are needed that the camera does not see
 * or where the framebuffer is not the camera's: hardware selection, UseShadows, GL2PS export,
 * hidden-line removal, unknown render passes, VR windows, other cullers behind this one.
 * vtkNBufferDecision names each case and GetDecision() tells it. A failure (no context or an old
 * one, no float textures, depth that cannot be read) draws everything, is counted, and the first of
 * its kind warns with cause and remedy.
 *
 * Sources: X. Decoret, "N-Buffers for efficient depth map query", 2005, section 3.1; M. Turitzin,
 * "Hierarchical Depth Buffers", 2020, for reductions of images of any size.
 *
 * @sa vtkNBufferStatistics vtkFrustumCoverageCuller
 */
#ifndef vtkNBufferCuller_h
#define vtkNBufferCuller_h

#include "vtkCuller.h"
#include "vtkNBufferCullerTraits.h" // For the base class
#include "vtkNBufferModule.h"       // For export macro
#include "vtkNBufferStatistics.h"   // For vtkNBufferVerdict and the counters
#include "vtkNBufferTuning.h"       // For the tuning

#include <memory> // For the implementation's pointer

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;

class VTKNBUFFER_EXPORT vtkNBufferCuller
  : public vtkCuller
  , public vtkNBufferCullerTraits
{
public:
  static vtkNBufferCuller* New();
  vtkTypeMacro(vtkNBufferCuller, vtkCuller);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the levels are built.
  enum BackendType
  {
    Auto,   ///< Chosen once per graphics context; see GetBackendInUse().
    OpenGL, ///< By fragment passes; the levels are read back.
    CPU     ///< On the host, from the depth image read back.
  };

  ///@{
  /// Off lets every prop through. Default: on.
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  ///@{
  /// Where the levels are built; they are the same to the bit. Default: Auto.
  vtkSetClampMacro(Backend, int, Auto, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  /// When triangles are looked at one by one.
  enum SliverTestType
  {
    Never,
    OnSoftware, ///< With software renderers only.
    Always
  };

  ///@{
  /// Look at the triangles of hidden props for slivers that a rasteriser may draw before the box
  /// that they are in (vtkNBufferSliverTest): stray pixels that the image has without the culler.
  /// Mesa's llvmpipe is known to draw them, one in 40 frames of a plant of thin pipes. Costs some
  /// 5 microseconds per hidden prop of a hundred points and triangles in every frame, 24 bytes per
  /// point and 12 per triangle of their meshes, and the props drawn for it: a few in a hundred of
  /// those hidden, which in a street of a city are more than those that are seen. Default: Never.
  vtkSetClampMacro(TestSlivers, int, Never, Always);
  vtkGetMacro(TestSlivers, int);
  ///@}

  ///@{
  /// Keep the verdicts while the camera moves, to fly around and see what a view draws. The image
  /// is then not the one without the culler. Default: off.
  vtkSetMacro(Freeze, bool);
  vtkGetMacro(Freeze, bool);
  vtkBooleanMacro(Freeze, bool);
  ///@}

  ///@{
  /// The constants that measurements and tests vary, in one call; see vtkNBufferTuning. A value
  /// that is out of its range is an error, and the tuning stays as it was.
  void SetTuning(const vtkNBufferTuning& tuning);
  const vtkNBufferTuning& GetTuning() const { return this->Tuning; }
  ///@}

  /// Why a prop was drawn or culled in the last frame of `renderer`, or, without one, of the
  /// renderer culled last. Unknown if it was not in that frame. Costs one hash look-up.
  vtkNBufferVerdict GetVerdict(vtkProp* prop, vtkRenderer* renderer = nullptr) const;

  /// Counts and times of the last frame of `renderer`, or of the renderer culled last.
  const vtkNBufferStatistics& GetStatistics(vtkRenderer* renderer = nullptr) const;

  ///@{
  /// The same numbers one by one, of the renderer culled last.
  int GetNumberOfProps() const { return this->GetStatistics().Props; }
  int GetNumberOfPropsDrawn() const { return this->GetStatistics().GetNumberOfPropsDrawn(); }
  int GetNumberOfHiddenProps() const
  {
    return this->GetStatistics().GetCount(vtkNBufferVerdict::Hidden);
  }
  int GetNumberOfPropsOutside() const
  {
    return this->GetStatistics().GetCount(vtkNBufferVerdict::Outside);
  }
  const char* GetDecision() const
  {
    return vtkNBufferStatistics::GetName(this->GetStatistics().Decision);
  }
  std::string GetStatisticsAsJSON() const { return this->GetStatistics().GetAsJSON(); }
  ///@}

  /// The back-end used last (OpenGL or CPU; Auto before the first test) and why it was chosen.
  int GetBackendInUse() const;
  const char* GetBackendReason() const;

  /// Whether the image is the one without the culler, which is true unless Freeze is on. A subclass
  /// has to say so itself, because it may remove more props.
  bool PreservesImage() const override;

  /// Called by vtkRenderer before it draws.
  double Cull(
    vtkRenderer* renderer, vtkProp** propList, int& listLength, int& initialized) override;

protected:
  vtkNBufferCuller();
  ~vtkNBufferCuller() override;

private:
  vtkNBufferCuller(const vtkNBufferCuller&) = delete;
  void operator=(const vtkNBufferCuller&) = delete;

  bool Enabled = true;
  int Backend = Auto;
  int TestSlivers = Never;
  bool Freeze = false;
  vtkNBufferTuning Tuning;

  class Internals;
  std::unique_ptr<Internals> Implementation;
};

VTK_ABI_NAMESPACE_END
#endif
