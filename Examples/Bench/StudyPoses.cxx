// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyPoses.h"

#include <cstddef>

namespace NBufferBench
{

NBufferExamples::CameraPath Spread(const NBufferExamples::CameraPath& path, int frames)
{
  NBufferExamples::CameraPath spread;
  for (int i = 0; i < frames; ++i)
  {
    spread.push_back(
      path[path.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(frames)]);
  }
  return spread;
}

NBufferExamples::CameraPath MakeRuns(const NBufferExamples::CameraPath& path, int frames)
{
  constexpr std::size_t row = 10;
  const std::size_t runs = (static_cast<std::size_t>(frames) + row - 1) / row;
  NBufferExamples::CameraPath poses;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i)
  {
    poses.push_back(path[(i / row * path.size() / runs + i % row) % path.size()]);
  }
  return poses;
}

} // namespace NBufferBench
