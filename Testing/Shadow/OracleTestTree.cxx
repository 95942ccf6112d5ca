// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The tree against all triangles, and against VTK's locator.
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace
{
using TreeTest = OffscreenFixture;

double GetRandom(std::mt19937& random)
{
  return static_cast<double>(random() % 20001) / 10000.0 - 1.0;
}

/// The triangles that the ray crosses, by testing all.
std::set<int> GetCrossings(const std::vector<double>& corners, const Ray& ray)
{
  std::set<int> result;
  const PreparedRay prepared(ray);
  for (std::size_t i = 0; i < corners.size() / 9; ++i)
  {
    double t;
    if (prepared.Intersect(&corners[9 * i], t) && t > ray.Near && t < ray.Far)
    {
      result.insert(static_cast<int>(i));
    }
  }
  return result;
}

double GetDistance(const std::vector<double>& corners, const Ray& ray, int triangle)
{
  double t = VTK_DOUBLE_MAX;
  PreparedRay(ray).Intersect(&corners[9 * static_cast<std::size_t>(triangle)], t);
  return t;
}

void ExpectSameRay(const TriangleTree& tree, const std::vector<double>& corners, const Ray& ray)
{
  const std::set<int> expected = GetCrossings(corners, ray);
  std::set<int> found;
  tree.VisitCrossings(ray,
    [&](int triangle, double t)
    {
      EXPECT_EQ(t, GetDistance(corners, ray, triangle));
      EXPECT_TRUE(found.insert(triangle).second) << triangle << " was found twice";
      return true;
    });
  ASSERT_EQ(found, expected) << "from " << ray.Origin[0] << " " << ray.Origin[1] << " "
                             << ray.Origin[2] << " along " << ray.Direction[0] << " "
                             << ray.Direction[1] << " " << ray.Direction[2] << " up to " << ray.Far;
  double nearest = std::numeric_limits<double>::infinity();
  for (const int triangle : expected)
  {
    nearest = std::min(nearest, GetDistance(corners, ray, triangle));
  }
  ASSERT_EQ(tree.FindNearest(ray).T, nearest);
  ASSERT_EQ(tree.FindNearest(ray).Triangle < 0, expected.empty());
}
}

TEST_F(TreeTest, RandomTriangles)
{
  std::mt19937 random(5);
  for (const int count : { 0, 1, 4, 5, 9, 300 })
  {
    std::vector<double> corners(9 * count);
    std::generate(corners.begin(), corners.end(), [&random]() { return GetRandom(random); });
    TriangleTree tree;
    tree.Build(corners);
    EXPECT_EQ(tree.GetNumberOfTriangles(), count);
    for (int i = 0; i < 500; ++i)
    {
      SCOPED_TRACE(i);
      Ray ray;
      for (int k = 0; k < 3; ++k)
      {
        ray.Origin[k] = 2.0 * GetRandom(random);
        // Every fourth ray is along an axis.
        ray.Direction[k] = i % 4 == 0 ? (i / 4 % 3 == k) : GetRandom(random);
      }
      ray.Far = i % 2 ? 1.0 : ray.Far;
      ASSERT_NO_FATAL_FAILURE(ExpectSameRay(tree, corners, ray));
    }
  }
}

// Rays are along axes, in the planes of faces and boxes, and through corners and edges.
TEST_F(TreeTest, TrianglesOnAGrid)
{
  std::mt19937 random(6);
  const auto grid = [&random]() { return static_cast<double>(random() % 4); };
  std::vector<double> corners(9 * 200);
  std::generate(corners.begin(), corners.end(), grid);
  TriangleTree tree;
  tree.Build(corners);
  for (int i = 0; i < 3000; ++i)
  {
    SCOPED_TRACE(i);
    Ray ray = { { grid(), grid(), grid() }, { grid() - 1.0, grid() - 1.0, grid() - 1.0 } };
    if (vtkMath::Norm(ray.Direction) > 0.0)
    {
      ASSERT_NO_FATAL_FAILURE(ExpectSameRay(tree, corners, ray));
    }
  }
}

// Rays from inside of a closed mesh through its edges and corners must cross a triangle.
TEST_F(TreeTest, ClosedMeshesAreTight)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeGlobe({ 0.1, 0.2, 0.3 }, 1.0, 9);
  std::vector<double> corners;
  vtkIdType size;
  const vtkIdType* ids;
  sphere->GetPolys()->InitTraversal();
  while (sphere->GetPolys()->GetNextCell(size, ids))
  {
    ASSERT_EQ(size, 3);
    for (int i = 0; i < 3; ++i)
    {
      corners.insert(corners.end(), sphere->GetPoint(ids[i]), sphere->GetPoint(ids[i]) + 3);
    }
  }
  TriangleTree tree;
  tree.Build(corners);
  for (std::size_t i = 0; i < corners.size() / 3; ++i)
  {
    const double* a = &corners[3 * i];
    const double* b = &corners[3 * (i % 3 == 2 ? i - 2 : i + 1)];
    for (int k = 0; k < 32; ++k)
    {
      Ray ray = { { 0.1, 0.2, 0.3 }, {} };
      for (int axis = 0; axis < 3; ++axis)
      {
        ray.Direction[axis] = a[axis] + k / 32.0 * (b[axis] - a[axis]) - ray.Origin[axis];
      }
      ASSERT_GE(tree.FindNearest(ray).Triangle, 0) << i << " " << k;
    }
  }
}

// Receivers and shadows of whole images must equal those that are found by testing all triangles.
TEST_F(TreeTest, ScenesByBruteForce)
{
  for (const char* name :
    { "ManyLights", "CadSpot", "QuadsStripsPolygons", "LightAtVertex", "HugeCoordinates" })
  {
    SCOPED_TRACE(name);
    Stage stage = SetNamedStage(name);
    const Oracle oracle(stage.GetRenderer());
    const std::vector<double>& corners = oracle.GetTriangles().Corners;
    for (int y = 1; y < oracle.GetHeight(); y += 9)
    {
      for (int x = y % 7; x < oracle.GetWidth(); x += 7)
      {
        ExpectSameRay(oracle.GetTree(), corners, oracle.GetEyeRay(x, y));
        Oracle::Receiver receiver;
        if (!oracle.GetReceiver(x, y, 0.0, 0.0, receiver))
        {
          continue;
        }
        for (vtkLight* vtklight : stage.Lights)
        {
          const OracleLight light(vtklight);
          // The other way round than the oracle does it: from the light.
          Ray ray;
          for (int i = 0; i < 3; ++i)
          {
            ray.Origin[i] = light.Positional ? light.Position[i]
                                             : receiver.Position[i] - 100.0 * light.Direction[i];
            ray.Direction[i] = receiver.Position[i] - ray.Origin[i];
          }
          ray.Near = light.Positional ? 1e-9 : 0.0;
          ray.Far = 1.0 - 1e-9;
          std::set<int> crossed = GetCrossings(corners, ray);
          crossed.erase(receiver.Triangle);
          EXPECT_EQ(oracle.IsShadowed(receiver, light), !crossed.empty()) << x << " " << y;
          EXPECT_EQ(oracle.CountCrossings(receiver, light), static_cast<int>(crossed.size()))
            << x << " " << y;
        }
      }
    }
  }
}

TEST_F(TreeTest, AgreesWithLocator)
{
  Stage stage = SetNamedStage("CityDirectional");
  const Oracle oracle(stage.GetRenderer());
  const OracleLight light(stage.Lights[0]);
  const std::vector<double>& corners = oracle.GetTriangles().Corners;
  std::vector<Point> points;
  std::vector<Polygon> triangles;
  for (std::size_t i = 0; i < corners.size(); i += 9)
  {
    const int first = static_cast<int>(points.size());
    for (std::size_t k = 0; k < 9; k += 3)
    {
      points.push_back(glm::make_vec3(&corners[i + k]));
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(MakeMesh(points, triangles));
  locator->BuildLocator();
  int receivers = 0;
  int shadowed = 0;
  for (int y = 0; y < oracle.GetHeight(); y += 3)
  {
    for (int x = 0; x < oracle.GetWidth(); x += 3)
    {
      Oracle::Receiver receiver;
      const OracleSample sample = oracle.Classify(x, y, 0.0, 0.0, light).Sample;
      if ((sample != OracleSample::Lit && sample != OracleSample::Shadowed) ||
        oracle.IsAmbiguous(x, y, light))
      {
        continue;
      }
      ASSERT_TRUE(oracle.GetReceiver(x, y, 0.0, 0.0, receiver));
      // A little away from the receiver's own surface.
      double from[3];
      double to[3];
      for (int i = 0; i < 3; ++i)
      {
        from[i] = receiver.Position[i] - 1e-6 * light.Direction[i];
        to[i] = receiver.Position[i] - 400.0 * light.Direction[i];
      }
      double t;
      double hit[3];
      double parameters[3];
      int subId;
      vtkIdType cellId;
      vtkNew<vtkGenericCell> cell;
      const bool found =
        locator->IntersectWithLine(from, to, 0.0, t, hit, parameters, subId, cellId, cell) != 0;
      EXPECT_EQ(found, sample == OracleSample::Shadowed) << x << " " << y;
      ++receivers;
      shadowed += found;
    }
  }
  EXPECT_GT(receivers, 1000);
  EXPECT_GT(shadowed, 100);
}
