// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankFrames.h"

#include "vtkCamera.h"

namespace
{
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
  stages.Stock = Stage(RankSize[0], RankSize[1]);
  stages.Culled = Stage(RankSize[0], RankSize[1]);
  stages.Both(
    [&](Stage& stage)
    {
      Scenes::BuildCity(stage);
      Distribute(stage, options, rank);
    });
  stages.Culled.Culler = vtkSmartPointer<vtkNBufferCuller>::New();
  vtkNBufferTuning tuning = stages.Culled.Culler->GetTuning();
  tuning.BackOff = options.BackOff;
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
}

void SetRankCamera(vtkRenderer* renderer, double t)
{
  Scenes::SetCityCamera(renderer, t);
  renderer->GetActiveCamera()->SetClippingRange(0.5, 300.0);
}

std::vector<RankFrame> DrawRanks(
  const RankOptions& options, const std::string& messages, int warnings)
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
        stages.Both([&](Stage& stage) { SetRankCamera(stage.GetRenderer(), options.Path(i)); });
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
  EXPECT_EQ(CountWarnings(found),
    warnings >= 0        ? warnings
      : messages.empty() ? 0
                         : options.Ranks)
    << found;
  EXPECT_NE(found.find(messages), std::string::npos) << found;
  for (int i = 0; i < options.Frames; ++i)
  {
    if (options.Compares(i))
    {
      EXPECT_EQ(
        TestScene::FindDifference(Composite(frames[i].Stock), Composite(frames[i].Culled)), "")
        << "frame " << i;
    }
    for (int exchanges : frames[i].Exchanges)
    {
      EXPECT_EQ(exchanges, frames[i].Exchanges[0]) << "frame " << i;
    }
  }
  return frames;
}

int Sum(const std::vector<RankFrame>& frames, int first)
{
  return std::accumulate(frames.begin() + first, frames.end(), 0,
    [](int sum, const RankFrame& frame) { return sum + frame.GetDrawn(); });
}
