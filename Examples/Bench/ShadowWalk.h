// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowWalk.h
 * @brief Renders the frames of a camera path with several kinds of shadows and times each.
 *
 * Modes take turns in blocks of frames as in Walk.h. Fragments are counted and rays cast
 * afterwards, in frames that are not timed.
 */
#ifndef ShadowWalk_h
#define ShadowWalk_h

#include "CameraPath.h"
#include "Session.h"
#include "Walk.h"

#include "vtkInformation.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkLight;

namespace NBufferBench
{

struct ShadowWalkOptions
{
  std::vector<std::string> Modes = { "none", "unclamped", "cull", "exact",
    "exact:SkipUnlitReceivers=0", "auto", "clamp", "slabs", "exact@32", "exact@64", "exact@128",
    "exact@512", "exact@1024", "vtk" };
  /// Lexels along each side of the litmaps of modes that do not name it.
  int Litmap = 256;
  /// vtkShadowVolumeClampPass::BoxCost of modes that do not name it; less than 0: its default.
  int BoxCost = -1;
  /// Of the modes that ShadowMode names.
  bool SkipUnlitReceivers = false;
  /// Only props with these keys cast; nullptr: all.
  vtkSmartPointer<vtkInformation> CasterKeys;
  /// Compare the first, middle and last frame with rays.
  bool Oracle = false;
  /// The middle one alone.
  bool OracleOnce = false;
  /// Measure the times of the graphics device, too.
  bool DeviceTimes = false;
  /// Timed frames of a mode in a row.
  int Block = 5;
  /// Where to write the middle frame of each mode.
  std::string ImageFolder;
  /// What of vtkShadowVolumeClampPass::DebugViews is laid over these.
  int DebugView = 0;
  std::function<void(const std::string&)> Progress;
};

/// Samples that the light reaches but for shadows, against rays.
struct OracleCounts
{
  long long Samples = 0;
  long long Shadowed = 0;  ///< In shadow by rays.
  long long Wrong = 0;     ///< They differ and are not ambiguous.
  long long Ambiguous = 0; ///< They differ and are ambiguous.
  /// Frame, x and y (from below) of the first wrong ones.
  std::vector<std::array<int, 3>> Places;
};

struct ShadowWalkResult
{
  /// Milliseconds; vtkShadowStatistics as JSON; drawn props are not counted.
  WalkResult Walk;
  /// Of all frames, by mode; only of shadow volumes.
  std::map<std::string, long long> Fragments;
  /// Pixels of all frames that shadows change: what no mode can have fewer fragments than. -1
  /// unless unclamped is among the modes.
  long long Shadowed = -1;
  /// Empty without the oracle, and not of none.
  std::map<std::string, OracleCounts> Oracle;
};

/// The light is the only one of the session's renderer.
ShadowWalkResult RunShadowWalk(Session& session, vtkLight* light,
  const NBufferExamples::CameraPath& path, const ShadowWalkOptions& options);

} // namespace NBufferBench

#endif
