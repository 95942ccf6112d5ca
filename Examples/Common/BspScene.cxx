// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneKinds.h"

#include "BspMap.h"
#include "Compressed.h"
#include "Parts.h"
#include "Random.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
namespace fs = std::filesystem;
using MapPointer = std::shared_ptr<const BspMap>;

// Units of the map.
constexpr double PlayerEyeHeight = 26.0; // above the origin of a player
constexpr double PlayerStep = 12.0;
constexpr double PlayerClearance = 16.0;
constexpr double PlayerLookAhead = 48.0;
constexpr double NearPlane = 4.0;
constexpr int PatchSteps = 4;

/// The faces of each actor.
using Parts = std::vector<std::vector<std::size_t>>;

Parts MakeParts(const BspMap& map, bool byClusters)
{
  std::map<int, std::vector<std::size_t>> byCluster;
  Parts parts;
  for (std::size_t face = 0; face < map.GetFaces().size(); ++face)
  {
    if (map.GetMesh(face, 1).Triangles.empty())
    {
      continue;
    }
    const std::vector<int>& clusters = map.GetClusters(face);
    if (byClusters && map.IsWorld(face) && !clusters.empty())
    {
      byCluster[clusters.front()].push_back(face);
    }
    else
    {
      parts.push_back({ face });
    }
  }
  for (const auto& cluster : byCluster)
  {
    parts.push_back(cluster.second);
  }
  return parts;
}

vtkSmartPointer<vtkPolyData> MakeFaceMesh(const BspMap& map, const std::vector<std::size_t>& faces)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (std::size_t face : faces)
  {
    const BspMesh mesh = map.GetMesh(face, PatchSteps);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const BspPoint& point : mesh.Points)
    {
      points->InsertNextPoint(glm::value_ptr(point));
    }
    for (const auto& triangle : mesh.Triangles)
    {
      triangles->InsertNextCell({ first + triangle[0], first + triangle[1], first + triangle[2] });
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

class BspVisibility : public PotentiallyVisibleSet
{
public:
  BspVisibility(MapPointer map, const Parts& parts)
    : Map(std::move(map))
  {
    for (const std::vector<std::size_t>& part : parts)
    {
      std::set<int> clusters;
      bool known = true;
      for (std::size_t face : part)
      {
        const std::vector<int>& more = this->Map->GetClusters(face);
        known = known && this->Map->IsWorld(face) && !more.empty();
        clusters.insert(more.begin(), more.end());
      }
      this->Clusters.push_back(known ? clusters : std::set<int>());
    }
  }

  std::vector<char> Find(const glm::dvec3& eye) const override
  {
    const int from = this->Map->FindCluster(eye);
    if (from == BspMap::Opaque)
    {
      return {};
    }
    std::vector<char> visible;
    visible.reserve(this->Clusters.size());
    for (const std::set<int>& clusters : this->Clusters)
    {
      visible.push_back(clusters.empty() ||
        std::any_of(
          clusters.begin(), clusters.end(), [&](int to) { return this->Map->MaySee(from, to); }));
    }
    return visible;
  }

  bool IsKnown(int actor) const override
  {
    return !this->Clusters[static_cast<std::size_t>(actor)].empty();
  }

  bool IsBlocked(const glm::dvec3& from, const glm::dvec3& to) const override
  {
    // A unit is what the place of a pixel may be behind the surface, which bounds opaque leaves.
    constexpr double tolerance = 1.0;
    return this->Map->GetOpaqueLength(from, to) > tolerance;
  }

private:
  MapPointer Map;
  /// The clusters of each actor; none if they are unknown.
  std::vector<std::set<int>> Clusters;
};

/// Returns whether no opaque wall is within the clearance.
bool IsFree(const BspMap& map, const BspPoint& eye)
{
  bool free = true;
  for (int i = 0; i < 27 && free; ++i)
  {
    const BspPoint step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    free = map.FindCluster(eye + PlayerClearance * step) != BspMap::Opaque;
  }
  return free;
}

std::vector<BspPoint> FindStarts(const BspMap& map)
{
  std::vector<BspPoint> starts;
  for (const char* prefix : { "info_player_", "team_CTF_" })
  {
    for (BspPoint origin : map.FindOrigins(prefix))
    {
      origin[2] += PlayerEyeHeight;
      if (IsFree(map, origin))
      {
        starts.push_back(origin);
      }
    }
  }
  return starts;
}

CameraPath MakePlayerWalk(const BspMap& map, int frames, std::uint64_t seed)
{
  const std::vector<BspPoint> starts = FindStarts(map);
  if (starts.empty())
  {
    throw std::runtime_error(
      "the map has no start of a player that is free of walls; take orbit or cuts");
  }
  // Another start after each sixth, to see more of the map.
  const int stretch = std::max(10, (frames + 5) / 6);
  Random random(seed);
  CameraPath path;
  BspPoint eye(0.0);
  double yaw = 0.0;
  for (int i = 0; i < frames; ++i)
  {
    const auto ahead = [&](double distance)
    { return eye + distance * BspPoint(std::cos(yaw), std::sin(yaw), 0.0); };
    if (i % stretch == 0)
    {
      eye = starts[random.Index(starts.size())];
      yaw = random.Between(0.0, 2.0 * vtkMath::Pi());
    }
    else
    {
      const auto isFree = [&]()
      {
        return IsFree(map, ahead(PlayerStep)) &&
          map.GetOpaqueLength(eye, ahead(PlayerLookAhead)) == 0.0;
      };
      yaw += random.Between(-0.03, 0.03);
      for (int turns = 0; turns < 12 && !isFree(); ++turns)
      {
        yaw += 0.5;
      }
      eye = isFree() ? ahead(PlayerStep) : eye;
    }
    // 90 degrees wide at 4 to 3, the game's default.
    path.push_back({ eye, ahead(1.0), { 0.0, 0.0, 1.0 }, 73.74, NearPlane, 8192.0 });
  }
  return path;
}

/// Returns the file of a name, and the kind of its actors.
std::pair<std::string, std::string> Split(const std::string& name)
{
  std::smatch words;
  return std::regex_match(name, words, std::regex("(.+):(faces|clusters)"))
    ? std::make_pair(words[1].str(), words[2].str())
    : std::make_pair(name, std::string("faces"));
}
}

bool IsBspName(const std::string& name)
{
  fs::path file = Split(name).first;
  if (file.extension() == ".gz")
  {
    file.replace_extension();
  }
  return file.extension() == ".bsp";
}

Scene LoadBsp(const std::string& name)
{
  const auto [file, parts] = Split(name);
  const MapPointer map =
    ParseFile(file, [](const std::string& bytes) { return std::make_shared<const BspMap>(bytes); });
  const Parts faces = MakeParts(*map, parts == "clusters");
  if (faces.empty())
  {
    throw std::runtime_error(file + ": the map has nothing to draw");
  }
  Scene scene;
  scene.Name = fs::path(file).filename().string() + " " + parts;
  for (const std::vector<std::size_t>& part : faces)
  {
    AddPart(scene, MakePartMapper(MakeFaceMesh(*map, part)));
  }
  scene.Known = std::make_shared<const BspVisibility>(map, faces);
  scene.Paths = { { "walk",
    [map](int frames, std::uint64_t seed) { return MakePlayerWalk(*map, frames, seed); } } };
  return scene;
}

} // namespace NBufferExamples
