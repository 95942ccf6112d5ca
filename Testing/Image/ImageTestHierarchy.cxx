// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Culling over a hierarchy: the image of every frame, and when the hierarchy is built and refit.
#include "CullerTest.h"
#include "Scenes.h"
#include "Tune.h"
#include "vtkNBufferCandidateTree.h"

#include "vtkProperty.h"
#include "vtkRenderer.h"

using Scenes::Wall;

namespace
{
ComparisonOptions MakeHierarchyOptions(int hierarchySize)
{
  ComparisonOptions options;
  options.KeepDefaultCuller = false;
  options.Tuning.HierarchySize = hierarchySize;
  return options;
}

/// A frame with the camera elsewhere.
const vtkNBufferStatistics& MoveAndRender(
  Comparison& comparison, double shift, const std::string& what)
{
  Scenes::FrameOfWall(comparison, shift, what);
  EXPECT_EQ(comparison.GetDecision(), Decision::Culled) << what;
  return comparison.GetStatistics();
}
}

// Hazard: a prop is left out because of something that is true only of its neighbours in the
// hierarchy.
TEST(CullerHierarchy, VerdictsAreThoseOfTheTestOneByOne)
{
  const auto build = [](Stage& stage) { Scenes::BuildCity(stage); };
  Comparison flat(build, MakeHierarchyOptions(VTK_INT_MAX));
  Comparison tree(build, MakeHierarchyOptions(0));
  long long queriesSaved = 0;
  for (int i = 0; i <= 20; ++i)
  {
    for (Comparison* comparison : { &flat, &tree })
    {
      comparison->Both([i](Stage& stage) { Scenes::SetCityCamera(stage.GetRenderer(), 0.05 * i); });
      comparison->Frame("frame " + std::to_string(i));
    }
    const vtkNBufferStatistics& one = flat.GetStatistics();
    const vtkNBufferStatistics& other = tree.GetStatistics();
    EXPECT_EQ(one.Nodes, 0);
    EXPECT_GT(other.Nodes, 0);
    EXPECT_EQ(one.Candidates, other.Candidates);
    EXPECT_EQ(one.GetCount(Verdict::Outside), other.GetCount(Verdict::Outside));
    EXPECT_EQ(one.GetCount(Verdict::NearPlane), other.GetCount(Verdict::NearPlane));
    EXPECT_LE(one.GetCount(Verdict::Hidden), other.GetCount(Verdict::Hidden));
    queriesSaved += one.Queries - other.Queries;
  }
  EXPECT_GT(queriesSaved, 0);
}

TEST(CullerHierarchy, IsBuiltOnceForAListThatStays)
{
  Comparison comparison(Scenes::BuildWall, MakeHierarchyOptions(0));
  int builds = 0;
  for (int i = 0; i < 8; ++i)
  {
    const vtkNBufferStatistics& statistics =
      MoveAndRender(comparison, 0.1 * i, "frame " + std::to_string(i));
    EXPECT_GT(statistics.Nodes, 0);
    EXPECT_EQ(statistics.Refits, 0);
    builds += statistics.Builds;
    EXPECT_EQ(builds, 1);
  }
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Frame("still");
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  EXPECT_EQ(comparison.GetStatistics().Nodes, 0);
  EXPECT_EQ(comparison.GetStatistics().Builds, 0);
}

// Hazard: a prop moves, and is tested at its former place.
TEST(CullerHierarchy, IsRefitToPropsThatMove)
{
  Comparison comparison(Scenes::BuildWall, MakeHierarchyOptions(0));
  MoveAndRender(comparison, 0.0, "first");
  MoveAndRender(comparison, 0.1, "second");
  const int props[] = { Wall::FirstBehind, Wall::FirstBehind + 7, Wall::FirstInFront };
  for (int i = 0; i < 6; ++i)
  {
    comparison.Both(
      [&](Stage& stage)
      {
        for (int prop : props)
        {
          // Before the wall, back again, and out of view.
          const double z[] = { 6.0, -6.0, 0.0 };
          stage.GetActor(prop)->AddPosition(i % 3 == 2 ? 50.0 : 0.3, 0.0, z[i % 3]);
        }
      });
    // With the camera and without.
    if (i % 2 == 0)
    {
      Scenes::MoveWallCamera(comparison, 0.2 + 0.1 * i);
    }
    comparison.Frame("moved " + std::to_string(i));
    EXPECT_EQ(comparison.GetStatistics().Refits, 3);
    EXPECT_EQ(comparison.GetStatistics().Builds, 0);
    EXPECT_GT(comparison.GetStatistics().Nodes, 0);
  }
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind), Verdict::Outside);
}

// Hazard: a frame in which very many props move tests them one by one. In the next one nothing
// moves, and the hierarchy has the boxes of before.
TEST(CullerHierarchy, IsRefitAfterAFrameInWhichVeryManyMoved)
{
  constexpr int boxes = vtkNBufferCandidateTree::FewChanges + 64;
  const auto build = [](Stage& stage)
  {
    Scenes::BuildWall(stage);
    for (int i = 0; i < boxes; ++i)
    {
      Scenes::AddBox(stage, 100.0 + 0.3 * (i % 32), 0.2 * (i / 32) - 3.0, 3.0, 0.2, 0.1, 0.1);
    }
  };
  Comparison comparison(build, MakeHierarchyOptions(0));
  MoveAndRender(comparison, 0.0, "first");
  MoveAndRender(comparison, 0.1, "second");
  EXPECT_GE(comparison.GetStatistics().GetCount(Verdict::Outside), boxes);
  comparison.Both(
    [](Stage& stage)
    {
      for (int i = 0; i < boxes; ++i)
      {
        stage.GetActor(Wall::Count + i)->AddPosition(-104.0, 0.0, 0.0);
      }
    });
  MoveAndRender(comparison, 0.1, "moved");
  EXPECT_EQ(comparison.GetStatistics().Nodes, 0);
  MoveAndRender(comparison, 0.15, "only the camera");
  EXPECT_GT(comparison.GetStatistics().Nodes, 0);
  EXPECT_LT(comparison.GetStatistics().GetCount(Verdict::Outside), boxes / 2);
}

// Hazard: the list of props changes, and the hierarchy refers to places of the old list.
TEST(CullerHierarchy, IsBuiltAgainWhenTheListHasChangedAndStays)
{
  Comparison comparison(Scenes::BuildWall, MakeHierarchyOptions(0));
  MoveAndRender(comparison, 0.0, "first");
  MoveAndRender(comparison, 0.1, "second");
  const auto check = [&comparison](double shift, const std::string& what)
  {
    EXPECT_EQ(MoveAndRender(comparison, shift, what + ", one by one").Nodes, 0) << what;
    const vtkNBufferStatistics& statistics = MoveAndRender(comparison, shift + 0.05, what);
    EXPECT_EQ(statistics.Builds, 1) << what;
    EXPECT_GT(statistics.Nodes, 0) << what;
  };
  comparison.Both(
    [](Stage& stage) { stage.GetRenderer()->RemoveViewProp(stage.Props[Wall::FirstBehind + 3]); });
  check(0.2, "removed");
  comparison.Both(
    [](Stage& stage) { stage.GetRenderer()->AddViewProp(stage.Props[Wall::FirstBehind + 3]); });
  check(0.3, "added");
  // With a list that changes in every frame a hierarchy is never worth its cost.
  for (int i = 0; i < 6; ++i)
  {
    comparison.Both(
      [i](Stage& stage) { stage.GetActor(Wall::FirstBehind)->SetVisibility(i % 2 == 0 ? 0 : 1); });
    const vtkNBufferStatistics& statistics =
      MoveAndRender(comparison, 0.5 + 0.05 * i, "shown " + std::to_string(i));
    EXPECT_EQ(statistics.Nodes + statistics.Builds, 0);
  }
}

// Hazard: a prop becomes a candidate, or ceases to be one, while its place in the list stays the
// same.
TEST(CullerHierarchy, PropsThatBecomeAndCeaseToBeCandidates)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      stage.GetActor(Wall::FirstBehind + 1)->GetProperty()->SetRepresentationToWireframe();
    },
    MakeHierarchyOptions(0));
  MoveAndRender(comparison, 0.0, "first");
  MoveAndRender(comparison, 0.1, "second");
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + 1), Verdict::NotASurface);
  comparison.Both(
    [](Stage& stage)
    {
      stage.GetActor(Wall::FirstBehind + 1)->GetProperty()->SetRepresentationToSurface();
      stage.GetActor(Wall::FirstBehind + 2)->GetProperty()->SetRepresentationToWireframe();
      stage.GetActor(Wall::FirstBehind + 3)->GetProperty()->SetOpacity(0.5);
    });
  MoveAndRender(comparison, 0.2, "changed");
  MoveAndRender(comparison, 0.3, "and again");
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + 1), Verdict::Hidden);
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + 2), Verdict::NotASurface);
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + 3), Verdict::Hidden);
  EXPECT_EQ(comparison.GetStatistics().Builds, 0);
  // While it is no candidate nobody follows it; then it is elsewhere.
  comparison.Both(
    [](Stage& stage) { stage.GetActor(Wall::FirstBehind + 2)->AddPosition(0.0, 0.0, 8.0); });
  MoveAndRender(comparison, 0.4, "moved");
  comparison.Both([](Stage& stage)
    { stage.GetActor(Wall::FirstBehind + 2)->GetProperty()->SetRepresentationToSurface(); });
  MoveAndRender(comparison, 0.5, "a surface again");
  MoveAndRender(comparison, 0.6, "and seen");
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind + 2), Verdict::Visible);
}

TEST(CullerHierarchy, SizeMayChangeAtAnyTime)
{
  Comparison comparison(Scenes::BuildWall, MakeHierarchyOptions(Wall::Count + 1));
  EXPECT_EQ(MoveAndRender(comparison, 0.0, "too few").Nodes, 0);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::HierarchySize, Wall::Count);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::HierarchySize, 0);
  EXPECT_GT(MoveAndRender(comparison, 0.1, "built").Nodes, 0);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::HierarchySize, VTK_INT_MAX);
  comparison.Both(
    [](Stage& stage) { stage.GetActor(Wall::FirstBehind)->AddPosition(0.0, 0.0, 6.0); });
  EXPECT_EQ(MoveAndRender(comparison, 0.2, "off").Nodes, 0);
  Tune(comparison.GetCuller(), &vtkNBufferTuning::HierarchySize, 0);
  MoveAndRender(comparison, 0.3, "on");
  EXPECT_GT(MoveAndRender(comparison, 0.4, "and built").Nodes, 0);
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden - 1);
}
