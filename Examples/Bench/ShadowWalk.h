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

#include "vtkInformation.h"
#include "vtkSmartPointer.h"
#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

class vtkLight;

namespace NBufferBench
{

struct ShadowWalkOptions
{
  std::vector<std::string> Modes = { "none", "unclamped", "cull", "exact", "auto", "clamp", "slabs",
    "exact@32", "exact@64", "exact@128", "exact@512", "exact@1024", "vtk" };
  /// Only props with these keys cast shadows; nullptr: all props.
  vtkSmartPointer<vtkInformation> CasterKeys;
  /// Whether the first, middle and last frame are compared with rays.
  bool Oracle = false;
  /// Whether the middle frame alone is compared with rays.
  bool OracleOnce = false;
  /// Whether the times of the graphics device are measured, too.
  bool DeviceTimes = false;
  /// Timed frames of a mode in a row.
  int Block = 5;
  /// Folder for the middle frame of each mode; empty: no images.
  std::string ImageFolder;
  /// The debug view (vtkShadowVolumeClampPass::DebugViews) that is drawn over these images.
  int DebugView = 0;
};

/// Returns the part of the report (SCHEMA.md) that is measured. The light is the only one of the
/// session's renderer.
Json::Value RunShadowWalk(Session& session, vtkLight* light,
  const NBufferExamples::CameraPath& path, const ShadowWalkOptions& options);

} // namespace NBufferBench

#endif
