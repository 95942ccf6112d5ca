// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowCaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace
{
/// How a ray meets a triangle.
struct Crossing
{
  int Sign = 0;           ///< 1: leaves through its front, -1: enters, 0: misses it.
  double Parameter = 0.0; ///< Of the place on the ray, if Sign is not 0.
  bool Certain = true;    ///< False within the tolerance of its border, or of its plane.
};

/**
 * The ray from `start` along `direction` against a triangle with homogeneous corners, w >= 0: seen
 * from the start, (xyz - w start) is the direction of a corner also if it is infinitely far.
 */
Crossing Cross(const Point& start, const Point& direction, const std::array<glm::dvec4, 3>& corners,
  double tolerance)
{
  Point relative[3];
  double lengths[3];
  double w = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    relative[i] = Point(corners[i]) - corners[i][3] * start;
    lengths[i] = glm::length(relative[i]);
  }
  // direction = sum of sides[i] / volume * relative[i], and the place is that over its w.
  const double volume = glm::dot(relative[0], glm::cross(relative[1], relative[2]));
  const double norm = glm::length(direction);
  int positive = volume > tolerance * lengths[0] * lengths[1] * lengths[2];
  int negative = volume < -tolerance * lengths[0] * lengths[1] * lengths[2];
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double side = glm::dot(direction, glm::cross(relative[j], relative[k]));
    const double limit = tolerance * norm * lengths[j] * lengths[k];
    positive += side > limit;
    negative += side < -limit;
    w += corners[i][3] * side;
  }
  Crossing crossing;
  if (positive == 4 || negative == 4)
  {
    crossing.Sign = positive ? 1 : -1;
    crossing.Parameter = w != 0.0 ? volume / w : std::numeric_limits<double>::infinity();
  }
  else
  {
    crossing.Certain = positive > 0 && negative > 0;
  }
  return crossing;
}

}

std::optional<int> CountByBruteForce(
  const ShadowMesh& mesh, const vtkShadowLight& light, const Point& x, bool awayOnly)
{
  constexpr double tolerance = 1e-4;
  const Point toLight = light.IsPositional() ? light.Position - x : -light.Direction;
  int count = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); t += 3)
  {
    std::array<glm::dvec4, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = glm::dvec4(mesh.Points[mesh.Triangles[t + i]], 1.0);
    }
    const Crossing crossing = Cross(x, toLight, corners, tolerance);
    const bool atLight =
      light.IsPositional() && std::abs(crossing.Parameter - 1.0) < tolerance && crossing.Sign;
    if (!crossing.Certain || atLight)
    {
      return {};
    }
    const bool before = !light.IsPositional() || crossing.Parameter < 1.0;
    count += before && (awayOnly ? crossing.Sign < 0 : crossing.Sign != 0);
  }
  return count;
}

int CountInVolume(const vtkShadowVolume& volume, const Point& x, std::mt19937& random)
{
  const std::vector<glm::dvec4>& vertices = volume.GetVertices();
  for (int attempt = 0; attempt < 100; ++attempt)
  {
    const Point direction = MakePoint(random, 1.0);
    int count = 0;
    bool certain = true;
    for (std::size_t i = 0; i < volume.GetIndices().size() && certain; i += 3)
    {
      const unsigned int* corners = volume.GetIndices().data() + i;
      const Crossing crossing = Cross(
        x, direction, { vertices[corners[0]], vertices[corners[1]], vertices[corners[2]] }, 1e-12);
      certain = crossing.Certain;
      count += crossing.Sign;
    }
    if (certain)
    {
      return count;
    }
  }
  ADD_FAILURE() << "every ray meets an edge";
  return -1;
}

bool IsWatertight(const vtkShadowVolume& volume)
{
  std::map<std::pair<unsigned int, unsigned int>, int> balance;
  const std::vector<unsigned int>& indices = volume.GetIndices();
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    const unsigned int from = indices[i];
    const unsigned int to = indices[i % 3 == 2 ? i - 2 : i + 1];
    EXPECT_NE(from, to);
    EXPECT_LT(from, volume.GetVertices().size());
    balance[{ std::min(from, to), std::max(from, to) }] += from < to ? 1 : -1;
  }
  return std::all_of(
    balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}
