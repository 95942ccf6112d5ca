// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scene.h
 * @brief Many actors, wherever they come from.
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

} // namespace NBufferExamples

#endif
