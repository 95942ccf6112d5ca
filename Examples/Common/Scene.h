// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scene.h
 * @brief Many actors from anywhere: the city, an OSM extract, the plant, files that VTK imports.
 */
#ifndef Scene_h
#define Scene_h

#include "CameraPose.h"
#include "City.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkRenderer;

namespace NBufferExamples
{

class PotentiallyVisibleSet;

struct Scene
{
  /// Makes a path of a number of frames; the same seed, the same path.
  using PathMaker = std::function<CameraPath(int frames, std::uint64_t seed)>;

  std::string Name;
  /// In a city the buildings come first, in the order of Plan->Buildings, then the ground, then
  /// the streets.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  /// Only of a city.
  std::shared_ptr<const City> Plan;
  /// 0, 1 or 2: x, y or z points up.
  int UpAxis = 2;
  /// What is known of visibility beforehand; only of a map.
  std::shared_ptr<const PotentiallyVisibleSet> Known;
  /// Camera paths that only this scene has, by name; the first one is the usual one.
  std::vector<std::pair<std::string, PathMaker>> Paths;

  vtkBoundingBox GetBounds() const;

  /// Add all actors, and light and background that suit them.
  void AddTo(vtkRenderer* renderer) const;

  /**
   * Copies of the actors around them, ring by ring in the plane that is not up, until there are
   * `count`. A copy shares mapper and property with its original. Plan, Known and Paths stay those
   * of the original.
   */
  void Tile(int count);
};

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
 * A file that comes with the examples: beside an installed program (`program` is argv[0]) or in
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
