// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowStatistics.h
 * @brief What shadows of a frame took: casters by verdict, volumes, fragments, times.
 *
 * One struct feeds the getters of vtkShadowVolumeClampPass, PrintSelf, JSON and tests. Every caster
 * has one verdict for each casting light: for each light they add up to Casters (to more where a
 * caster is drawn in several parts).
 */
#ifndef vtkShadowStatistics_h
#define vtkShadowStatistics_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

/// Which part of shadow volumes is drawn.
enum class vtkShadowMode : int
{
  Unclamped, ///< All of every caster's, everywhere: the reference for what others save.
  Culled,    ///< Of casters with receivers, everywhere.
  Scissored, ///< Of casters with receivers, into the receivers' boxes on the screen.
  Clamped,   ///< Of these, where the receivers are.
  Automatic  ///< Scissored for lights whose litmaps pay (vtkShadowCostModel.h), Unclamped for
             ///< others.
};

/// What is drawn over the picture to show why shadows take what they take.
enum class vtkShadowPicture : int
{
  None,
  Litmaps, ///< Nearest and farthest depth and occupancy of each lexel.
  Extents, ///< The boxes of pixels into which volumes are drawn.
  Volumes, ///< The edges of the volumes' triangles.
  Counts   ///< How many fragments volumes have in each pixel.
};

/// What the graphics device is timed for.
enum class vtkShadowStage : int
{
  Depth, ///< Drawing the receivers' depth.
  Draw,  ///< Counting volumes and making masks.
  Color, ///< Drawing the opaque props with their shadows.
  NumberOfStages
};
constexpr int NumberOfShadowStages = int(vtkShadowStage::NumberOfStages);
using vtkShadowStageTimes = std::array<double, NumberOfShadowStages>;
constexpr vtkShadowStageTimes UnknownShadowStageTimes = { -1.0, -1.0, -1.0 };

/// What became of a caster for a light.
enum class vtkShadowVerdict : int
{
  Whole,             ///< Drawn whole: Unclamped, or no litmap was worth it.
  Boxed,             ///< Drawn whole, into its receivers' boxes of pixels.
  Clamped,           ///< Drawn in slabs, into such boxes.
  ThroughLightPlane, ///< Drawn whole: it reaches to the light's plane or behind it.
  NoReceiver,        ///< Not drawn: the camera sees nothing on its rays.
  BeforeCaster,      ///< Not drawn: all that the camera sees there is nearer to the light.
  BehindLight,       ///< Not drawn: the light looks away from it.
  OutsideCone,       ///< Not drawn: no ray of the spot meets it.
  Empty,             ///< Not drawn: no triangle counts.
  NumberOfVerdicts
};

/// Why an actor of the renderer does not cast.
enum class vtkShadowSkip : int
{
  NotAnActor,      ///< Volumes, billboards, props of the application's own.
  NotASurface,     ///< Wireframes and points.
  Translucent,     ///< It, or the block of it.
  NotAPlainMapper, ///< No polydata to be had: glyphs, data sets.
  NumberOfSkips
};
constexpr int NumberOfShadowSkips = int(vtkShadowSkip::NumberOfSkips);

/// What was done with a frame, or why no shadow was due.
enum class vtkShadowDecision : int
{
  None,       ///< No frame yet.
  Drawn,      ///< With shadows.
  Still,      ///< With the shadows of the last frame: nothing has changed.
  NoLight,    ///< No light that is switched on can cast.
  NoCaster,   ///< No prop can cast.
  NoReceiver, ///< No caster has a receiver: drawn as without the pass.
  Failed,     ///< OpenGL refused something: drawn as without the pass.
  NumberOfDecisions
};

struct VTKNBUFFER_EXPORT vtkShadowStatistics
{
  static constexpr int NumberOfVerdicts = int(vtkShadowVerdict::NumberOfVerdicts);

  vtkShadowDecision Decision = vtkShadowDecision::None;
  int Lights = 0;                                    ///< That cast.
  int Casters = 0;                                   ///< Meshes that can cast.
  std::array<int, NumberOfShadowSkips> Skipped = {}; ///< Actors that cannot, by reason.
  std::array<int, NumberOfVerdicts> Verdicts = {};   ///< Casters, for each light.
  int Updates = 0;                                   ///< Casters whose mesh or matrix changed.
  int Silhouettes = 0;                               ///< Made in this frame.
  int Draws = 0;                                     ///< Of volumes.
  int ZPass = 0; ///< Of these, counted between eye and receiver.
  int Boxes = 0; ///< Of pixels that volumes were drawn into: one or more for each of the Draws.
  /// Times that counting began anew: once for each light with volumes, more often where a receiver
  /// might be in more of them than a stencil can count.
  int StencilClears = 0;
  int Slabs = 0;
  long long Triangles = 0; ///< Of volumes.
  long long Receivers = 0; ///< Samples scattered into litmaps (or lexels drawn), of all lights.
  /// Fragments that volumes covered, samples of them with multisampling, whatever the depth test
  /// said; -1 unless they are counted.
  long long Fragments = -1;
  int Litmaps = 0;         ///< Made in this frame.
  int UnclampedLights = 0; ///< Drawn without litmaps in this frame.
  int ReadBacks = 0;       ///< Of depth.
  int FailedFrames = 0;
  int DebugDraws = 0;  ///< Of debug views.
  int Samples = 1;     ///< Of each pixel of the masks.
  int PixelFrames = 0; ///< With one for each pixel, the device having refused those of the window.

  ///@{
  /// Milliseconds of the calling thread: collecting casters and silhouettes, drawing receivers'
  /// depth, reading it, making litmaps, deciding and making volumes, and drawing them.
  double CasterTime = 0.0;
  double DepthTime = 0.0;
  double ReadTime = 0.0;
  double LitmapTime = 0.0;
  double PlanTime = 0.0;
  double DrawTime = 0.0;
  ///@}

  /// Milliseconds of the graphics device by stage, of the last frame that is known (timers are
  /// never waited for; see vtkShadowTimers.h); -1 unless they are measured, and where the driver
  /// has no timers.
  vtkShadowStageTimes DeviceTimes = UnknownShadowStageTimes;

  double GetDeviceTime(vtkShadowStage stage) const
  {
    return this->DeviceTimes[static_cast<std::size_t>(stage)];
  }

  int GetCount(vtkShadowVerdict verdict) const
  {
    return this->Verdicts[static_cast<std::size_t>(verdict)];
  }

  /// One JSON object with a member per field, verdicts and decision by name.
  std::string GetAsJSON() const;

  static const char* GetName(vtkShadowVerdict verdict);
  static const char* GetName(vtkShadowSkip reason);
  static const char* GetName(vtkShadowDecision decision);
  static const char* GetName(vtkShadowStage stage);
};

VTK_ABI_NAMESPACE_END
#endif
