// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTopology
 * @brief Which triangles of a caster share which edges, for any mesh. No OpenGL.
 *
 * Points are merged if their coordinates are equal to the bit (-0 equals 0). So a mesh is closed
 * even if it repeats points to give them several normals or texture coordinates. An edge is a pair
 * of merged points, the one with the lower number first. Each edge has a list of its uses: the
 * triangle, and whether the triangle runs along the edge (+1) or against it (-1). Any mesh is
 * allowed: open edges have one use, non-manifold edges have three or more, and edges between badly
 * wound triangles have two of the same direction (B. Kim, K. Kim, G. Turk, "A shadow-volume
 * algorithm for opaque and transparent nonmanifold casters", Journal of Graphics Tools 13(3),
 * 2008).
 *
 *        2           edge {1, 2} of triangles T0 = (0, 1, 2) and T1 = (1, 3, 2):
 *       /|\            T0 runs from 1 to 2, along the edge: +1
 *      / | \           T1 runs from 2 to 1, against it:     -1
 *     0  |  3        edge {0, 1} has one use: the mesh is open there.
 *      \ | /
 *       \|/
 *        1
 *
 * Two kinds of triangles are left out: those that use a merged point twice (they have
 * no area, and their edges cancel), and those with a coordinate that is no finite float.
 *
 * The topology depends only on the coordinates before any matrix is applied, so it is built once
 * for each mesh: an invertible affine matrix keeps equal points equal and convex bodies convex.
 *
 * The cost is a hash of the points and a sort of the edges, O(n log n).
 */
#ifndef vtkShadowTopology_h
#define vtkShadowTopology_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Points of a caster.
using vtkShadowPoints = std::vector<glm::dvec3>;

class VTKNBUFFER_EXPORT vtkShadowTopology
{
public:
  /// An undirected edge.
  struct Edge
  {
    int A = 0;     ///< The merged point with the lower number.
    int B = 0;     ///< The merged point with the higher number.
    int First = 0; ///< The index of its first use in GetUses().
    int Count = 0; ///< The number of its uses.
  };

  /// The use of an edge by a triangle.
  struct Use
  {
    int Triangle = 0;  ///< The number of the triangle.
    int Direction = 0; ///< 1: the triangle goes from A to B, -1: it goes from B to A.
  };

  vtkShadowTopology() = default;

  /// The topology of triangles, at most 2^31 / 3, each of which has three indices into `points`. A
  /// triangle with an index out of range is left out like one with a coordinate that is no finite
  /// float.
  vtkShadowTopology(const vtkShadowPoints& points, const std::vector<vtkIdType>& triangles);

  /// The merged points that the kept triangles use, in the order of their first use.
  const vtkShadowPoints& GetPoints() const { return this->Points; }
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size()); }

  /// The numbers of three merged points for each triangle that was kept, in the given winding.
  const std::vector<int>& GetTriangles() const { return this->Triangles; }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size() / 3); }

  /// The edges, sorted by A, then B.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /// The uses of all edges. Those of one edge are in the order of their triangles.
  const std::vector<Use>& GetUses() const { return this->Uses; }

  /// For each triangle the number of its component, from 0. Triangles that share an edge are in one
  /// component, except where those on one side of an edge are closed without the others: bodies
  /// that touch in an edge are components of their own, as they may be wound differently.
  const std::vector<int>& GetComponents() const { return this->Components; }
  int GetNumberOfComponents() const { return this->NumberOfComponents; }

  /**
   * Returns true if every edge has as many uses along it (+1) as against it (-1). Then the surface
   * is closed: a line that enters it also leaves it. Only then may a shadow volume be made of the
   * triangles that face away from the light alone (vtkShadowCounting::Away).
   */
  bool IsClosed() const { return this->Closed; }

  /**
   * Returns true if the surface is proven to be that of one convex body, wound outwards or inwards.
   * The proof takes rounding errors into account. If they leave the answer open, this returns
   * false. It is true for boxes, and false for most spheres, whose points are rounded.
   */
  bool IsConvex() const { return this->Convex; }

private:
  void BuildEdges();
  void BuildComponents();
  bool ProveConvex() const;

  vtkShadowPoints Points;
  std::vector<int> Triangles;
  std::vector<Edge> Edges;
  std::vector<Use> Uses;
  std::vector<int> Components;
  int NumberOfComponents = 0;
  bool Closed = false;
  bool Convex = false;
};

VTK_ABI_NAMESPACE_END
#endif
