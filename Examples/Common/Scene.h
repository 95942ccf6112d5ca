// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scene.h
 * @brief A scene of many actors, from any source.
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
  /// Makes a path of a number of frames. The same seed gives the same path.
  using PathMaker = std::function<CameraPath(int frames, std::uint64_t seed)>;

  std::string Name;
  /// The actors of the scene. In a city the buildings come first, in the order of Plan->Buildings,
  /// then the ground, then the streets.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  /// The plan of a city; nullptr in other scenes.
  std::shared_ptr<const City> Plan;
  /// The axis that points up: 0, 1 or 2 for x, y or z.
  int UpAxis = 2;
  /// The visibility that is known beforehand; nullptr unless the scene is a map.
  std::shared_ptr<const PotentiallyVisibleSet> Known;
  /// The camera paths that only this scene has, by name. The first one is the default.
  std::vector<std::pair<std::string, PathMaker>> Paths;

  /// Returns the bounds of all actors.
  vtkBoundingBox GetBounds() const;

  /// Adds all actors to a renderer, and a light and a background that suit them.
  void AddTo(vtkRenderer* renderer) const;

  /**
   * Adds copies of the actors around the originals, ring by ring in the level plane, until there
   * are `count` actors. A copy shares mapper and property with its original. Plan, Known and Paths
   * stay those of the original.
   */
  void Tile(int count);
};

} // namespace NBufferExamples

#endif
