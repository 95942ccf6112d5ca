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

// Hazard: exactly the same geometry many times over; only the last in the list shows.
TEST(CullerHazards, TheSameQuadFiftyTimes)
{
  Comparison comparison(
    [](Stage& stage)
    {
      for (int i = 0; i < 50; ++i)
      {
        AddQuad(stage, -2.0, -2.0, 2.0, 2.0, 0.0);
      }
      Scenes::AddBox(stage, 0.0, 0.0, 2.0, 4.0, 4.0, 0.1);
      LookAt(stage, 0.0, 0.0, 12.0);
    });
  for (int i = 0; i < 8; ++i)
  {
    comparison.Both(
      [i](Stage& stage) { stage.GetActor(50)->SetPosition(i % 4 == 3 ? 9.0 : i % 4, 0.0, 0.0); });
    comparison.Frame();
    // None is hidden by another one's equal depth.
    EXPECT_TRUE(i % 4 == 0 || comparison.GetHidden() == 0) << comparison.GetHidden();
  }
  for (int i = 0; i < 4; ++i)
  {
    comparison.Both(
      [i](Stage& stage)
      {
        stage.GetActor(50)->SetPosition(0.0, 0.0, 0.0);
        LookAt(stage, 0.01 * i, 0.0, 12.0);
      });
    comparison.Frame("behind the door");
  }
  for (int i = 0; i < 50; ++i)
  {
    EXPECT_EQ(comparison.GetVerdict(i), Verdict::Hidden) << i;
  }
}

// Hazard: a decal lies on the face of a box: its nearest depth is the farthest depth there.
TEST(CullerHazards, DecalsOnFaces)
{
  Comparison comparison(
    [](Stage& stage)
    {
      for (int i = 0; i < 8; ++i)
      {
        for (int j = 0; j < 5; ++j)
        {
          const double x = 1.5 * i - 5.0;
          const double y = 1.3 * j - 2.5;
          Scenes::AddBox(stage, x, y, -0.5, 1.0, 1.0, 1.0);
          AddQuad(stage, x - 0.3, y - 0.3, x + 0.3, y + 0.3, 0.0);
          AddQuad(stage, x - 0.2, y - 0.2, x + 0.2, y + 0.2, 0.0, 3);
        }
      }
      Scenes::AddBox(stage, 0.0, 0.0, 3.0, 4.0, 3.0, 0.2);
    });
  for (int i = 0; i < 10; ++i)
  {
    comparison.Both([i](Stage& stage) { LookAt(stage, 6.0 * std::sin(0.8 * i), 0.3 * i, 14.0); });
    comparison.Frame();
    EXPECT_GT(comparison.GetHidden(), 5);
  }
}

// Hazard: tiles that abut share edges and faces; boxes flush with their neighbours' faces.
TEST(CullerHazards, AbuttingTilesAndBoxes)
{
  Comparison comparison(
    [](Stage& stage)
    {
      for (int i = 0; i < 12; ++i)
      {
        for (int j = 0; j < 8; ++j)
        {
          AddQuad(stage, i - 6.0, j - 4.0, i - 5.0, j - 3.0, 0.0);
          Scenes::AddBox(stage, i - 5.5, j - 3.5, -0.5 - (i + j) % 2, 1.0, 1.0, 1.0);
        }
      }
    });
  for (int i = 0; i < 8; ++i)
  {
    comparison.Both([i](Stage& stage) { LookAt(stage, 0.8 * i - 3.0, 0.2 * i, 13.0); });
    comparison.Frame();
    EXPECT_GT(comparison.GetHidden(), 10);
  }
}

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

// Hazard: the eye flies through the props, inside and out again.
TEST(CullerHazards, FlyingThroughBoxes)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  for (int i = 0; i < 24; ++i)
  {
    comparison.Both(
      [i](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(0.2, 0.1, 4.0 - 0.5 * i);
        camera->SetFocalPoint(0.1, 0.0, -20.0);
        stage.GetRenderer()->ResetCameraClippingRange();
      });
    comparison.Frame();
    EXPECT_TRUE(i > 7 || comparison.GetHidden() > 15) << "before the wall";
  }
}

// Hazard: a near plane set by hand cuts the wall open and shows what is behind it.
TEST(CullerHazards, NearPlaneCutsTheOccluder)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  for (double near : { 19.0, 19.9, 20.0, 20.2, 20.3, 22.0, 25.0, 1.0 })
  {
    comparison.Both([near](Stage& stage)
      { stage.GetRenderer()->GetActiveCamera()->SetClippingRange(near, 40.0); });
    comparison.Frame("near " + std::to_string(near));
    // The wall ends at 20.25.
    EXPECT_TRUE(near < 2.0 || near > 20.25 || comparison.GetHidden() > 40);
    EXPECT_TRUE(near < 20.25 || comparison.GetHidden() < 10) << "they hide each other at most";
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

// Hazard: thousands of specks smaller than a pixel; none may vanish.
TEST(CullerHazards, Specks)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 5.0, 3.0, 0.2);
      std::mt19937 random(5);
      for (int i = 0; i < 600; ++i)
      {
        const double x = 0.012 * static_cast<double>(random() % 1000) - 6.0;
        const double y = 0.008 * static_cast<double>(random() % 1000) - 4.0;
        const double z = 0.004 * static_cast<double>(random() % 1000) - 3.0;
        Scenes::AddBox(stage, x, y, z, 0.02, 0.02, 0.02);
      }
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Both([i](Stage& stage) { LookAt(stage, 0.4 * i, 0.0, 16.0); });
    comparison.Frame();
    EXPECT_GT(comparison.GetHidden(), 50);
  }
}

// Hazard: gaps of about a pixel between slats; a reduced depth must take the farthest.
TEST(CullerHazards, FenceWithNarrowGaps)
{
  for (int factor : { 1, 2, 4, 8 })
  {
    SCOPED_TRACE(factor);
    ComparisonOptions options;
    options.Configure = [factor](vtkNBufferCuller* culler)
    { Tune(culler, &vtkNBufferTuning::BaseFactor, factor); };
    Comparison comparison(
      [](Stage& stage)
      {
        for (int i = 0; i < 60; ++i)
        {
          Scenes::AddBox(stage, 0.2 * i - 6.0, 0.0, 2.0, 0.165, 8.0, 0.05);
        }
        for (int i = 0; i < 60; ++i)
        {
          Scenes::AddBox(stage, 0.19 * i - 5.8, 0.1 * (i % 30) - 1.5, -2.0, 0.15, 0.15, 0.15);
        }
      },
      options);
    for (int i = 0; i < 4; ++i)
    {
      comparison.Both([i](Stage& stage) { LookAt(stage, 0.33 * i, 0.0, 16.0); });
      comparison.Frame();
      EXPECT_GT(comparison.GetHidden(), 5);
    }
  }
}

// Hazard: coordinates of millions with details of centimetres; vertices are rounded to float.
TEST(CullerHazards, FarFromTheOrigin)
{
  for (double offset : { 1e4, 1e6, 5e6 })
  {
    SCOPED_TRACE(offset);
    const auto camera = [offset](Stage& stage, double shift)
    {
      vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
      camera->SetPosition(offset + shift, offset, 20.0);
      camera->SetFocalPoint(offset, offset, 0.0);
      stage.GetRenderer()->ResetCameraClippingRange();
    };
    Comparison comparison(
      [offset](Stage& stage)
      {
        Scenes::AddBox(stage, offset, offset, 0.0, 12.0, 6.0, 0.5);
        for (int i = 0; i < 60; ++i)
        {
          Scenes::AddBox(
            stage, offset + 0.13 * i - 4.0, offset + 0.05 * (i % 50) - 1.0, -3.0, 0.6, 0.6, 0.6);
          Scenes::AddBox(stage, offset + 0.13 * i - 4.0, offset + 3.0, 0.26, 0.01, 0.01, 0.01);
        }
      });
    for (int i = 0; i < 4; ++i)
    {
      comparison.Both([&camera, i](Stage& stage) { camera(stage, 0.7 * i); });
      comparison.Frame();
      // The first frame draws the specks before the wall and the second one finds out. VTK moves
      // points like these near to zero before it rounds them to float, so that far away as many
      // are hidden as near the origin.
      EXPECT_TRUE(i < 2 || comparison.GetHidden() > 50) << comparison.GetHidden();
    }
  }
}

// Hazard: a large model matrix undone by small coordinates, and the other way round.
TEST(CullerHazards, LargeMatricesAndScales)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 0; i < 30; ++i)
      {
        const double scale = std::pow(10.0, i % 7 - 3);
        const double x = 0.25 * i - 4.0;
        const double z = i % 2 ? -3.0 : 2.0;
        const int index =
          Scenes::AddBox(stage, 1e3 / scale, 0.0, 0.0, 0.5 / scale, 0.5 / scale, 0.5 / scale);
        stage.GetActor(index)->SetScale(scale);
        stage.GetActor(index)->SetPosition(x - 1e3, 0.3, z);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Both([i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), 0.5 * i); });
    comparison.Frame();
    EXPECT_GE(comparison.GetHidden(), Wall::Hidden - 10);
  }
}

// Hazard: depth is squeezed towards 1 with a near plane of a millimetre.
TEST(CullerHazards, ExtremeClippingRanges)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  const double ranges[][2] = { { 1e-3, 1e4 }, { 1e-3, 1e7 }, { 0.1, 1e7 }, { 10.0, 30.0 } };
  for (const auto& range : ranges)
  {
    for (int i = 0; i < 3; ++i)
    {
      comparison.Both(
        [&range, i](Stage& stage)
        {
          Scenes::SetWallCamera(stage.GetRenderer(), 0.2 * i);
          stage.GetRenderer()->GetActiveCamera()->SetClippingRange(range);
        });
      comparison.Frame(std::to_string(range[0]) + " to " + std::to_string(range[1]));
      EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
    }
  }
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
