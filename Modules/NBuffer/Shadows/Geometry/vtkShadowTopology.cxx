// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTopology.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The hash of coordinates. -0 and 0 have the same hash, because they are equal.
struct PointHash
{
  std::size_t operator()(const glm::dvec3& x) const
  {
    const std::hash<double> hash;
    constexpr std::uint64_t factor = 0x9e3779b97f4a7c15u; // 2^64 / golden ratio
    return static_cast<std::size_t>((hash(x[0]) * factor + hash(x[1])) * factor + hash(x[2]));
  }
};

/// Six times the signed volume of tetrahedron (a, b, c, d), and a bound of its rounding error. The
/// volume is positive if d lies behind triangle (a, b, c): seen from d, the corners go round
/// clockwise. An error of 0 means that the volume is exact.
struct TetrahedronVolume
{
  TetrahedronVolume(
    const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
  {
    const glm::dvec3 u = a - d;
    const glm::dvec3 v = b - d;
    const glm::dvec3 w = c - d;
    this->Value = glm::dot(u, glm::cross(v, w));
    double magnitude = 0.0;
    bool exact = true;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      magnitude += std::abs(u[i]) * (std::abs(v[j] * w[k]) + std::abs(v[k] * w[j]));
      const bool isZero = (v[j] == 0.0 || w[k] == 0.0) && (v[k] == 0.0 || w[j] == 0.0);
      exact = exact && (u[i] == 0.0 || isZero);
    }
    // This is more than the bound of orient3d (J. R. Shewchuk, "Adaptive precision floating-point
    // arithmetic and fast robust geometric predicates", 1997) plus what underflow can lose.
    this->Error = exact ? 0.0 : 8.0 * 0x1p-53 * magnitude + 1e-290;
  }

  double Value = 0.0;
  double Error = 0.0;
};

/// The solid angle of a triangle whose corners are relative to the eye (A. van Oosterom, J.
/// Strackee, "The solid angle of a plane triangle", 1983).
double GetSolidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double divisor =
    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(std::abs(glm::dot(a, glm::cross(b, c))), divisor);
}
}

vtkShadowTopology::vtkShadowTopology(
  const vtkShadowPoints& points, const std::vector<vtkIdType>& triangles)
{
  this->Triangles.reserve(triangles.size());
  std::unordered_map<glm::dvec3, int, PointHash> numbers;
  numbers.reserve(std::min(points.size(), triangles.size()));
  std::vector<int> merged(points.size(), -1);
  const auto isUsable = [&points](vtkIdType i)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    return i >= 0 && i < static_cast<vtkIdType>(points.size()) &&
      glm::all(glm::lessThanEqual(vtkNBufferGLM::Abs(points[i]), glm::dvec3(largest)));
  };
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
  {
    const vtkIdType* corners = triangles.data() + t;
    const auto isSame = [&](int i, int j) { return points[corners[i]] == points[corners[j]]; };
    if (!std::all_of(corners, corners + 3, isUsable) || isSame(0, 1) || isSame(1, 2) ||
      isSame(2, 0))
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      int& number = merged[static_cast<std::size_t>(corners[i])];
      if (number < 0)
      {
        const auto [place, isNew] =
          numbers.try_emplace(points[corners[i]], this->GetNumberOfPoints());
        number = place->second;
        if (isNew)
        {
          this->Points.push_back(points[corners[i]]);
        }
      }
      this->Triangles.push_back(number);
    }
  }
  this->BuildEdges();
  this->BuildComponents();
  this->Convex = this->ProveConvex();
}

void vtkShadowTopology::BuildEdges()
{
  struct HalfEdge
  {
    int A;
    int B;
    Use U;
  };
  std::vector<HalfEdge> halves;
  halves.reserve(this->Triangles.size());
  for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    const int* corners = this->Triangles.data() + 3 * std::size_t(t);
    for (int i = 0; i < 3; ++i)
    {
      const int from = corners[i];
      const int to = corners[(i + 1) % 3];
      halves.push_back({ std::min(from, to), std::max(from, to), { t, from < to ? 1 : -1 } });
    }
  }
  std::sort(halves.begin(), halves.end(),
    [](const HalfEdge& x, const HalfEdge& y)
    { return std::tie(x.A, x.B, x.U.Triangle) < std::tie(y.A, y.B, y.U.Triangle); });

  this->Uses.reserve(halves.size());
  this->Closed = true;
  int balance = 0;
  for (const HalfEdge& half : halves)
  {
    if (this->Edges.empty() || this->Edges.back().A != half.A || this->Edges.back().B != half.B)
    {
      this->Closed = this->Closed && balance == 0;
      balance = 0;
      this->Edges.push_back({ half.A, half.B, static_cast<int>(this->Uses.size()), 0 });
    }
    this->Uses.push_back(half.U);
    ++this->Edges.back().Count;
    balance += half.U.Direction;
  }
  this->Closed = this->Closed && balance == 0;
}

void vtkShadowTopology::BuildComponents()
{
  // Union-find: each triangle points to a triangle with a lower number in its component. The lowest
  // one points to itself.
  std::vector<int>& parents = this->Components;
  parents.resize(static_cast<std::size_t>(this->GetNumberOfTriangles()));
  std::iota(parents.begin(), parents.end(), 0);
  const auto find = [&parents](int t)
  {
    while (parents[t] != t)
    {
      parents[t] = parents[parents[t]];
      t = parents[t];
    }
    return t;
  };
  const auto unite = [&parents, &find](int x, int y)
  {
    x = find(x);
    y = find(y);
    parents[std::max(x, y)] = std::min(x, y);
  };
  for (const Edge& edge : this->Edges)
  {
    if (edge.Count == 2)
    {
      unite(this->Uses[edge.First].Triangle, this->Uses[edge.First + 1].Triangle);
    }
  }
  for (const Edge& edge : this->Edges)
  {
    if (edge.Count > 2)
    {
      std::map<int, int> balances; // of the components that use the edge
      for (int u = edge.First; u < edge.First + edge.Count; ++u)
      {
        balances[find(this->Uses[u].Triangle)] += this->Uses[u].Direction;
      }
      int last = -1; // the last component that is open here
      for (const auto& [component, balance] : balances)
      {
        if (balance != 0)
        {
          unite(component, last >= 0 ? last : component);
          last = component;
        }
      }
    }
  }
  // In ascending order, all lower entries have already been replaced by numbers of components.
  for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    parents[t] = parents[t] == t ? this->NumberOfComponents++ : parents[parents[t]];
  }
}

/**
 * First, the mean of all points must lie behind the planes of all triangles. Seen from there, the
 * surface covers the sphere of directions, branched at corners only. If the solid angles of all
 * triangles add up to 4 pi, it covers every direction once, and so bounds a star-shaped body.
 * Second, no edge may be concave. Then that body is convex (H. Tietze, 1928). The second condition
 * alone does not suffice, not even with the Euler characteristic of a sphere: the bipyramid over a
 * pentagram fulfils both.
 */
bool vtkShadowTopology::ProveConvex() const
{
  const auto simple = [](const Edge& edge) { return edge.Count == 2; };
  if (!this->Closed || this->NumberOfComponents != 1 ||
    !std::all_of(this->Edges.begin(), this->Edges.end(), simple))
  {
    return false;
  }
  glm::dvec3 centre(0.0);
  for (const glm::dvec3& point : this->Points)
  {
    centre += point / static_cast<double>(this->GetNumberOfPoints());
  }
  double orientation = 0.0; // 1: wound outwards, -1: inwards
  double solidAngle = 0.0;
  for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    const int* corners = this->Triangles.data() + 3 * std::size_t(t);
    const glm::dvec3& a = this->Points[corners[0]];
    const glm::dvec3& b = this->Points[corners[1]];
    const glm::dvec3& c = this->Points[corners[2]];
    const TetrahedronVolume volume(a, b, c, centre);
    if (t == 0)
    {
      orientation = volume.Value > 0.0 ? 1.0 : -1.0;
    }
    if (!(orientation * volume.Value > volume.Error))
    {
      return false;
    }
    solidAngle += GetSolidAngle(a - centre, b - centre, c - centre);
  }
  // The sum is a multiple of 4 pi, up to rounding, so that it is 4 pi if it is less than 6 pi.
  if (!(solidAngle < 6.0 * vtkMath::Pi()))
  {
    return false;
  }

  // The corner of a triangle that lies opposite to one of its edges.
  const auto getOpposite = [this](const Edge& edge, const Use& use)
  {
    const int* corners = this->Triangles.data() + 3 * std::size_t(use.Triangle);
    return corners[0] + corners[1] + corners[2] - edge.A - edge.B;
  };
  return std::all_of(this->Edges.begin(), this->Edges.end(),
    [&](const Edge& edge)
    {
      const Use& use = this->Uses[edge.First];
      const double side = orientation * use.Direction;
      const TetrahedronVolume volume(this->Points[edge.A], this->Points[edge.B],
        this->Points[getOpposite(edge, use)],
        this->Points[getOpposite(edge, this->Uses[edge.First + 1])]);
      return side * volume.Value - volume.Error >= 0.0; // false if a value overflowed
    });
}
VTK_ABI_NAMESPACE_END
