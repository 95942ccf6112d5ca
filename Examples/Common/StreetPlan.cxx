// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StreetPlan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
constexpr double CellSize = 50.0;      // metres
constexpr double Clearance = 0.45;     // metres from a wall, more than the near plane is away
constexpr double LargestHouse = 400.0; // square metres
constexpr double Step = 0.5;           // metres between points that are looked at

PlanPoint ToPlanPoint(const CityPoint& point)
{
  return { CityMetresPerUnit * point.X, CityMetresPerUnit * point.Y };
}

bool IsForWalks(const std::string& kind)
{
  static const std::set<std::string> excluded = { "motorway", "motorway_link", "trunk",
    "trunk_link", "raceway", "platform", "rest_area", "elevator", "bus_stop" };
  return excluded.count(kind) == 0;
}
}

StreetPlan::StreetPlan(const City& city)
  : Plan(city)
{
  for (std::size_t i = 0; i < city.Buildings.size(); ++i)
  {
    const CityRing& ring = city.Buildings[i].Rings.front();
    PlanPoint low = ToPlanPoint(ring.front());
    PlanPoint high = low;
    for (const CityPoint& point : ring)
    {
      const PlanPoint p = ToPlanPoint(point);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    // A metre wider than the building: more than the clearance.
    for (double x = std::floor((low.x - 1.0) / CellSize); x * CellSize <= high.x + 1.0; ++x)
    {
      for (double y = std::floor((low.y - 1.0) / CellSize); y * CellSize <= high.y + 1.0; ++y)
      {
        this->Cells[this->GetCellKey((x + 0.5) * CellSize, (y + 0.5) * CellSize)]
          .Buildings.push_back(static_cast<int>(i));
      }
    }
    // The halls of a trading estate do not make a town centre.
    const double area = 0.5 * GetSignedDoubleArea(ring) * CityMetresPerUnit * CityMetresPerUnit;
    this->Cells[this->GetCellKey(0.5 * (low.x + high.x), 0.5 * (low.y + high.y))].BuiltArea +=
      std::min(area, LargestHouse);
  }

  // Streets that meet share a node of OpenStreetMap, so that their points are equal.
  std::unordered_map<std::uint64_t, int> nodeByPoint;
  for (const CityStreet& street : city.Streets)
  {
    if (!IsForWalks(city.StreetKinds[static_cast<std::size_t>(street.Kind)]))
    {
      continue;
    }
    int before = -1;
    for (const CityPoint& point : street.Points)
    {
      const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(point.X)) << 32 |
        static_cast<std::uint32_t>(point.Y);
      const auto [found, isNew] = nodeByPoint.emplace(key, static_cast<int>(this->Nodes.size()));
      if (isNew)
      {
        this->Nodes.push_back(ToPlanPoint(point));
        this->Edges.emplace_back();
      }
      const int node = found->second;
      if (before >= 0 && before != node)
      {
        this->Edges[static_cast<std::size_t>(before)].push_back({ node, this->NumberOfEdges });
        this->Edges[static_cast<std::size_t>(node)].push_back({ before, this->NumberOfEdges });
        ++this->NumberOfEdges;
      }
      before = node;
    }
  }
}

std::uint64_t StreetPlan::GetCellKey(double x, double y, int stepX, int stepY) const
{
  const auto cell = [](double value, int step)
  {
    return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::floor(value / CellSize)) + step);
  };
  return static_cast<std::uint64_t>(cell(x, stepX)) << 32 | cell(y, stepY);
}

bool StreetPlan::Contains(int building, const PlanPoint& point) const
{
  // Holes turn the parity back, so that a courtyard is outside.
  bool inside = false;
  for (const CityRing& ring : this->Plan.Buildings[static_cast<std::size_t>(building)].Rings)
  {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    {
      const PlanPoint a = ToPlanPoint(ring[i]);
      const PlanPoint b = ToPlanPoint(ring[j]);
      if ((a.y > point.y) != (b.y > point.y) &&
        point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y))
      {
        inside = !inside;
      }
    }
  }
  return inside;
}

bool StreetPlan::IsBuiltOver(const PlanPoint& point) const
{
  const auto cell = this->Cells.find(this->GetCellKey(point.x, point.y));
  if (cell == this->Cells.end())
  {
    return false;
  }
  const PlanPoint x(Clearance, 0.0);
  const PlanPoint y(0.0, Clearance);
  const PlanPoint around[] = { point, point - x, point + x, point - y, point + y };
  const std::vector<int>& buildings = cell->second.Buildings;
  return std::any_of(buildings.begin(), buildings.end(),
    [&](int building)
    {
      return std::any_of(std::begin(around), std::end(around),
        [&](const PlanPoint& p) { return this->Contains(building, p); });
    });
}

bool StreetPlan::IsEdgeFree(int from, const Edge& edge) const
{
  const PlanPoint& a = this->Nodes[static_cast<std::size_t>(from)];
  const PlanPoint& b = this->Nodes[static_cast<std::size_t>(edge.To)];
  const int count = 1 + static_cast<int>(GetDistance(a, b) / Step);
  for (int i = 0; i <= count; ++i)
  {
    const double t = static_cast<double>(i) / count;
    if (this->IsBuiltOver(a + t * (b - a)))
    {
      return false;
    }
  }
  return true;
}

double StreetPlan::GetDensity(const PlanPoint& point) const
{
  double area = 0.0;
  for (int x = -3; x <= 3; ++x)
  {
    for (int y = -3; y <= 3; ++y)
    {
      const auto cell = this->Cells.find(this->GetCellKey(point.x, point.y, x, y));
      area += cell == this->Cells.end() ? 0.0 : cell->second.BuiltArea;
    }
  }
  return area;
}

std::vector<int> StreetPlan::GetDenseNodes(double share) const
{
  std::vector<double> density;
  density.reserve(this->Nodes.size());
  for (const PlanPoint& node : this->Nodes)
  {
    density.push_back(this->GetDensity(node));
  }
  std::vector<int> nodes(this->Nodes.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  std::stable_sort(nodes.begin(), nodes.end(),
    [&density](int a, int b)
    { return density[static_cast<std::size_t>(a)] > density[static_cast<std::size_t>(b)]; });
  nodes.resize(static_cast<std::size_t>(std::ceil(share * static_cast<double>(nodes.size()))));
  return nodes;
}

std::vector<PlanPoint> StreetPlan::GetDensePoints(double share) const
{
  std::vector<PlanPoint> points;
  for (int node : this->GetDenseNodes(share))
  {
    points.push_back(this->Nodes[static_cast<std::size_t>(node)]);
  }
  return points;
}

std::vector<PlanPoint> StreetPlan::WalkFrom(int start, double length) const
{
  std::vector<char> used(static_cast<std::size_t>(this->NumberOfEdges), 0);
  std::vector<PlanPoint> walk;
  double done = 0.0;
  PlanPoint heading;
  for (int node = start; done < length;)
  {
    const PlanPoint from = this->Nodes[static_cast<std::size_t>(node)];
    const Edge* best = nullptr;
    // No sharper turn than 120 degrees: a walker does not turn on his heel.
    double bestCosine = -0.5;
    for (const Edge& edge : this->Edges[static_cast<std::size_t>(node)])
    {
      const PlanPoint& to = this->Nodes[static_cast<std::size_t>(edge.To)];
      const double distance = GetDistance(from, to);
      const double cosine = walk.empty() ? 0.0 : glm::dot(to - from, heading) / distance;
      if (!used[static_cast<std::size_t>(edge.Id)] && distance > 0.0 && cosine > bestCosine &&
        this->IsEdgeFree(node, edge))
      {
        best = &edge;
        bestCosine = cosine;
      }
    }
    if (!best)
    {
      break;
    }
    const PlanPoint to = this->Nodes[static_cast<std::size_t>(best->To)];
    const double distance = GetDistance(from, to);
    heading = (to - from) / distance;
    for (double along = walk.empty() ? 0.0 : Step; along < distance; along += Step)
    {
      walk.push_back(from + along * heading);
    }
    walk.push_back(to);
    used[static_cast<std::size_t>(best->Id)] = 1;
    done += distance;
    node = best->To;
  }
  return done < length ? std::vector<PlanPoint>() : walk;
}

std::vector<PlanPoint> StreetPlan::Walk(double length, Random& random) const
{
  // The densest tenth of the corners is the centre of a town; longer walks start farther out.
  for (double share : { 0.1, 0.3, 1.0 })
  {
    const std::vector<int> starts = this->GetDenseNodes(share);
    for (int attempt = 0; attempt < 200 && !starts.empty(); ++attempt)
    {
      std::vector<PlanPoint> walk = this->WalkFrom(starts[random.Index(starts.size())], length);
      if (!walk.empty())
      {
        return walk;
      }
    }
  }
  throw std::runtime_error("the city has no walk of " + std::to_string(static_cast<int>(length)) +
    " m along its streets; ask for fewer frames");
}

} // namespace NBufferExamples
