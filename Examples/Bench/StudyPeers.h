// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyPeers.h
 * @brief Whole frames by other means: stock VTK, no culler, the oracle, and last frame's verdicts.
 *
 *     frames    modes (as Report.h, with queries of the hardware) and ratios, wrong_bytes: of all
 *               modes but oracle, skipped.MODE: why it cannot run here; draw_us: what a prop more
 *               costs, from the times of modes none and oracle and the props that they draw
 *     latent[]  step: poses of the path from the frame that is tested to the one that is drawn by
 *               its verdicts; frames; popping_frames: with wrong pixels; missing_props and
 *               wrong_pixels: of all frames, most_wrong_pixels: of one; hidden_share_percent:
 *               hidden props that are left out
 */
#ifndef StudyPeers_h
#define StudyPeers_h

#include "CameraPath.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <functional>
#include <string>
#include <vector>

namespace NBufferBench
{

/// Modes of whole frames that the study compares, in the order of its tables.
const std::vector<std::string>& GetPeerNames();

/// Those that the current context can run.
std::vector<std::string> GetPeersThatRun();

/// `modes`: stock, nbuffer, oracle, and of the others those that can run.
Json::Value MeasureFrames(Session& session, const NBufferExamples::CameraPath& path,
  const std::vector<std::string>& modes, const std::function<void(const std::string&)>& progress);

/// Picks `pairs` pairs of poses along the path. The worst frame goes to `fileName`, wrong pixels in
/// red; no picture if there are none.
Json::Value MeasureLatent(Session& session, const NBufferExamples::CameraPath& path, int step,
  int pairs, const std::string& fileName);

} // namespace NBufferBench

#endif
