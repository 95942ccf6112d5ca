// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Families.h
 * @brief Scenes around one hazard each, and the cameras that look at them.
 */
#ifndef Families_h
#define Families_h

#include "Scenario.h"

#include "Random.h"

#include <vector>

namespace TestScene
{
/// Fills a scenario. Its window and number of frames are settled already.
class Writer
{
public:
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

  /// The last view again, for a frame that changes a part of it; the first one has defaults.
  View& AddView(int frame);

  /// Props that the next changes may take away or open: what hides the others.
  std::vector<int> Occluders;
  /// World units across the view at the place of interest; the measure of moves.
  double Scale = 10.0;

  Scenario& Scene;
  NBufferExamples::Random& Random;
};

using Family = void (*)(Writer&);

struct NamedFamily
{
  const char* Name;
  double Weight;
  Family Build;
};

const std::vector<NamedFamily>& GetFamilies();

/// Let some props draw what an earlier prop of their renderer draws, each in its own way.
void ShareMappers(Writer& writer);

/// Make some props parts of the assembly that stands before them in the list.
void NestAssemblies(Writer& writer);

/// Props, views, lights and changes of any named scenario of the tests (NamedScenarios.h).
void BuildNamed(Writer& writer, bool shadows);
}

#endif
