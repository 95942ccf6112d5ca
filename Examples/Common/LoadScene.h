// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoadScene.h
 * @brief Scenes by name: the city, an OSM extract, the plant, files that VTK imports.
 */
#ifndef LoadScene_h
#define LoadScene_h

#include "Scene.h"

namespace NBufferExamples
{

struct SceneOptions
{
  /// The city file that the name "city" stands for; see FindDefaultCity.
  std::string DefaultCity;
  /// "x", "y", "z", or empty for what is usual with the file format.
  std::string Up;
  /// Of the plant.
  std::uint64_t Seed = 1;
  /// Called with what is being done.
  std::function<void(const std::string&)> Progress;
};

/**
 * A file that comes with the examples: next to an installed program (`program` is argv[0]) or in
 * the source tree. Empty when it is nowhere.
 */
std::string FindData(const std::string& program, const std::string& name);

/// The city that comes with them.
std::string FindDefaultCity(const std::string& program);

/**
 * One name: "city", "plant" (Plant.h), a city file, an OSM extract, a map (BspScene.h), a board or
 * a folder of boards (KicadScene.h), .glb, .gltf, .obj, .wrl, .vtm or .vtpc. One or more: .stl or
 * .ply. Each but an OSM extract also as .gz. Throws std::runtime_error that names the file, the
 * cause, and where there is one a remedy.
 */
Scene LoadScene(const std::vector<std::string>& names, const SceneOptions& options);

} // namespace NBufferExamples

#endif
