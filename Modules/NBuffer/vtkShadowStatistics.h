// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowStatistics.h
 * @brief How much work and time the shadows of a frame took: casters by verdict, volumes,
 * fragments, milliseconds.
 *
 * The getters of vtkShadowVolumeClampPass, PrintSelf, JSON and tests all read one struct. For each
 * light that casts shadows, a caster has one verdict, or several if it is drawn in several parts.
 * So the verdicts of one light add up to Casters or more.
 */
#ifndef vtkShadowStatistics_h
#define vtkShadowStatistics_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Which part of the shadow volumes is drawn: see vtkShadowVolumeClampPass::SetMode().
enum class vtkShadowMode : int
{
  Unclamped,
  Culled,
  Scissored,
  Clamped,
  Automatic
};

/// What is drawn over the picture: see vtkShadowVolumeClampPass::SetDebugView().
enum class vtkShadowPicture : int
{
  None,
  Litmaps,
  Extents,
  Volumes,
  Counts
};

/// The parts of a frame whose time on the graphics device is measured.
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

/// How the shadow of a caster was drawn for a light, or why there was none to draw.
enum class vtkShadowVerdict : int
{
  Whole,             ///< Drawn whole: the mode is Unclamped, or no litmap was worth its cost.
  Boxed,             ///< Drawn whole, but only inside boxes of pixels around its receivers. In mode
                     ///< Culled, and where the device also draws outside of scissor boxes, it is
                     ///< drawn in the whole viewport.
  Clamped,           ///< Drawn in slabs, inside such boxes.
  ThroughLightPlane, ///< As Boxed: the caster reaches to or behind the light's plane s = 0.
  NoReceiver,        ///< Not drawn: the camera sees nothing on the light rays through the caster.
  BeforeCaster,      ///< Not drawn: what the camera sees on these rays is nearer to the light.
  BehindLight,       ///< Not drawn: the caster is behind a spot light, which shines away from it.
  OutsideCone,       ///< Not drawn: the caster is outside of the cone of a spot light.
  Empty,             ///< Not drawn: the caster has no triangle that can cast a shadow.
  NumberOfVerdicts
};

/// Why a prop of the renderer casts no shadow.
enum class vtkShadowSkip : int
{
  NotAnActor,      ///< It is a volume, a billboard or a prop of a class of the application.
  NotASurface,     ///< It is drawn as wireframe or points, or it is a skybox.
  Translucent,     ///< It is translucent, or a block of it is.
  NotAPlainMapper, ///< The triangles that its mapper draws cannot be known (splats, for instance).
  NumberOfSkips
};
constexpr int NumberOfShadowSkips = int(vtkShadowSkip::NumberOfSkips);

/// What the pass did with a frame, or why it drew no shadow.
enum class vtkShadowDecision : int
{
  None,       ///< There was no frame yet.
  Drawn,      ///< The frame was drawn with shadows.
  Still,      ///< Nothing has changed: the shadows of the last frame were used again.
  NoLight,    ///< No light that is switched on can cast shadows.
  NoCaster,   ///< No prop can cast a shadow.
  NoReceiver, ///< No caster has a receiver; the frame was drawn as without the pass.
  Failed,     ///< The shadows could not be drawn, or the application aborted the frame
              ///< (vtkRenderWindow::SetAbortRender()); it was drawn as without the pass.
  NumberOfDecisions
};

/**
 * The estimated and the measured times of the shadows of one light, in milliseconds. Litmaps are
 * assumed to save two thirds of the time of whole volumes. So mode Automatic makes litmaps if
 * LitmapEstimate is less than two thirds of WholeEstimate (vtkShadowCostModel.h). Both estimates
 * are -1 in other modes.
 */
struct vtkShadowLightCost
{
  /// True if the light was drawn with litmaps.
  bool HasLitmaps = false;
  /// The estimate for drawing its whole volumes, or only for their triangles without the fragments
  /// if this number already shows that litmaps are worth their cost.
  double WholeEstimate = -1.0;
  /// The estimate for making its litmaps.
  double LitmapEstimate = -1.0;
  /// The time of the calling thread for this light in this frame. The device may take longer.
  double Time = 0.0;
};

/**
 * Counts and times of one frame of one renderer (and eye).
 */
struct VTKNBUFFER_EXPORT vtkShadowStatistics
{
  static constexpr int NumberOfVerdicts = int(vtkShadowVerdict::NumberOfVerdicts);

  vtkShadowDecision Decision = vtkShadowDecision::None;

  /// The lights that cast shadows.
  int Lights = 0;
  /// The meshes that can cast a shadow; each block and each instance of a glyph is one.
  int Casters = 0;
  /// The number of actors, blocks and other props that cannot cast, by reason.
  std::array<int, NumberOfShadowSkips> Skipped = {};
  /// The number of casters with each verdict, summed over the lights.
  std::array<int, NumberOfVerdicts> Verdicts = {};
  /// The number of casters whose mesh, matrix or clipping planes had changed.
  int Updates = 0;
  /// The silhouettes that were computed in this frame.
  int Silhouettes = 0;
  /// The pieces of shadow volumes that were made in this frame. Whole volumes are kept until the
  /// caster or the light changes, except those of positional lights for parallel cameras; slabs are
  /// made anew.
  int Pieces = 0;
  /// The pieces of shadow volumes that were drawn: whole volumes, or slabs of them.
  int Draws = 0;
  /// Those of Draws that were counted by z-pass.
  int ZPass = 0;
  /// The boxes of pixels that volumes were drawn into: one or more for each of the Draws.
  int Boxes = 0;
  /// How often the stencil was cleared: once for each light with volumes, and more often where a
  /// receiver might be in more volumes than a stencil can count.
  int StencilClears = 0;
  /// The slabs that volumes were cut into.
  int Slabs = 0;
  /// The triangles of the volumes that were drawn.
  long long Triangles = 0;
  /// The samples that were scattered into litmaps, summed over the lights.
  long long Receivers = 0;
  /// The fragments of the volumes, whether or not they passed the depth test; with multisampling,
  /// the samples of these fragments. -1 unless vtkShadowTuning::CountFragments is set.
  long long Fragments = -1;
  /// The litmaps that were made in this frame.
  int Litmaps = 0;
  /// The lights that were drawn without litmaps in this frame.
  int UnclampedLights = 0;
  /// The costs of each light that casts shadows, in the order of these lights. They say why a light
  /// was drawn with or without litmaps.
  std::vector<vtkShadowLightCost> LightCosts;
  /// The read-backs of depth from OpenGL. The measurement of MeasureTime makes three more.
  int ReadBacks = 0;
  /// The number of frames so far with the decision Failed.
  int FailedFrames = 0;
  /// How often something was drawn for a debug view: once for all volumes (Volumes and Counts), and
  /// once for the image.
  int DebugDraws = 0;
  /// The number of samples in each pixel of the masks.
  int Samples = 1;
  /// The frames so far whose masks have one sample in each pixel, although the window has more,
  /// because the device refused masks with more.
  int PixelFrames = 0;

  ///@{
  /// Milliseconds of the calling thread for finding the casters, for drawing the depth of
  /// receivers, for reading this depth, for making litmaps, for computing silhouettes, plans and
  /// volumes, and for drawing the volumes.
  double CasterTime = 0.0;
  double DepthTime = 0.0;
  double ReadTime = 0.0;
  double LitmapTime = 0.0;
  double PlanTime = 0.0;
  double DrawTime = 0.0;
  ///@}

  /// Milliseconds for measuring the costs of the mode Automatic on the device, which are a part of
  /// PlanTime. They are 0 in all frames except for one of each pass and context.
  double MeasureTime = 0.0;

  /// Milliseconds of the graphics device for each stage. They belong to the last frame whose times
  /// have arrived, because the pass never waits for a timer (vtkShadowTimers.h). All are -1 until
  /// there is such a frame, and always if vtkShadowTuning::MeasureDeviceTime is off or the driver
  /// has no timers.
  vtkShadowStageTimes DeviceTimes = UnknownShadowStageTimes;

  /// The milliseconds of the graphics device for one stage; -1 for a number that is none.
  double GetDeviceTime(vtkShadowStage stage) const
  {
    const auto i = static_cast<std::size_t>(stage);
    return i < this->DeviceTimes.size() ? this->DeviceTimes[i] : -1.0;
  }

  /// The number of casters with a verdict, summed over the lights; 0 for a number that is none.
  int GetCount(vtkShadowVerdict verdict) const
  {
    const auto i = static_cast<std::size_t>(verdict);
    return i < this->Verdicts.size() ? this->Verdicts[i] : 0;
  }

  /// A JSON object on one line, with a member for each field above. Verdicts and the decision are
  /// given by name.
  std::string GetAsJSON() const;

  ///@{
  /// The name of an enumerator as in this file (in small letters for a stage); "Invalid" for a
  /// number that is none.
  static const char* GetName(vtkShadowVerdict verdict);
  static const char* GetName(vtkShadowSkip reason);
  static const char* GetName(vtkShadowDecision decision);
  static const char* GetName(vtkShadowStage stage);
  ///@}
};

VTK_ABI_NAMESPACE_END
#endif
