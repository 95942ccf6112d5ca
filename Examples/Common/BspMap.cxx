// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BspMap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
constexpr std::size_t LumpCount = 17;
constexpr int Version = 46;

/// Places in the directory, and bytes of an entry.
enum Lump : std::size_t
{
  EntitiesLump = 0,
  PlanesLump = 2,
  NodesLump = 3,
  LeavesLump = 4,
  LeafFacesLump = 5,
  ModelsLump = 7,
  VerticesLump = 10,
  IndicesLump = 11,
  FacesLump = 13,
  VisibilityLump = 16
};

template <typename... Words>
[[noreturn]] void Fail(const Words&... words)
{
  std::ostringstream text;
  (text << "damaged map: " << ... << words);
  throw std::runtime_error(text.str());
}

/// The Bernstein polynomials of the second degree.
glm::dvec3 GetWeights(double t)
{
  return { (1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t };
}
}

/// Numbers of a lump, little-endian.
class BspMap::Reader
{
public:
  Reader(const std::string& bytes, Lump lump, std::size_t entrySize, const std::string& name)
    : Name(name)
    , EntrySize(entrySize)
  {
    constexpr std::size_t header = 8;
    const std::uint64_t offset = Get(bytes, header + 8 * lump);
    const std::uint64_t length = Get(bytes, header + 8 * lump + 4);
    if (offset + length > bytes.size())
    {
      Fail("its ", name, " end after the file does");
    }
    if (length % entrySize != 0)
    {
      Fail("its ", name, " are no whole number of entries");
    }
    this->Bytes = bytes.substr(offset, length);
  }

  std::size_t GetCount() const { return this->Bytes.size() / this->EntrySize; }
  const std::string& GetBytes() const { return this->Bytes; }

  int GetInt(std::size_t entry, std::size_t offset) const
  {
    return static_cast<int>(Get(this->Bytes, entry * this->EntrySize + offset));
  }

  double GetFloat(std::size_t entry, std::size_t offset) const
  {
    const std::uint32_t bits = Get(this->Bytes, entry * this->EntrySize + offset);
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof(value));
    if (!std::isfinite(value))
    {
      Fail("a number of its ", this->Name, " is not finite");
    }
    return value;
  }

  BspPoint GetPoint(std::size_t entry, std::size_t offset) const
  {
    return { this->GetFloat(entry, offset), this->GetFloat(entry, offset + 4),
      this->GetFloat(entry, offset + 8) };
  }

  /// An index below `count`.
  std::size_t GetIndex(std::size_t entry, std::size_t offset, std::size_t count) const
  {
    const int index = this->GetInt(entry, offset);
    if (index < 0 || static_cast<std::size_t>(index) >= count)
    {
      Fail("entry ", entry, " of its ", this->Name, " refers to ", index, " of ", count);
    }
    return static_cast<std::size_t>(index);
  }

  /// The first of as many entries as the number after it says, all below `count`.
  std::size_t GetRange(
    std::size_t entry, std::size_t offset, std::size_t count, std::size_t& length) const
  {
    const int first = this->GetInt(entry, offset);
    const int size = this->GetInt(entry, offset + 4);
    if (first < 0 || size < 0 ||
      static_cast<std::uint64_t>(first) + static_cast<std::uint64_t>(size) > count)
    {
      Fail("entry ", entry, " of its ", this->Name, " refers to ", size, " entries from ", first,
        " on, of ", count);
    }
    length = static_cast<std::size_t>(size);
    return static_cast<std::size_t>(first);
  }

  static std::uint32_t Get(const std::string& bytes, std::size_t at)
  {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    return value;
  }

private:
  std::string Name;
  std::string Bytes;
  std::size_t EntrySize;
};

BspMap::BspMap(const std::string& bytes)
{
  if (bytes.compare(0, 4, "IBSP") != 0)
  {
    throw std::runtime_error("no map: it does not begin with IBSP");
  }
  if (bytes.size() < 8 + 8 * LumpCount)
  {
    Fail("its directory ends after the file does");
  }
  const auto version = static_cast<int>(Reader::Get(bytes, 4));
  if (version != Version)
  {
    throw std::runtime_error(
      "a map of version " + std::to_string(version) + ", and only 46 (Quake III) is known");
  }
  this->Entities = Reader(bytes, EntitiesLump, 1, "entities").GetBytes();

  const Reader planes(bytes, PlanesLump, 16, "planes");
  for (std::size_t i = 0; i < planes.GetCount(); ++i)
  {
    this->Planes.push_back({ planes.GetPoint(i, 0), planes.GetFloat(i, 12) });
  }

  const Reader table(bytes, VisibilityLump, 1, "table of visibility");
  if (table.GetBytes().size() < 8)
  {
    throw std::runtime_error("the map was compiled without its table of visibility");
  }
  const std::uint32_t clusters = Reader::Get(table.GetBytes(), 0);
  this->RowBytes = Reader::Get(table.GetBytes(), 4);
  this->Table = table.GetBytes().substr(8);
  if (clusters == 0 || this->RowBytes < (static_cast<std::uint64_t>(clusters) + 7) / 8 ||
    this->RowBytes > this->Table.size() || this->Table.size() / this->RowBytes < clusters)
  {
    Fail("its table of visibility has not the size that it says");
  }
  this->Clusters = static_cast<int>(clusters);

  const Reader leaves(bytes, LeavesLump, 48, "leaves");
  const Reader nodes(bytes, NodesLump, 36, "nodes");
  for (std::size_t i = 0; i < nodes.GetCount(); ++i)
  {
    Node node = { nodes.GetIndex(i, 0, this->Planes.size()), {} };
    for (std::size_t side = 0; side < 2; ++side)
    {
      const int child = nodes.GetInt(i, 4 + 4 * side);
      const std::size_t place =
        static_cast<std::size_t>(child >= 0 ? child : -(static_cast<long long>(child) + 1));
      if (place >= (child >= 0 ? nodes.GetCount() : leaves.GetCount()))
      {
        Fail("node ", i, " has no child ", child);
      }
      node.Children[side] = child;
    }
    this->Nodes.push_back(node);
  }
  this->CheckTree();

  const Reader vertices(bytes, VerticesLump, 44, "vertices");
  for (std::size_t i = 0; i < vertices.GetCount(); ++i)
  {
    this->Vertices.push_back(vertices.GetPoint(i, 0));
  }
  const Reader indices(bytes, IndicesLump, 4, "mesh indices");
  for (std::size_t i = 0; i < indices.GetCount(); ++i)
  {
    this->MeshIndices.push_back(indices.GetInt(i, 0));
  }

  const Reader faces(bytes, FacesLump, 104, "faces");
  for (std::size_t i = 0; i < faces.GetCount(); ++i)
  {
    const int kind = faces.GetInt(i, 8);
    if (kind < 1 || kind > 4)
    {
      Fail("face ", i, " is of the unknown kind ", kind);
    }
    BspFace face;
    face.Kind = static_cast<BspSurface>(kind);
    face.FirstVertex = faces.GetRange(i, 12, this->Vertices.size(), face.Vertices);
    face.FirstIndex = faces.GetRange(i, 20, this->MeshIndices.size(), face.Indices);
    face.Width = faces.GetInt(i, 96);
    face.Height = faces.GetInt(i, 100);
    if (face.Kind == BspSurface::Patch)
    {
      const bool isGrid = face.Width >= 3 && face.Height >= 3 && face.Width % 2 == 1 &&
        face.Height % 2 == 1 &&
        static_cast<std::uint64_t>(face.Width) * static_cast<std::uint64_t>(face.Height) ==
          face.Vertices;
      if (!isGrid)
      {
        Fail("patch ", i, " of ", face.Width, " x ", face.Height, " points has ", face.Vertices);
      }
    }
    else if (face.Kind != BspSurface::Flare)
    {
      for (std::size_t k = 0; k < face.Indices; ++k)
      {
        const int index = this->MeshIndices[face.FirstIndex + k];
        if (index < 0 || static_cast<std::size_t>(index) >= face.Vertices)
        {
          Fail("face ", i, " of ", face.Vertices, " vertices has the index ", index);
        }
      }
    }
    this->Faces.push_back(face);
  }

  const Reader models(bytes, ModelsLump, 40, "models");
  if (models.GetCount() == 0)
  {
    Fail("it has no world");
  }
  if (models.GetRange(0, 24, this->Faces.size(), this->WorldFaces) != 0)
  {
    Fail("its world does not begin with the first face");
  }

  const Reader leafFaces(bytes, LeafFacesLump, 4, "faces of leaves");
  this->FaceClusters.resize(this->Faces.size());
  for (std::size_t i = 0; i < leaves.GetCount(); ++i)
  {
    const int cluster = leaves.GetInt(i, 0);
    if (cluster >= this->Clusters)
    {
      Fail("leaf ", i, " is in cluster ", cluster, " of ", this->Clusters);
    }
    this->LeafClusters.push_back(cluster < 0 ? Opaque : cluster);
    std::size_t count = 0;
    const std::size_t first = leaves.GetRange(i, 32, leafFaces.GetCount(), count);
    for (std::size_t k = first; k < first + count; ++k)
    {
      const std::size_t face = leafFaces.GetIndex(k, 0, this->Faces.size());
      if (cluster >= 0)
      {
        this->FaceClusters[face].push_back(cluster);
      }
    }
  }
  for (std::vector<int>& list : this->FaceClusters)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

void BspMap::CheckTree() const
{
  if (this->Nodes.empty())
  {
    Fail("it has no nodes");
  }
  std::vector<char> seen(this->Nodes.size(), 0);
  std::vector<std::size_t> open = { 0 };
  while (!open.empty())
  {
    const std::size_t node = open.back();
    open.pop_back();
    if (seen[node])
    {
      Fail("node ", node, " has two parents");
    }
    seen[node] = 1;
    for (int child : this->Nodes[node].Children)
    {
      if (child >= 0)
      {
        open.push_back(static_cast<std::size_t>(child));
      }
    }
  }
}

BspMesh BspMap::GetMesh(std::size_t face, int steps) const
{
  const BspFace& surface = this->Faces[face];
  BspMesh mesh;
  if (surface.Kind == BspSurface::Flare)
  {
    return mesh;
  }
  const BspPoint* points = this->Vertices.data() + surface.FirstVertex;
  if (surface.Kind != BspSurface::Patch)
  {
    mesh.Points.assign(points, points + surface.Vertices);
    for (std::size_t i = 0; i + 2 < surface.Indices; i += 3)
    {
      const int* index = this->MeshIndices.data() + surface.FirstIndex + i;
      mesh.Triangles.push_back({ index[0], index[1], index[2] });
    }
    return mesh;
  }
  // One grid over all pieces, so that they share the points between them.
  const int columns = (surface.Width - 1) / 2 * steps + 1;
  const int rows = (surface.Height - 1) / 2 * steps + 1;
  for (int row = 0; row < rows; ++row)
  {
    const int pieceY = std::min(row / steps, (surface.Height - 3) / 2);
    const glm::dvec3 v = GetWeights(static_cast<double>(row - pieceY * steps) / steps);
    for (int column = 0; column < columns; ++column)
    {
      const int pieceX = std::min(column / steps, (surface.Width - 3) / 2);
      const glm::dvec3 u = GetWeights(static_cast<double>(column - pieceX * steps) / steps);
      BspPoint sum(0.0);
      for (int y = 0; y < 3; ++y)
      {
        for (int x = 0; x < 3; ++x)
        {
          sum += u[x] * v[y] * points[(2 * pieceY + y) * surface.Width + 2 * pieceX + x];
        }
      }
      mesh.Points.push_back(sum);
      if (row > 0 && column > 0)
      {
        const int here = row * columns + column;
        mesh.Triangles.push_back({ here - columns - 1, here - columns, here });
        mesh.Triangles.push_back({ here - columns - 1, here, here - 1 });
      }
    }
  }
  return mesh;
}

double BspMap::GetDistance(std::size_t node, const BspPoint& point) const
{
  const Plane& plane = this->Planes[this->Nodes[node].Plane];
  return glm::dot(plane.Normal, point) - plane.Distance;
}

int BspMap::FindCluster(const BspPoint& point) const
{
  int child = 0;
  while (child >= 0)
  {
    const auto node = static_cast<std::size_t>(child);
    child = this->Nodes[node].Children[this->GetDistance(node, point) >= 0.0 ? 0 : 1];
  }
  return this->LeafClusters[static_cast<std::size_t>(-(child + 1))];
}

bool BspMap::MaySee(int from, int to) const
{
  if (from < 0 || to < 0 || from >= this->Clusters || to >= this->Clusters)
  {
    return false;
  }
  const std::size_t byte =
    static_cast<std::size_t>(from) * this->RowBytes + static_cast<std::size_t>(to) / 8;
  return (static_cast<unsigned char>(this->Table[byte]) >> (to % 8) & 1) != 0;
}

double BspMap::GetOpaqueLength(const BspPoint& from, const BspPoint& to) const
{
  struct Piece
  {
    int Child;
    BspPoint From, To;
  };
  double length = 0.0;
  std::vector<Piece> open = { { 0, from, to } };
  while (!open.empty())
  {
    const Piece piece = open.back();
    open.pop_back();
    if (piece.Child < 0)
    {
      if (this->LeafClusters[static_cast<std::size_t>(-(piece.Child + 1))] == Opaque)
      {
        length += std::hypot(
          piece.To[0] - piece.From[0], piece.To[1] - piece.From[1], piece.To[2] - piece.From[2]);
      }
      continue;
    }
    const auto node = static_cast<std::size_t>(piece.Child);
    const double a = this->GetDistance(node, piece.From);
    const double b = this->GetDistance(node, piece.To);
    const int* children = this->Nodes[node].Children;
    if ((a >= 0.0) == (b >= 0.0))
    {
      open.push_back({ children[a >= 0.0 ? 0 : 1], piece.From, piece.To });
      continue;
    }
    const BspPoint middle = piece.From + a / (a - b) * (piece.To - piece.From);
    open.push_back({ children[a >= 0.0 ? 0 : 1], piece.From, middle });
    open.push_back({ children[b >= 0.0 ? 0 : 1], middle, piece.To });
  }
  return length;
}

std::vector<BspPoint> BspMap::FindOrigins(const std::string& prefix) const
{
  std::vector<BspPoint> origins;
  // { "key" "value" ... } of every entity.
  std::istringstream lines(this->Entities);
  std::string name;
  std::string origin;
  for (std::string line; std::getline(lines, line);)
  {
    const auto take = [&line](const std::string& key, std::string& value)
    {
      const std::string begin = "\"" + key + "\" \"";
      if (line.rfind(begin, 0) == 0)
      {
        value = line.substr(begin.size(), line.find('"', begin.size()) - begin.size());
      }
    };
    take("classname", name);
    take("origin", origin);
    if (line.find('}') == 0)
    {
      BspPoint point(0.0);
      std::istringstream numbers(origin);
      if (name.rfind(prefix, 0) == 0 && numbers >> point[0] >> point[1] >> point[2])
      {
        origins.push_back(point);
      }
      name.clear();
      origin.clear();
    }
  }
  return origins;
}

} // namespace NBufferExamples
