// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranks that differ from the others: they do not cull, are aborted, select, draw another size or
// view, or have other settings. No rank waits for a rank that does not join, and the composited
// image is that of VTK alone.
#include "Once.h"
#include "OwnFramebuffer.h"
#include "RankFrames.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkDataObject.h"
#include "vtkProperty.h"

#include <array>
#include <chrono>
#include <thread>

/// A rank that does not cull as the others do joins all the same.
struct Straggler
{
  const char* Name;
  std::function<void(RankStages&, int frame)> Before;
};

using CullerRanksStraggler = testing::TestWithParam<Straggler>;

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
/// Aborts the next frame of a stage before anything is drawn: at once, or when VTK asks.
void AbortNext(Stage& stage, bool byCheck)
{
  vtkRenderWindow* window = stage.Window;
  const auto abort = [window] { window->SetAbortRender(1); };
  Observe(stage.GetRenderer(), vtkCommand::StartEvent,
    [=]
    {
      if (!byCheck)
      {
        abort();
        return;
      }
      // VTK invokes the event five times a second at most.
      std::this_thread::sleep_for(std::chrono::milliseconds(250));
      Observe(window, vtkCommand::AbortCheckEvent, abort);
      window->CheckAbortStatus();
    });
}

/// When the exchange and its observers are told of the end of the next frame, a framebuffer without
/// depth is bound in place of that of the window.
void HideDepthAtTheEnd(Stage& stage)
{
  const auto names = std::make_shared<std::array<GLuint, 2>>();
  const auto bound = std::make_shared<std::array<GLint, 2>>();
  Observe(
    stage.GetRenderer(), vtkCommand::EndEvent,
    [=]
    {
      glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &(*bound)[0]);
      glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &(*bound)[1]);
      glGenFramebuffers(1, &(*names)[0]);
      glGenRenderbuffers(1, &(*names)[1]);
      glBindFramebuffer(GL_FRAMEBUFFER, (*names)[0]);
      glBindRenderbuffer(GL_RENDERBUFFER, (*names)[1]);
      glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, RankSize[0], RankSize[1]);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, (*names)[1]);
    },
    2000.0F);
  Observe(
    stage.GetRenderer(), vtkCommand::EndEvent,
    [=]
    {
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (*bound)[0]);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, (*bound)[1]);
      glDeleteFramebuffers(1, &(*names)[0]);
      glDeleteRenderbuffers(1, &(*names)[1]);
    },
    500.0F);
}

/// Makes a hardware selection in a stage, and returns how often that draws its renderer.
int SelectAll(Stage& stage, TestScene::Selection& found)
{
  int passes = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&passes);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  const int area[] = { 0, 0, RankSize[0] - 1, RankSize[1] - 1 };
  const unsigned long observer = stage.GetRenderer()->AddObserver(vtkCommand::EndEvent, counter);
  found = TestScene::Select(stage, area, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  stage.GetRenderer()->RemoveObserver(observer);
  return passes;
}

/// Makes the same hardware selection in both stages of a rank.
void SelectInBoth(RankStages& stages)
{
  TestScene::Selection expected;
  TestScene::Selection found;
  EXPECT_EQ(SelectAll(stages.Stock, expected), SelectAll(stages.Culled, found));
  EXPECT_EQ(found, expected);
}

const Straggler Stragglers[] = {
  // As an application may do that removes its own observers.
  { "LosesItsObservers",
    [](RankStages& stages, int) { stages.GetRenderer()->RemoveAllObservers(); } },
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
  { "Aborted",
    [](RankStages& stages, int frame)
    {
      if (frame % 3 != 0)
      {
        stages.Both([](Stage& stage) { AbortNext(stage, false); });
      }
    } },
  { "AbortedWhenVTKAsks",
    [](RankStages& stages, int frame)
    {
      if (frame % 3 == 0)
      {
        stages.Both([](Stage& stage) { AbortNext(stage, true); });
      }
    } },
  { "SelectsAlone",
    [](RankStages& stages, int)
    {
      stages.Exchange->ParallelRenderingOff();
      SelectInBoth(stages);
      stages.Exchange->ParallelRenderingOn();
    } },
  { "UnreadableDepth",
    [](RankStages& stages, int)
    {
      stages.Culled.Culler->EnabledOff(); // The exchange reads depth at the end of the frame.
      stages.Both(HideDepthAtTheEnd);
    } },
  { "Multisampled",
    [](RankStages& stages, int)
    { stages.Both([](Stage& stage) { stage.Window->SetMultiSamples(4); }); } },
  { "DevicePath",
    [](RankStages& stages, int) { stages.Culled.Culler->SetBackend(vtkNBufferCuller::OpenGL); } },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerRanksStraggler, testing::ValuesIn(Stragglers), GetCaseName);

// Hazard: a culler cannot read depth, and its rank does not join the exchange.
TEST(CullerRanksDraw, ARankWhoseCullerFailsJoinsEveryExchange)
{
  for (int straggler : { 0, 2 })
  {
    RankOptions options;
    options.Build = [straggler](RankStages& stages, int rank)
    {
      if (rank == straggler)
      {
        stages.Both(
          [](Stage& stage)
          {
            std::vector<vtkSmartPointer<vtkProp>> props = stage.Props;
            vtkRenderer* renderer = stage.GetRenderer();
            const auto isElsewhere = [renderer](vtkProp* prop)
            { return !renderer->HasViewProp(prop); };
            props.erase(std::remove_if(props.begin(), props.end(), isElsewhere), props.end());
            renderer->RemoveAllViewProps();
            vtkNew<OwnFramebuffer> framebuffer;
            framebuffer->WithDepth = false;
            renderer->AddViewProp(framebuffer);
            for (const auto& prop : props)
            {
              renderer->AddViewProp(prop);
            }
          });
      }
    };
    const std::vector<RankFrame> frames = DrawRanks(options, "has no depth buffer", 1);
    EXPECT_EQ(frames.back().Exchanges[0], 1);
  }
}

// Hazard: ranks wait for one that makes a hardware selection, which draws the renderer, too.
TEST(CullerRanksDraw, AllRanksSelectTogether)
{
  RankOptions options;
  options.Before = [](RankStages& stages, int, int frame)
  {
    if (frame % 3 == 2)
    {
      SelectInBoth(stages);
    }
  };
  EXPECT_EQ(DrawRanks(options).back().Exchanges[0], 1);
}

// A window with events of its own: a selection draws the first rank, and each draw draws the
// others.
TEST(CullerRanksDraw, OneRankSelectsAndTheOthersDraw)
{
  RankOptions options;
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    TestScene::Selection expected;
    const int passes = frame % 3 == 2 ? SelectAll(stages.Stock, expected) : 0;
    if (rank == 0 && passes > 0)
    {
      TestScene::Selection found;
      EXPECT_EQ(SelectAll(stages.Culled, found), passes);
      EXPECT_EQ(found, expected);
    }
    for (int i = 0; i < passes && rank > 0; ++i)
    {
      stages.Culled.Window->Render();
    }
  };
  EXPECT_EQ(DrawRanks(options).back().Exchanges[0], 1);
}

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
