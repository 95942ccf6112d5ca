// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The city, spread over the ranks of a parallel program that exchange depth: the composited image
// is that of VTK alone, no rank waits for one that does not come, and what walls of other ranks
// hide is not drawn.
#include "Ranks.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkProperty.h"

#include <functional>
#include <numeric>

namespace
{
constexpr int Size[2] = { 301, 173 };

enum class Spread
{
  Blocks, ///< Each rank has a part of the city.
  Mixed   ///< Neighbours belong to different ranks.
};

/// Looks along the streets of the whole city; the props of a rank do not matter.
void SetCamera(vtkRenderer* renderer, double t)
{
  Scenes::SetCityCamera(renderer, t);
  renderer->GetActiveCamera()->SetClippingRange(0.5, 300.0);
}

/// What one rank draws: with VTK alone, and with the culler.
struct RankStages
{
  Stage Stock;
  Stage Culled;
  vtkNew<RankExchange> Exchange;

  vtkRenderer* GetRenderer() const { return this->Culled.GetRenderer(); }
  void Both(const std::function<void(Stage&)>& change)
  {
    change(this->Stock);
    change(this->Culled);
  }
};

/// What all ranks have drawn of a frame.
struct RankFrame
{
  explicit RankFrame(int ranks)
    : Stock(ranks)
    , Culled(ranks)
    , Drawn(ranks)
    , Exchanges(ranks)
  {
  }
  int GetDrawn() const { return std::accumulate(this->Drawn.begin(), this->Drawn.end(), 0); }

  std::vector<TestScene::Picture> Stock;
  std::vector<TestScene::Picture> Culled;
  std::vector<int> Drawn;
  std::vector<int> Exchanges;
};

struct RankOptions
{
  int Ranks = 4;
  Spread How = Spread::Mixed;
  bool Exchange = true;
  int TileSize = 4;
  bool BackOff = false;
  int Frames = 12;
  /// Where the camera is in each frame.
  std::function<double(int frame)> Path = [](int frame) { return 0.01 * frame; };
  /// Called for each rank before its first frame, and before and after each frame.
  std::function<void(RankStages&, int rank)> Build;
  std::function<void(RankStages&, int rank, int frame)> Before;
  std::function<void(RankStages&, int rank, int frame)> After;
};

/// Keep only the props of a rank. The ground belongs to the first.
void Distribute(Stage& stage, const RankOptions& options, int rank)
{
  const int count = static_cast<int>(stage.Props.size());
  for (int i = 0; i < count; ++i)
  {
    const int owner = i == 0         ? 0
      : options.How == Spread::Mixed ? i % options.Ranks
                                     : (i - 1) * options.Ranks / (count - 1);
    if (owner != rank)
    {
      stage.GetRenderer()->RemoveViewProp(stage.Props[i]);
    }
  }
}

void BuildRank(RankStages& stages, Ranks& ranks, int rank, const RankOptions& options)
{
  stages.Stock = Stage(Size[0], Size[1]);
  stages.Culled = Stage(Size[0], Size[1]);
  stages.Both(
    [&](Stage& stage)
    {
      Scenes::BuildCity(stage);
      Distribute(stage, options, rank);
    });
  stages.Culled.Culler = vtkSmartPointer<vtkNBufferCuller>::New();
  vtkNBufferTuning tuning = stages.Culled.Culler->GetTuning();
  tuning.BackOff = false;
  stages.Culled.Culler->SetTuning(tuning);
  stages.GetRenderer()->AddCuller(stages.Culled.Culler);
  if (options.Exchange)
  {
    stages.Exchange->SetRank(&ranks, rank);
    stages.Exchange->SetRenderer(stages.GetRenderer());
    stages.Exchange->SetTileSize(options.TileSize);
    stages.Exchange->SetBackOff(options.BackOff);
    stages.Culled.Culler->SetDepthExchange(stages.Exchange);
  }
  if (options.Build)
  {
    options.Build(stages, rank);
  }
}

/// Draw the frames on all ranks, and compare the composited images.
std::vector<RankFrame> Draw(const RankOptions& options, const std::string& messages = "")
{
  std::vector<RankFrame> frames(options.Frames, RankFrame(options.Ranks));
  TakeMessages();
  std::string found;
  Ranks ranks(options.Ranks);
  const bool isOver = ranks.Run(
    [&](int rank)
    {
      RankStages stages;
      BuildRank(stages, ranks, rank, options);
      for (int i = 0; i < options.Frames; ++i)
      {
        stages.Both([&](Stage& stage) { SetCamera(stage.GetRenderer(), options.Path(i)); });
        if (options.Before)
        {
          options.Before(stages, rank, i);
        }
        const TestScene::FrameErrors errors = TestScene::RenderFrame(stages.Stock);
        EXPECT_EQ(errors.GL, "");
        found += errors.VTK;
        frames[i].Stock[rank] = TestScene::TakePicture(stages.Stock.Window, true);
        // Another rank may have made its context current while this one waited.
        stages.Culled.Window->Render();
        stages.Culled.MakeCurrent();
        frames[i].Culled[rank] = TestScene::TakePicture(stages.Culled.Window, true);
        frames[i].Drawn[rank] =
          stages.Culled.Culler ? stages.Culled.Culler->GetNumberOfPropsDrawn() : 0;
        frames[i].Exchanges[rank] = stages.Exchange->GetNumberOfExchanges();
        if (options.After)
        {
          options.After(stages, rank, i);
        }
      }
    });
  EXPECT_TRUE(isOver) << "a rank waited for one that did not come";
  found += TakeMessages();
  EXPECT_EQ(found.empty(), messages.empty()) << found;
  EXPECT_NE(found.find(messages), std::string::npos) << found;
  for (int i = 0; i < options.Frames; ++i)
  {
    EXPECT_EQ(
      TestScene::FindDifference(Composite(frames[i].Stock), Composite(frames[i].Culled)), "")
      << "frame " << i;
    for (int exchanges : frames[i].Exchanges)
    {
      EXPECT_EQ(exchanges, frames[i].Exchanges[0]) << "frame " << i;
    }
  }
  return frames;
}

int Sum(const std::vector<RankFrame>& frames, int first = 0)
{
  return std::accumulate(frames.begin() + first, frames.end(), 0,
    [](int sum, const RankFrame& frame) { return sum + frame.GetDrawn(); });
}
}

class CullerRanks : public testing::TestWithParam<std::tuple<int, Spread>>
{
};

TEST_P(CullerRanks, TheCompositedImageIsThatOfVTKAlone)
{
  RankOptions options;
  std::tie(options.Ranks, options.How) = this->GetParam();
  Draw(options);
}

TEST_P(CullerRanks, CutsToAndFro)
{
  RankOptions options;
  std::tie(options.Ranks, options.How) = this->GetParam();
  options.Path = [](int frame) { return frame / 3 % 2 ? 0.9 : 0.1 + 0.01 * frame; };
  Draw(options);
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
    const std::vector<RankFrame> shared = Draw(options);
    options.Exchange = false;
    const std::vector<RankFrame> local = Draw(options);
    options.Ranks = 1;
    const std::vector<RankFrame> alone = Draw(options);
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
  const std::vector<RankFrame> frames = Draw(options);
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
  EXPECT_EQ(Draw(options).back().Drawn[3], 0);
}

TEST(CullerRanksDraw, OneExchangePerFrameTwoAtFirstNoneWhileStill)
{
  RankOptions options;
  options.Frames = 30;
  options.Path = [](int frame) { return 0.01 * std::min(frame, 5); };
  const std::vector<RankFrame> frames = Draw(options);
  for (int i = 1; i < options.Frames; ++i)
  {
    // Frame 5 is the first of its view.
    const bool isDue = i < 5 + 3 || (i - 5) % 16 == 0;
    EXPECT_EQ(frames[i].Exchanges[0], isDue ? 1 : 0) << "frame " << i;
  }
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
  const std::vector<RankFrame> frames = Draw(options);
  EXPECT_EQ(frames.back().Exchanges[0], 1);
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
  const std::vector<RankFrame> frames = Draw(options);
  const int exchanges = std::accumulate(frames.begin(), frames.end(), 0,
    [](int sum, const RankFrame& frame) { return sum + frame.Exchanges[0]; });
  EXPECT_LT(exchanges, 30);
  EXPECT_GT(exchanges, 8);
}

/// A rank that does not cull as the others do joins all the same.
struct Straggler
{
  const char* Name;
  std::function<void(RankStages&, int frame)> Before;
};

class CullerRanksStraggler : public testing::TestWithParam<Straggler>
{
};

TEST_P(CullerRanksStraggler, JoinsEveryExchange)
{
  // The first rank has the ground.
  for (int straggler : { 0, 2 })
  {
    RankOptions options;
    options.How = straggler == 0 ? Spread::Blocks : Spread::Mixed;
    options.Path = [](int frame) { return 0.1 + 0.02 * frame + (frame > 7 ? 0.5 : 0.0); };
    options.Before = [&](RankStages& stages, int rank, int frame)
    {
      if (rank == straggler && frame >= 3)
      {
        this->GetParam().Before(stages, frame);
      }
    };
    const std::vector<RankFrame> frames = Draw(options);
    EXPECT_GT(frames.back().Exchanges[0], 0);
  }
}

namespace
{
const Straggler Stragglers[] = {
  { "NoProps",
    [](RankStages& stages, int)
    { stages.Both([](Stage& stage) { stage.GetRenderer()->RemoveAllViewProps(); }); } },
  { "AllInvisible",
    [](RankStages& stages, int)
    {
      stages.Both(
        [](Stage& stage)
        {
          for (const auto& prop : stage.Props)
          {
            prop->VisibilityOff();
          }
        });
    } },
  { "FewProps",
    [](RankStages& stages, int)
    {
      stages.Both(
        [](Stage& stage)
        {
          for (std::size_t i = 20; i < stage.Props.size(); ++i)
          {
            stage.GetRenderer()->RemoveViewProp(stage.Props[i]);
          }
        });
    } },
  { "SwitchedOff",
    [](RankStages& stages, int frame) { stages.Culled.Culler->SetEnabled(frame % 3 == 0); } },
  { "CullerRemoved",
    [](RankStages& stages, int) { stages.GetRenderer()->GetCullers()->RemoveAllItems(); } },
  { "CullerDeletedAndAnotherOne",
    [](RankStages& stages, int frame)
    {
      stages.GetRenderer()->GetCullers()->RemoveAllItems();
      stages.Culled.Culler = nullptr;
      if (frame % 2)
      {
        stages.Culled.Culler = vtkSmartPointer<vtkNBufferCuller>::New();
        stages.Culled.Culler->SetDepthExchange(stages.Exchange);
        stages.GetRenderer()->AddCuller(stages.Culled.Culler);
      }
    } },
  { "ExchangeForgotten",
    [](RankStages& stages, int) { stages.Culled.Culler->SetDepthExchange(nullptr); } },
  { "SmoothedImage",
    [](RankStages& stages, int)
    { stages.Both([](Stage& stage) { stage.GetRenderer()->UseFXAAOn(); }); } },
  { "HiddenLines",
    [](RankStages& stages, int)
    {
      stages.Both(
        [](Stage& stage)
        {
          stage.GetActor(40)->GetProperty()->SetRepresentationToWireframe();
          stage.GetRenderer()->UseHiddenLineRemovalOn();
        });
    } },
  { "AnotherLayer",
    [](RankStages& stages, int frame)
    {
      if (frame == 3)
      {
        stages.Both([](Stage& stage) { stage.AddRenderer(0.0, 0.0, 1.0, 1.0, 0)->EraseOff(); });
      }
    } },
  { "DevicePath",
    [](RankStages& stages, int) { stages.Culled.Culler->SetBackend(vtkNBufferCuller::OpenGL); } },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerRanksStraggler, testing::ValuesIn(Stragglers), GetCaseName);

TEST(CullerRanksDraw, AllRanksChangeTheirSizeTogether)
{
  RankOptions options;
  options.Before = [](RankStages& stages, int, int frame)
  { stages.Both([&](Stage& stage) { stage.Window->SetSize(301 - 10 * (frame / 4), 173); }); };
  Draw(options);
}

TEST(CullerRanksDraw, TilesOfEachSize)
{
  for (int size : { 1, 2, 8 })
  {
    RankOptions options;
    options.TileSize = size;
    Draw(options);
  }
}

TEST(CullerRanksDraw, DifferentSettingsAreReportedAndEachRankIsAlone)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int rank)
  { stages.Exchange->SetTileSize(rank == 1 ? 2 : 4); };
  Draw(options, "with different settings");
}

TEST(CullerRanksDraw, DifferentViewsAreReportedAndEachRankIsAlone)
{
  RankOptions options;
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    if (rank == 1)
    {
      stages.Both([frame](Stage& stage) { SetCamera(stage.GetRenderer(), 0.5 + 0.01 * frame); });
    }
  };
  Draw(options, "different views");
}

TEST(CullerRanksDraw, NothingIsExchangedWhereItIsOffOrThereIsOneRank)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int) { stages.Exchange->ParallelRenderingOff(); };
  for (const RankFrame& frame : Draw(options))
  {
    EXPECT_EQ(frame.Exchanges[0], 0);
  }
  options = RankOptions();
  options.Ranks = 1;
  for (const RankFrame& frame : Draw(options))
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
