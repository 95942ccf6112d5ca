// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Writer.h
 * @brief Fills a scenario with random props, changes and cameras.
 */
#ifndef Writer_h
#define Writer_h

#include "Scenario.h"

#include "Random.h"

#include <initializer_list>
#include <vector>

namespace TestScene
{
/// Fills a scenario whose window and number of frames are set already.
class Writer
{
public:
  /// The distance of cameras from the plane z = 0, unless a view needs another.
  static constexpr double Distance = 20.0;

  Writer(Scenario& scenario, NBufferExamples::Random& random)
    : Scene(scenario)
    , Random(random)
  {
  }

  ///@{
  /// Make random choices. Integer() includes both ends.
  double Between(double low, double high) { return this->Random.Between(low, high); }
  int Integer(int low, int high)
  {
    return low + static_cast<int>(this->Random.Index(static_cast<std::size_t>(high - low) + 1));
  }
  bool Chance(double probability) { return this->Random.Between(0.0, 1.0) < probability; }
  template <typename T>
  T Any(std::initializer_list<T> values)
  {
    return values.begin()[this->Random.Index(values.size())];
  }
  ///@}

  /// Adds a plain actor of a random colour. The reference is valid until the next prop is added.
  Prop& Add(ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size);
  Prop& Box(const glm::dvec3& center, const glm::dvec3& size)
  {
    return this->Add(ShapeKind::Box, center, size);
  }
  void AddChange(int frame, ChangeKind kind, int target, std::vector<double> values);

  /// Adds views of the plane z = 0: the camera walks, cuts, jumps back and forth, or stays. `width`
  /// is the width of the scene.
  void AddViewsFromFront(double width);

  /// Adds a view for a frame, as a copy of the last one, if there is one.
  View& AddView(int frame);

  /// The Ids of props that hide others. Later changes may remove or move them.
  std::vector<int> Occluders;
  /// The extent of the scene in world units; distances of moves are in proportion to it.
  double Scale = 10.0;

  Scenario& Scene;
  NBufferExamples::Random& Random;
};
}

#endif
