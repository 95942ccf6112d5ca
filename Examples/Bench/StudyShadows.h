// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyShadows.h
 * @brief What accuracy costs in time for shadows: modes and resolutions of litmaps on the scenes
 * of ShadowScene.h.
 *
 *     scene, path, size, frames, none_ms, shadowed_percent: pixels that shadows change, of the
 *     fragments of whole volumes: no mode can have less
 *     points[]   name and litmap; ms of a frame, median, p10 and p90; fragments of a frame, and in
 *                percent of those of whole volumes, -1 for shadow maps; samples compared with rays,
 *                wrong: those that differ and are not ambiguous, also in percent; ambiguous: those
 *                that differ and are; must_be_exact: a wrong one is an error of this module;
 *                pareto: nothing is faster and has fewer fragments, none wrong; is_default
 */
#ifndef StudyShadows_h
#define StudyShadows_h

#include "Command.h"
#include "ShadowWalk.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

const std::vector<std::string>& GetShadowSceneNames();

struct ShadowEffort
{
  int Frames;
  ///@{
  /// Of the image at most: a ray is cast for every pixel.
  int Width;
  int Height;
  ///@}
  /// Lexels along a side of the litmaps that are tried.
  std::vector<int> Litmaps;
};

/// A walk with vtkNBufferCuller, ground and streets only receiving shadows. `report` gets scene,
/// path, size and frames.
ShadowWalkResult WalkShadows(const std::string& scene, const ViewOptions& view,
  const ShadowEffort& effort, ShadowWalkOptions& options,
  const std::function<void(const std::string&)>& progress, Json::Value& report);

/// All modes of a scene, with vtkNBufferCuller, ground and streets only receiving shadows.
Json::Value MeasureShadows(const std::string& scene, const ViewOptions& view,
  const ShadowEffort& effort, const std::function<void(const std::string&)>& progress);

/// `folder`/shadows-SCENE and `folder`/shadow-errors-SCENE, .png and .svg.
void WriteShadowCharts(const Json::Value& scene, const std::string& folder);

/// Wrong samples of points that must be exact.
long long GetWrongSamples(const Json::Value& scene);

/// Every point of every scene, one a line. Throws std::runtime_error when it cannot be written.
void WriteShadowCSV(const Json::Value& scenes, const std::string& fileName);

} // namespace NBufferBench

#endif
