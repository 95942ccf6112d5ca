// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ranks.h
 * @brief The ranks of a parallel program, as threads of one process of which one runs at a time, so
 * that tests of the exchange need no MPI.
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

  /// Call the function once for each rank. Returns false if a rank waited in a reduction for one
  /// that had ended, or ranks joined one with different counts. With MPI the program would hang.
  bool Run(const std::function<void(int rank)>& function);

  /// vtkNBufferDepthExchange::ReduceToMinimum() of a rank.
  bool Reduce(int rank, const float* values, float* minima, int count);

  /// The number of reductions so far.
  int GetReductions() const { return this->Reductions; }

private:
  enum class State
  {
    Ready,
    Waiting, ///< In a reduction.
    Ended
  };

  /// Let the next rank run that is ready. If there is none, complete the reduction.
  void Pass(int rank);

  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<State> States;
  std::vector<std::vector<float>> Values;
  std::vector<float> Minima;
  int Turn = 0;
  int Reductions = 0;
  bool IsBroken = false;
};

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

/// What compositing by depth makes of the pictures of all ranks: each pixel is that of the rank
/// with the nearest depth, and of the first one of several.
TestScene::Picture Composite(const std::vector<TestScene::Picture>& pictures);

#endif
