// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The city, spread over the ranks of a parallel program that exchange depth: the composited image
// is that of VTK alone, what walls of other ranks hide is not drawn, and no message is sent that is
// not needed.
#include "RankFrames.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkSmartPointer.h"

#include <string>

using CullerRanks = testing::TestWithParam<std::tuple<int, Spread>>;

TEST_P(CullerRanks, TheCompositedImageIsThatOfVTKAlone)
{
  RankOptions options;
  std::tie(options.Ranks, options.How) = this->GetParam();
  DrawRanks(options);
}

TEST_P(CullerRanks, CutsToAndFro)
{
  RankOptions options;
  std::tie(options.Ranks, options.How) = this->GetParam();
  options.Path = [](int frame) { return frame / 3 % 2 ? 0.9 : 0.1 + 0.01 * frame; };
  DrawRanks(options);
}

INSTANTIATE_TEST_SUITE_P(Each, CullerRanks,
  testing::Combine(testing::Values(2, 3, 7), testing::Values(Spread::Blocks, Spread::Mixed)),
  [](const auto& info)
  {
    return std::to_string(std::get<0>(info.param)) +
      (std::get<1>(info.param) == Spread::Blocks ? "Blocks" : "Mixed");
  });

TEST(CullerRanksDraw, WhatTheWallsOfOtherRanksHideIsNotDrawn)
{
  for (Spread how : { Spread::Blocks, Spread::Mixed })
  {
    RankOptions options;
    options.How = how;
    const std::vector<RankFrame> shared = DrawRanks(options);
    options.Exchange = false;
    const std::vector<RankFrame> local = DrawRanks(options);
    options.Ranks = 1;
    const std::vector<RankFrame> alone = DrawRanks(options);
    EXPECT_LT(Sum(shared, 2), Sum(local, 2));
    // The first frames draw guesses.
    EXPECT_LE(Sum(shared, 2), 1.5 * Sum(alone, 2));
  }
}

TEST(CullerRanksDraw, FewPropsOfEachRankAreManyTogether)
{
  RankOptions options;
  options.Ranks = 12; // Each has 16 or 17 of 197 props, less than MinimumNumberOfCandidates.
  options.Frames = 6;
  const std::vector<RankFrame> frames = DrawRanks(options);
  EXPECT_LT(frames.back().GetDrawn(), 80);
}

TEST(CullerRanksDraw, TheOnlyCandidateOfARankIsNotDrawnWhereOthersHideIt)
{
  RankOptions options;
  options.Frames = 6;
  options.Path = [](int frame) { return 0.1 + 0.001 * frame; };
  // The last rank has only a house at the other end of the city.
  options.Build = [](RankStages& stages, int rank)
  {
    stages.Both(
      [rank](Stage& stage)
      {
        for (int i = 0; i < 197 && rank == 3; ++i)
        {
          if (i != 14 * 13)
          {
            stage.GetRenderer()->RemoveViewProp(stage.Props[i]);
          }
        }
        if (rank == 3)
        {
          stage.GetRenderer()->AddViewProp(stage.Props[14 * 13]);
        }
      });
  };
  EXPECT_EQ(DrawRanks(options).back().Drawn[3], 0);
}

TEST(CullerRanksDraw, TheOnlyPropInViewOfARankHidesThoseOfOthers)
{
  RankOptions options;
  options.Frames = 6;
  options.Path = [](int frame) { return 0.001 * frame; };
  // The last rank has only a wall across the street, and one behind the camera.
  options.Build = [](RankStages& stages, int rank)
  {
    stages.Both(
      [rank](Stage& stage)
      {
        if (rank == 3)
        {
          stage.GetRenderer()->RemoveAllViewProps();
          Scenes::AddBox(stage, 24.0, 12.0, 20.0, 80.0, 0.5, 60.0);
          Scenes::AddBox(stage, 24.0, -12.0, 20.0, 80.0, 0.5, 60.0);
        }
      });
  };
  const RankFrame last = DrawRanks(options).back();
  EXPECT_EQ(last.Drawn[3], 1);
  EXPECT_LT(last.GetDrawn(), 12);
}

TEST(CullerRanksDraw, OneExchangePerFrameAndOnlyAPollWhileStill)
{
  RankOptions options;
  options.Frames = 30;
  options.Path = [](int frame) { return 0.01 * std::min(frame, 5); };
  // Frame 5 is the first of its view. The next ones find out what was drawn in vain.
  const auto isOpen = [](int frame) { return frame == 0 || (frame > 5 && frame < 9); };
  options.After = [&](RankStages& stages, int, int frame)
  {
    if (!isOpen(frame))
    {
      EXPECT_EQ(stages.Exchange->GetNumberOfExchanges(), frame <= 5 ? 1 : 0) << frame;
      EXPECT_EQ(stages.Exchange->GetNumberOfBytes() == sizeof(float), frame > 5) << frame;
    }
  };
  DrawRanks(options);
}

TEST(CullerRanksDraw, PropsThatMoveWhileTheCameraIsStillAreExchanged)
{
  RankOptions options;
  options.Frames = 12;
  options.Path = [](int) { return 0.05; };
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    stages.Both(
      [&](Stage& stage) { stage.GetActor(44 + rank)->SetPosition(0.3 * frame, 0.1 * frame, 0.0); });
  };
  const std::vector<RankFrame> frames = DrawRanks(options);
  EXPECT_EQ(frames.back().Exchanges[0], 1);
}

namespace
{
/// A wall of another rank is removed while the camera stands still.
RankOptions MakeFallingWall()
{
  RankOptions options;
  options.Frames = 16;
  options.Path = [](int) { return 0.05; };
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    if (rank == 1 && frame >= 9)
    {
      stages.Both(
        [&](Stage& stage)
        {
          for (int i = 1; i < 197; i += 4)
          {
            stage.GetActor(i)->SetPosition(0.0, 0.0, frame == 9 ? 500.0 : 500.0 + frame / 12);
          }
        });
    }
  };
  return options;
}
}

TEST(CullerRanksDraw, AWallThatIsTakenAwayWhileTheCameraStandsStillHidesNothing)
{
  const std::vector<RankFrame> frames = DrawRanks(MakeFallingWall());
  EXPECT_EQ(frames[8].Exchanges[0], 0);
  EXPECT_EQ(frames[9].Exchanges[0], 1);
  EXPECT_EQ(frames[12].Exchanges[0], 1);
  EXPECT_EQ(frames.back().Exchanges[0], 0);
}

TEST(CullerRanksDraw, AWallOfARankWithoutACullerIsNotTrustedWhileTheCameraStandsStill)
{
  RankOptions options = MakeFallingWall();
  options.Build = [](RankStages& stages, int rank)
  {
    if (rank == 1)
    {
      stages.GetRenderer()->GetCullers()->RemoveAllItems();
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options);
  for (int i = 0; i <= 9; ++i)
  {
    EXPECT_GT(frames[i].Exchanges[0], 0) << "frame " << i;
  }
  // Without its wall that rank has no depth that could become farther.
  EXPECT_EQ(frames.back().Exchanges[0], 0);
}

namespace
{
/// The place of the wall in the list of rank 0. In that of rank 1 the boxes behind it begin there.
constexpr int WallOfAbsence = 197;

/// What keeps rank 1 from testing while a wall of another rank goes.
struct Absence
{
  const char* Name;
  std::function<void(RankStages&, bool begins)> Change;
};

const Absence Absences[] = {
  { "NoProps",
    [](RankStages& stages, bool begins)
    {
      stages.Both(
        [begins](Stage& stage)
        {
          vtkRenderer* renderer = stage.GetRenderer();
          for (std::size_t i = WallOfAbsence; i < stage.Props.size(); ++i)
          {
            begins ? renderer->RemoveViewProp(stage.Props[i])
                   : renderer->AddViewProp(stage.Props[i]);
          }
        });
    } },
  { "Frozen", [](RankStages& stages, bool begins) { stages.Culled.Culler->SetFreeze(begins); } },
};
}

using CullerRanksAbsence = testing::TestWithParam<Absence>;

// Hazard: a rank that did not test while a wall of another rank was taken away uses the verdicts of
// the last frame that it tested.
TEST_P(CullerRanksAbsence, AWallThatIsTakenAwayMeanwhileHidesNothing)
{
  const bool isFrozen = std::string(this->GetParam().Name) == "Frozen";
  RankOptions options;
  options.Ranks = 2;
  options.Frames = 24;
  options.Path = [](int) { return 0.0; };
  options.Compares = [isFrozen](int frame) { return !isFrozen || frame < 9 || frame > 17; };
  options.Build = [](RankStages& stages, int rank)
  {
    stages.Both(
      [rank](Stage& stage)
      {
        if (rank == 0)
        {
          Scenes::AddBox(stage, 24.0, 12.0, 20.0, 80.0, 0.5, 60.0);
          return;
        }
        stage.GetRenderer()->RemoveAllViewProps();
        for (int i = 0; i < 40; ++i)
        {
          const int box = Scenes::AddBox(
            stage, 21.0 + i % 8 * 0.8, 30.0 + i / 8 * 2.0, 1.0 + i / 8 * 0.5, 0.6, 0.6, 0.6);
          // When its prop leaves the renderer, vtkPolyDataMapper gets a newer time.
          vtkNew<vtkDataSetMapper> mapper;
          mapper->SetInputData(stage.GetActor(box)->GetMapper()->GetInput());
          stage.GetActor(box)->SetMapper(mapper);
        }
      });
  };
  options.Before = [&](RankStages& stages, int rank, int frame)
  {
    if (rank == 0 && frame == 9)
    {
      stages.Both(
        [](Stage& stage) { stage.GetActor(WallOfAbsence)->SetPosition(0.0, 0.0, 500.0); });
    }
    if (rank == 1 && (frame == 7 || frame == 18))
    {
      this->GetParam().Change(stages, frame == 7);
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options);
  EXPECT_EQ(frames[6].Drawn[1], 0);
  EXPECT_EQ(frames[8].Exchanges[0], 0);
  EXPECT_EQ(frames[9].Exchanges[0], 1);
  EXPECT_EQ(frames[17].Exchanges[0] == 0, !isFrozen) << "its verdicts are too old";
  EXPECT_EQ(frames[18].Exchanges[0], 1);
  EXPECT_EQ(frames.back().Exchanges[0], 0);
  EXPECT_EQ(frames.back().Drawn[1], 40);
}

INSTANTIATE_TEST_SUITE_P(Each, CullerRanksAbsence, testing::ValuesIn(Absences), GetCaseName);

// Hazard: the rank has no candidates and gives the depth of its finished picture, in which VTK has
// drawn 2-D props at the near plane. Nothing tells that these have moved.
TEST(CullerRanksDraw, A2DPropOfARankWithoutCandidatesHidesNothingWhereItWas)
{
  RankOptions options;
  options.Ranks = 2;
  options.Frames = 14;
  options.Path = [](int) { return 0.0; };
  options.Build = [](RankStages& stages, int rank)
  {
    stages.Both(
      [rank](Stage& stage)
      {
        vtkRenderer* renderer = stage.GetRenderer();
        renderer->RemoveAllViewProps();
        for (int i = 0; i < 197 && rank == 1; ++i)
        {
          renderer->AddViewProp(stage.Props[i]);
        }
        for (int i = 0; i < 60 && rank == 1; ++i) // In the lower middle of the picture.
        {
          Scenes::AddBox(stage, 23.0 + i % 10 * 0.2, 6.0, 0.8 + i / 10 * 0.2, 0.1, 0.1, 0.1);
        }
        if (rank == 0)
        {
          vtkNew<vtkPlaneSource> plane;
          plane->SetPoint1(60.0, 0.0, 0.0);
          plane->SetPoint2(0.0, 60.0, 0.0);
          vtkNew<vtkPolyDataMapper2D> mapper;
          mapper->SetInputConnection(plane->GetOutputPort());
          const auto square = vtkSmartPointer<vtkActor2D>::New();
          square->SetMapper(mapper);
          stage.Add(square);
        }
      });
  };
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    if (rank == 0)
    {
      stages.Both(
        [frame](Stage& stage)
        {
          auto* square = vtkActor2D::SafeDownCast(stage.Props.back());
          square->SetPosition(frame < 9 ? 100 : 200, frame < 9 ? 20 : 100);
        });
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options);
  EXPECT_GT(frames.back().Drawn[1], frames[8].Drawn[1]);
}

TEST(CullerRanksDraw, VerdictsOfSharedDepthEndWithTheExchange)
{
  RankOptions options = MakeFallingWall();
  const auto takeAway = options.Before;
  options.Before = [=](RankStages& stages, int rank, int frame)
  {
    stages.Exchange->SetParallelRendering(frame < 7);
    takeAway(stages, rank, frame);
  };
  DrawRanks(options);
}

TEST(CullerRanksDraw, RanksBackOffTogetherWhereNothingIsHidden)
{
  RankOptions options;
  options.BackOff = true;
  options.Frames = 40;
  options.Before = [](RankStages& stages, int, int frame)
  {
    stages.Both(
      [&](Stage& stage)
      {
        vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
        camera->SetPosition(80.0 + 0.1 * frame, 80.0, 250.0);
        camera->SetFocalPoint(80.0 + 0.1 * frame, 80.1, 0.0);
      });
  };
  // Hazard: tests of shared frames begin a pause of the rank's own, which draws all props for up to
  // 64 frames when the exchange pauses.
  std::vector<vtkNBufferDecision> ofFirstRank;
  options.After = [&ofFirstRank](RankStages& stages, int rank, int)
  {
    if (rank == 0)
    {
      ofFirstRank.push_back(stages.Culled.Culler->GetStatistics().Decision);
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options);
  const auto paused = std::find_if(
    frames.begin(), frames.end(), [](const RankFrame& frame) { return frame.Exchanges[0] == 0; });
  ASSERT_NE(paused, frames.end());
  EXPECT_NE(ofFirstRank[paused - frames.begin()], vtkNBufferDecision::BackedOff);
  const int exchanges = std::accumulate(frames.begin(), frames.end(), 0,
    [](int sum, const RankFrame& frame) { return sum + frame.Exchanges[0]; });
  EXPECT_LT(exchanges, 30);
  EXPECT_GT(exchanges, 8);
}

TEST(CullerRanksDraw, NothingIsExchangedWhereItIsOffOrThereIsOneRank)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int) { stages.Exchange->ParallelRenderingOff(); };
  for (const RankFrame& frame : DrawRanks(options))
  {
    EXPECT_EQ(frame.Exchanges[0], 0);
  }
  options = RankOptions();
  options.Ranks = 1;
  for (const RankFrame& frame : DrawRanks(options))
  {
    EXPECT_EQ(frame.Exchanges[0], 0);
  }
}

TEST(CullerRanksDraw, DefaultsAndWrongSettings)
{
  vtkNew<RankExchange> exchange;
  EXPECT_EQ(exchange->GetRenderer(), nullptr);
  EXPECT_TRUE(exchange->GetParallelRendering());
  EXPECT_TRUE(exchange->GetBackOff());
  EXPECT_EQ(exchange->GetTileSize(), 4);
  EXPECT_EQ(exchange->GetNumberOfExchanges(), 0);
  EXPECT_EQ(exchange->GetNumberOfBytes(), 0);
  EXPECT_EQ(exchange->GetExchangeTime(), 0.0);
  TakeMessages();
  exchange->SetTileSize(3);
  EXPECT_NE(TakeMessages().find("TileSize"), std::string::npos);
  EXPECT_EQ(exchange->GetTileSize(), 4);
  vtkNew<vtkNBufferCuller> culler;
  EXPECT_EQ(culler->GetDepthExchange(), nullptr);
  culler->SetDepthExchange(exchange);
  EXPECT_EQ(culler->GetDepthExchange(), exchange);
}
