// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StreetPlan.h
 * @brief The streets of a city as a graph, and the places of its buildings.
 */
#ifndef StreetPlan_h
#define StreetPlan_h

#include "City.h"
#include "Random.h"

#include "vtkNBufferGLM.h"

#include <cmath>
#include <unordered_map>
#include <vector>

namespace NBufferExamples
{

/// A point of the plan in metres.
using PlanPoint = glm::dvec2;

/// Returns the distance of two points in metres.
inline double GetDistance(const PlanPoint& a, const PlanPoint& b)
{
  return std::hypot(b.x - a.x, b.y - a.y);
}

class StreetPlan
{
public:
  explicit StreetPlan(const City& city);

  /// Returns whether a building stands so near to a point that the near plane of an eye there could
  /// cut it.
  bool IsBuiltOver(const PlanPoint& point) const;

  /**
   * Returns the corners of streets around which most of the ground is built over, the densest ones
   * first. `share`, in (0, 1], is their share of all corners. Motorways are left out.
   */
  std::vector<PlanPoint> GetDensePoints(double share) const;

  /**
   * Returns the points of a walk of at least `length` metres that starts near the dense points,
   * goes straight on where it can, takes no street twice and enters no building. There is a point
   * every 0.5 m and at every bend of a street. Throws std::runtime_error if the city has no such
   * walk.
   */
  std::vector<PlanPoint> Walk(double length, Random& random) const;

private:
  struct Edge
  {
    int To = 0;
    int Id = 0;
  };
  struct Cell
  {
    std::vector<int> Buildings;
    double BuiltArea = 0.0;
  };

  std::uint64_t GetCellKey(double x, double y, int stepX = 0, int stepY = 0) const;
  bool Contains(int building, const PlanPoint& point) const;
  bool IsEdgeFree(int from, const Edge& edge) const;
  double GetDensity(const PlanPoint& point) const;
  std::vector<PlanPoint> WalkFrom(int start, double length) const;
  std::vector<int> GetDenseNodes(double share) const;

  const City& Plan;
  std::vector<PlanPoint> Nodes;
  std::vector<std::vector<Edge>> Edges;
  int NumberOfEdges = 0;
  std::unordered_map<std::uint64_t, Cell> Cells;
};

} // namespace NBufferExamples

#endif
