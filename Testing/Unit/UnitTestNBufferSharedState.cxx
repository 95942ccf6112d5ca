// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which shared objects are used in several ways, in any order of the props.
#include "vtkNBufferSharedState.h"

#include "vtkNew.h"
#include "vtkPolyDataMapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
using Uses = vtkNBufferSharedState::Uses;

vtkNBufferSharedState Collect(const std::vector<Uses>& all)
{
  vtkNBufferSharedState state;
  std::for_each(all.begin(), all.end(), [&state](const Uses& uses) { state.Add(uses); });
  std::for_each(all.begin(), all.end(), [&state](const Uses& uses) { state.AddCommon(uses); });
  return state;
}

Uses Make(const int& object, std::size_t way)
{
  Uses uses;
  uses[vtkNBufferSharedState::Shaders] = { &object, way };
  return uses;
}
}

TEST(NBufferSharedState, MixedObjectsAreFoundInAnyOrder)
{
  const int a = 0;
  const int b = 0;
  const int c = 0;
  for (const std::size_t wayOfB : { 1, 2 })
  {
    std::vector<Uses> all = { Make(a, 1), Make(a, 2), Make(b, wayOfB), Make(b, wayOfB), Make(c, 2),
      Uses() };
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      std::rotate(all.begin(), all.begin() + 1, all.end());
      const vtkNBufferSharedState state = Collect(all);
      EXPECT_TRUE(state.IsMixed(Make(a, 1))) << i;
      EXPECT_TRUE(state.IsMixed(Make(a, 2))) << i;
      EXPECT_FALSE(state.IsMixed(Make(b, wayOfB))) << i;
      EXPECT_FALSE(state.IsMixed(Make(c, 2))) << i;
      EXPECT_FALSE(state.IsMixed(Uses())) << i;
    }
  }
  EXPECT_FALSE(Collect({ Make(a, 2), Make(a, 2), Make(b, 1), Uses() }).IsMixed(Make(a, 2)));
  EXPECT_FALSE(Collect({}).IsMixed(Make(a, 1)));
}

// A mapper is an object in two places, with a way of using it in each.
TEST(NBufferSharedState, PlacesAreApart)
{
  const int a = 0;
  Uses first = Make(a, 1);
  first[vtkNBufferSharedState::Parameters] = { &a, 3 };
  Uses second = first;
  second[vtkNBufferSharedState::Shaders].Way = 2;
  EXPECT_FALSE(Collect({ first, first }).IsMixed(first));
  const vtkNBufferSharedState state = Collect({ first, second });
  EXPECT_TRUE(state.IsMixed(first));
  EXPECT_TRUE(state.IsMixed(first, vtkNBufferSharedState::Shaders));
  EXPECT_FALSE(state.IsMixed(first, vtkNBufferSharedState::Parameters));
}

// Whether shaders have been made anew is only known where the mapper draws.
TEST(NBufferSharedState, MixedMappersStayMarked)
{
  using State = vtkNBufferSharedState;
  vtkNew<vtkPolyDataMapper> mapper;
  for (const std::size_t place : { State::Parameters, State::Shaders })
  {
    EXPECT_FALSE(State::HasOtherShaders(mapper, place, false));
    EXPECT_TRUE(State::HasOtherShaders(mapper, place, true));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(State::HasOtherShaders(mapper, place, false));
      EXPECT_FALSE(State::HasNewShaders(mapper));
    }
  }
}
