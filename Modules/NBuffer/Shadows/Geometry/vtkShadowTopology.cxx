// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTopology.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// Gives equal coordinates equal numbers, from 0 in order of appearance. A hash table with open
/// addressing.
class PointMerger
{
public:
  PointMerger(std::vector<double>& points, vtkIdType maximum)
    : Points(points)
  {
    std::size_t size = 16;
    while (size < 2 * static_cast<std::size_t>(maximum))
    {
      size *= 2;
    }
    this->Table.assign(size, -1);
  }

  int GetNumber(const double x[3])
  {
    const std::size_t mask = this->Table.size() - 1;
    std::size_t slot = GetHash(x) & mask;
    while (this->Table[slot] >= 0)
    {
      if (std::equal(x, x + 3, this->Points.data() + 3 * std::size_t(this->Table[slot])))
      {
        return this->Table[slot];
      }
      slot = (slot + 1) & mask;
    }
    this->Table[slot] = static_cast<int>(this->Points.size() / 3);
    this->Points.insert(this->Points.end(), x, x + 3);
    return this->Table[slot];
  }

private:
  static std::size_t GetHash(const double x[3])
  {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double value = x[i] + 0.0; // -0 becomes 0
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }

  std::vector<double>& Points;
  std::vector<int> Table;
};

bool IsFinite(const double x[3])
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// Six times the volume of tetrahedron (a, b, c, d), and a bound of its error. Positive if d lies
/// behind triangle (a, b, c), from where its corners go round clockwise. An error of 0 means exact.
struct TetrahedronVolume
{
  TetrahedronVolume(const double* a, const double* b, const double* c, const double* d)
  {
    double u[3];
    double v[3];
    double w[3];
    vtkMath::Subtract(a, d, u);
    vtkMath::Subtract(b, d, v);
    vtkMath::Subtract(c, d, w);
    double magnitude = 0.0;
    bool exact = true;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      this->Value += u[i] * (v[j] * w[k] - v[k] * w[j]);
      magnitude += std::abs(u[i]) * (std::abs(v[j] * w[k]) + std::abs(v[k] * w[j]));
      const bool nought = (v[j] == 0.0 || w[k] == 0.0) && (v[k] == 0.0 || w[j] == 0.0);
      exact = exact && (u[i] == 0.0 || nought);
    }
    // More than orient3d's bound (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and
    // fast robust geometric predicates", 1997), and than what underflow can take away.
    this->Error = exact ? 0.0 : 8.0 * 0x1p-53 * magnitude + 1e-290;
  }

  double Value = 0.0;
  double Error = 0.0;
};

/// Solid angle of a triangle whose corners are relative to the eye (A. van Oosterom, J. Strackee,
/// "The solid angle of a plane triangle", 1983).
double GetSolidAngle(const double a[3], const double b[3], const double c[3])
{
  const double la = vtkMath::Norm(a);
  const double lb = vtkMath::Norm(b);
  const double lc = vtkMath::Norm(c);
  double bc[3];
  vtkMath::Cross(b, c, bc);
  const double divisor =
    la * lb * lc + vtkMath::Dot(a, b) * lc + vtkMath::Dot(b, c) * la + vtkMath::Dot(c, a) * lb;
  return 2.0 * std::atan2(std::abs(vtkMath::Dot(a, bc)), divisor);
}
}

void vtkShadowTopology::Build(const double* points, vtkIdType numberOfPoints,
  const vtkIdType* triangles, vtkIdType numberOfTriangles)
{
  *this = vtkShadowTopology();
  this->Triangles.reserve(3 * static_cast<std::size_t>(numberOfTriangles));
  PointMerger merger(this->Points, std::min(numberOfPoints, 3 * numberOfTriangles));
  std::vector<int> merged(static_cast<std::size_t>(numberOfPoints), -1);
  for (vtkIdType t = 0; t < numberOfTriangles; ++t)
  {
    const vtkIdType* corners = triangles + 3 * t;
    const bool valid = std::all_of(corners, corners + 3,
      [&](vtkIdType i) { return i >= 0 && i < numberOfPoints && IsFinite(points + 3 * i); });
    const auto equal = [&](int i, int j)
    {
      return std::equal(
        points + 3 * corners[i], points + 3 * corners[i] + 3, points + 3 * corners[j]);
    };
    if (!valid || equal(0, 1) || equal(1, 2) || equal(2, 0))
    {
      ++this->Degenerates;
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      int& number = merged[static_cast<std::size_t>(corners[i])];
      if (number < 0)
      {
        number = merger.GetNumber(points + 3 * corners[i]);
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
  // Union-find: each triangle points to a lower one of its component, the lowest to itself.
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
  for (const Edge& edge : this->Edges)
  {
    for (int u = edge.First + 1; u < edge.First + edge.Count; ++u)
    {
      const int x = find(this->Uses[u - 1].Triangle);
      const int y = find(this->Uses[u].Triangle);
      parents[std::max(x, y)] = std::min(x, y);
    }
  }
  // In ascending order all lower entries are numbers of components already.
  for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    parents[t] = parents[t] == t ? this->NumberOfComponents++ : parents[parents[t]];
  }
}

/**
 * With a point that is behind all triangles' planes, the view from there is a covering of the
 * sphere of directions, branched at corners only. Solid angles of 4 pi in all make it a simple one:
 * the surface bounds a star-shaped body. If no edge is concave, that body is convex (H. Tietze,
 * 1928). Convex edges alone do not suffice, nor with the Euler characteristic of a sphere: the
 * bipyramid over a pentagram has both.
 */
bool vtkShadowTopology::ProveConvex() const
{
  const auto simple = [](const Edge& edge) { return edge.Count == 2; };
  if (!this->Closed || this->NumberOfComponents != 1 ||
    !std::all_of(this->Edges.begin(), this->Edges.end(), simple))
  {
    return false;
  }
  double centre[3] = { 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    centre[i % 3] += this->Points[i] / this->GetNumberOfPoints();
  }
  const auto getPoint = [this](int i) { return this->Points.data() + 3 * std::size_t(i); };

  double orientation = 0.0; // 1: wound outwards, -1: inwards
  double solidAngle = 0.0;
  for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
  {
    const int* corners = this->Triangles.data() + 3 * std::size_t(t);
    const double* x[3] = { getPoint(corners[0]), getPoint(corners[1]), getPoint(corners[2]) };
    const TetrahedronVolume volume(x[0], x[1], x[2], centre);
    if (t == 0)
    {
      orientation = volume.Value > 0.0 ? 1.0 : -1.0;
    }
    if (!(orientation * volume.Value > volume.Error))
    {
      return false;
    }
    double relative[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(x[i], centre, relative[i]);
    }
    solidAngle += GetSolidAngle(relative[0], relative[1], relative[2]);
  }
  // A multiple of 4 pi, up to rounding.
  if (!(solidAngle < 6.0 * vtkMath::Pi()))
  {
    return false;
  }

  // The third corner of a triangle, beside those of one of its edges.
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
      const TetrahedronVolume volume(getPoint(edge.A), getPoint(edge.B),
        getPoint(getOpposite(edge, use)), getPoint(getOpposite(edge, this->Uses[edge.First + 1])));
      return side * volume.Value - volume.Error >= 0.0; // false if a value overflowed
    });
}
VTK_ABI_NAMESPACE_END
