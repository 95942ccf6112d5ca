// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK leaves undefined is not in the scenarios.
#include "Undefined.h"

#include <gtest/gtest.h>

using namespace TestScene;

// With a render pass a selector of VTK 9.1 reads the number of a prop that it has never set.
TEST(FuzzUndefined, NothingIsSelectedWithAPassThatComesLater)
{
  Scenario scenario;
  scenario.Renderers.resize(1);
  scenario.Changes.resize(2);
  scenario.Changes[0].Kind = ChangeKind::Select;
  scenario.Changes[1].Kind = ChangeKind::Pass;
  scenario.Changes[1].Values = { static_cast<double>(PassKind::None) };
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Changes.size(), 2u) << "without a pass a selection is defined";
  scenario.Changes[1].Values = { static_cast<double>(PassKind::SSAO) };
  RemoveUndefined(scenario);
  ASSERT_EQ(scenario.Changes.size(), 1u);
  EXPECT_EQ(scenario.Changes[0].Kind, ChangeKind::Pass);
}

// Where a flat triangle has no extent, or ends near the horizon, its normals may be NaN.
TEST(FuzzUndefined, NoFlatTrianglesUnderAmbientOcclusion)
{
  Scenario scenario;
  scenario.Renderers.resize(1);
  scenario.Props.resize(1);
  scenario.Props[0].Flat = true;
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Props[0].Flat);
  scenario.Renderers[0].SSAO = true;
  RemoveUndefined(scenario);
  EXPECT_FALSE(scenario.Props[0].Flat);
}

// VTK alone draws them with the shader program of the prop before them.
TEST(FuzzUndefined, NoUnlitPropsWithShadowMaps)
{
  Scenario scenario;
  scenario.Renderers.resize(2);
  scenario.Props.resize(1);
  scenario.Props[0].Lighting = false;
  RemoveUndefined(scenario);
  EXPECT_FALSE(scenario.Props[0].Lighting);
  scenario.Renderers[1].Shadows = true;
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Props[0].Lighting);
}

// A billboard that two renderers share depends on which of them was modified last.
TEST(FuzzUndefined, NoSharedBillboardsWithShadowVolumes)
{
  Scenario scenario;
  scenario.Renderers.resize(2);
  scenario.Props.resize(1);
  scenario.Props[0].Kind = PropKind::Billboard;
  scenario.Renderers[0].Pass = PassKind::ShadowVolumes;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[0].Kind, PropKind::Billboard);
  scenario.Renderers[1].SharesProps = true;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[0].Kind, PropKind::Actor);
}

namespace
{
/// Expects that a change is removed if a clipped prop is of this kind, and kept if it is an actor.
void ExpectRemoved(ChangeKind change, PropKind kind)
{
  Scenario scenario;
  scenario.Props.resize(1);
  scenario.Props[0].ClippingPlane = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 };
  scenario.Changes.push_back({ 1, change, 0, { 1.0 } });
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Changes.size(), 1U);
  scenario.Props[0].Kind = kind;
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Changes.empty());
}
}

// VTK alone crashes with splats in a window that gets another context.
TEST(FuzzUndefined, NoNewContextWithSplats)
{
  ExpectRemoved(ChangeKind::NewContext, PropKind::Splats);
}

// VTK 9.1 alone draws such splats in another color each time.
TEST(FuzzUndefined, NoEdgesOfSplats)
{
  ExpectRemoved(ChangeKind::Edges, PropKind::Splats);
  Scenario scenario;
  scenario.Props.resize(2);
  scenario.Props[0].Edges = scenario.Props[1].Edges = true;
  scenario.Props[1].Kind = PropKind::Splats;
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Props[0].Edges);
  EXPECT_FALSE(scenario.Props[1].Edges);
}

// VTK 9.1 alone crashes with such glyphs.
TEST(FuzzUndefined, NoEdgesOfClippedGlyphs)
{
  ExpectRemoved(ChangeKind::Edges, PropKind::Glyphs);
  Scenario scenario;
  scenario.Props.resize(3);
  scenario.Props[0].Edges = scenario.Props[1].Edges = scenario.Props[2].Edges = true;
  scenario.Props[1].Kind = scenario.Props[2].Kind = PropKind::Glyphs;
  scenario.Props[2].Id = 2;
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Props[2].Edges) << "nothing is clipped";
  scenario.Props[0].ClippingPlane =
    scenario.Props[1].ClippingPlane = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 };
  scenario.Changes.push_back({ 1, ChangeKind::ClippingPlane, 2, { 1.0 } });
  RemoveUndefined(scenario);
  EXPECT_TRUE(scenario.Props[0].Edges);
  EXPECT_FALSE(scenario.Props[1].Edges);
  EXPECT_FALSE(scenario.Props[2].Edges);
}

TEST(FuzzUndefined, NoMappersThatCannotBeShared)
{
  Scenario scenario;
  scenario.Props.resize(7);
  for (int i = 0; i < 7; ++i)
  {
    scenario.Props[i].Id = i;
    scenario.Props[i].MapperOf = i > 0 ? 0 : -1;
  }
  scenario.Props[0].Kind = PropKind::NoMapper;
  scenario.Props[1].Kind = PropKind::Follower;
  scenario.Props[2].Renderer = 1;
  scenario.Props[4].Renderer = 1;
  scenario.Props[4].Kind = PropKind::Assembly;
  scenario.Props[5].PartOf = 4;
  scenario.Props[6].BackOpacity = 0.5;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[1].MapperOf, -1);
  EXPECT_EQ(scenario.Props[2].MapperOf, -1);
  EXPECT_EQ(scenario.Props[3].MapperOf, 0);
  EXPECT_EQ(scenario.Props[5].MapperOf, -1);
  EXPECT_EQ(scenario.Props[6].MapperOf, -1);
}

// VTK draws glyphs of lines as wide as the lines before them, be it in an earlier scenario.
TEST(FuzzUndefined, NoWireframesOfGlyphs)
{
  Scenario scenario;
  scenario.Props.resize(2);
  scenario.Props[0].Representation = scenario.Props[1].Representation = Representation::Wireframe;
  scenario.Props[1].Kind = PropKind::Glyphs;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[0].Representation, Representation::Wireframe);
  EXPECT_EQ(scenario.Props[1].Representation, Representation::Surface);
}

// A renderer without cullers draws them as opaque once.
TEST(FuzzUndefined, NoTranslucentScalarsOfFilters)
{
  Scenario scenario;
  scenario.Props.resize(1);
  scenario.Props[0].Kind = PropKind::Piped;
  scenario.Props[0].Scalars = Translucency::Opaque;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[0].Kind, PropKind::Piped);
  scenario.Props[0].Scalars = Translucency::Some;
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[0].Kind, PropKind::Actor);
}

// VTK crashes when it draws the selection of a mapper whose buffers it has released, and colors it
// at random where the prop has edges.
TEST(FuzzUndefined, NoSelectionsOfReleasedPropsAndOfThoseWithEdges)
{
  Scenario scenario;
  scenario.Props.resize(3);
  scenario.Props[1].Id = 1;
  scenario.Props[2].Id = 2;
  scenario.Props[2].MapperOf = 0;
  scenario.Props[0].Edges = scenario.Props[1].Edges = true;
  scenario.Changes = { { 1, ChangeKind::MarkedCells, 0, { 1.0 } }, { 2, ChangeKind::Rejoin, 0, {} },
    { 2, ChangeKind::Rejoin, 1, {} }, { 2, ChangeKind::Rejoin, 2, {} },
    { 2, ChangeKind::NewContext, 0, {} } };
  RemoveUndefined(scenario);
  ASSERT_EQ(scenario.Changes.size(), 2u);
  EXPECT_EQ(scenario.Changes[1].Target, 1);
  EXPECT_FALSE(scenario.Props[0].Edges);
  EXPECT_TRUE(scenario.Props[1].Edges);
}

// Composite mappers keep texture units, until VTK has no more of them.
TEST(FuzzUndefined, NotManyCompositeProps)
{
  Scenario scenario;
  scenario.Props.resize(40);
  for (Prop& prop : scenario.Props)
  {
    prop.Kind = PropKind::Composite;
  }
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Props[23].Kind, PropKind::Composite);
  EXPECT_EQ(scenario.Props[24].Kind, PropKind::Actor);
}

// VTK does not notice that a block has moved. It may compute a clipping range from old bounds, and
// leave the prop out by them.
TEST(FuzzUndefined, NoOldBoundsOfBlocksThatMove)
{
  Scenario scenario;
  scenario.Props.resize(1);
  scenario.Views.resize(2);
  scenario.Views[1].Near = 1.0;
  scenario.Views[1].Far = 7.0;
  scenario.Changes = { { 1, ChangeKind::MovePoints, 0, { 1.0 } } };
  RemoveUndefined(scenario);
  EXPECT_EQ(scenario.Views[0].Far, 0.0) << "not composite";
  scenario.Props[0].Kind = PropKind::Composite;
  RemoveUndefined(scenario);
  EXPECT_GT(scenario.Views[0].Far, scenario.Views[0].Near);
  EXPECT_EQ(scenario.Views[1].Far, 7.0);
  EXPECT_EQ(scenario.Culler.DefaultCuller, DefaultCuller::Removed);
}

// Splats keep the global offset with which their shaders were made.
TEST(FuzzUndefined, NoChangedOffsetOfSplats)
{
  ExpectRemoved(ChangeKind::PolygonOffset, PropKind::Splats);
}
