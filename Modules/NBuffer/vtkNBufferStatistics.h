// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferStatistics.h
 * @brief What the culler did with every prop of a frame, and how much work and time that took.
 *
 * The getters of vtkNBufferCuller, PrintSelf, JSON, overlays and tests all read one struct. Every
 * prop that the renderer gave to the culler has exactly one verdict, so that in every frame
 *
 *     Props = sum of Verdicts = drawn + hidden + outside.
 */
#ifndef vtkNBufferStatistics_h
#define vtkNBufferStatistics_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

/**
 * Why a prop was drawn or not drawn. Props with the verdicts Outside and Hidden were not drawn.
 * Visible, NearPlane and Translucent were tested and drawn. All others were drawn without a test of
 * the whole prop. Most of those from NotAPlainActor on can never be tested, because what they draw
 * may differ from what their box says; of large glyphs and splats (NotAPlainMapper) the parts are.
 */
enum class vtkNBufferVerdict : int
{
  Unknown,          ///< The last frame did not contain it: it is invisible or in another renderer.
  Outside,          ///< Not drawn: its box lies outside the view frustum.
  Hidden,           ///< Not drawn: its box lies behind occluders (for translucent props, too).
  Visible,          ///< Drawn: its box may be seen.
  NearPlane,        ///< Drawn: its box reaches the near plane or the eye point.
  Untested,         ///< Drawn: the frame was not tested (vtkNBufferDecision says why).
  NotAPlainActor,   ///< Drawn: no vtkOpenGLActor itself, but a subclass that is not known
                    ///< (vtkNBufferCuller::AddKnownActor()), a volume, an assembly, 2D, ...
  NotAPlainMapper,  ///< Drawn: it has no mapper, or one of a class that is not known
                    ///< (vtkNBufferCuller::AddKnownMapper()), whose bounds may be too small.
  Translucent,      ///< Drawn: it may be seen and has translucent geometry, which hides nothing.
  NotASurface,      ///< Drawn: it draws lines, points, edges, vertices or spheres.
  DepthOffset,      ///< Drawn: coincident-topology parameters pull its depth towards the eye.
  ShaderReplaced,   ///< Drawn: the application replaces its shader code.
  OtherCoordinates, ///< Drawn: its coordinates are not world coordinates.
  NoBounds,         ///< Drawn: its bounds are null, uninitialised, infinite or NaN, or its matrix
                    ///< is not affine.
  SharedMapper,     ///< Drawn: it shares its mapper, lookup table or array of points with another
                    ///< prop (or a part of one) that uses it in another way. VTK then draws one of
                    ///< them with the shaders, the range or the vertex buffer of the other. If
                    ///< these shaders read what the other does not set, all props are drawn.
  Blended,          ///< Drawn: it blends in the opaque stage, or comes in the renderer's list after
                    ///< a prop that blends there or reads the depth, so that their order shows.
  NumberOfVerdicts
};

/**
 * What the culler did with a frame, or why it did nothing. It tests props against depth only if the
 * value is Culled. After a failure everything is drawn, and the first failure of its kind in a
 * window writes a warning with cause and remedy.
 */
enum class vtkNBufferDecision : int
{
  None,              ///< There was no frame yet.
  Culled,            ///< Props were tested against the depth of this frame.
  Still,             ///< Nothing has changed since the last frame, whose verdicts were used again.
  Frozen,            ///< Freeze is on: the verdicts of the frozen frame were used again.
  NothingHeld,       ///< All candidates in the frustum were visible before; none is held back.
  FewCandidates,     ///< Fewer candidates than MinimumNumberOfCandidates are in the frustum.
  BackedOff,         ///< Recent tests hid next to nothing; there is no test for some frames.
  Disabled,          ///< Enabled is off.
  Selecting,         ///< A hardware selector draws; it numbers the props in their order.
  Shadows,           ///< VTK's shadow maps need the props that the camera does not see.
  RenderPass,        ///< The renderer has a render pass that the culler does not know.
  HiddenLines,       ///< Hidden-line removal draws wireframes of this renderer in its own way.
  Exporting,         ///< A GL2PS capture is active; it draws no depth.
  Delegated,         ///< A vtkRendererDelegate draws in place of this renderer.
  UnsupportedWindow, ///< The window is a VR window, or the renderer's viewport has no pixels.
  OtherCuller,       ///< A culler comes after this one; it would not see what is held back.
  Blending,          ///< The image depends on the order of drawing: props share an object
                     ///< (docs/limits.md says which kinds of vtkNBufferVerdict::SharedMapper do
                     ///< this), normals blend (ambient occlusion over unlit props), or a prop
                     ///< blends among the opaque ones and too few candidates come before it.
  OtherView,         ///< The camera, the viewport or the framebuffer cannot be tested, or is not
                     ///< the one of Cull(); all props were drawn.
  NoContext,         ///< Failure: the window has no OpenGL context.
  OldContext,        ///< Failure: OpenGL is older than 3.2.
  NoFloatTextures,   ///< Failure: the device cannot draw into float textures, and the depth cannot
                     ///< be read in another way.
  NoDepth, ///< Failure: the depth cannot be read without changing the image, or not at all.
  NumberOfDecisions
};

/**
 * Counts and times of one frame of one renderer (and eye).
 */
struct VTKNBUFFER_EXPORT vtkNBufferStatistics
{
  static constexpr int MaximumNumberOfRounds = 8;
  static constexpr int NumberOfVerdicts = int(vtkNBufferVerdict::NumberOfVerdicts);

  vtkNBufferDecision Decision = vtkNBufferDecision::None;

  /// The props that the renderer gave to the culler.
  int Props = 0;
  /// The props of a kind that can be tested, translucent ones included, and those with the verdict
  /// Blended not.
  int Candidates = 0;
  /// The candidates whose boxes were tested against depth.
  int Tested = 0;
  /// The tested opaque candidates that the levels alone did not find hidden in the first round.
  int PassedCoarseTest = 0;
  /// The candidates that Cull() held back, and the translucent ones that this frame's test may
  /// leave out.
  int HeldBack = 0;
  /// The props that were drawn once more to restore the order of equal depths (vtkNBufferTieOrder).
  int Redrawn = 0;
  /// The props that had changed, so that the culler read them again.
  int Refreshed = 0;

  /// The frames of this window so far in which everything was drawn because of a failure.
  int FailedFrames = 0;

  /// The number of props with each verdict, indexed by vtkNBufferVerdict.
  std::array<int, NumberOfVerdicts> Verdicts = {};

  /// The number of rounds, which is the number of tests.
  int Rounds = 0;
  /// The candidates that were not held back ([0]), and those that each draw of props held back drew
  /// ([1], [2], ...). In a view of which nothing is known, draw [1] comes before the first test;
  /// otherwise draw [i] follows test i.
  std::array<int, MaximumNumberOfRounds + 1> DrawnInRound = {};

  /// The candidates that were found hidden by their triangles (vtkNBufferPixelTest) although their
  /// boxes were not, in all rounds.
  int HiddenByTriangles = 0;

  ///@{
  /// The units of the props that are drawn unit by unit (vtkNBufferCuller::SetDivideProps): all,
  /// those outside the frustum, those drawn before the first test, those drawn after it, and those
  /// found hidden.
  int Units = 0;
  int UnitsOutside = 0;
  int UnitsKept = 0;
  int UnitsFresh = 0;
  int UnitsHidden = 0;
  ///@}
  /// How many of the units are in props whose units the graphics device has tested
  /// (vtkNBufferTuning::MinimumNumberOfUnitsOnDevice).
  int UnitsOnDevice = 0;
  /// How many props were drawn a second time, for their fresh units.
  int FreshDraws = 0;

  /// The number of draws of fresh units that write nothing. Each counts the fragments that have the
  /// same depth as an earlier one (vtkNBufferTieQuery). If there are none, nothing is drawn once
  /// more because of these units.
  int TieQueries = 0;

  ///@{
  /// The work on N-buffers in all rounds: the levels built and their texels, the rectangles that
  /// were compared with levels and the texels read for that, the read-backs from OpenGL and their
  /// bytes.
  int Levels = 0;
  long long Texels = 0;
  long long Queries = 0;
  long long Lookups = 0;
  int ReadBacks = 0;
  long long BytesRead = 0;
  ///@}

  /// The props that were found hidden, but drawn because one of their slivers may be seen
  /// (vtkNBufferCuller::SetTestSlivers). A prop may be counted once in each round.
  int Slivers = 0;

  ///@{
  /// The work on the hierarchy over the props (vtkNBufferTuning::HierarchySize): the nodes visited
  /// by the frustum test and by the tests against depth, the changed boxes that were replaced, and
  /// 1 if the hierarchy was built in this frame.
  long long Nodes = 0;
  int Refits = 0;
  int Builds = 0;
  ///@}

  ///@{
  /// Milliseconds of the calling thread in Cull(): the whole, and two parts of it. RefreshTime is
  /// for bringing caches up to date. FrustumTime is for the frustum test and for deciding what to
  /// do with the frame.
  double CullTime = 0.0;
  double RefreshTime = 0.0;
  double FrustumTime = 0.0;
  ///@}

  ///@{
  /// Milliseconds of the calling thread while the frame is drawn: for waiting for and reading the
  /// depth, for building levels, for comparing boxes with levels and with pixels, for testing
  /// slivers, and for drawing what was held back.
  double ReadTime = 0.0;
  double BuildTime = 0.0;
  double TestTime = 0.0;
  double PixelTestTime = 0.0;
  double SliverTestTime = 0.0;
  double DrawTime = 0.0;
  ///@}

  /// Milliseconds of the graphics device for the last reduction of depth in a frame; 0 without
  /// timer queries. They may belong to an earlier frame: the culler never waits for a timer query.
  double DeviceBuildTime = 0.0;

  /// The number of props with a verdict; 0 for a number that is none.
  int GetCount(vtkNBufferVerdict verdict) const
  {
    const auto i = static_cast<std::size_t>(verdict);
    return i < this->Verdicts.size() ? this->Verdicts[i] : 0;
  }

  /// The number of props that were culled.
  int GetNumberOfPropsNotDrawn() const
  {
    return this->GetCount(vtkNBufferVerdict::Outside) + this->GetCount(vtkNBufferVerdict::Hidden);
  }

  /// The number of props that were drawn.
  int GetNumberOfPropsDrawn() const { return this->Props - this->GetNumberOfPropsNotDrawn(); }

  /// A JSON object on one line, with a member for each field above, such as held_back for HeldBack.
  /// The times are in the member milliseconds. Verdicts and the decision are given by name.
  std::string GetAsJSON() const;

  ///@{
  /// The name of an enumerator as in this file; "Invalid" for a number that is none.
  static const char* GetName(vtkNBufferVerdict verdict);
  static const char* GetName(vtkNBufferDecision decision);
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
