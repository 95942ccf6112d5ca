// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Coordinates of millions with details of centimetres: terrain and city where maps have them.
#include "CullerTest.h"
#include "SceneBuilder.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkPoints.h"

#if VTKNBUFFER_TEST_HAS_CITY
#include "CityFile.h"
#include "CityScene.h"
#include "Compressed.h"
#endif

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <vector>

namespace
{
/// How coordinates of millions come to be.
enum class Storage
{
  Local,   ///< Not at all: the same scene around the origin, to compare the counts with.
  Doubles, ///< In points of doubles.
  Floats,  ///< In points of floats, half a metre apart there.
  Position ///< In the position of the actor, its points around the origin.
};

/// A place as UTM gives it: east and north in metres.
constexpr double East = 3.5e5 + 0.37;
constexpr double North = 4.785e6 + 0.21;

struct World
{
  Storage How;
  glm::dvec3 Origin;

  explicit World(Storage how)
    : How(how)
    , Origin(how == Storage::Local ? glm::dvec3(0.0) : glm::dvec3(East, North, 0.0))
  {
  }

  /// Add an actor with these points around the origin, moved to its place in this way.
  void Add(Stage& stage, vtkPolyData* local) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(this->How == Storage::Doubles ? VTK_DOUBLE : VTK_FLOAT);
    const bool inPoints = this->How == Storage::Doubles || this->How == Storage::Floats;
    for (vtkIdType i = 0; i < local->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 p = glm::make_vec3(local->GetPoint(i));
      points->InsertNextPoint(glm::value_ptr(inPoints ? p + this->Origin : p));
    }
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(local);
    data->SetPoints(points);
    double color[3];
    Scenes::GetColor(static_cast<int>(stage.Props.size()), color);
    vtkActor* actor = stage.AddActor(data, color);
    if (this->How == Storage::Position)
    {
      actor->SetPosition(this->Origin.x, this->Origin.y, 0.0);
    }
  }

  void PlaceBox(Stage& stage, double x, double y, double z, double sx, double sy, double sz) const
  {
    this->Add(stage, Scenes::MakeBox({ x, y, z }, { sx, sy, sz }));
  }

  void Look(
    Stage& stage, const glm::dvec3& eye, const glm::dvec3& to, double near, double far) const
  {
    vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
    camera->SetPosition(glm::value_ptr(eye + this->Origin));
    camera->SetFocalPoint(glm::value_ptr(to + this->Origin));
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(45.0);
    camera->SetClippingRange(near, far);
  }
};

/// Elevations in metres on a grid of 3 arc seconds.
class Terrain
{
public:
  static constexpr int Side = 97;
  static constexpr int Cells = 8; ///< Of a tile, in x and y.
  static constexpr int Tiles = (Side - 1) / Cells;
  static constexpr double StepX = 74.41; ///< Metres between columns, at 36.6 degrees north
  static constexpr double StepY = 92.66; ///< and between rows.

  bool Read(const std::string& file)
  {
    std::ifstream stream(file);
    std::string line;
    while (std::getline(stream, line))
    {
      std::istringstream row(line);
      std::string value;
      while (std::getline(row, value, ','))
      {
        this->Heights.push_back(std::stod(value));
      }
    }
    return this->Heights.size() == static_cast<std::size_t>(Side) * Side;
  }

  double GetHeight(int column, int row) const { return this->Heights[row * Side + column]; }

  vtkSmartPointer<vtkPolyData> MakeTile(int tileX, int tileY) const
  {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<int>> triangles;
    for (int j = 0; j <= Cells; ++j)
    {
      for (int i = 0; i <= Cells; ++i)
      {
        const int column = tileX * Cells + i;
        const int row = tileY * Cells + j;
        const int p = static_cast<int>(points.size());
        points.emplace_back(column * StepX, row * StepY, this->GetHeight(column, row));
        if (i < Cells && j < Cells)
        {
          triangles.push_back({ p, p + 1, p + Cells + 2 });
          triangles.push_back({ p, p + Cells + 2, p + Cells + 1 });
        }
      }
    }
    return TestScene::MakeMesh(points, triangles);
  }

private:
  std::vector<double> Heights;
};

/// Hidden props over some frames, each of which the culler tests.
int CountHidden(
  Comparison& comparison, int frames, const std::function<void(Stage&, int)>& lookInFrame)
{
  int hidden = 0;
  for (int i = 0; i < frames; ++i)
  {
    comparison.Frame([&](Stage& stage) { lookInFrame(stage, i); });
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    hidden += comparison.GetHidden();
  }
  return hidden;
}

struct Way : NamedCase
{
  Storage How;
};

class CullerFarAway : public testing::TestWithParam<Way>
{
protected:
  /// Hidden props over all frames, with the scene around the origin and where it belongs.
  template <typename Run>
  void Compare(Run&& run)
  {
    const int local = run(World(Storage::Local));
    const int away = run(World(this->GetParam().How));
    EXPECT_GT(local, 0);
    // VTK moves points near to zero before it rounds them to float. What the points themselves
    // have lost is lost, and half a metre matters for boxes of centimetres.
    EXPECT_GE(away, this->GetParam().How == Storage::Floats ? local / 4 : local - local / 20)
      << "of " << local << " around the origin: slack that grows with the coordinates hides less";
  }
};
}

// Hazard: a terrain in tiles has the large coordinates of a map. Float vertices and a float matrix
// lose metres there, and slack that covers these errors hides nothing any more.
TEST_P(CullerFarAway, Terrain)
{
  Terrain terrain;
  ASSERT_TRUE(terrain.Read(VTKNBUFFER_TEST_DATA "/jacksboro-heights.csv"));
  this->Compare(
    [&terrain](const World& world)
    {
      Comparison comparison(
        [&](Stage& stage)
        {
          for (int i = 0; i < Terrain::Tiles * Terrain::Tiles; ++i)
          {
            world.Add(stage, terrain.MakeTile(i % Terrain::Tiles, i / Terrain::Tiles));
          }
        },
        Scenes::MakeExactOptions(301, 173));
      const int hidden = CountHidden(comparison, 8,
        [&](Stage& stage, int i)
        {
          const int column = 20 + 6 * i;
          const glm::dvec3 eye = { column * Terrain::StepX, 30.0 * Terrain::StepY,
            terrain.GetHeight(column, 30) + 20.0 };
          world.Look(
            stage, eye, eye + glm::dvec3(300.0 * std::sin(0.7 * i), 300.0, -20.0), 1.0, 12000.0);
        });
      EXPECT_GT(hidden, 8 * 5);
      return hidden;
    });
}

// Hazard: details of centimetres at coordinates of millions: a board must hide what is a few
// centimetres behind it, and not what sticks out by one.
TEST_P(CullerFarAway, DetailsOfCentimetres)
{
  constexpr int Count = 48;
  this->Compare(
    [](const World& world)
    {
      Comparison comparison(
        [&](Stage& stage)
        {
          world.PlaceBox(stage, 0.0, 3.0, 1.0, 1.6, 0.02, 1.0); // the board
          for (int i = 0; i < Count; ++i)
          {
            const double x = 0.03 * i - 0.72;
            world.PlaceBox(stage, x, 3.10, 1.1, 0.02, 0.02, 0.02); // behind
            world.PlaceBox(stage, x, 3.03, 1.5, 0.02, 0.02, 0.02); // sticks out by 1 cm
            world.PlaceBox(stage, x, 2.96, 1.3, 0.02, 0.02, 0.02); // before
          }
        },
        Scenes::MakeExactOptions(401, 301));
      int hidden = 0;
      for (int i = 0; i < 5; ++i)
      {
        comparison.Frame(
          [&](Stage& stage) {
            world.Look(stage, { 0.01 * i, 0.0, 1.5 }, { 0.01 * i, 3.0, 1.2 }, 0.5, 500.0);
          });
        hidden += comparison.GetHidden();
        for (int k = 0; k < Count; ++k)
        {
          const auto has = [&](int prop, Verdict verdict)
          { return world.How == Storage::Floats || comparison.GetVerdict(prop) == verdict; };
          EXPECT_TRUE(i < 3 || has(1 + 3 * k, Verdict::Hidden)) << k;
          EXPECT_TRUE(has(2 + 3 * k, Verdict::Visible)) << k;
          EXPECT_TRUE(has(3 + 3 * k, Verdict::Visible)) << k;
        }
      }
      return hidden;
    });
}

// Hazard: a real city whose buildings have the large coordinates of a map.
TEST_P(CullerFarAway, City)
{
#if VTKNBUFFER_TEST_HAS_CITY
  const NBufferExamples::City city = NBufferExamples::ReadCity(VTKNBUFFER_TEST_CITY);
  std::vector<vtkSmartPointer<vtkPolyData>> buildings;
  for (const NBufferExamples::CityBuilding& building : city.Buildings)
  {
    const NBufferExamples::CityPoint& point = building.Rings.front().front();
    if (std::hypot(point.X, point.Y) < 45000.0) // cm
    {
      buildings.emplace_back(NBufferExamples::MakeBuilding(building));
    }
  }
  ASSERT_GT(buildings.size(), 100u);
  this->Compare(
    [&buildings](const World& world)
    {
      Comparison comparison(
        [&](Stage& stage)
        {
          world.PlaceBox(stage, 0.0, 0.0, -0.5, 1000.0, 1000.0, 1.0);
          for (const auto& building : buildings)
          {
            world.Add(stage, building);
          }
        },
        Scenes::MakeExactOptions(301, 173));
      const int hidden = CountHidden(comparison, 8,
        [&](Stage& stage, int i)
        {
          const glm::dvec3 eye = { 3.0 * i, -2.0 * i, 2.0 + i };
          world.Look(
            stage, eye, eye + glm::dvec3(std::sin(0.8 * i), std::cos(0.8 * i), 0.0), 0.3, 1500.0);
        });
      EXPECT_GT(hidden, 8 * 20);
      return hidden;
    });
#else
  GTEST_SKIP() << "built without the examples, which read the city";
#endif
}

// Hazard: a file gives large coordinates of a map with six digits, so that points are ten metres
// apart and triangles are slivers. The terrain is not part of this repository.
TEST_P(CullerFarAway, TerrainOfAFile)
{
  const char* file = std::getenv("VTKNBUFFER_TEST_TERRAIN");
  if (!file)
  {
    GTEST_SKIP() << "VTKNBUFFER_TEST_TERRAIN does not name an ASCII STL file (it may be "
                    "compressed by gzip)";
  }
#if VTKNBUFFER_TEST_HAS_CITY
  std::istringstream stream(NBufferExamples::ReadMaybeCompressed(file));
  std::vector<glm::dvec3> corners;
  glm::dvec3 low(HUGE_VAL);
  glm::dvec3 high(-HUGE_VAL);
  std::string word;
  while (stream >> word)
  {
    glm::dvec3 p;
    if (word == "vertex" && stream >> p[0] >> p[1] >> p[2])
    {
      corners.push_back(p);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  ASSERT_GE(corners.size(), 3u);
  World world(this->GetParam().How);
  world.Origin = { low.x, low.y, 0.0 };
  // Tiles of a twelfth of the whole.
  std::map<std::pair<int, int>, std::vector<glm::dvec3>> tiles;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    const auto cell = [&](int k)
    { return static_cast<int>(12.0 * (corners[i][k] - low[k]) / (high[k] - low[k] + 1.0)); };
    for (std::size_t k = i; k < i + 3; ++k)
    {
      tiles[{ cell(0), cell(1) }].push_back(corners[k] - world.Origin);
    }
  }
  Comparison comparison(
    [&](Stage& stage)
    {
      for (const auto& [place, points] : tiles)
      {
        std::vector<std::vector<int>> triangles;
        for (int i = 0; i < static_cast<int>(points.size()); i += 3)
        {
          triangles.push_back({ i, i + 1, i + 2 });
        }
        world.Add(stage, TestScene::MakeMesh(points, triangles));
      }
    },
    Scenes::MakeExactOptions(301, 173));
  const glm::dvec3 size = high - low;
  const int hidden = CountHidden(comparison, 8,
    [&](Stage& stage, int i)
    {
      world.Look(stage, { 0.125 * i * size.x, -60.0, low.z + 40.0 },
        { 0.5 * size.x, size.y, low.z }, 1.0, 3000.0);
    });
  EXPECT_GT(hidden, 0);
#else
  GTEST_SKIP() << "built without the examples, which read compressed files";
#endif
}

INSTANTIATE_TEST_SUITE_P(Each, CullerFarAway,
  testing::Values(Way{ "Doubles", Storage::Doubles }, Way{ "Floats", Storage::Floats },
    Way{ "Position", Storage::Position }),
  GetCaseName);
