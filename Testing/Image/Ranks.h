// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * @brief The ranks of a parallel program as threads of one process, so that tests of the exchange
 * need no MPI. Only one of the threads runs at a time.
 */
#ifndef Ranks_h
#define Ranks_h

#include "Judge.h"

#include "vtkNBufferDepthExchange.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

class Ranks
{
public:
  explicit Ranks(int count)
    : States(count, State::Ready)
    , Values(count)
  {
  }

  int GetCount() const { return static_cast<int>(this->States.size()); }

  /// Calls the function once for each rank. Returns false if ranks have waited in a reduction for a
  /// rank that had ended, or have given a reduction different counts. With MPI the program would
  /// hang.
  bool Run(const std::function<void(int rank)>& function);

  /// Does what vtkNBufferDepthExchange::ReduceToMinimum() does, for one rank.
  bool Reduce(int rank, const float* values, float* minima, int count);

private:
  enum class State
  {
    Ready,
    Waiting, ///< In a reduction.
    Ended
  };

  /// Lets the next rank run that is ready. If none is, completes the reduction first.
  void Pass(int rank);

  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<State> States;
  std::vector<std::vector<float>> Values;
  std::vector<float> Minima;
  int Turn = 0;
  bool IsBroken = false;
};

/// The exchange of depth of one rank.
class RankExchange : public vtkNBufferDepthExchange
{
public:
  static RankExchange* New();
  vtkTypeMacro(RankExchange, vtkNBufferDepthExchange);

  void SetRank(Ranks* ranks, int rank)
  {
    this->All = ranks;
    this->Rank = rank;
  }
  int GetNumberOfRanks() override { return this->All->GetCount(); }
  int GetRank() override { return this->Rank; }
  bool ReduceToMinimum(const float* values, float* minima, int count) override
  {
    return this->All->Reduce(this->Rank, values, minima, count);
  }

private:
  Ranks* All = nullptr;
  int Rank = 0;
};

/// Composites the pictures of all ranks by depth: each pixel is that of the rank with the nearest
/// depth there, or of the first of several such ranks.
TestScene::Picture Composite(const std::vector<TestScene::Picture>& pictures);

#endif
