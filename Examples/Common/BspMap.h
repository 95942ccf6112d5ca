// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BspMap.h
 * @brief A map of Quake III Arena or OpenArena (IBSP, version 46): surfaces, tree, and the table of
 * what can be seen from where that its compiler worked out.
 *
 * The tree cuts space into convex leaves. Leaves of walls are opaque, all others belong to a
 * cluster. A cluster's row of the table has the clusters that any point of any of its leaves may
 * see past the opaque leaves: conservative, so that what it leaves out is hidden from all of them.
 *
 * Source: the format as the public sources of the game read it (qfiles.h, GPL-2; nothing copied).
 */
#ifndef BspMap_h
#define BspMap_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace NBufferExamples
{

using BspPoint = std::array<double, 3>;

/// Kinds of surfaces, by the numbers of the file.
enum class BspSurface
{
  Polygon = 1,
  Patch = 2, ///< Bezier pieces of 3 x 3 points.
  Mesh = 3,
  Flare = 4 ///< A light's glow: a point, nothing to draw.
};

struct BspFace
{
  BspSurface Kind = BspSurface::Polygon;
  std::size_t FirstVertex = 0;
  std::size_t Vertices = 0;
  std::size_t FirstIndex = 0;
  std::size_t Indices = 0;
  int Width = 0;  ///< Points of a patch.
  int Height = 0; ///< Points of a patch.
};

struct BspMesh
{
  std::vector<BspPoint> Points;
  std::vector<std::array<int, 3>> Triangles;
};

class BspMap
{
public:
  /// Cluster of opaque leaves, and of places outside of the map.
  static constexpr int Opaque = -1;

  /**
   * From the bytes of a file. Throws std::runtime_error that says what is wrong with it: every
   * number that refers to something is checked, so that no other function can fail.
   */
  explicit BspMap(const std::string& bytes);

  const std::vector<BspFace>& GetFaces() const { return this->Faces; }
  int GetNumberOfClusters() const { return this->Clusters; }

  /// Whether a face belongs to the world, not to a door or a lift, which move.
  bool IsWorld(std::size_t face) const { return face < this->WorldFaces; }

  /// The clusters that a face lies in, each once, in ascending order; empty for what is in none.
  const std::vector<int>& GetClusters(std::size_t face) const { return this->FaceClusters[face]; }

  /// Triangles of a face; patches in `steps` x `steps` quads for each piece. None for a flare.
  BspMesh GetMesh(std::size_t face, int steps) const;

  int FindCluster(const BspPoint& point) const;

  /// Whether the table says that something in `to` may be seen from `from`. From and to opaque
  /// leaves: no.
  bool MaySee(int from, int to) const;

  /// How much of the straight way lies in opaque leaves, in units of the map.
  double GetOpaqueLength(const BspPoint& from, const BspPoint& to) const;

  /// "x y z" of all entities whose class name begins with `prefix`.
  std::vector<BspPoint> FindOrigins(const std::string& prefix) const;

private:
  struct Plane
  {
    double Normal[3];
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
