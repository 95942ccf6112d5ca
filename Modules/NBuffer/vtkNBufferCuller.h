// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCuller
 * @brief Draws only the props that can be seen; the image stays the same to the bit, except for the
 * cases that docs/limits.md names.
 *
 * @code
 * vtkNew<vtkNBufferCuller> culler;
 * renderer->AddCuller(culler);
 * @endcode
 *
 * Nothing else is needed. The culler may be added before or after the first Render(), to several
 * renderers of several windows, and removed at any time. Windows that are drawn in several threads
 * need a culler each.
 *
 * ## How it decides
 *
 * Cull() lets through every prop that it does not test and the candidates that the last test found
 * visible. It holds the other candidates back behind one proxy at the end of the list, or before
 * the first prop that blends in the opaque stage. When the renderer reaches the proxy, this frame's
 * depth is in the framebuffer. The culler reduces it to an N-buffer (vtkNBufferMath.h), tests the
 * boxes of all candidates against it with at most four lookups each, and draws the props held back
 * that may be visible. Where little is known (first frame, camera cut), it first draws near props
 * that probably hide the others, and tests the others in rounds. No test uses the depth of an older
 * frame, so no prop appears a frame too late.
 *
 * Candidates are plain opaque surface actors: vtkOpenGLActor itself with a polydata, composite
 * or dataset mapper, and the subclasses that the application vouches for (AddKnownActor()). Of
 * large meshes, glyphs and splats only parts may be left out (SetDivideProps()). All other props
 * are drawn as without the culler; vtkNBufferVerdict says why. Translucent actors keep their places
 * in the order of blending; those behind opaque props are left out, and no translucent actor hides
 * anything.
 *
 * The culler does the work of each vtkFrustumCoverageCuller with default settings, and moves it
 * behind itself (vtkNBufferTuning::TakeOverFrustumCulling): the culler's own frustum test takes a
 * fraction of the time.
 *
 * Where two props have exactly the same depth in a pixel, the one drawn last wins. A prop that was
 * held back is drawn later than its place in the renderer's list says. The props that come after it
 * in that list are therefore drawn once more where they can touch it (vtkNBufferTieOrder.h).
 *
 * ## Cost
 *
 * A frame costs about 0.1 microseconds per prop to keep its bounds up to date and to test the
 * frustum (long lists use a hierarchy, see vtkNBufferTuning::HierarchySize). To find changes so
 * cheaply, the culler observes a prop without a pipeline and its objects once the prop has not
 * changed for a while (up to 4 kB per prop, see vtkNBufferTuning::ObserveAfter). A prop with a
 * pipeline costs one or two microseconds. A test costs one read-back of a reduced depth image (with
 * software renderers, of the whole one) and the levels that the rectangles of this frame need.
 * There is no test in a frame with fewer candidates than
 * vtkNBufferTuning::MinimumNumberOfCandidates, and none while camera and props stay the same. Where
 * recent tests found next to nothing hidden, there is only a probe now and then.
 *
 * ## Lifetime
 *
 * Observers may remove and delete props, and the culler itself, while a frame is drawn. The props
 * with which the frame began are still drawn, as without the culler, and they and the culler live
 * until the end of the frame (vtkNBufferFrameGuard.h).
 *
 * ## Limits
 *
 * The culler steps aside, and everything is drawn as usual, where props are needed that the camera
 * does not see or where the framebuffer is not the camera's: hardware selection, UseShadows, GL2PS
 * export, hidden-line removal, unknown render passes, VR windows, other cullers behind this one.
 * vtkNBufferDecision lists the cases, and GetDecision() returns the name of the one that applies.
 * After a failure (no context or an old one, no float textures, depth that cannot be read)
 * everything is drawn, the frame is counted, and the first failure of its kind in a window prints a
 * warning with cause and remedy.
 *
 * Sources: X. Decoret, "N-Buffers for efficient depth map query", 2005, section 3.1; M. Turitzin,
 * "Hierarchical Depth Buffers", 2020, for reductions of images of any size.
 *
 * @sa vtkNBufferStatistics vtkNBufferDepthExchange vtkFrustumCoverageCuller
 */
#ifndef vtkNBufferCuller_h
#define vtkNBufferCuller_h

#include "vtkCuller.h"
#include "vtkNBufferCullerTraits.h" // For the base class
#include "vtkNBufferModule.h"       // For export macro
#include "vtkNBufferStatistics.h"   // For vtkNBufferVerdict and the counters
#include "vtkNBufferTuning.h"       // For the tuning
#include "vtkSmartPointer.h"        // For the exchange

#include <memory> // For the implementation's pointer

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferDepthExchange;
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

  /// The depth image from which the host builds the levels.
  enum BackendType
  {
    Auto,   ///< Chosen once per graphics context; see GetBackendInUse().
    OpenGL, ///< From a depth image that the device reduces before it is read back.
    CPU     ///< From the depth image, which is read back.
  };

  ///@{
  /// Whether the culler works. If off, it lets every prop through. Default: on.
  vtkSetMacro(Enabled, bool);
  vtkGetMacro(Enabled, bool);
  vtkBooleanMacro(Enabled, bool);
  ///@}

  ///@{
  /// The depth image from which the levels are built (BackendType). Every back-end builds the same
  /// levels, to the bit. Default: Auto.
  vtkSetClampMacro(Backend, int, Auto, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  ///@{
  /// Whether, with a software renderer, the triangles of hidden props are searched for slivers that
  /// it may draw nearer than the prop's box (vtkNBufferSliverTest). Without the culler the image
  /// has such stray pixels. Mesa's llvmpipe is known to draw them, for example in one of 30 frames
  /// of a plant of thin pipes; no graphics device is. In each frame the search takes 0.2
  /// microseconds per hidden prop of some twenty triangles. It takes 16 bytes per face and 80 per
  /// 32 triangles of each prop that has been hidden, and for some hundred frames 24 bytes per point
  /// and 12 per triangle. A prop with a sliver that may be seen is drawn: one in 1,300 of the
  /// hidden props of a street. Props of vtkNBufferTuning::MinimumNumberOfPrimitives polygons or
  /// more are not searched. Default: on.
  vtkSetMacro(TestSlivers, bool);
  vtkGetMacro(TestSlivers, bool);
  vtkBooleanMacro(TestSlivers, bool);
  ///@}

  ///@{
  /// Whether large props are culled unit by unit: meshes of at least
  /// vtkNBufferTuning::MinimumNumberOfPrimitives cells, whose units are groups of neighbouring
  /// triangles or points. A pass in the property keys lets VTK draw only units that may be seen,
  /// from its own vertex buffers (vtkNBufferDrawHook.h says when a mesh is drawn whole). Takes at
  /// most 100 bytes per unit and, if the file does not list neighbours together, 4 per triangle;
  /// and OpenGL has lists of what is drawn, twice 12 bytes per visible triangle and 104 per visible
  /// instance. If the device makes the lists, it needs 4 bytes per triangle more. While units are
  /// made, once, that needs 24 bytes per point and 32 per triangle. Default: on.
  vtkSetMacro(DivideProps, bool);
  vtkGetMacro(DivideProps, bool);
  vtkBooleanMacro(DivideProps, bool);
  ///@}

  ///@{
  /// Whether the verdicts stay as they are while the camera moves, so that one can fly around and
  /// see what was drawn for a view. The image may then differ from the one without the culler.
  /// Default: off.
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

  ///@{
  /**
   * Vouch for a class of the application's own, by the name that its GetClassName() returns. From
   * the next frame on every culler, and the casters of vtkShadowVolumeClampPass, treat it like the
   * class of VTK from which it is derived; its subclasses have to be named themselves. These
   * functions are static, because a promise holds for a class, and scripts and plug-ins have no
   * access to every culler. A name cannot be removed; a null or empty one is an error.
   *
   * A pass promises for itself, and for all passes that it calls, what vtkNBufferRenderPassTraits
   * lists, and that it uses the list of each frame, and not that of an earlier one. It draws each
   * opaque prop once in a frame, from the renderer's active camera into a framebuffer of the
   * viewport's size, with VTK's depth test and with depth that can be read while it draws.
   *
   * A mapper is derived from vtkOpenGLPolyDataMapper, vtkDataSetMapper or the composite mapper;
   * otherwise it stays NotAPlainMapper. It draws the cells of its input, or some of them, at the
   * positions and depths at which that class draws them, within GetBounds(). It blends nothing in
   * the opaque stage and leaves the OpenGL state that its base class leaves. What it draws does not
   * depend on when, how often and after which props it is drawn. GetMTime() of the mapper or of its
   * data is newer whenever that changes. (A mapper that moves vertices by bones breaks this.)
   *
   * An actor is derived from vtkActor. It draws what vtkOpenGLActor would draw with its
   * GetMapper(), property, texture, shader property and matrix, in the same stages, within
   * GetBounds(), and its GetMTime() is newer whenever these change. It may have several mappers if
   * GetMapper() returns the one that it would draw next and the choice stays the same while a frame
   * is drawn. (This is so for ParaView's vtkPVLODActor, which is known, but not for vtkLODActor and
   * vtkFollower.)
   */
  static void AddKnownPass(const char* className);
  static void AddKnownMapper(const char* className);
  static void AddKnownActor(const char* className);
  ///@}

  ///@{
  /// The object that gives the culler the depth that other ranks of a parallel program have drawn
  /// in the exchange's renderer; see vtkNBufferDepthExchange. Default: nullptr.
  void SetDepthExchange(vtkNBufferDepthExchange* exchange);
  vtkNBufferDepthExchange* GetDepthExchange() const;
  ///@}

  /// Why a prop was drawn or culled in the last frame of `renderer`; nullptr means the renderer
  /// that was culled last. Unknown if the prop was not in that frame. (Props are known by their
  /// addresses: until the next frame a new prop may have the verdict of a deleted one.) Costs one
  /// hash look-up.
  vtkNBufferVerdict GetVerdict(vtkProp* prop, vtkRenderer* renderer = nullptr) const;

  /// The verdict of one part of a prop that is drawn unit by unit (SetDivideProps()): Visible if
  /// the unit of this part was drawn, otherwise Hidden or Outside, and Unknown if the prop has no
  /// such part. `part` is the id of a point of the input for vtkGlyph3DMapper, and the flat index
  /// of a block for composite data. For a mesh it is the number of the triangle or vertex in the
  /// order in which VTK draws them, from 0 on: the id of the cell, if all cells are triangles or
  /// all are vertices. The other parts of a unit have the same verdict. If the prop is drawn or
  /// culled as a whole, every number has the verdict of the prop. The first call after a prop was
  /// divided may make a table of 4 bytes per part; each further one costs two look-ups.
  vtkNBufferVerdict GetVerdict(vtkProp* prop, int part, vtkRenderer* renderer = nullptr) const;

  /**
   * Which pixels keep a prop visible: where the last test of `renderer` found the farthest depth in
   * the rectangle of the prop's box. The prop is not hidden by the levels, because this depth is
   * not nearer than the nearest corner of its box. (The comparison of its box and triangles with
   * single pixels, which follows, may have found another pixel, too.) `pixels` is (x0, y0, x1, y1),
   * half-open, counted from the lower left corner of the viewport, and has at most
   * vtkNBufferTuning::BaseFactor pixels along each side. Returns false, with zeros, if the verdict
   * of the prop in the last frame is not Visible. `renderer` nullptr means the renderer that was
   * culled last. Costs about fifty lookups.
   */
  bool GetVisiblePixels(vtkProp* prop, int pixels[4], vtkRenderer* renderer = nullptr) const;

  /// Counts and times of the last frame of `renderer`; nullptr means the renderer that was culled
  /// last. A renderer without visible props calls no culler: these stay those of the last frame in
  /// which it had some.
  const vtkNBufferStatistics& GetStatistics(vtkRenderer* renderer = nullptr) const;

  ///@{
  /// Single values of GetStatistics(), of the renderer that was culled last.
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

  /// The back-end that was used last in the window of the renderer culled last (OpenGL or CPU; Auto
  /// before the first test there), and why it was chosen.
  int GetBackendInUse() const;
  const char* GetBackendReason() const;

  /// Whether the image is the same as without the culler: true unless Freeze is on. For a subclass
  /// it is false, because the subclass may remove more props; one that does not may override it.
  bool PreservesImage() const override;

  /// Called by vtkRenderer before it draws. It removes props from the list, may put proxies into
  /// it, and returns the sum of the props' render time multipliers (vtkCuller::Cull()).
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
  bool TestSlivers = true;
  bool DivideProps = true;
  bool Freeze = false;
  vtkNBufferTuning Tuning;
  vtkSmartPointer<vtkNBufferDepthExchange> DepthExchange;

  class Internals;
  std::unique_ptr<Internals> Implementation;
};

VTK_ABI_NAMESPACE_END
#endif
