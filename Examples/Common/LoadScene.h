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
};

/// Returns the path of a file that comes with the examples: next to an installed program (`program`
/// is argv[0]) or in the source tree. Returns an empty text if the file is in neither place.
std::string FindData(const std::string& program, const std::string& name);

/**
 * Loads a scene by one name: "city", "plant", a city file, a map, a board or a folder of boards
 * (all of SceneKinds.h), .glb, .gltf, .obj, .wrl, .vtm or .vtpc; or by one or more names of .stl or
 * .ply files. A file may also be compressed (.gz). Throws std::runtime_error with the name of the
 * file, the cause, and a remedy where there is one.
 */
Scene LoadScene(const std::vector<std::string>& names, const SceneOptions& options);

} // namespace NBufferExamples

#endif
