// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferStatistics.h
 * @brief What happened to every prop of a frame, and what finding it out cost.
 *
 * One struct feeds the getters of vtkNBufferCuller, PrintSelf, JSON, overlays and tests. Every
 * prop that the culler was given has exactly one verdict, so that in every frame
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
 * Why a prop was drawn or not. The first group was culled, the second tested and drawn, the third
 * drawn without a test because the test could not be trusted for it.
 */
enum class vtkNBufferVerdict : int
{
  Unknown,          ///< Not in the last frame: invisible, another renderer, or never culled.
  Outside,          ///< Not drawn: its box lies outside the view frustum.
  Hidden,           ///< Not drawn: its box lies behind what is drawn (translucent props too).
  Visible,          ///< Drawn: its box may be seen.
  NearPlane,        ///< Drawn: its box reaches the near plane or the eye point.
  Untested,         ///< Drawn: a candidate in a frame without a test (see vtkNBufferDecision).
  NotAPlainActor,   ///< Drawn: no vtkOpenGLActor itself (subclass, volume, assembly, 2D, custom).
  NotAPlainMapper,  ///< Drawn: mapper of another class, whose bounds may be too small, or none.
  Translucent,      ///< Drawn: may be seen and has translucent geometry; it hides nothing.
  NotASurface,      ///< Drawn: lines, wireframe, all as points, visible edges or vertices, spheres.
  DepthOffset,      ///< Drawn: coincident-topology parameters pull its depth towards the eye.
  ShaderReplaced,   ///< Drawn: the application replaces its shader code.
  OtherCoordinates, ///< Drawn: its coordinate system is not the world.
  NoBounds,         ///< Drawn: null, uninitialised, infinite or NaN bounds.
  NumberOfVerdicts
};

/**
 * What the culler did with a frame, or why it did nothing. Values above Culled test nothing. After
 * a failure everything is drawn, and the first one of its kind in a window is a warning with cause
 * and remedy.
 */
enum class vtkNBufferDecision : int
{
  None,              ///< No frame yet.
  Culled,            ///< Tested against this frame's depth.
  Still,             ///< Camera, window and props are as in the last frame: its verdicts stand.
  Frozen,            ///< Freeze is on: the verdicts of the frozen frame stand.
  NothingHeld,       ///< No candidate could be held back: all in the frustum were visible already.
  FewCandidates,     ///< Fewer candidates in the frustum than MinimumNumberOfCandidates.
  BackedOff,         ///< Recent tests hid next to nothing; the next one is a probe some frames on.
  Disabled,          ///< Enabled is off.
  Selecting,         ///< A hardware selector indexes the props.
  Shadows,           ///< VTK's shadow maps need the props that the camera does not see.
  RenderPass,        ///< A render pass that the culler does not know.
  HiddenLines,       ///< Hidden-line removal draws wireframes by itself.
  Exporting,         ///< A GL2PS capture draws no depth.
  Delegated,         ///< A delegate draws this renderer.
  UnsupportedWindow, ///< A VR window, or one without a size.
  OtherCuller,       ///< A culler behind this one, which would not see what is held back.
  Blending,          ///< A prop blends in the opaque stage, where order then shows.
  OtherView,         ///< Framebuffer, camera or viewport were not those of Cull(): all drawn.
  NoContext,         ///< Failure: no OpenGL window, or one without a context.
  OldContext,        ///< Failure: OpenGL older than 3.2.
  NoFloatTextures,   ///< Failure: levels cannot be built on the device, nor the depth be read.
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

  ///@{
  /// Props that the culler was given, and of these: candidates for the test (translucent ones
  /// too), those whose boxes were tested against depth, those of them that the levels did not find
  /// hidden in the first round, those held back until the test, draws once more for the order
  /// of equal depths (see vtkNBufferTieOrder.h), and the caches refreshed because something
  /// changed.
  int Props = 0;
  int Candidates = 0;
  int Tested = 0;
  int PassedCoarseTest = 0;
  int HeldBack = 0;
  int Redrawn = 0;
  int Refreshed = 0;
  ///@}

  /// Frames of this window so far that were drawn whole because of a failure.
  int FailedFrames = 0;

  /// Props by verdict, indexed by vtkNBufferVerdict.
  std::array<int, NumberOfVerdicts> Verdicts = {};

  ///@{
  /// Rounds of test and draw, and the candidates drawn before the first test ([0]) and after each
  /// ([1], [2], ...).
  int Rounds = 0;
  std::array<int, MaximumNumberOfRounds + 1> DrawnInRound = {};
  ///@}

  ///@{
  /// N-buffer work of all rounds: levels and texels built, rectangles asked, texels looked up,
  /// read-backs from the graphics context and their bytes.
  int Levels = 0;
  long long Texels = 0;
  long long Queries = 0;
  long long Lookups = 0;
  int ReadBacks = 0;
  long long BytesRead = 0;
  ///@}

  /// Props whose boxes were found hidden and which were drawn for slivers that may be seen (see
  /// vtkNBufferCuller::SetTestSlivers); a prop may be counted once in each round.
  int Slivers = 0;

  ///@{
  /// Work of the hierarchy over the props (vtkNBufferCuller::SetHierarchySize): nodes looked at for
  /// the view and for the test, boxes that it was refit to because they had changed, and whether it
  /// was built.
  long long Nodes = 0;
  int Refits = 0;
  int Builds = 0;
  ///@}

  ///@{
  /// Milliseconds of the calling thread: Cull() as a whole and of it bringing caches up to date
  /// (with the frustum test where the camera has moved) and deciding (with the frustum test
  /// elsewhere); then waiting for and reading the depth, building levels, testing boxes, pixels and
  /// slivers, and drawing what had been held back. On the graphics device: building levels (OpenGL
  /// back-end; of an earlier frame, because a timer query is never waited for).
  double CullTime = 0.0;
  double RefreshTime = 0.0;
  double FrustumTime = 0.0;
  double ReadTime = 0.0;
  double BuildTime = 0.0;
  double TestTime = 0.0;
  double PixelTestTime = 0.0;
  double SliverTestTime = 0.0;
  double DrawTime = 0.0;
  double DeviceBuildTime = 0.0;
  ///@}

  int GetCount(vtkNBufferVerdict verdict) const
  {
    return this->Verdicts[static_cast<std::size_t>(verdict)];
  }
  int GetNumberOfPropsNotDrawn() const
  {
    return this->GetCount(vtkNBufferVerdict::Outside) + this->GetCount(vtkNBufferVerdict::Hidden);
  }
  int GetNumberOfPropsDrawn() const { return this->Props - this->GetNumberOfPropsNotDrawn(); }

  /// One JSON object with a member per field, verdicts and decision by name.
  std::string GetAsJSON() const;

  static const char* GetName(vtkNBufferVerdict verdict);
  static const char* GetName(vtkNBufferDecision decision);
};

VTK_ABI_NAMESPACE_END
#endif
