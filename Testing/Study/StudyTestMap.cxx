// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BspMap.h"
#include "Messages.h"
#include "TinyMap.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using NBufferExamples::BspFace;
using NBufferExamples::BspMap;
using NBufferExamples::BspMesh;
using NBufferExamples::BspSurface;

using StudyTest::Bytes;
using StudyTest::Join;
using StudyTest::MakeLumps;

std::string GetError(const std::string& bytes)
{
  return GetThrownMessage([&bytes] { const BspMap map(bytes); });
}

/// With an int of a lump replaced.
std::string Change(std::size_t lump, std::size_t offset, int value)
{
  std::vector<std::string> lumps = MakeLumps();
  lumps[lump].replace(offset, 4, Bytes().Int(value).Text);
  return Join(lumps);
}
}

TEST(StudyMap, FindsTheClusterOfAPlace)
{
  const BspMap map(Join(MakeLumps()));
  EXPECT_EQ(map.GetNumberOfClusters(), 2);
  EXPECT_EQ(map.FindCluster({ 4.0, 0.0, 0.0 }), 0);
  EXPECT_EQ(map.FindCluster({ 0.5, 9.0, 0.0 }), BspMap::Opaque);
  EXPECT_EQ(map.FindCluster({ -4.0, 0.0, 7.0 }), 1);
}

TEST(StudyMap, ReadsTheTable)
{
  const BspMap map(Join(MakeLumps()));
  EXPECT_TRUE(map.MaySee(0, 0));
  EXPECT_FALSE(map.MaySee(0, 1));
  EXPECT_FALSE(map.MaySee(1, 0));
  EXPECT_TRUE(map.MaySee(1, 1));
  EXPECT_FALSE(map.MaySee(BspMap::Opaque, 0));
  EXPECT_FALSE(map.MaySee(0, BspMap::Opaque));
  EXPECT_FALSE(map.MaySee(0, 2));
}

TEST(StudyMap, KnowsTheClustersOfFaces)
{
  const BspMap map(Join(MakeLumps()));
  ASSERT_EQ(map.GetFaces().size(), 4u);
  EXPECT_EQ(map.GetClusters(0), std::vector<int>({ 0 }));
  EXPECT_EQ(map.GetClusters(1), std::vector<int>({ 1 })); // Named twice.
  EXPECT_TRUE(map.GetClusters(2).empty());
  EXPECT_TRUE(map.IsWorld(1));
  EXPECT_FALSE(map.IsWorld(2));
}

TEST(StudyMap, MeasuresWhatIsOpaqueOnTheWay)
{
  const BspMap map(Join(MakeLumps()));
  EXPECT_DOUBLE_EQ(map.GetOpaqueLength({ 4.0, 0.0, 0.0 }, { -4.0, 0.0, 0.0 }), 2.0);
  EXPECT_DOUBLE_EQ(map.GetOpaqueLength({ -4.0, 6.0, 0.0 }, { 4.0, 0.0, 0.0 }), 2.5);
  EXPECT_DOUBLE_EQ(map.GetOpaqueLength({ 4.0, 0.0, 0.0 }, { 2.0, 5.0, 5.0 }), 0.0);
  EXPECT_DOUBLE_EQ(map.GetOpaqueLength({ 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }), 0.5);
}

TEST(StudyMap, TakesTrianglesAsTheyAre)
{
  const BspMap map(Join(MakeLumps()));
  const BspMesh quad = map.GetMesh(0, 4);
  EXPECT_EQ(quad.Points.size(), 4u);
  ASSERT_EQ(quad.Triangles.size(), 2u);
  EXPECT_EQ(quad.Triangles[1], (std::array<int, 3>{ 0, 2, 3 }));
  EXPECT_TRUE(map.GetMesh(3, 4).Triangles.empty());
}

TEST(StudyMap, TessellatesPatches)
{
  const BspMap map(Join(MakeLumps()));
  const BspMesh patch = map.GetMesh(1, 4);
  ASSERT_EQ(patch.Points.size(), 25u);
  EXPECT_EQ(patch.Triangles.size(), 32u);
  // A quarter of the middle point's weight, the corners as they are.
  EXPECT_DOUBLE_EQ(patch.Points[12][0], -500.0 + 0.25 * 800.0);
  EXPECT_DOUBLE_EQ(patch.Points[12][1], 0.0);
  EXPECT_DOUBLE_EQ(patch.Points[24][0], -500.0);
  EXPECT_DOUBLE_EQ(patch.Points[24][1], 1000.0);
  EXPECT_DOUBLE_EQ(patch.Points[24][2], 1000.0);
}

TEST(StudyMap, FindsOriginsOfEntities)
{
  const BspMap map(Join(MakeLumps()));
  ASSERT_EQ(map.FindOrigins("info_player").size(), 1u);
  EXPECT_EQ(map.FindOrigins("info_player")[0], (NBufferExamples::BspPoint{ 100.0, 8.0, 9.0 }));
  EXPECT_EQ(map.FindOrigins("light")[0][2], 3.0);
  EXPECT_TRUE(map.FindOrigins("team").empty());
}

TEST(StudyMap, SaysWhatIsWrongWithAFile)
{
  EXPECT_EQ(GetError(Join(MakeLumps())), "");
  EXPECT_EQ(GetError("PK\3\4"), "no map: it does not begin with IBSP");
  EXPECT_EQ(GetError("IBSP"), "damaged map: its directory ends after the file does");
  EXPECT_EQ(
    GetError(Join(MakeLumps(), 47)), "a map of version 47, and only 46 (Quake III) is known");
  std::vector<std::string> lumps = MakeLumps();
  lumps[16].clear();
  EXPECT_EQ(GetError(Join(lumps)), "the map was compiled without its table of visibility");
  EXPECT_EQ(GetError(Change(3, 4, -7)), "damaged map: node 0 has no child -7");
  EXPECT_EQ(GetError(Change(3, 8, 0)), "damaged map: node 0 has two parents");
  EXPECT_EQ(GetError(Change(3, 0, 2)), "damaged map: entry 0 of its nodes refers to 2 of 2");
  EXPECT_EQ(GetError(Change(4, 0, 2)), "damaged map: leaf 0 is in cluster 2 of 2");
  EXPECT_EQ(
    GetError(Change(5, 4, 4)), "damaged map: entry 1 of its faces of leaves refers to 4 of 4");
  EXPECT_EQ(
    GetError(Change(10, 0, 0x7f800000)), "damaged map: a number of its vertices is not finite");
  EXPECT_EQ(GetError(Change(11, 4, 4)), "damaged map: face 0 of 4 vertices has the index 4");
  EXPECT_EQ(GetError(Change(13, 8, 9)), "damaged map: face 0 is of the unknown kind 9");
  EXPECT_EQ(GetError(Change(13, 104 + 96, 4)), "damaged map: patch 1 of 4 x 3 points has 9");
  EXPECT_EQ(GetError(Change(13, 16, 0x7fffffff)),
    "damaged map: entry 0 of its faces refers to 2147483647 entries from 0 on, of 13");
  EXPECT_EQ(GetError(Change(16, 0, 17)),
    "damaged map: its table of visibility has not the size that it says");
}

TEST(StudyMap, EveryFileThatIsCutOffIsAnError)
{
  const std::string file = Join(MakeLumps());
  for (std::size_t size = 0; size < file.size(); ++size)
  {
    EXPECT_NE(GetError(file.substr(0, size)), "") << size << " bytes";
  }
}

TEST(StudyMap, ChangedBytesAreAnErrorOrAMap)
{
  const std::string file = Join(MakeLumps());
  int errors = 0;
  for (std::size_t i = 0; i < file.size(); ++i)
  {
    for (int value : { 0x00, 0x01, 0x7f, 0x80, 0xff })
    {
      std::string changed = file;
      changed[i] = static_cast<char>(value);
      try
      {
        const BspMap map(changed);
        // Nothing that it answers may fail.
        for (std::size_t face = 0; face < map.GetFaces().size(); ++face)
        {
          map.GetMesh(face, 2);
          map.GetClusters(face);
        }
        map.MaySee(map.FindCluster({ 4.0, 0.0, 0.0 }), 1);
        map.GetOpaqueLength({ 4.0, 0.0, 0.0 }, { -4.0, 0.0, 0.0 });
        map.FindOrigins("info_");
      }
      catch (const std::runtime_error& error)
      {
        EXPECT_FALSE(std::string(error.what()).empty());
        ++errors;
      }
    }
  }
  EXPECT_GT(errors, 500);
}
