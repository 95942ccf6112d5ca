// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranks of a parallel program that each draw their part of the city as one mesh, as filters leave
// it: its units are culled by the depth of all ranks.
#include "RankFrames.h"

#include "vtkAppendPolyData.h"
#include "vtkMapper.h"
#include "vtkPropCollection.h"

namespace
{
void MergeProps(Stage& stage)
{
  vtkNew<vtkAppendPolyData> append;
  vtkRenderer* renderer = stage.GetRenderer();
  for (int i = 0; i < static_cast<int>(stage.Props.size()); ++i)
  {
    if (renderer->HasViewProp(stage.GetActor(i)))
    {
      append->AddInputDataObject(stage.GetActor(i)->GetMapper()->GetInputDataObject(0, 0));
      renderer->RemoveViewProp(stage.GetActor(i));
    }
  }
  append->Update();
  const double color[3] = { 0.8, 0.6, 0.3 };
  stage.AddActor(append->GetOutput(), color);
}

/// Divides the meshes of all ranks, and adds the units that a rank has drawn to its number of
/// props.
RankOptions MakeMeshes(std::vector<int>& drawnUnits)
{
  RankOptions options;
  options.Build = [](RankStages& stages, int)
  {
    stages.Both(MergeProps);
    vtkNBufferTuning tuning = stages.Culled.Culler->GetTuning();
    tuning.MinimumNumberOfPrimitives = 100;
    tuning.UnitSize = 8;
    tuning.DivideAfter = 0;
    tuning.DivideInBackground = false;
    tuning.TimeUnits = false;
    stages.Culled.Culler->SetTuning(tuning);
  };
  options.After = [&drawnUnits](RankStages& stages, int, int frame)
  {
    const vtkNBufferStatistics& statistics = stages.Culled.Culler->GetStatistics();
    EXPECT_GT(statistics.Units, frame > 3 ? 50 : -1) << frame;
    drawnUnits.resize(std::max<std::size_t>(drawnUnits.size(), frame + 1), 0);
    drawnUnits[frame] += statistics.UnitsKept + statistics.UnitsFresh;
  };
  return options;
}

int SumFrom(const std::vector<int>& numbers, int first)
{
  return std::accumulate(numbers.begin() + first, numbers.end(), 0);
}
}

// Hazard: a unit that only another rank's wall hides is drawn, or one is missing that this wall
// does not hide.
TEST(CullerRanksLargeProps, UnitsBehindTheWallsOfOtherRanksAreNotDrawn)
{
  for (Spread how : { Spread::Blocks, Spread::Mixed })
  {
    std::vector<int> shared;
    RankOptions options = MakeMeshes(shared);
    options.How = how;
    DrawRanks(options);
    std::vector<int> local;
    options = MakeMeshes(local);
    options.How = how;
    options.Exchange = false;
    DrawRanks(options);
    std::vector<int> alone;
    options = MakeMeshes(alone);
    options.Ranks = 1;
    DrawRanks(options);
    // The first frames draw whole meshes, and then guesses.
    EXPECT_LT(SumFrom(shared, 5), 0.8 * SumFrom(local, 5));
    EXPECT_LE(SumFrom(shared, 5), 1.5 * SumFrom(alone, 5));
  }
}

// Hazard: each rank has a single prop, and the ranks back off because they count no others.
TEST(CullerRanksLargeProps, UnitsCountInWhatTheExchangeGains)
{
  std::vector<int> drawn;
  RankOptions options = MakeMeshes(drawn);
  options.BackOff = true;
  options.Frames = 60;
  const std::vector<RankFrame> frames = DrawRanks(options);
  int exchanges = 0;
  for (int i = 40; i < options.Frames; ++i)
  {
    exchanges += frames[i].Exchanges[0];
  }
  EXPECT_EQ(exchanges, 20);
}

TEST(CullerRanksLargeProps, MeshesThatMoveWhileTheCameraIsStill)
{
  std::vector<int> drawn;
  RankOptions options = MakeMeshes(drawn);
  options.Frames = 16;
  options.Path = [](int) { return 0.05; };
  options.After = nullptr;
  options.Before = [](RankStages& stages, int rank, int frame)
  {
    stages.Both(
      [&](Stage& stage)
      {
        const int mesh = static_cast<int>(stage.Props.size()) - 1;
        stage.GetActor(mesh)->SetPosition(0.0, 0.0, rank == 1 && frame > 8 ? -0.3 * frame : 0.0);
      });
  };
  DrawRanks(options);
}
