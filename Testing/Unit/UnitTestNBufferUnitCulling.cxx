// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which units are kept, that is drawn before the first test, after tests with given depths.
#include "vtkNBufferLevels.h"
#include "vtkNBufferUnitChoice.h"
#include "vtkNBufferUnitCulling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr int Size = 32;

/// Four triangles side by side, each of them a unit, at half of the depth of a parallel view.
class UnitsThatAreKept : public testing::Test
{
protected:
  void SetUp() override
  {
    const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    this->Projection.Set(identity, Size, Size, vtkNBufferDepthFormat::FromQuantum(0x1p-24));
    vtkNBufferUnits::Mesh mesh;
    for (int i = 0; i < 4; ++i)
    {
      const double x = -0.95 + 0.5 * i;
      for (const glm::dvec3& point :
        { glm::dvec3(x, -0.5, 0.0), glm::dvec3(x + 0.4, -0.5, 0.0), glm::dvec3(x, 0.5, 0.0) })
      {
        mesh.Indices.push_back(static_cast<unsigned int>(mesh.Points.size()));
        mesh.Points.push_back(point);
      }
    }
    this->Culling.SetUnits(vtkNBufferUnits::Make(mesh, 1));
    this->Culling.SetRounding({ glm::dvec3(0.0), glm::dvec3(1.0), 0.0 });
    this->Draw(false); // Of a new mesh the nearest unit is drawn; all of them are known afterwards.
    ASSERT_TRUE(this->Draw(false));
  }

  /// Draw a frame in which something hides the first unit, or nothing does. Returns whether the
  /// unit was kept.
  bool Draw(bool isHidden)
  {
    std::vector<float> depth(Size * Size, 1.0F);
    for (std::size_t i = 0; i < depth.size(); ++i)
    {
      depth[i] = isHidden && i % Size < Size / 4 ? 0.25F : 1.0F;
    }
    vtkNBufferLevels levels;
    levels.BuildBase(depth.data(), Size, Size, 1, vtkNBufferExtremum::Maximum);
    levels.BuildLevels(5);
    this->Culling.FindKept(this->Projection);
    const bool isKept = this->Culling.GetDrawn()[0] != 0;
    this->Culling.Test(this->Projection, { levels });
    EXPECT_EQ(this->Culling.GetFresh()[0] != 0, !isHidden && !isKept);
    return isKept;
  }

  vtkNBufferProjection Projection;
  vtkNBufferUnitCulling Culling;
};

// Hazard: all units that are seen through the gaps between those of the last frame are drawn, most
// of which others of them hide.
TEST(UnitsOfANewView, AQuarterOfWhatIsDrawnIsMany)
{
  EXPECT_FALSE(vtkNBufferUnitChoice::AreMany(25, 100));
  EXPECT_TRUE(vtkNBufferUnitChoice::AreMany(26, 100));
}

// Hazard: after a cut everything is drawn that what was visible before does not hide.
TEST(UnitsOfANewView, NearOnesBeforeOthers)
{
  // A fence of 20 x 20 triangles, and 10 behind each of them.
  constexpr int columns = 20;
  constexpr int layers = 11;
  vtkNBufferUnits::Mesh mesh;
  for (int layer = 0; layer < layers; ++layer)
  {
    for (int i = 0; i < columns * columns; ++i)
    {
      const double x = -1.0 + 2.0 * (i % columns) / columns;
      const double y = -1.0 + 2.0 * (i / columns) / columns;
      for (const glm::dvec2& corner : { glm::dvec2(0.0), glm::dvec2(0.09, 0.0), glm::dvec2(0.09) })
      {
        mesh.Indices.push_back(static_cast<unsigned int>(mesh.Points.size()));
        mesh.Points.emplace_back(x + corner.x, y + corner.y, 0.05 * layer);
      }
    }
  }
  const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  constexpr int pixels = 10 * columns;
  vtkNBufferProjection projection;
  projection.Set(identity, pixels, pixels, vtkNBufferDepthFormat::FromQuantum(0x1p-24));
  vtkNBufferUnitCulling culling;
  culling.SetUnits(vtkNBufferUnits::Make(mesh, 1));
  culling.SetRounding({ glm::dvec3(0.0), glm::dvec3(1.0), 0.0 });
  const auto getLevels = [](float depth)
  {
    const std::vector<float> image(pixels * pixels, depth);
    vtkNBufferLevels levels;
    levels.BuildBase(image.data(), pixels, pixels, 1, vtkNBufferExtremum::Maximum);
    levels.BuildLevels(8);
    return levels;
  };
  const auto countInFence = [&culling](const std::vector<unsigned char>& marked)
  {
    int count = 0;
    for (std::size_t i = 0; i < marked.size(); ++i)
    {
      count += marked[i] && culling.GetUnits().GetLevels()[0][i].Low.z == 0.0F;
    }
    return count;
  };
  constexpr int size = columns * columns * layers;

  // All that is known is wrong: the last frame was another view, in which a few were visible.
  culling.FindKept(projection);
  const int kept = culling.GetCounts().Kept;
  EXPECT_EQ(kept, countInFence(culling.GetDrawn()));
  EXPECT_GT(kept, columns * columns / 4);
  EXPECT_LT(kept, size / 8);
  EXPECT_EQ(culling.Test(projection, { getLevels(1.0F) }), size - kept);
  EXPECT_TRUE(culling.PostponeFar(projection));
  const int fresh = culling.CountFresh();
  EXPECT_GT(fresh, columns * columns / 4);
  EXPECT_LT(fresh, size / 8);
  EXPECT_EQ(fresh, std::count(culling.GetFresh().begin(), culling.GetFresh().end(), 1));

  // What has been left out is tested again, and what was drawn counts.
  culling.AddFreshToDrawn();
  const int left = columns * columns - countInFence(culling.GetDrawn());
  EXPECT_EQ(culling.Test(projection, { getLevels(0.51F) }), left);
  EXPECT_EQ(culling.GetCounts().Fresh, fresh + left);
  EXPECT_FALSE(culling.PostponeFar(projection)) << "none hides another one";
  EXPECT_GT(culling.CountKeptInVain(), 0);
  culling.AddFreshToDrawn();
  culling.FindKept(projection);
  EXPECT_EQ(culling.GetCounts().Kept, columns * columns);

  // From a little farther to the side the fence still hides the others, but not from behind.
  const auto turn = [pixels](double degrees)
  {
    const double c = std::cos(glm::radians(degrees));
    const double s = std::sin(glm::radians(degrees));
    const double matrix[16] = { c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1 };
    vtkNBufferProjection turned;
    turned.Set(matrix, pixels, pixels, vtkNBufferDepthFormat::FromQuantum(0x1p-24));
    return turned;
  };
  culling.FindKept(turn(10.0));
  EXPECT_GT(culling.GetCounts().Kept, columns * columns * 3 / 4);
  EXPECT_EQ(culling.GetCounts().Kept, countInFence(culling.GetDrawn()));
  culling.FindKept(turn(180.0));
  EXPECT_GT(culling.GetCounts().Kept, columns * columns / 4);
  EXPECT_LT(culling.GetCounts().Kept, size / 8);
  EXPECT_EQ(countInFence(culling.GetDrawn()), 0);
}

TEST_F(UnitsThatAreKept, NotAfterATestFoundThemHidden)
{
  EXPECT_TRUE(this->Draw(true));
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_FALSE(this->Draw(true));
  }
  EXPECT_FALSE(this->Draw(false));
  EXPECT_TRUE(this->Draw(true));
  EXPECT_FALSE(this->Draw(true)) << "the unit did not come back at once";
}

TEST_F(UnitsThatAreKept, FifteenTestsLongerIfTheyCameBackAtOnce)
{
  EXPECT_TRUE(this->Draw(true));
  EXPECT_FALSE(this->Draw(false));
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_TRUE(this->Draw(true)) << i;
  }
  EXPECT_TRUE(this->Draw(false));
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_TRUE(this->Draw(true)) << i;
  }
  EXPECT_FALSE(this->Draw(true));
}

// Hazard: a trial of ranks counts other units as hidden than the test finds.
using UnitsThatAreHidden = UnitsThatAreKept;

TEST_F(UnitsThatAreHidden, AreCountedByTheSamplesOfTheWindow)
{
  // The triangles reach from row 8 to row 24, and their borders, without the middle of any pixel,
  // into the rows beside them, which nothing hides.
  std::vector<float> depth(Size * Size, 1.0F);
  std::fill(depth.begin() + 8 * Size, depth.begin() + 24 * Size, 0.25F);
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), Size, Size, 1, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(5);
  for (const bool isSingle : { true, false })
  {
    const vtkNBufferUnitCulling::Depth compared = { levels, nullptr, isSingle ? 0.0 : 0.5 };
    const int hidden = this->Culling.CountHidden(this->Projection, compared);
    EXPECT_EQ(hidden, isSingle ? 4 : 0);
    this->Culling.FindKept(this->Projection);
    this->Culling.ClearDrawn();
    EXPECT_EQ(this->Culling.Test(this->Projection, compared), 4 - hidden);
  }
}
}
