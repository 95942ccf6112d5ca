// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowTopology
 * @brief Which triangles of a caster share which edges, whatever the mesh. No OpenGL.
 *
 * Points are one if their coordinates are equal to the bit (-0 equals 0): meshes that repeat points
 * for normals or texture coordinates are closed all the same. Edges are undirected pairs of merged
 * points, each with the list of its uses: the triangle and whether it runs along the edge (+1) or
 * against it (-1). Nothing is demanded of the mesh: open edges have one use, non-manifold ones
 * three and more, badly wound ones two of the same direction (B. Kim, K. Kim, G. Turk, "A shadow-
 * volume algorithm for opaque and transparent nonmanifold casters", Journal of Graphics Tools
 * 13(3), 2008).
 *
 * Left out are triangles that use a merged point twice (no area, and their edges cancel) and those
 * with a coordinate that is not finite (counted).
 *
 * It depends on the coordinates before any matrix only, so that it is built once per mesh: an
 * invertible affine matrix moves equal points to equal places, and keeps convex what is convex.
 *
 * Cost: a hash of the points and a sort of the edges, O(n log n).
 */
#ifndef vtkShadowTopology_h
#define vtkShadowTopology_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowTopology
{
public:
  struct Edge
  {
    int A = 0;     ///< Merged point, less than B.
    int B = 0;     ///< Merged point.
    int First = 0; ///< First of its uses in GetUses().
    int Count = 0; ///< Number of its uses.
  };

  struct Use
  {
    int Triangle = 0;
    int Direction = 0; ///< 1: the triangle goes from A to B, -1: from B to A.
  };

  /**
   * `points`: xyz of each point. `triangles`: three indices of points each, at most 2^31 / 3
   * triangles; indices out of range drop the triangle as if a coordinate were not finite.
   */
  void Build(const double* points, vtkIdType numberOfPoints, const vtkIdType* triangles,
    vtkIdType numberOfTriangles);

  /// Merged points that triangles use, xyz each, in order of first use.
  const std::vector<double>& GetPoints() const { return this->Points; }
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size() / 3); }

  /// Three merged points for each triangle that was kept, wound as given.
  const std::vector<int>& GetTriangles() const { return this->Triangles; }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size() / 3); }

  /// Sorted by A, then B. The uses of an edge are in the order of their triangles.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }
  const std::vector<Use>& GetUses() const { return this->Uses; }

  /// For each triangle the number, from 0, of the part of the mesh that hangs together by edges.
  const std::vector<int>& GetComponents() const { return this->Components; }
  int GetNumberOfComponents() const { return this->NumberOfComponents; }

  /// Triangles left out for want of area or of finite coordinates.
  vtkIdType GetNumberOfDegenerates() const { return this->Degenerates; }

  /**
   * True if every edge is run along as often as against: the surface is closed, and every line
   * that enters it leaves it. Only then may a volume be made of the lit triangles alone.
   */
  bool IsClosed() const { return this->Closed; }

  /**
   * True if the surface is proven to be that of one convex body, wound outwards or inwards.
   * Rounding errors are bounded: what cannot be decided is not convex. Spheres, whose coordinates
   * are rounded off the sphere, mostly are not; boxes are.
   */
  bool IsConvex() const { return this->Convex; }

private:
  void BuildEdges();
  void BuildComponents();
  bool ProveConvex() const;

  std::vector<double> Points;
  std::vector<int> Triangles;
  std::vector<Edge> Edges;
  std::vector<Use> Uses;
  std::vector<int> Components;
  int NumberOfComponents = 0;
  vtkIdType Degenerates = 0;
  bool Closed = false;
  bool Convex = false;
};

VTK_ABI_NAMESPACE_END
#endif
