// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scene.h
 * @brief A scene of many actors, from any source, and the ways of a camera through it.
 */
#ifndef Scene_h
#define Scene_h

#include "City.h"

#include "vtkNBufferGLM.h"

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

/// The camera of a frame.
struct CameraPose
{
  glm::dvec3 Eye = { 0.0, 0.0, 1.0 };
  glm::dvec3 Target = { 0.0, 0.0, 0.0 };
  glm::dvec3 Up = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0; ///< The vertical view angle in degrees.
  ///@{
  /// The distances of the near and the far plane. If both are 0, they are fitted to the scene.
  double Near = 0.0;
  double Far = 0.0;
  ///@}
};

using CameraPath = std::vector<CameraPose>;

/// What can be seen from where, computed beforehand and independently of any image.
class PotentiallyVisibleSet
{
public:
  virtual ~PotentiallyVisibleSet() = default;

  /// Returns, for every actor in the order of the scene's list, 1 if it may be seen from the eye or
  /// if the set knows nothing about it, else 0. Returns an empty list if the set knows nothing
  /// about this eye.
  virtual std::vector<char> Find(const glm::dvec3& eye) const = 0;

  /// Returns whether the set knows something about an actor, given by its place in the list.
  virtual bool IsKnown(int actor) const = 0;

  /// Returns whether the straight line between two points leads through a region that is opaque for
  /// the set. An image that shows something along such a line does not contradict the set, because
  /// nothing is drawn in that region.
  virtual bool IsBlocked(const glm::dvec3& from, const glm::dvec3& to) const = 0;
};

struct Scene
{
  /// Makes a path of a number of frames. The same seed gives the same path.
  using PathMaker = std::function<CameraPath(int frames, std::uint64_t seed)>;

  std::string Name;
  /// The actors of the scene. In a city the buildings come first, in the order of Plan->Buildings,
  /// then the ground, then the streets.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  /// The names of the actors, in their order, where the scene comes from a file that names its
  /// parts; else an empty list.
  std::vector<std::string> PartNames;
  /// The plan of a city; nullptr in other scenes.
  std::shared_ptr<const City> Plan;
  /// The axis that points up: 0, 1 or 2 for x, y or z.
  int UpAxis = 2;
  /// The visibility that is known beforehand; nullptr unless the scene is a map.
  std::shared_ptr<const PotentiallyVisibleSet> Known;
  /// The camera paths that only this scene has, by name. The first one is the default.
  std::vector<std::pair<std::string, PathMaker>> Paths;

  /// Returns the name of an actor, given by its place in the list: its own, or a number.
  std::string GetPartName(std::size_t actor) const;

  /// Returns the bounds of all actors.
  vtkBoundingBox GetBounds() const;

  /// Adds all actors to a renderer, and a light and a background that suit them.
  void AddTo(vtkRenderer* renderer) const;

  /**
   * Adds copies of the actors around the originals, ring by ring in the level plane, until there
   * are `count` actors. A copy shares mapper, property and name with its original. Plan, Known and
   * Paths stay those of the original.
   */
  void Tile(int count);

  /// Makes one actor of all: of one mesh with a color at each point, or of composite data with a
  /// colored block for each actor. Plan, Known and Paths stay as they are. Throws
  /// std::runtime_error if an actor shows something else than polygons.
  void Merge(bool toBlocks);

  /// Puts the triangles of the only actor into a random order, always the same one, as some files
  /// have them. Throws std::runtime_error unless the scene is one mesh of polygons.
  void Shuffle();
};

} // namespace NBufferExamples

#endif
