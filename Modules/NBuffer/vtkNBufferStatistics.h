// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferStatistics.h
 * @brief What the culler did with every prop of a frame, and what that cost.
 *
 * One struct feeds the getters of vtkNBufferCuller, PrintSelf, JSON, overlays and tests. Every prop
 * that the renderer gave to the culler has exactly one verdict, so that in every frame
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
 * Visible and NearPlane were tested and drawn. All others were drawn without a test; those from
 * NotAPlainActor on can never be tested, because what they draw may differ from what their box
 * says.
 */
enum class vtkNBufferVerdict : int
{
  Unknown,          ///< The last frame did not contain it: it is invisible or in another renderer.
  Outside,          ///< Not drawn: its box lies outside the view frustum.
  Hidden,           ///< Not drawn: its box lies behind what is drawn (translucent props too).
  Visible,          ///< Drawn: its box may be seen.
  NearPlane,        ///< Drawn: its box reaches the near plane or the eye point.
  Untested,         ///< Drawn: the frame was not tested (vtkNBufferDecision says why).
  NotAPlainActor,   ///< Drawn: not exactly a vtkOpenGLActor (subclass, volume, assembly, 2D, ...).
  NotAPlainMapper,  ///< Drawn: it has no mapper, or one of a class whose bounds may be too small.
  Translucent,      ///< Drawn: it may be seen and has translucent geometry, which hides nothing.
  NotASurface,      ///< Drawn: it draws lines, points, edges, vertices or spheres.
  DepthOffset,      ///< Drawn: coincident-topology parameters pull its depth towards the eye.
  ShaderReplaced,   ///< Drawn: the application replaces its shader code.
  OtherCoordinates, ///< Drawn: its coordinates are not world coordinates.
  NoBounds,         ///< Drawn: its bounds are null, uninitialised, infinite or NaN.
  SharedMapper,     ///< Drawn: its mapper, lookup table or array of points belongs to another prop
                    ///< as well, or to a part of one, which uses it in another way. VTK keeps the
                    ///< shaders, the range or the buffer of one of them for the other.
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
  NothingHeld,       ///< All candidates in the frustum were visible before: none to hold back.
  FewCandidates,     ///< Fewer candidates than MinimumNumberOfCandidates are in the frustum.
  BackedOff,         ///< Recent tests hid next to nothing; there is no test for some frames.
  Disabled,          ///< Enabled is off.
  Selecting,         ///< A hardware selector draws, which numbers the props in their order.
  Shadows,           ///< VTK's shadow maps need the props that the camera does not see.
  RenderPass,        ///< The renderer has a render pass that the culler does not know.
  HiddenLines,       ///< Hidden-line removal is on, which draws wireframes in its own way.
  Exporting,         ///< A GL2PS capture goes on, which draws no depth.
  Delegated,         ///< A delegate draws this renderer.
  UnsupportedWindow, ///< The window is a VR window or has no size.
  OtherCuller,       ///< A culler comes after this one; it would not see what is held back.
  Blending,          ///< The order of drawing can be seen: a prop blends among the opaque ones, or
                     ///< shares what is described at vtkNBufferVerdict::SharedMapper.
  OtherView,         ///< Camera, viewport or framebuffer were not those of Cull(): all was drawn.
  NoContext,         ///< Failure: the window has no OpenGL context.
  OldContext,        ///< Failure: OpenGL is older than 3.2.
  NoFloatTextures,   ///< Failure: the device cannot draw into float textures, nor is there another
                     ///< way.
  NoDepth,           ///< Failure: the depth cannot be read.
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
  /// The props of a kind that can be tested, translucent ones included.
  int Candidates = 0;
  /// The candidates whose boxes were tested against depth.
  int Tested = 0;
  /// The tested candidates that the levels did not find hidden in the first round.
  int PassedCoarseTest = 0;
  /// The candidates that were not drawn before the first test.
  int HeldBack = 0;
  /// The props drawn once more for the order of equal depths (vtkNBufferTieOrder).
  int Redrawn = 0;
  /// The props whose cached box was computed anew because something had changed.
  int Refreshed = 0;

  /// The frames of this window so far in which everything was drawn because of a failure.
  int FailedFrames = 0;

  /// The number of props with each verdict, indexed by vtkNBufferVerdict.
  std::array<int, NumberOfVerdicts> Verdicts = {};

  /// The rounds of test and draw.
  int Rounds = 0;
  /// The candidates drawn before the first test ([0]) and after each test ([1], [2], ...).
  std::array<int, MaximumNumberOfRounds + 1> DrawnInRound = {};

  /// The candidates that were found hidden by their triangles alone (vtkNBufferPixelTest), in all
  /// rounds. Their boxes are not hidden.
  int HiddenByTriangles = 0;

  ///@{
  /// The work on N-buffers in all rounds: levels built and their texels, rectangles that were
  /// compared with them, texels read for that, and read-backs from OpenGL with their bytes.
  int Levels = 0;
  long long Texels = 0;
  long long Queries = 0;
  long long Lookups = 0;
  int ReadBacks = 0;
  long long BytesRead = 0;
  ///@}

  /// The props whose boxes were found hidden and which were drawn because a sliver of theirs may be
  /// seen (vtkNBufferCuller::SetTestSlivers). A prop may be counted once in each round.
  int Slivers = 0;

  ///@{
  /// The work on the hierarchy over the props (vtkNBufferTuning::HierarchySize): nodes visited for
  /// the frustum and for the test, boxes replaced because they had changed, and 1 if the hierarchy
  /// was built in this frame.
  long long Nodes = 0;
  int Refits = 0;
  int Builds = 0;
  ///@}

  ///@{
  /// Milliseconds of the calling thread in Cull(): as a whole, and two parts of it. The first part
  /// is bringing caches up to date, with the frustum test where the camera has moved; the second is
  /// deciding what to do, with the frustum test in other frames.
  double CullTime = 0.0;
  double RefreshTime = 0.0;
  double FrustumTime = 0.0;
  ///@}

  ///@{
  /// Milliseconds of the calling thread while the frame is drawn: waiting for and reading the
  /// depth, building levels, testing boxes, pixels and slivers, and drawing what was held back.
  double ReadTime = 0.0;
  double BuildTime = 0.0;
  double TestTime = 0.0;
  double PixelTestTime = 0.0;
  double SliverTestTime = 0.0;
  double DrawTime = 0.0;
  ///@}

  /// Milliseconds of the graphics device for building levels with the OpenGL back-end. They belong
  /// to an earlier frame, because the culler never waits for a timer query.
  double DeviceBuildTime = 0.0;

  /// The number of props with a verdict.
  int GetCount(vtkNBufferVerdict verdict) const
  {
    return this->Verdicts[static_cast<std::size_t>(verdict)];
  }

  /// The number of props that were culled.
  int GetNumberOfPropsNotDrawn() const
  {
    return this->GetCount(vtkNBufferVerdict::Outside) + this->GetCount(vtkNBufferVerdict::Hidden);
  }

  /// The number of props that were drawn.
  int GetNumberOfPropsDrawn() const { return this->Props - this->GetNumberOfPropsNotDrawn(); }

  /// A JSON object on one line, with a member for each field above. Verdicts and the decision are
  /// given by name.
  std::string GetAsJSON() const;

  ///@{
  /// The name of an enumerator as in this file; "Invalid" for a number that is none.
  static const char* GetName(vtkNBufferVerdict verdict);
  static const char* GetName(vtkNBufferDecision decision);
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
