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
#include <utility>
#include <vector>

namespace TestScene
{
/// Fills a scenario. Its window and number of frames are settled already.
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
  /// Shorthand for random choices.
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

  /// A plain actor of its own colour; the reference is good until the next one.
  Prop& Add(ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size);
  Prop& Box(const glm::dvec3& center, const glm::dvec3& size)
  {
    return this->Add(ShapeKind::Box, center, size);
  }
  void AddChange(int frame, ChangeKind kind, int target, std::vector<double> values);

  /// The camera walks, cuts, jumps back and forth or stays, before the plane z = 0.
  void AddViewsFromFront(double width);

  /// The last view again, for a frame that changes a part of it; the first one has defaults.
  View& AddView(int frame);

  /// Props that the next changes may take away or open: what hides the others.
  std::vector<int> Occluders;
  /// World units across the view at the place of interest; the measure of moves.
  double Scale = 10.0;

  Scenario& Scene;
  NBufferExamples::Random& Random;
};
}

#endif
