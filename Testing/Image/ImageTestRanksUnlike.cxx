// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranks that differ from the others: they do not cull, draw another size or view, or have other
// settings. No rank waits for a rank that does not join, and the composited image is that of VTK
// alone.
#include "RankFrames.h"

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkProperty.h"

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
    const std::vector<RankFrame> frames = DrawRanks(options);
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
  DrawRanks(options);
}

TEST(CullerRanksDraw, TilesOfEachSize)
{
  for (int size : { 1, 2, 8 })
  {
    RankOptions options;
    options.TileSize = size;
    DrawRanks(options);
  }
}

TEST(CullerRanksDraw, DifferentSettingsAreReportedAndEachRankIsAlone)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int rank)
  { stages.Exchange->SetTileSize(rank == 1 ? 2 : 4); };
  DrawRanks(options, "with different settings");
}

namespace
{
/// In frames 4 to 7 one rank is not like the others. The camera stands still, or not.
void BeUnlike(const std::function<void(RankStages&, bool unlike)>& change, bool isStill)
{
  RankOptions options;
  options.Frames = 14;
  options.Path = [isStill](int frame) { return isStill ? 0.05 : 0.05 + 0.01 * frame; };
  options.Before = [&](RankStages& stages, int rank, int frame)
  {
    if (rank == 1 && (frame == 4 || frame == 8))
    {
      change(stages, frame == 4);
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options, "with different settings");
  EXPECT_EQ(frames[6].Exchanges[0], 0);
  EXPECT_EQ(frames[8].Exchanges[0], 1);
  EXPECT_LT(Sum({ frames[10] }), Sum({ frames[6] }));
}
}

TEST(CullerRanksDraw, OneRankThatChangesASettingAloneIsReportedAndEachRankIsAlone)
{
  for (bool isStill : { false, true })
  {
    BeUnlike([](RankStages& stages, bool unlike) { stages.Exchange->SetTileSize(unlike ? 2 : 4); },
      isStill);
    BeUnlike([](RankStages& stages, bool unlike) { stages.Exchange->SetBackOff(unlike); }, isStill);
  }
}

TEST(CullerRanksDraw, OneRankThatChangesItsSizeAloneIsReportedAndEachRankIsAlone)
{
  for (bool isStill : { false, true })
  {
    BeUnlike(
      [](RankStages& stages, bool unlike)
      {
        stages.Both([unlike](Stage& stage)
          { stage.Window->SetSize(RankSize[0], unlike ? RankSize[1] + 30 : RankSize[1]); });
      },
      isStill);
  }
}

TEST(CullerRanksDraw, OneCameraThatMovesWhileTheOthersStandStillIsReported)
{
  RankOptions options;
  options.Frames = 14;
  options.Path = [](int) { return 0.05; };
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    if (rank == 2 && frame > 6)
    {
      stages.Both([frame](Stage& stage) { SetRankCamera(stage.GetRenderer(), 0.01 * frame); });
    }
  };
  const std::vector<RankFrame> frames = DrawRanks(options, "different views");
  EXPECT_EQ(frames[6].Exchanges[0], 0);
  EXPECT_EQ(frames[8].Exchanges[0], 1);
}

TEST(CullerRanksDraw, DifferentViewsAreReportedAndEachRankIsAlone)
{
  RankOptions options;
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    if (rank == 1)
    {
      stages.Both(
        [frame](Stage& stage) { SetRankCamera(stage.GetRenderer(), 0.5 + 0.01 * frame); });
    }
  };
  DrawRanks(options, "different views");
}
