// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyScenes.h
 * @brief The scenes of a study beside the city: what each is, how much of it is measured, and the
 * command that builds it where it is missing.
 */
#ifndef StudyScenes_h
#define StudyScenes_h

#include <string>
#include <vector>

namespace NBufferBench
{

struct StudyScene
{
  /// For LoadScene; of a file its name below the folder of scenes.
  const char* Name;
  bool IsFile;
  std::vector<std::string> Paths;
  bool InQuick;
  ///@{
  /// Least and most that is measured of it, where the city gets more: frames and repetitions of the
  /// structures, whole frames, pairs of latent ones.
  int Frames;
  int Repetitions;
  int WalkFrames;
  int LatentPairs;
  ///@}

  /// What LoadScene is to be called with.
  std::string GetPath(const std::string& folder) const;
  bool IsThere(const std::string& folder) const;
};

const std::vector<StudyScene>& GetStudyScenes();

/// What builds the scenes that are files.
const char* GetSceneCommand();

} // namespace NBufferBench

#endif
