// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BspMap.h
 * @brief A map of Quake III Arena or OpenArena (IBSP, version 46): surfaces, tree, and the table of
 * visibility that the map's compiler computed.
 *
 * The tree cuts space into convex leaves. The leaves of walls are opaque; all others belong to a
 * cluster. A cluster's row of the table lists the clusters that some point in one of its leaves may
 * see past the opaque leaves. The table is conservative: a cluster that is not in the row is hidden
 * from every point.
 *
 * The format is that which the public sources of the game read (qfiles.h, GPL-2; nothing is
 * copied).
 */
#ifndef BspMap_h
#define BspMap_h

#include "vtkNBufferGLM.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace NBufferExamples
{

/// A point in units of the map.
using BspPoint = glm::dvec3;

/// The kinds of surfaces, with their numbers in the file.
enum class BspSurface
{
  Polygon = 1,
  Patch = 2, ///< Bezier patches of 3 x 3 points each.
  Mesh = 3,
  Flare = 4 ///< The glow of a light: a point that is not drawn.
};

struct BspFace
{
  BspSurface Kind = BspSurface::Polygon;
  std::size_t FirstVertex = 0;
  std::size_t Vertices = 0;
  std::size_t FirstIndex = 0;
  std::size_t Indices = 0;
  int Width = 0;  ///< The columns of points of a patch.
  int Height = 0; ///< The rows of points of a patch.
};

struct BspMesh
{
  std::vector<BspPoint> Points;
  std::vector<std::array<int, 3>> Triangles;
};

class BspMap
{
public:
  /// The cluster of opaque leaves, and of places outside the map.
  static constexpr int Opaque = -1;

  /**
   * Reads the bytes of a file. Throws std::runtime_error with the cause if they are no map or a
   * damaged one: every number that refers to something is checked here, so that no other function
   * can fail.
   */
  explicit BspMap(const std::string& bytes);

  const std::vector<BspFace>& GetFaces() const { return this->Faces; }
  int GetNumberOfClusters() const { return this->Clusters; }

  /// Returns whether a face belongs to the world, and not to a door or a lift, which move.
  bool IsWorld(std::size_t face) const { return face < this->WorldFaces; }

  /// Returns the clusters in which a face lies, each once, in ascending order.
  const std::vector<int>& GetClusters(std::size_t face) const { return this->FaceClusters[face]; }

  /// Returns the triangles of a face. Each piece of a patch becomes `steps` x `steps` quads; a
  /// flare has no triangles.
  BspMesh GetMesh(std::size_t face, int steps) const;

  /// Returns the cluster of a point.
  int FindCluster(const BspPoint& point) const;

  /// Returns whether, by the table, something in the cluster `to` may be seen from the cluster
  /// `from`. Returns false if one of them is Opaque.
  bool MaySee(int from, int to) const;

  /// Returns how much of the straight line between two points lies in opaque leaves, in units of
  /// the map.
  double GetOpaqueLength(const BspPoint& from, const BspPoint& to) const;

  /// Returns the origins of all entities whose class name begins with `prefix`.
  std::vector<BspPoint> FindOrigins(const std::string& prefix) const;

private:
  struct Plane
  {
    glm::dvec3 Normal;
    double Distance;
  };
  struct Node
  {
    std::size_t Plane;
    int Children[2]; ///< Below 0: leaf -(child + 1).
  };
  class Reader;

  double GetDistance(std::size_t node, const BspPoint& point) const;
  void CheckTree() const;

  std::string Entities;
  std::vector<Plane> Planes;
  std::vector<Node> Nodes;
  std::vector<int> LeafClusters;
  std::vector<BspFace> Faces;
  std::vector<std::vector<int>> FaceClusters;
  std::vector<BspPoint> Vertices;
  std::vector<int> MeshIndices;
  std::size_t WorldFaces = 0;
  int Clusters = 0;
  std::size_t RowBytes = 0;
  std::string Table;
};

} // namespace NBufferExamples

#endif
