// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleTree.h
 * @brief Finds the triangles that a ray crosses, in double precision, by a tree of boxes that are
 * split at medians.
 *
 * The test of ray and triangle is watertight: a ray through a shared edge crosses at least one of
 * the triangles that share the edge (S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle
 * Intersection", Journal of Computer Graphics Techniques 2(1), 2013). A ray that touches an edge
 * crosses the triangle; a ray never crosses triangles that it meets edge-on or that have no area.
 */
#ifndef TriangleTree_h
#define TriangleTree_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// The points Origin + t * Direction for Near < t < Far. The direction need not have unit length.
struct Ray
{
  double Origin[3];
  double Direction[3];
  double Near = 0.0;
  double Far = std::numeric_limits<double>::infinity();
};

/// A ray with the values that every intersection with it needs.
class PreparedRay
{
public:
  explicit PreparedRay(const Ray& ray);

  /// Finds the t at which the line of the ray crosses a triangle (nine coordinates), whatever Near
  /// and Far are. Returns false if it does not cross.
  bool Intersect(const double corners[9], double& t) const;

  /// Returns the least t at which the part of the ray up to `far` is in a box, or infinity if it
  /// misses the box.
  double Enter(const double low[3], const double high[3], double far) const;

private:
  Ray Line;
  double Inverse[3];
  int Axes[3]; ///< The last one is the axis of the direction's largest component.
  double Shear[3];
};

class TriangleTree
{
public:
  /// Builds the tree. `corners` has nine coordinates for each triangle, all of them finite.
  void Build(const std::vector<double>& corners);

  int GetNumberOfTriangles() const { return static_cast<int>(this->Ids.size()); }

  struct Hit
  {
    int Triangle = -1; ///< The place in the list that Build() got, or -1 for no triangle.
    double T = std::numeric_limits<double>::infinity();
  };

  /// Returns the first triangle on the ray.
  Hit FindNearest(const Ray& ray) const;

  /**
   * Calls visit(triangle, t) for each triangle that the ray crosses, nearer parts of the tree
   * first, until it returns false.
   */
  template <typename Visitor>
  void VisitCrossings(const Ray& ray, Visitor&& visit) const;

private:
  struct Node
  {
    double Low[3];
    double High[3];
    int First = 0; ///< Leaf: its first triangle. Else: its second child; the first is next to it.
    int Count = 0; ///< Leaf: its number of triangles. Else: 0.
  };

  /// Calls visit(triangle, t, far) for each triangle that the ray crosses; visit() may lower `far`.
  template <typename Visitor>
  void Traverse(const Ray& ray, Visitor&& visit) const;

  void BuildNode(const std::vector<double>& corners, int first, int last);

  std::vector<Node> Nodes;
  std::vector<int> Ids;        ///< In the order of the leaves.
  std::vector<double> Corners; ///< In the order of the leaves.
};

template <typename Visitor>
void TriangleTree::Traverse(const Ray& ray, Visitor&& visit) const
{
  constexpr double missed = std::numeric_limits<double>::infinity();
  const PreparedRay prepared(ray);
  double far = ray.Far;
  // A split at the median halves the triangles, so that the depth is at most the bits of an int.
  int stack[64];
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const int index = stack[--size];
    const Node& node = this->Nodes[index];
    if (prepared.Enter(node.Low, node.High, far) == missed)
    {
      continue;
    }
    for (int i = node.First; i < node.First + node.Count; ++i)
    {
      double t;
      if (prepared.Intersect(&this->Corners[9 * static_cast<std::size_t>(i)], t) && t > ray.Near &&
        t < far)
      {
        visit(this->Ids[i], t, far);
      }
    }
    if (node.Count == 0)
    {
      const Node& one = this->Nodes[index + 1];
      const Node& two = this->Nodes[node.First];
      const bool oneFirst =
        prepared.Enter(one.Low, one.High, far) <= prepared.Enter(two.Low, two.High, far);
      stack[size++] = oneFirst ? node.First : index + 1;
      stack[size++] = oneFirst ? index + 1 : node.First;
    }
  }
}

template <typename Visitor>
void TriangleTree::VisitCrossings(const Ray& ray, Visitor&& visit) const
{
  bool goOn = true;
  this->Traverse(ray,
    [&](int triangle, double t, double& far)
    {
      goOn = goOn && visit(triangle, t);
      if (!goOn)
      {
        far = -std::numeric_limits<double>::infinity();
      }
    });
}

#endif
