// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Geometry on which culling by depth goes wrong first.
#include "CullerTest.h"
#include "Scenes.h"
#include "Tune.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <random>

using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;
using Scenes::Wall;

using Scenes::AddQuad;

namespace
{
void LookAt(
  Stage& stage, double x, double y, double z, double fx = 0.0, double fy = 0.0, double fz = 0.0)
{
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(fx, fy, fz);
  stage.GetRenderer()->ResetCameraClippingRange();
}

}

//------------------------------------------------------------------------------------------------
namespace
{
class CullerTies : public testing::TestWithParam<int>
{
};
}

// Hazard: of equal depths the one drawn last stays, and a culler draws in another order; here
// stacks of coplanar quads of different colours appear from behind a door that slides.
TEST_P(CullerTies, QuadsFacingTheCamera)
{
  for (bool parallel : { true, false })
  {
    SCOPED_TRACE(parallel ? "parallel" : "perspective");
    ComparisonOptions options;
    options.RoundSize = 5; // many rounds, many orders
    Comparison comparison(
      [this, parallel](Stage& stage)
      {
        Scenes::BuildTies(
          stage, static_cast<unsigned int>(this->GetParam()), this->GetParam() % 2 == 0);
        stage.GetRenderer()->GetActiveCamera()->SetParallelProjection(parallel);
        stage.GetRenderer()->GetActiveCamera()->SetParallelScale(4.0);
      },
      options);
    const int door = Scenes::FindDoor(comparison.Reference);
    ASSERT_GE(door, 0);
    for (int i = 0; i < 10; ++i)
    {
      comparison.Both(
        [i, door](Stage& stage)
        {
          stage.GetActor(door)->SetPosition(2.5 * std::sin(1.3 * i), 1.5 * std::cos(0.9 * i), 0.0);
          LookAt(stage, 0.02 * i, 0.0, 15.0, 0.02 * i);
        });
      comparison.Frame();
      EXPECT_GT(comparison.GetHidden(), 0);
    }
    // Jumps: what is visible changes wholly.
    for (int i = 0; i < 6; ++i)
    {
      comparison.Both([i](Stage& stage) { LookAt(stage, i % 2 ? 3.0 : -3.0, 0.0, 15.0); });
      comparison.Frame("jump");
      EXPECT_GT(comparison.GetHidden(), 5);
    }
  }
}

// Hazard: seen at an angle, coplanar quads fight, pixel by pixel, in an order-dependent way.
TEST_P(CullerTies, QuadsAtAnAngle)
{
  ComparisonOptions options;
  options.RoundSize = 7;
  Comparison comparison([this](Stage& stage)
    { Scenes::BuildTies(stage, static_cast<unsigned int>(100 + this->GetParam()), true); },
    options);
  const int door = Scenes::FindDoor(comparison.Reference);
  for (int i = 0; i < 12; ++i)
  {
    comparison.Both(
      [i, door](Stage& stage)
      {
        stage.GetActor(door)->SetPosition(2.5 * std::sin(1.3 * i), 0.0, 0.0);
        LookAt(stage, 9.0 * std::sin(0.7 * i), 3.0 * std::cos(0.5 * i), 12.0);
      });
    comparison.Frame();
    EXPECT_GT(comparison.GetHidden(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Seed, CullerTies, testing::Range(1, 7));

// Hazard: corners behind the eye have no place on the screen; their box must count as visible.
TEST(CullerHazards, BoxesThroughTheNearPlaneAndAroundTheEye)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      Scenes::AddBox(stage, 3.0, 2.0, 15.0, 1.0, 1.0, 40.0);                   // past the eye
      Scenes::AddBox(stage, 0.0, -5.0, 10.0, 40.0, 1.0, 60.0);                 // a floor under it
      const int room = Scenes::AddBox(stage, 0.0, 0.0, 0.0, 90.0, 90.0, 90.0); // around it
      stage.GetActor(room)->GetProperty()->FrontfaceCullingOn();
      Scenes::AddBox(stage, 0.0, 0.0, 40.0, 1.0, 1.0, 1.0); // behind it
    });
  for (int i = 0; i < 6; ++i)
  {
    comparison.Both([i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), 0.1 * i); });
    comparison.Frame();
    // The first two reach behind the eye, but not through the near plane in view.
    EXPECT_EQ(comparison.GetVerdict(Wall::Count), Verdict::Visible);
    EXPECT_EQ(comparison.GetVerdict(Wall::Count + 1), Verdict::Visible);
    EXPECT_EQ(comparison.GetVerdict(Wall::Count + 2), Verdict::NearPlane);
    // In the first frame the default culler still stood before ours.
    EXPECT_EQ(comparison.GetVerdict(Wall::Count + 3), i ? Verdict::Outside : Verdict::Unknown);
    // In the first frame the nearest props are drawn untested, in the second as visible before.
    EXPECT_GE(comparison.GetHidden(), i > 1 ? Wall::Hidden : 40);
  }
}

// Hazard: boxes of no thickness, lines and points as bounds. Lines are drawn, hidden or not.
TEST(CullerHazards, FlatThinAndSinglePointBounds)
{
  constexpr int Each = 12; // before and behind the wall
  constexpr int Lines = 6; // of them
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (double z : { 3.0, -3.0 })
      {
        for (int i = 0; i < 10; ++i)
        {
          const double x = 0.7 * i - 3.3;
          vtkNew<vtkPolyData> data;
          vtkNew<vtkPoints> points;
          points->InsertNextPoint(x, 0.5, z);
          vtkNew<vtkCellArray> cells;
          if (i % 3 == 0)
          {
            cells->InsertNextCell({ 0 });
            data->SetVerts(cells);
          }
          else
          {
            points->InsertNextPoint(x + 0.4, i % 3 == 1 ? 0.5 : 0.9, z);
            cells->InsertNextCell({ 0, 1 });
            data->SetLines(cells);
          }
          data->SetPoints(points);
          const double yellow[3] = { 1.0, 1.0, 0.0 };
          vtkActor* actor = stage.AddActor(data, yellow);
          actor->GetProperty()->SetLineWidth(static_cast<float>(1 + i));
          actor->GetProperty()->SetPointSize(static_cast<float>(1 + 2 * i));
        }
        AddQuad(stage, -2.0, -1.0, 2.0, -1.0, z); // an edge
        AddQuad(stage, 2.0, 1.0, 2.0, 1.0, z);    // a point
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  for (int i = 0; i < 6; ++i)
  {
    comparison.Both([i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), 1.7 * i); });
    comparison.Frame();
    EXPECT_TRUE(i < 2 || comparison.GetHidden() >= Wall::Hidden + Each - Lines)
      << comparison.GetHidden();
    for (int k = 0; k < Each; ++k)
    {
      EXPECT_NE(comparison.GetVerdict(Wall::Count + k), Verdict::Hidden) << "before the wall";
      const bool line = k < 10 && k % 3 != 0;
      EXPECT_EQ(comparison.GetVerdict(Wall::Count + Each + k),
        line ? Verdict::NotASurface : Verdict::Hidden)
        << "behind it";
    }
  }
}

// Hazard: wide lines and large points stick out of the projection of their bounds, past the edge
// of what hides the bounds.
TEST(CullerHazards, WideLinesStickOutOfTheirBounds)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 0; i < 24; ++i)
      {
        // Just behind the upper edge of the wall.
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPoints> points;
        const double y = 3.0 - 0.01 * i;
        points->InsertNextPoint(0.4 * i - 5.0, y, -0.4);
        points->InsertNextPoint(0.4 * i - 4.7, y, -0.4);
        data->SetPoints(points);
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({ 0, 1 });
        (i % 2 ? data->SetLines(cells) : data->SetVerts(cells));
        const double yellow[3] = { 1.0, 1.0, 0.0 };
        vtkActor* actor = stage.AddActor(data, yellow);
        actor->GetProperty()->SetLineWidth(8.0);
        actor->GetProperty()->SetPointSize(9.0);
      }
    });
  for (int i = 0; i < 6; ++i)
  {
    comparison.Both([i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), 0.3 * i); });
    comparison.Frame();
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  }
}

// Hazard: the depth of a line goes on beyond its ends, for half a pixel and, where it is seen
// end-on, through the wall before it.
TEST(CullerHazards, LinesSeenEndOn)
{
  constexpr int Actors = 100;
  constexpr int LinesEach = 40;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      std::minstd_rand random(1);
      const auto between = [&random](double a, double b)
      { return a + (b - a) * static_cast<double>(random() % 100000) / 100000.0; };
      for (int i = 0; i < Actors; ++i)
      {
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> cells;
        for (int k = 0; k < LinesEach; ++k)
        {
          const double x = between(-4.0, 4.0);
          const double y = between(-2.0, 2.0);
          // The eye is at z = 20: towards it, but for a pixel or so.
          const double near = 1.0 - (-0.4) / 20.0;
          const double far = 1.0 - (-2.0) / 20.0;
          const auto aside = [&between]() { return between(-0.03, 0.03); };
          points->InsertNextPoint(x * near, y * near, -0.4);
          points->InsertNextPoint(x * far + aside(), y * far + aside(), -2.0);
          cells->InsertNextCell({ 2 * k, 2 * k + 1 });
        }
        data->SetPoints(points);
        data->SetLines(cells);
        const double yellow[3] = { 1.0, 1.0, 0.0 };
        stage.AddActor(data, yellow);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame();
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  }
  EXPECT_EQ(comparison.GetVerdict(Wall::Count), Verdict::NotASurface);
}

// Hazard: long props, the whole of whose nearest depth is that of one end.
TEST(CullerHazards, LongPropsAreTestedInPieces)
{
  const auto build = [](Stage& stage)
  {
    // A corridor wall that recedes, and rails behind it that recede with it.
    Scenes::AddBox(stage, -1.0, 0.0, -20.0, 0.1, 6.0, 50.0);
    for (int i = 0; i < 60; ++i)
    {
      Scenes::AddBox(stage, -1.6 - 0.02 * i, 0.05 * i - 1.5, -22.0, 0.02, 0.02, 44.0);
    }
    stage.GetRenderer()->GetActiveCamera()->SetViewAngle(60.0);
    LookAt(stage, 1.0, 0.0, 4.0, -0.5, 0.0, -20.0);
  };
  int hidden[2] = { 0, 0 };
  for (int pieces : { 1, 8 })
  {
    ComparisonOptions options;
    options.Configure = [pieces](vtkNBufferCuller* c)
    { Tune(c, &vtkNBufferTuning::MaximumNumberOfPieces, pieces); };
    Comparison comparison(build, options);
    for (int i = 0; i < 3; ++i)
    {
      comparison.Both(
        [i](Stage& stage) { LookAt(stage, 1.0 + 0.1 * i, 0.0, 4.0, -0.5, 0.0, -20.0); });
      comparison.Frame();
    }
    hidden[pieces > 1] = comparison.GetHidden();
  }
  EXPECT_GE(hidden[1], hidden[0]);
  EXPECT_GT(hidden[1], 20) << "cut in pieces nearly all of them are behind the wall";
}
