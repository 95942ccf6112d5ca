// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow volumes are watertight, and their signed crossings are the number of triangles that a
// point's shadow ray meets: for all meshes, lights and kinds of pieces.
#include "ShadowCaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace
{
/// `Mesh` is what brute force counts with.
struct Caster : ShadowCaster
{
  using ShadowCaster::ShadowCaster;

  /// A point, half of them behind a triangle.
  Point MakeReceiver(std::mt19937& random) const
  {
    Point x = MakePoint(random, 3.0);
    if (random() % 2)
    {
      const std::size_t t = random() % this->Topology.GetNumberOfTriangles();
      Point weights(MakeUniform(random, 0, 1), 0.0, 0.0);
      weights[1] = MakeUniform(random, 0, 1);
      weights[2] = MakeUniform(random, 0, 1);
      weights /= weights[0] + weights[1] + weights[2];
      const double distance = MakeUniform(random, 0.0, 2.0);
      Point hit(0.0);
      for (int i = 0; i < 3; ++i)
      {
        hit += weights[i] * this->GetPoints()[this->Topology.GetTriangles()[3 * t + i]];
      }
      x = hit +
        distance *
          (this->Light.IsPositional() ? hit - this->Light.Position : this->Light.Direction);
    }
    return x;
  }
};

/// A light of any kind, outside of all meshes, turned towards the origin.
vtkShadowLight MakeLight(std::mt19937& random)
{
  const Point direction = vtkNBufferGLM::Normalize(MakePoint(random, 1.0));
  const Point position = MakeUniform(random, 2.5, 5.0) * direction;
  constexpr vtkShadowLightKind kinds[] = { vtkShadowLightKind::Directional,
    vtkShadowLightKind::Spot, vtkShadowLightKind::Point };
  return MakeLight(kinds[random() % 3], position);
}

std::string GetText(const vtkShadowLight& light)
{
  return "light of kind " + std::to_string(static_cast<int>(light.Kind)) + ", position " +
    testing::PrintToString(light.Position) + ", direction " +
    testing::PrintToString(light.Direction);
}

/// Where a volume is claimed to hold a caster's counts; elsewhere it must hold nothing.
struct Range
{
  double Near = -std::numeric_limits<double>::infinity();
  double Far = std::numeric_limits<double>::infinity();
  const vtkShadowBlock* View = nullptr; ///< Points outside of it are not checked.
};

/// Counts of a volume against brute force, for random points.
void CheckCounts(const Caster& caster, const vtkShadowVolume& volume,
  const vtkShadowLightSpace& frame, const Range& range, std::mt19937& random, int points,
  int& shadowed)
{
  ASSERT_TRUE(IsWatertight(volume));
  const bool lit = caster.Silhouette.GetCounting() == vtkShadowCounting::Away;
  for (int i = 0; i < points; ++i)
  {
    const Point x = caster.MakeReceiver(random);
    if (range.View && !range.View->Meets({ x, x }))
    {
      continue;
    }
    const double depth = frame.GetDepth(x);
    std::optional<int> expected = CountByBruteForce(caster.Mesh, caster.Light, x, lit);
    if (!expected || std::abs(depth - range.Near) < 1e-4 || std::abs(depth - range.Far) < 1e-4)
    {
      continue;
    }
    ASSERT_LE(*expected, caster.Silhouette.GetMaximumCount());
    if (depth < range.Near || depth > range.Far)
    {
      expected = 0;
    }
    shadowed += *expected != 0;
    ASSERT_EQ(CountInVolume(volume, x, random), *expected)
      << "at " << testing::PrintToString(x) << ", depth " << depth;
  }
}

/// Whole and clamped volumes of a caster. `outwards` is the same mesh, wound outwards if closed.
void CheckVolumes(const ShadowMesh& mesh, const ShadowMesh& outwards, const vtkShadowLight& light,
  vtkShadowCounting counting, std::mt19937& random, int points, int& shadowed)
{
  SCOPED_TRACE(mesh.Name + ", " + GetText(light));
  Caster caster(mesh, light, counting);
  caster.Mesh = outwards;
  const vtkShadowLightSpace frame = light.Kind == vtkShadowLightKind::Point
    ? vtkShadowLightSpace(light, -light.Position)
    : vtkShadowLightSpace(light);
  vtkShadowVolume volume;
  caster.AddWhole(volume);
  ASSERT_NO_FATAL_FAILURE(CheckCounts(caster, volume, frame, Range(), random, points, shadowed));

  // A parallel camera sees a box, beyond which the volume ends.
  vtkShadowBlock view;
  view.Add(MakePoint(random, 4.0));
  view.Add(MakePoint(random, 4.0));
  Range range;
  range.View = &view;
  volume = vtkShadowVolume();
  caster.AddWhole(volume, &view);
  for (const glm::dvec4& vertex : volume.GetVertices())
  {
    ASSERT_EQ(vertex.w, 1.0);
  }
  ASSERT_NO_FATAL_FAILURE(CheckCounts(caster, volume, frame, range, random, points, shadowed));

  const auto [least, largest] = caster.GetDepths(frame);
  if (light.IsPositional() && least < 0.1)
  {
    return;
  }
  const vtkShadowSlab slabs[] = { { largest + 0.3, largest + 1.3 },
    { (least + largest) / 2.0, largest + 0.6 }, { least - 0.05, (least + largest) / 2.0 } };
  for (const vtkShadowSlab& slab : slabs)
  {
    SCOPED_TRACE("slab " + std::to_string(slab.Near) + " " + std::to_string(slab.Far));
    Range range;
    range.Near = largest < slab.Near ? slab.Near : range.Near;
    range.Far = std::max(slab.Far, largest);
    volume = vtkShadowVolume();
    caster.AddClamped(volume, frame, slab);
    ASSERT_NO_FATAL_FAILURE(CheckCounts(caster, volume, frame, range, random, points, shadowed));
  }
}

/// The multiplicities of a silhouette, each with the number of its edges.
std::map<int, int> CountMultiplicities(const vtkShadowSilhouette& silhouette)
{
  std::map<int, int> counts;
  for (const vtkShadowSilhouette::Edge& edge : silhouette.GetEdges())
  {
    ++counts[edge.Multiplicity];
  }
  return counts;
}

using Multiplicities = std::map<int, int>;
}

TEST(ShadowVolume, SilhouettesOfKnownMeshes)
{
  const vtkShadowLight sun = MakeLight(vtkShadowLightKind::Directional, { 0, 0, 1 });
  const vtkShadowLight slanted = MakeLight(vtkShadowLightKind::Directional, { 3, 2, 1 });
  const auto get = [](const ShadowMesh& mesh, const vtkShadowLight& light,
                     vtkShadowCounting counting = vtkShadowCounting::Away)
  { return Caster(mesh, light, counting).Silhouette; };

  // Walls are seen edge-on.
  vtkShadowSilhouette cube = get(MakeCube(), sun);
  EXPECT_EQ(cube.GetTriangles().size(), 3u * 2u);
  EXPECT_EQ(CountMultiplicities(cube), (Multiplicities{ { 1, 4 } }));
  EXPECT_EQ(cube.GetMaximumCount(), 1);
  cube = get(MakeCube(), slanted);
  EXPECT_EQ(cube.GetTriangles().size(), 3u * 6u);
  EXPECT_EQ(CountMultiplicities(cube), (Multiplicities{ { 1, 6 } }));
  // Both the lit and the unlit triangles end at the outline.
  cube = get(MakeCube(), slanted, vtkShadowCounting::All);
  EXPECT_EQ(cube.GetTriangles().size(), 3u * 12u);
  EXPECT_EQ(CountMultiplicities(cube), (Multiplicities{ { 2, 6 } }));
  EXPECT_EQ(cube.GetMaximumCount(), 2);

  const vtkShadowSilhouette quad = get(MakeOpenRectangle(), sun);
  EXPECT_EQ(quad.GetCounting(), vtkShadowCounting::All);
  EXPECT_EQ(CountMultiplicities(quad), (Multiplicities{ { 1, 4 } }));
  EXPECT_EQ(quad.GetMaximumCount(), 2);

  // Pages at 45, 0 and -45 degrees around their spine: all on one side of it as this light sees
  // them, or two on one and one on the other.
  ShadowMesh book = MakeThreePages();
  book.Points[4] = { 1, 1, -1 };
  book.Points[5] = { 1, 1, 1 };
  book.Points[6] = { 1, -1, -1 };
  book.Points[7] = { 1, -1, 1 };
  const vtkShadowLight above = MakeLight(vtkShadowLightKind::Directional, { 1, 9, 0.5 });
  const vtkShadowLight along = MakeLight(vtkShadowLightKind::Directional, { -1, 0.1, 0 });
  EXPECT_EQ(CountMultiplicities(get(book, above)), (Multiplicities{ { 1, 9 }, { 3, 1 } }));
  EXPECT_EQ(CountMultiplicities(get(book, along)), (Multiplicities{ { 1, 10 } }));
}

// Hazard: the unlit side of a sheet lies in its lit side, which would be in its shadow.
TEST(ShadowVolume, AllTrianglesOfMeshesWithoutThicknessCount)
{
  const vtkShadowLight light = MakeLight(vtkShadowLightKind::Directional, { 3, 2, 1 });
  const auto getCounting = [&light](const ShadowMesh& mesh)
  { return Caster(mesh, light, vtkShadowCounting::Away).Silhouette.GetCounting(); };
  const auto flatten = [](double height)
  { return MakeCube().Move([height](const Point& x) { return x * Point(1.0, 1.0, height); }); };
  EXPECT_EQ(getCounting(MakeTwoSided()), vtkShadowCounting::All);
  EXPECT_EQ(getCounting(Join("", { MakeCube(), MakeTwoSided() })), vtkShadowCounting::All);
  EXPECT_EQ(getCounting(flatten(0x1p-17)), vtkShadowCounting::Away);
  EXPECT_EQ(getCounting(flatten(0x1p-19)), vtkShadowCounting::All);
  EXPECT_EQ(getCounting(flatten(-0x1p-17)), vtkShadowCounting::Away) << "inside out";
  EXPECT_EQ(getCounting(flatten(0x1p-17).Translate(1e6, 0.0, 0.0)), vtkShadowCounting::Away);
}

// Hazard: volumes have holes, counts do not cancel, or far caps do not fit the sides.
TEST(ShadowVolume, CountsAgreeWithBruteForce)
{
  std::mt19937 random(11);
  int shadowed = 0;
  for (int seed = 0; seed < 6; ++seed)
  {
    for (const ShadowMesh& made : MakeShadowMeshes(100 + seed))
    {
      const ShadowMesh mesh = made.Move(MakeRigidMotion(random, 0.3));
      const bool mixed = mesh.Name.rfind("two bodies", 0) == 0;
      const vtkShadowCounting counting =
        random() % 3 == 0 || mixed ? vtkShadowCounting::All : vtkShadowCounting::Away;
      ASSERT_NO_FATAL_FAILURE(
        CheckVolumes(mesh, mesh, MakeLight(random), counting, random, 12, shadowed));
    }
  }
  EXPECT_GT(shadowed, 1000);
}

// Hazard: a mirrored or badly wound body begins to cast its shadow at the wrong one of its two
// surfaces.
TEST(ShadowVolume, InsideOutBodiesAreTurnedRound)
{
  std::mt19937 random(12);
  int shadowed = 0;
  const auto mirror = [](const Point& x) { return x * Point(-1, 1, 1); };
  for (int i = 0; i < 20; ++i)
  {
    const auto motion = MakeRigidMotion(random, 0.3);
    const vtkShadowLight light = MakeLight(random);
    for (const ShadowMesh& made : { MakeEll(), MakeSphere(4, 5), MakeTorus(3, 5) })
    {
      const ShadowMesh mesh = made.Move(mirror).Move(motion);
      ASSERT_NO_FATAL_FAILURE(
        CheckVolumes(mesh, mesh.Reverse(), light, vtkShadowCounting::Away, random, 12, shadowed));
    }
    const ShadowMesh cube = MakeCube().Translate(-0.7, 0, 0);
    const ShadowMesh inner = MakeTetrahedron().Translate(0.2, 0, 0);
    const ShadowMesh mesh = Join("two bodies", { cube, inner.Reverse() });
    const ShadowMesh outwards = Join("two bodies", { cube, inner });
    ASSERT_NO_FATAL_FAILURE(CheckVolumes(mesh.Move(motion), outwards.Move(motion), light,
      vtkShadowCounting::Away, random, 12, shadowed));
    const ShadowMesh neighbour = MakeCube().Translate(-0.7, 1, 1);
    const ShadowMesh touching = Join("two bodies at an edge", { cube, neighbour.Reverse() });
    ASSERT_NO_FATAL_FAILURE(
      CheckVolumes(touching.Move(motion), Join("", { cube, neighbour }).Move(motion), light,
        vtkShadowCounting::Away, random, 12, shadowed));
  }
  EXPECT_GT(shadowed, 500);
}

// Hazard: a count is larger than its bound, and overflows the stencil; or a bound is far too large,
// and more passes are drawn than needed.
TEST(ShadowVolume, CountsAreBounded)
{
  std::mt19937 random(15);
  const ShadowMesh meshes[] = { MakeSphere(30, 40), MakeTorus(30, 40), MakeSoup(random, 900, 300),
    MakeSphere(4, 5) };
  for (int i = 0; i < 12; ++i)
  {
    const ShadowMesh& mesh = meshes[i % 4];
    const vtkShadowLight light = MakeLight(random);
    SCOPED_TRACE(mesh.Name + ", " + GetText(light));
    const Caster caster(mesh, light, vtkShadowCounting::Away);
    const int bound = caster.Silhouette.GetMaximumCount();
    const bool lit = caster.Silhouette.GetCounting() == vtkShadowCounting::Away;
    for (int p = 0; p < 500; ++p)
    {
      const std::optional<int> count =
        CountByBruteForce(mesh, light, caster.MakeReceiver(random), lit);
      ASSERT_LE(count.value_or(0), bound);
    }
    EXPECT_TRUE(bound < 60 || mesh.Triangles.size() <= 3000) << bound;
  }

  ShadowMesh sheets;
  for (int i = 0; i < 300; ++i)
  {
    sheets.Append(MakeOpenRectangle().Translate(0, 0, 0.01 * i));
  }
  const Caster caster(
    sheets, MakeLight(vtkShadowLightKind::Directional, { 0, 0, 1 }), vtkShadowCounting::Away);
  EXPECT_GE(caster.Silhouette.GetMaximumCount(), 300);
  EXPECT_LE(caster.Silhouette.GetMaximumCount(), 600);
  // All but one in the same cell.
  ShadowMesh pile = MakeOpenRectangle();
  const ShadowMesh small = MakeOpenRectangle().Move(
    [](const Point& x) { return Point(0.5, 0.5, 0.0) + Point(1e-3, 1e-3, 1.0) * x; });
  for (int i = 1; i <= 300; ++i)
  {
    pile.Append(small.Translate(0, 0, 0.01 * i));
  }
  EXPECT_GE(Caster(pile, caster.Light, vtkShadowCounting::Away).Silhouette.GetMaximumCount(), 300);
  const Caster around(MakeSphere(30, 40),
    MakeLight(vtkShadowLightKind::Point, { 0, 0, 0 }, { 1, 0, 0 }), vtkShadowCounting::All);
  EXPECT_EQ(around.Silhouette.GetMaximumCount(), around.Topology.GetNumberOfTriangles());
}

// Hazard: no triangle of a closed caster faces a light inside of it, and nothing is in shadow.
TEST(ShadowVolume, LightInsideOrOnACaster)
{
  std::mt19937 random(13);
  int shadowed = 0;
  const auto check = [&](const ShadowMesh& mesh, const Point& position)
  {
    const vtkShadowLight light = MakeLight(vtkShadowLightKind::Point, position, { 2, 3, 4 });
    CheckVolumes(mesh, mesh, light, vtkShadowCounting::All, random, 50, shadowed);
  };
  for (int i = 0; i < 10; ++i)
  {
    check(MakeCube(), MakePoint(random, 0.4));
    check(MakeSphere(5, 7), MakePoint(random, 0.4));
    check(MakeEll(), MakePoint(random, 0.6));
    check(MakeOpenCube(), MakePoint(random, 0.4));
  }
  EXPECT_GT(shadowed, 1000);

  // At a corner, on an edge, in a face; then outside in the plane of a face and on an edge's line.
  check(MakeTetrahedron(), { 0, 0, 0 });
  check(MakeTetrahedron(), { 0.5, 0, 0 });
  check(MakeTetrahedron(), { 0.25, 0.25, 0 });
  for (const Point& position : { Point{ 2, 2, 0 }, Point{ 3, 0, 0 } })
  {
    const vtkShadowLight light = MakeLight(vtkShadowLightKind::Point, position, { 0, 0, 0.4 });
    const ShadowMesh mesh = MakeTetrahedron();
    CheckVolumes(mesh, mesh, light, vtkShadowCounting::Away, random, 200, shadowed);
  }
}

// Shadows do not depend on the winding of triangles or on the points that they share, and they move
// with the scene.
TEST(ShadowVolume, ShadowsDoNotDependOnTheMeshsForm)
{
  std::mt19937 random(14);
  int shadowed = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (const ShadowMesh& mesh : MakeShadowMeshes(200 + i))
    {
      const vtkShadowLight light = MakeLight(random);
      SCOPED_TRACE(mesh.Name + ", " + GetText(light));
      const ShadowMesh flipped = mesh.Flip(random);
      const auto motion = MakeRigidMotion(random, 10.0);
      const Point origin = motion({ 0, 0, 0 });
      vtkShadowLight movedLight = light;
      movedLight.Position = motion(light.Position);
      movedLight.Direction = motion(light.Direction) - origin;

      const vtkShadowCounting counting = vtkShadowCounting::Away;
      const Caster caster(mesh, light, counting);
      const auto makeVolume = [](const Caster& from)
      {
        vtkShadowVolume volume;
        from.AddWhole(volume);
        return volume;
      };
      const vtkShadowVolume volume = makeVolume(caster);
      const vtkShadowVolume unshared = makeVolume({ mesh.Unshare(), light, counting });
      const vtkShadowVolume badlyWound = makeVolume({ flipped, light, counting });
      const vtkShadowVolume moved = makeVolume({ mesh.Move(motion), movedLight, counting });
      EXPECT_EQ(volume.GetVertices(), unshared.GetVertices());
      EXPECT_EQ(volume.GetIndices(), unshared.GetIndices());
      for (int p = 0; p < 20; ++p)
      {
        const Point x = caster.MakeReceiver(random);
        if (!CountByBruteForce(mesh, light, x, false))
        {
          continue;
        }
        const int count = CountInVolume(volume, x, random);
        // Inside of a closed body, where all triangles count, it is dark; those that face away
        // count nothing there.
        const bool dark = CountInVolume(badlyWound, x, random) != 0;
        const std::optional<int> all = CountByBruteForce(mesh, light, x, false);
        ASSERT_TRUE(dark == (count != 0) || (dark && all.value() % 2 == 1));
        ASSERT_EQ(CountInVolume(moved, motion(x), random), count);
        shadowed += count != 0;
      }
    }
  }
  EXPECT_GT(shadowed, 200);
}

// Volumes for a parallel camera are hardly longer than necessary.
TEST(ShadowVolume, LengthsForParallelCameras)
{
  const auto getLowest = [](const vtkShadowLight& light, const vtkShadowBlock& view)
  {
    vtkShadowVolume volume;
    Caster(MakeCube(), light, vtkShadowCounting::Away).AddWhole(volume, &view);
    double lowest = 0.0;
    for (const glm::dvec4& vertex : volume.GetVertices())
    {
      lowest = std::min(lowest, vertex.z);
    }
    return lowest;
  };
  const vtkShadowBlock view = { { -4.0, -3.0, -12.0 }, { 2.0, 0.0, 5.0 } };
  const double bottom = MakeCube().Points[0][2];
  const vtkShadowLight lamp = MakeLight(vtkShadowLightKind::Point, { 0, 0, 3 });
  // The walls' upper edges are the nearest place that counts, and (-4, -3, -12) the farthest in
  // view.
  const double factor = glm::length(Point(4.0, 3.0, 15.0)) / glm::length(Point(0.5, 0.0, 2.5));
  EXPECT_NEAR(getLowest(lamp, view), 3.0 + factor * (bottom - 3.0), 0.3);
  const vtkShadowLight sun = MakeLight(vtkShadowLightKind::Directional, { 0, 0, 1 });
  EXPECT_NEAR(getLowest(sun, view), -12.0, 0.2);
  EXPECT_NEAR(getLowest(sun, { { -1.0, -1.0, 2.0 }, { 1.0, 1.0, 3.0 } }), bottom, 0.1);
  // A view before the caster has nothing in shadow.
  EXPECT_NEAR(getLowest(lamp, { { -1.0, -1.0, 2.0 }, { 1.0, 1.0, 3.0 } }), bottom, 0.1);
}

TEST(ShadowVolume, SizesOfPieces)
{
  const vtkShadowLight light = MakeLight(vtkShadowLightKind::Spot, { 3, 2, 1 });
  const vtkShadowLightSpace frame(light);
  const Caster caster(MakeSphere(8, 10), light, vtkShadowCounting::Away);
  const std::size_t lit = caster.Silhouette.GetTriangles().size() / 3;
  const std::size_t edges = caster.Silhouette.GetEdges().size();
  const auto getSize = [&](const vtkShadowVolume& volume)
  { return std::make_pair(volume.GetIndices().size() / 3, volume.GetVertices().size()); };
  const auto clamp = [&](const vtkShadowSlab& slab)
  {
    vtkShadowVolume volume;
    caster.AddClamped(volume, frame, slab);
    return getSize(volume);
  };
  EXPECT_EQ(clamp({ 6, 7 }), std::make_pair(4 * edges, 2 * edges + 2));
  EXPECT_EQ(clamp({ 1, 7 }).first, lit + 3 * edges);

  // Several casters in one volume.
  vtkShadowVolume volume;
  caster.AddWhole(volume);
  EXPECT_EQ(volume.GetIndices().size() / 3, 2 * lit + 2 * edges);
  caster.AddClamped(volume, frame, { 6, 7 });
  EXPECT_EQ(volume.GetIndices().size() / 3, 2 * lit + 6 * edges);
  EXPECT_TRUE(IsWatertight(volume));
  volume = vtkShadowVolume();

  const Caster sunlit(MakeSphere(8, 10), MakeLight(vtkShadowLightKind::Directional, { 3, 2, 1 }),
    vtkShadowCounting::Away);
  sunlit.AddWhole(volume);
  EXPECT_EQ(volume.GetIndices().size(),
    sunlit.Silhouette.GetTriangles().size() + 3 * sunlit.Silhouette.GetEdges().size());
}
