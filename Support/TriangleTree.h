// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TriangleTree.h
 * @brief Which triangles a ray crosses, in double precision: a tree of boxes, split at medians.
 *
 * The test of ray and triangle is watertight: a ray through a shared edge crosses at least one of
 * the triangles that share it (S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle
 * Intersection", Journal of Computer Graphics Techniques 2(1), 2013). Touching an edge counts as
 * crossing; triangles seen edge-on and those without area are never crossed.
 */
#ifndef TriangleTree_h
#define TriangleTree_h

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Origin + t * Direction for Near < t < Far. The direction need not have unit length.
struct Ray
{
  double Origin[3];
  double Direction[3];
  double Near = 0.0;
  double Far = std::numeric_limits<double>::infinity();
};

/// A ray with what every intersection with it needs.
class PreparedRay
{
public:
  explicit PreparedRay(const Ray& ray);

  /// Where the line of the ray crosses the triangle (nine coordinates), whatever Near and Far are.
  bool Intersect(const double corners[9], double& t) const;

  /// Least t at which the part of the ray up to `far` is in the box; +infinity if it misses it.
  double Enter(const double low[3], const double high[3], double far) const;

private:
  Ray Line;
  double Inverse[3];
  int Axes[3]; ///< The last is the direction's largest component.
  double Shear[3];
};

class TriangleTree
{
public:
  /// Nine coordinates for each triangle, all finite.
  void Build(const std::vector<double>& corners);

  int GetNumberOfTriangles() const { return static_cast<int>(this->Ids.size()); }

  struct Hit
  {
    int Triangle = -1; ///< Its place in what Build() was given; -1: none.
    double T = std::numeric_limits<double>::infinity();
  };

  /// The first triangle on the ray.
  Hit FindNearest(const Ray& ray) const;

  /**
   * Call visit(triangle, t) for each triangle that the ray crosses, nearer parts of the tree first,
   * until it returns false.
   */
  template <typename Visitor>
  void VisitCrossings(const Ray& ray, Visitor&& visit) const;

private:
  struct Node
  {
    double Low[3];
    double High[3];
    int First = 0; ///< Leaf: the first of its triangles. Else: the second child; the first follows.
    int Count = 0; ///< Leaf: number of triangles. Else: 0.
  };

  /// Calls visit(triangle, t, far), which may lower far.
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
  // Medians halve: the depth is at most the number of bits of a count.
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
