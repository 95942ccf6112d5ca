// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RankFrames.h
 * @brief Draws frames of the city (Scenes.h), spread over the ranks of a parallel program, with and
 * without the culler, and compares the composited images.
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

/// The size of the windows in pixels.
constexpr int RankSize[2] = { 301, 173 };

enum class Spread
{
  Blocks, ///< Each rank has a part of the city.
  Mixed   ///< Neighbours belong to different ranks.
};

/// Sets the camera for a walk through the city, with t in [0, 1]. All ranks have the same clipping
/// range, whatever their props are.
void SetRankCamera(vtkRenderer* renderer, double t);

/// The two stages of a rank: one draws with VTK alone, the other one with the culler.
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

/// What all ranks have drawn in a frame. The lists have an entry for each rank.
struct RankFrame
{
  explicit RankFrame(int ranks)
    : Stock(ranks)
    , Culled(ranks)
    , Drawn(ranks)
    , Exchanges(ranks)
  {
  }
  /// Returns the number of props that all ranks have drawn.
  int GetDrawn() const { return std::accumulate(this->Drawn.begin(), this->Drawn.end(), 0); }

  std::vector<TestScene::Picture> Stock;
  std::vector<TestScene::Picture> Culled;
  std::vector<int> Drawn;     ///< The props that the rank has drawn with the culler.
  std::vector<int> Exchanges; ///< The exchanges of the rank in this frame.
};

struct RankOptions
{
  int Ranks = 4;
  Spread How = Spread::Mixed;
  bool Exchange = true; ///< Whether the cullers exchange depth.
  int TileSize = 4;
  bool BackOff = false; ///< Of the exchange and of the cullers.
  int Frames = 12;
  /// Returns the t of SetRankCamera() for a frame.
  std::function<double(int frame)> Path = [](int frame) { return 0.01 * frame; };
  ///@{
  /// Are called for each rank before its first frame, and before and after each frame.
  std::function<void(RankStages&, int rank)> Build;
  std::function<void(RankStages&, int rank, int frame)> Before;
  std::function<void(RankStages&, int rank, int frame)> After;
  ///@}
  /// Says whether the images of a frame are compared. Those of frozen cullers may differ.
  std::function<bool(int frame)> Compares = [](int) { return true; };
};

/// Draws the frames on all ranks. Expects that the composited images with and without the culler
/// are equal, that all ranks have made equally many exchanges in each frame, and that VTK gives
/// `warnings` warnings, which contain `messages`. By default there are none if `messages` is "",
/// and otherwise each rank gives one.
std::vector<RankFrame> DrawRanks(
  const RankOptions& options, const std::string& messages = "", int warnings = -1);

/// Returns the number of props that all ranks have drawn in the frames from `first` on.
int Sum(const std::vector<RankFrame>& frames, int first = 0);

#endif
