// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RankFrames.h
 * @brief Frames of the city, spread over the ranks of a parallel program: drawn by all ranks with
 * and without the culler, and the composited images compared.
 */
#ifndef RankFrames_h
#define RankFrames_h

#include "Ranks.h"
#include "Scenes.h"

#include "vtkNew.h"

#include <functional>
#include <numeric>
#include <string>
#include <vector>

constexpr int RankSize[2] = { 301, 173 };

enum class Spread
{
  Blocks, ///< Each rank has a part of the city.
  Mixed   ///< Neighbours belong to different ranks.
};

/// Looks along the streets of the whole city; the props of a rank do not matter.
void SetRankCamera(vtkRenderer* renderer, double t);

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

/// Draw the frames on all ranks, and compare the composited images. The messages of VTK must
/// contain `messages`, or there must be none if it is empty.
std::vector<RankFrame> DrawRanks(const RankOptions& options, const std::string& messages = "");

/// The props drawn by all ranks in all frames from `first` on.
int Sum(const std::vector<RankFrame>& frames, int first = 0);

#endif
