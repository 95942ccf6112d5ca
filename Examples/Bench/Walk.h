// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Walk.h
 * @brief Renders the frames of a camera path in several modes and times each.
 *
 * All modes take turns in one renderer of one window. A turn is a block of a few frames: the
 * frame before the block, untimed, then the frames of the block, timed, so that every timed frame
 * follows the one that it follows in an application that knows no other mode. The modes of a
 * block run one after the other, beginning with another one in each block, so that what else the
 * machine does meets all of them.
 *
 * A time is that of Render() and of waiting until the image is finished.
 */
#ifndef Walk_h
#define Walk_h

#include "CameraPath.h"
#include "Mode.h"
#include "Session.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace NBufferBench
{

struct WalkOptions
{
  std::vector<std::string> Modes = { "stock", "none", "nbuffer", "oracle" };
  ModeOptions Mode;
  /// Compare every frame with the one of mode none.
  bool Verify = false;
  /// Timed frames of a mode in a row.
  int Block = 5;
  /// The camera stays where it is for a block: at the pose of its first frame.
  bool Still = false;
  /// Where to write the first, middle and last frame of each mode, and those that differ.
  std::string ImageFolder;
  std::function<void(const std::string&)> Progress;
};

struct ModeResult
{
  /// By frame.
  std::vector<double> Milliseconds;
  std::vector<int> Drawn;
  /// Of nbuffer: vtkNBufferStatistics as JSON.
  std::vector<std::string> Statistics;
  /// Of the modes that ask the hardware.
  std::vector<NBufferPeers::QueryStatistics> Queries;
  /// Bytes that are not those of mode none, when verified.
  std::vector<long long> DifferingBytes;
  std::string Backend;
};

struct WalkResult
{
  std::size_t Frames = 0;
  std::size_t VerifiedFrames = 0;
  std::size_t Props = 0;
  /// In the order in which they were asked for.
  std::vector<std::string> Names;
  std::map<std::string, ModeResult> Modes;
};

WalkResult RunWalk(
  Session& session, const NBufferExamples::CameraPath& path, const WalkOptions& options);

} // namespace NBufferBench

#endif
