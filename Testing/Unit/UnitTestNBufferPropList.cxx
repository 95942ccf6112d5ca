// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What is stored for each prop stays with it when a renderer's list changes.
#include "vtkNBufferPropList.h"

#include "vtkActor.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace
{
struct Known
{
  explicit Known(vtkProp* prop)
    : Prop(prop)
  {
  }
  vtkProp* Prop;
  std::unique_ptr<int> Note; ///< Can be moved only.
};

class NBufferPropList : public testing::Test
{
protected:
  bool Synchronize(const std::vector<vtkProp*>& props)
  {
    return this->List.Synchronize(props.data(), props.size(), this->Numbers);
  }

  vtkNew<vtkActor> A;
  vtkNew<vtkActor> B;
  vtkNew<vtkActor> C;
  vtkNBufferPropList<Known> List;
  std::vector<int> Numbers;
};
}

TEST_F(NBufferPropList, SameListIsNoChange)
{
  EXPECT_FALSE(this->Synchronize({}));
  EXPECT_TRUE(this->Synchronize({ this->A, this->B }));
  EXPECT_FALSE(this->Synchronize({ this->A, this->B }));
  EXPECT_TRUE(this->Synchronize({ this->A }));
  EXPECT_TRUE(this->Synchronize({}));
  EXPECT_EQ(this->List.GetSize(), 0u);
}

// Hazard: after a prop is removed, other props get what was stored for their neighbours.
TEST_F(NBufferPropList, ItemsStayWithTheirProps)
{
  this->Synchronize({ this->A, this->B, this->C });
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(this->List[i].Prop, this->List.GetProp(i));
    this->List[i].Note = std::make_unique<int>(static_cast<int>(i));
    this->Numbers[i] = 10 + static_cast<int>(i);
  }
  ASSERT_TRUE(this->Synchronize({ this->C, this->A }));
  EXPECT_EQ(*this->List[0].Note, 2);
  EXPECT_EQ(*this->List[1].Note, 0);
  EXPECT_EQ(this->Numbers, (std::vector<int>{ 12, 10 }));
  EXPECT_EQ(this->List.GetProps(), (std::vector<vtkProp*>{ this->C, this->A }));

  // What was known of B is forgotten.
  ASSERT_TRUE(this->Synchronize({ this->A, this->B, this->C }));
  EXPECT_EQ(*this->List[0].Note, 0);
  EXPECT_EQ(this->List[1].Prop, this->B);
  EXPECT_FALSE(this->List[1].Note);
  EXPECT_EQ(this->Numbers, (std::vector<int>{ 10, 0, 12 }));
}

TEST_F(NBufferPropList, FindFollowsTheList)
{
  EXPECT_EQ(this->List.Find(this->A), -1);
  this->Synchronize({ this->A, this->B });
  EXPECT_EQ(this->List.Find(this->B), 1);
  EXPECT_EQ(this->List.Find(this->C), -1);
  this->Synchronize({ this->B, this->C });
  EXPECT_EQ(this->List.Find(this->A), -1);
  EXPECT_EQ(this->List.Find(this->B), 0);
  EXPECT_EQ(this->List.Find(this->C), 1);
}
