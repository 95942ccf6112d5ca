// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudySettings.h
 * @brief What each setting of the culler and of the shadow pass costs and gains in whole frames:
 * one is varied at a time, the others have their defaults, all take turns in one run.
 *
 *     renderer, vtk, size, effort, seconds
 *     culler[]   scene, path, size, frames, stock_ms, wrong_bytes, points[]
 *     still[]    the same, the camera standing still, only the settings that tell then; no
 *                kept_percent
 *     few[]      scene, path, entries[]: props in view, the nearest ones and no others; drawn by
 *                the culler; stock_ms; wrong_bytes; points[] as below, without setting and value,
 *                rounds and kept_percent
 *     shadows[]  scene, path, size, frames, none_ms, unclamped_ms, shadowed_percent, points[]
 *     again_ratio    of culler, still and shadows: of the default, drawn once more under another
 *                    name, to itself
 *     points[]   mode (see ModeSettings.h) and kind, that mode without settings; setting and value;
 *                is_default; ms: median, p10 and p90; ratio: median over the frames to the kind, in
 *                few[] to stock; of the culler drawn and rounds, each median, and kept_percent: of
 *                the hidden props those drawn, in every fifth frame; of shadows fragments_percent
 *                of those of whole volumes
 */
#ifndef StudySettings_h
#define StudySettings_h

#include "CameraPath.h"
#include "Command.h"
#include "Session.h"
#include "StudyShadows.h"

#include "vtk_jsoncpp.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

using Progress = std::function<void(const std::string&)>;

/// All settings of the culler; `onlyRest`: those alone that tell where culling gains little.
Json::Value MeasureCullerSettings(Session& session, const NBufferExamples::CameraPath& path,
  bool onlyRest, const Progress& progress);

/// As if the camera stood still for five frames at every fifth pose.
Json::Value MeasureStill(
  Session& session, const NBufferExamples::CameraPath& path, const Progress& progress);

/// An entry for each number of props in view, ascending.
Json::Value MeasureFewProps(Session& session, const NBufferExamples::CameraPath& path,
  const std::vector<std::size_t>& numbers, const Progress& progress);

struct SettingsEffort
{
  int Frames; ///< Of whole frames, a multiple of five.
  /// Of the city.
  std::vector<std::string> Paths;
  std::vector<std::size_t> FewProps;
  bool Plant;
  std::vector<std::string> ShadowScenes;
  ShadowEffort Shadows;
};

/// Of the city, whose session it is, the synthetic plant and scenes with shadows.
Json::Value MeasureSettings(const NBufferExamples::Scene& city, Session& session,
  const ViewOptions& view, const SettingsEffort& effort, const Progress& progress);

/// Settings of the shadow pass on a scene of ShadowScene.h.
Json::Value MeasureShadowSettings(const std::string& scene, const ViewOptions& view,
  const ShadowEffort& effort, const Progress& progress);

} // namespace NBufferBench

#endif
