// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Walk.h
 * @brief Renders the frames of a camera path in several modes and times each.
 *
 * All modes take turns in one renderer of one window. A turn is a block of a few frames: first the
 * frame before the block, untimed (before the first block the second frame, and of a camera that
 * stands still the frame itself), then the frames of the block, timed. So every timed frame, except
 * for the first one, comes after the same frame as in an application that has only this mode. The
 * modes of a block run one after the other, and each block begins with another mode, so that
 * disturbances of the machine affect all modes alike.
 *
 * A time is the time of Render() and of waiting until the image is finished.
 */
#ifndef Walk_h
#define Walk_h

#include "CameraPath.h"
#include "Mode.h"
#include "Session.h"

#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

namespace NBufferBench
{

/// Calls run(mode, begin, end) for every block of frames and every mode, and endBlock(begin, end)
/// after each block.
template <typename RunBlock, typename EndBlock>
void TakeTurns(
  std::size_t modes, std::size_t frames, int block, RunBlock&& run, EndBlock&& endBlock)
{
  const auto size = static_cast<std::size_t>(block > 1 ? block : 1);
  for (std::size_t turn = 0, begin = 0; begin < frames; begin += size, ++turn)
  {
    const std::size_t end = begin + size < frames ? begin + size : frames;
    for (std::size_t i = 0; i < modes; ++i)
    {
      run((i + turn) % modes, begin, end);
    }
    endBlock(begin, end);
  }
}

struct WalkOptions
{
  std::vector<std::string> Modes = { "stock", "none", "nbuffer", "oracle" };
  std::string Backend = "auto"; ///< The back-end of the mode nbuffer, as for Mode.
  /// Frames of each mode that are drawn before any frame is timed: forward along the path, back,
  /// and so on. The culler needs some hundred frames to get as fast as it can be in a scene.
  int WarmUp = 1;
  /// Whether every frame is compared with the same frame of mode none.
  bool Verify = false;
  /// Timed frames of a mode in a row.
  int Block = 5;
  /// Whether the camera stays at the first pose of a block for the whole block.
  bool Still = false;
  /// Folder for the first, middle and last frame of each mode and for frames that differ; empty:
  /// no images.
  std::string ImageFolder;
};

/// Returns the part of the report (SCHEMA.md) that is measured: modes, ratios, frames, props,
/// block, and verified_frames and differing_bytes, which are 0 unless frames are verified.
Json::Value RunWalk(
  Session& session, const NBufferExamples::CameraPath& path, const WalkOptions& options);

} // namespace NBufferBench

#endif
