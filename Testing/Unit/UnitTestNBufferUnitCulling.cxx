// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which units are kept, that is drawn before the first test, after tests with given depths.
#include "vtkNBufferLevels.h"
#include "vtkNBufferUnitCulling.h"

#include <gtest/gtest.h>

#include <algorithm>
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
    this->Projection.Set(identity, Size, Size, 0x1p-24);
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
}
