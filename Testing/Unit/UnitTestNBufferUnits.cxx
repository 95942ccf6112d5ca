// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{
using Mesh = vtkNBufferUnits::Mesh;
using Box = vtkNBufferUnits::Box;

/// A terrain of size x size quads, row by row.
Mesh MakeTerrain(unsigned int size)
{
  Mesh mesh;
  std::minstd_rand random(7);
  for (unsigned int y = 0; y <= size; ++y)
  {
    for (unsigned int x = 0; x <= size; ++x)
    {
      mesh.Points.emplace_back(
        0.1 * x, 0.1 * y, std::uniform_real_distribution<>(0.0, 0.1)(random));
    }
  }
  for (unsigned int y = 0; y < size; ++y)
  {
    for (unsigned int x = 0; x < size; ++x)
    {
      const unsigned int first = y * (size + 1) + x;
      for (const unsigned int step : { 0U, 1U, size + 1, 1U, size + 2, size + 1 })
      {
        mesh.Indices.push_back(first + step);
      }
    }
  }
  return mesh;
}

/// 64 small terrains of 32 triangles in a row. Those that are neighbours in the list are `step`
/// places apart.
Mesh MakePatches(int step)
{
  const Mesh one = MakeTerrain(4);
  Mesh patches;
  for (int patch = 0; patch < 64; ++patch)
  {
    const auto first = static_cast<unsigned int>(patches.Points.size());
    for (const glm::dvec3& point : one.Points)
    {
      patches.Points.push_back(point + glm::dvec3(0.7 * (patch * step % 64), 0.0, 0.0));
    }
    for (const unsigned int index : one.Indices)
    {
      patches.Indices.push_back(first + index);
    }
  }
  return patches;
}

/// The triangles of a mesh in another order.
Mesh Shuffle(const Mesh& mesh)
{
  std::vector<std::size_t> order(mesh.Indices.size() / 3);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::shuffle(order.begin(), order.end(), std::minstd_rand(3));
  Mesh result = mesh;
  for (std::size_t i = 0; i < mesh.Indices.size(); ++i)
  {
    result.Indices[i] = mesh.Indices[3 * order[i / 3] + i % 3];
  }
  return result;
}

/// The indices of the units that are marked, in the order of drawing.
std::vector<unsigned int> GetIndices(
  const vtkNBufferUnits& units, const Mesh& mesh, const std::vector<unsigned char>& drawn)
{
  std::vector<unsigned int> indices;
  for (const auto& [begin, end] : units.GetRanges(drawn))
  {
    const unsigned int* all = mesh.Indices.data();
    indices.insert(indices.end(), all + mesh.Corners * begin, all + mesh.Corners * end);
  }
  return indices;
}

/// The indices of each single unit.
std::vector<std::vector<unsigned int>> GetAllUnits(const vtkNBufferUnits& units, const Mesh& mesh)
{
  std::vector<std::vector<unsigned int>> all(units.GetSize());
  for (std::size_t unit = 0; unit < units.GetSize(); ++unit)
  {
    std::vector<unsigned char> drawn(units.GetSize());
    drawn[unit] = 1;
    all[unit] = GetIndices(units, mesh, drawn);
  }
  return all;
}

bool ContainsPoint(const Box& box, const glm::dvec3& point)
{
  return glm::all(glm::lessThanEqual(glm::dvec3(box.Low), point)) &&
    glm::all(glm::lessThanEqual(point, glm::dvec3(box.High)));
}
}

class Units : public testing::TestWithParam<bool>
{
protected:
  Mesh Get() const { return this->GetParam() ? Shuffle(MakePatches(1)) : MakePatches(1); }
};
INSTANTIATE_TEST_SUITE_P(Each, Units, testing::Bool(),
  [](const auto& info) { return std::string(info.param ? "Shuffled" : "PatchByPatch"); });

// Hazard: a primitive is in no unit or in two, or is outside of the box of its unit.
TEST_P(Units, EachPrimitiveIsInOneUnitAndInItsBox)
{
  const Mesh mesh = this->Get();
  const vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 64);
  ASSERT_EQ(units.GetSize(), 32U);
  std::size_t total = 0;
  const auto all = GetAllUnits(units, mesh);
  for (std::size_t unit = 0; unit < units.GetSize(); ++unit)
  {
    total += all[unit].size();
    for (const unsigned int index : all[unit])
    {
      EXPECT_TRUE(ContainsPoint(units.GetLevels()[0][unit], mesh.Points[index]));
    }
  }
  EXPECT_EQ(total, mesh.Indices.size());
  const std::vector<unsigned char> drawn(units.GetSize(), 1);
  EXPECT_EQ(GetIndices(units, mesh, drawn), mesh.Indices)
    << "all units are the mesh in its own order";
}

TEST_P(Units, AreFoundByTheirPrimitives)
{
  const Mesh mesh = this->Get();
  vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 64);
  EXPECT_EQ(units.AreSpatial(), this->GetParam());
  const auto all = GetAllUnits(units, mesh);
  std::vector<std::size_t> next(units.GetSize());
  for (std::size_t i = 0; i < mesh.Indices.size(); i += 3)
  {
    const std::size_t unit = units.FindUnit(i / 3);
    ASSERT_LT(unit, units.GetSize());
    ASSERT_LT(next[unit], all[unit].size());
    EXPECT_TRUE(std::equal(&mesh.Indices[i], &mesh.Indices[i] + 3, &all[unit][next[unit]]));
    next[unit] += 3;
  }
  EXPECT_EQ(units.FindUnit(mesh.Indices.size() / 3), units.GetSize());
}

// Hazard: the order of drawing, on which the image depends where depths are equal, becomes that of
// the units.
TEST_P(Units, KeepTheOrderOfDrawing)
{
  const Mesh mesh = this->Get();
  const vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 16);
  std::vector<unsigned char> drawn(units.GetSize());
  for (std::size_t i = 0; i < drawn.size(); i += 3)
  {
    drawn[i] = 1;
  }
  const std::vector<unsigned int> some = GetIndices(units, mesh, drawn);
  ASSERT_GT(some.size(), mesh.Indices.size() / 4);
  std::size_t next = 0;
  for (std::size_t i = 0; i < some.size(); i += 3)
  {
    while (next < mesh.Indices.size() && !std::equal(&some[i], &some[i] + 3, &mesh.Indices[next]))
    {
      next += 3;
    }
    ASSERT_LT(next, mesh.Indices.size()) << "triangle " << i / 3 << " is out of order";
    next += 3;
  }
}

// Hazard: a range lacks a primitive of the units, contains one of other units, or is out of order.
TEST_P(Units, RangesAreThoseOfTheUnits)
{
  const Mesh mesh = this->Get();
  vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 16);
  for (const std::size_t share : { 1, 2, 5, 1000 })
  {
    std::vector<unsigned char> drawn(units.GetSize());
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      drawn[i] = (i + 1) % share == 0 || (i + 2) % share == 0;
    }
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < mesh.Indices.size() / 3; ++i)
    {
      if (drawn[units.FindUnit(i)])
      {
        expected.push_back(i);
      }
    }
    std::vector<std::size_t> found;
    std::size_t last = 0;
    for (const auto& [begin, end] : units.GetRanges(drawn))
    {
      ASSERT_LT(begin, end);
      EXPECT_TRUE(found.empty() || begin > last) << "neighbours are joined, in order";
      for (std::size_t i = begin; i < end; ++i)
      {
        found.push_back(i);
      }
      last = end;
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.empty(), share == 1000);
  }
}

// Hazard: primitives of a part, which is one source or one mapper of blocks, are those of another.
TEST(UnitRanges, AreClippedToAPart)
{
  using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;
  const std::vector<vtkNBufferUnits::Range> ranges = { { 2, 5 }, { 7, 8 }, { 10, 20 } };
  const auto clip = [&ranges](std::size_t begin, std::size_t end)
  {
    Ranges clipped;
    for (const auto& [first, last] : vtkNBufferUnits::Clip(ranges, { begin, end }))
    {
      clipped.emplace_back(first, last);
    }
    return clipped;
  };
  EXPECT_EQ(clip(0, 30), (Ranges{ { 2, 5 }, { 7, 8 }, { 10, 20 } }));
  EXPECT_EQ(clip(3, 12), (Ranges{ { 0, 2 }, { 4, 5 }, { 7, 9 } }));
  EXPECT_EQ(clip(5, 10), (Ranges{ { 2, 3 } }));
  EXPECT_EQ(clip(8, 10), Ranges{});
  EXPECT_EQ(clip(12, 13), (Ranges{ { 0, 1 } }));
  EXPECT_EQ(clip(20, 30), Ranges{});
}

// Hazard: an order of equal depths is not restored, because the group of a fresh unit is too small.
TEST_P(Units, AreGroupedWithTheirNeighbours)
{
  const vtkNBufferUnits units = vtkNBufferUnits::Make(this->Get(), 8);
  std::vector<unsigned char> marked(units.GetSize());
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < units.GetSize(); i += 17)
  {
    marked[i] = 1;
    boxes.push_back(units.GetLevels()[0][i]);
  }
  ASSERT_LE(boxes.size(), 16U);
  const auto isSame = [](const Box& a, const Box& b) { return a.Low == b.Low && a.High == b.High; };
  EXPECT_TRUE(std::equal(boxes.begin(), boxes.end(), units.GetGroups(marked).begin(), isSame));

  // More than 16 are joined by the nodes of the hierarchy: here of 8 units, all of them marked.
  std::fill_n(marked.begin(), 128, 1);
  std::fill(marked.begin() + 128, marked.end(), 0);
  const std::vector<Box> groups = units.GetGroups(marked);
  ASSERT_EQ(groups.size(), 16U);
  EXPECT_TRUE(std::equal(groups.begin(), groups.end(), units.GetLevels()[1].begin(), isSame));
}

// Hazard: a node of the hierarchy does not contain everything below it.
TEST_P(Units, NodesContainTheirUnits)
{
  const vtkNBufferUnits units = vtkNBufferUnits::Make(this->Get(), 4);
  EXPECT_EQ(units.GetLevels().back().size(), 1U);
  for (std::size_t level = 0; level < units.GetLevels().size(); ++level)
  {
    std::size_t next = 0;
    for (std::size_t n = 0; n < units.GetLevels()[level].size(); ++n)
    {
      EXPECT_EQ(units.GetBegin(level, n), next);
      next = units.GetEnd(level, n);
      const Box& node = units.GetLevels()[level][n];
      for (std::size_t i = units.GetBegin(level, n); i < next; ++i)
      {
        EXPECT_TRUE(ContainsPoint(node, glm::dvec3(units.GetLevels()[0][i].Low)));
        EXPECT_TRUE(ContainsPoint(node, glm::dvec3(units.GetLevels()[0][i].High)));
      }
    }
    EXPECT_EQ(next, units.GetSize());
  }
}

// Units are groups of neighbours in space where the order in the file is of no use, and runs of
// that order where it is.
TEST(UnitsOfFiles, AreRunsOrGroupsWhicheverAreSmaller)
{
  // A unit of a row by row terrain is a long strip, so that groups win there, too; a mesh that
  // lists small patches one after the other has runs that are as good as any group.
  const Mesh patches = MakePatches(29);
  EXPECT_FALSE(vtkNBufferUnits::Make(patches, 32).AreSpatial());
  const vtkNBufferUnits shuffled = vtkNBufferUnits::Make(Shuffle(patches), 32);
  EXPECT_TRUE(shuffled.AreSpatial());
  // Groups that consist of single triangles are not drawn range by range.
  Mesh terrain = MakeTerrain(64);
  terrain.IsDrawnInRanges = true;
  EXPECT_TRUE(vtkNBufferUnits::Make(terrain, 128).AreSpatial());
  EXPECT_FALSE(vtkNBufferUnits::Make(Shuffle(terrain), 128).AreSpatial());
  double size = 0.0;
  for (const Box& box : shuffled.GetLevels()[0])
  {
    size = std::max<double>(size, box.High.x - box.Low.x);
  }
  EXPECT_LT(size, 2.0) << "of 45 in all";
}

TEST(UnitsOfFiles, PointsAreUnitsToo)
{
  Mesh mesh = MakeTerrain(10);
  mesh.Corners = 1;
  const vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 100);
  EXPECT_EQ(units.GetSize(), 6U);
  EXPECT_EQ(GetAllUnits(units, mesh)[5].size(), 100U);
}

// Hazard: coordinates are NaN, lists are empty or wrong, boxes have no extent.
TEST(UnitsOfFiles, BadNumbers)
{
  EXPECT_EQ(vtkNBufferUnits::Make({}, 8).GetSize(), 0U);
  Mesh mesh = MakeTerrain(4);
  mesh.Indices.push_back(1000);
  EXPECT_EQ(vtkNBufferUnits::Make(mesh, 8).GetSize(), 0U) << "an index out of range";

  mesh = MakeTerrain(4);
  mesh.Points[7].x = std::numeric_limits<double>::quiet_NaN();
  mesh.Points[9].y = std::numeric_limits<double>::infinity();
  mesh.Points[11] = glm::dvec3(1e300);
  const vtkNBufferUnits units = vtkNBufferUnits::Make(mesh, 1);
  const auto all = GetAllUnits(units, mesh);
  for (std::size_t unit = 0; unit < units.GetSize(); ++unit)
  {
    const bool isBad = std::any_of(all[unit].begin(), all[unit].end(),
      [](unsigned int index) { return index == 7 || index == 9 || index == 11; });
    EXPECT_EQ(std::isinf(units.GetLevels()[0][unit].High.x), isBad);
  }

  for (glm::dvec3& point : mesh.Points)
  {
    point = glm::dvec3(1.0 / 3.0);
  }
  const vtkNBufferUnits point = vtkNBufferUnits::Make(mesh, 2);
  EXPECT_TRUE(ContainsPoint(point.GetLevels()[0][0], mesh.Points[0])) << "rounded outward";
}
