// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoadScene.h
 * @brief Scenes by name: the city, the plant, maps, boards, and files that VTK reads.
 */
#ifndef LoadScene_h
#define LoadScene_h

#include "Scene.h"

namespace NBufferExamples
{

struct SceneOptions
{
  /// argv[0], to search the file of the scene "city" with FindData().
  std::string Program;
  /// The seed of the plant.
  std::uint64_t Seed = 1;
  /// A function that is called with a text that says what is being done.
  std::function<void(const std::string&)> Progress = [](const std::string&) {};
  /// Whether a file that holds one mesh becomes an actor for each connected region of the mesh.
  bool SplitRegions = false;
  ///@{
  /// The number of points or instances of the scenes that have them; 0: as many as they usually
  /// have.
  int Points = 0;
  int Instances = 0;
  ///@}
};

/// Returns the path of a file that comes with the examples: next to an installed program (`program`
/// is argv[0]) or in the source tree. Returns an empty text if the file is in neither place.
std::string FindData(const std::string& program, const std::string& name);

/**
 * Loads a scene by one name: "city", "plant", "isosurface", "terrain", "points-wall",
 * "points-terrain", "glyph-wall", "glyph-cloud", "glyph-open", "shells", "leaves", or a file of
 * FileFormats.h (the maps and boards, and a folder of boards, are described in SceneKinds.h); or by
 * several names of files that go together. A file may also be compressed (.gz). Throws
 * std::runtime_error with the name of the file, the cause, and a remedy where there is one.
 */
Scene LoadScene(const std::vector<std::string>& names, const SceneOptions& options);

} // namespace NBufferExamples

#endif
