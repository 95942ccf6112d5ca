// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FirstFrames.h
 * @brief What the first frames of a scene cost, while vtkNBufferCuller does not know it yet.
 *
 * Every run loads the scene again and shows it in a new window, so that nothing is on the device
 * and nothing is known. The first frame includes all uploads and shaders, but not the context. Runs
 * of all modes take turns.
 */
#ifndef FirstFrames_h
#define FirstFrames_h

#include "CameraPath.h"
#include "Scene.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace NBufferBench
{

struct FirstFramesOptions
{
  std::function<NBufferExamples::Scene()> LoadScene; ///< Is called for each run.
  NBufferExamples::CameraPath Path;                  ///< At least 12 frames.
  SessionOptions Window;
  std::vector<std::string> Modes; ///< stock is measured in any case.
  std::string Backend = "auto";   ///< The back-end of the mode nbuffer, as for Mode.
  int Runs = 5;                   ///< Of each mode.
};

/**
 * Returns the part of the report (SCHEMA.md) that is measured. For each mode and run it compares
 * the frames with those of a run of stock that was made next to it, by ratios of times (stock /
 * mode), and summarizes these over all runs.
 */
Json::Value RunFirstFrames(const FirstFramesOptions& options);

/// Prints the ratios of a report as a table.
void PrintFirstFrames(const Json::Value& report, std::ostream& out);

} // namespace NBufferBench

#endif
