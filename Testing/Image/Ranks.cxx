// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <thread>

vtkStandardNewMacro(RankExchange);

bool Ranks::Run(const std::function<void(int rank)>& function)
{
  std::fill(this->States.begin(), this->States.end(), State::Ready);
  this->Turn = 0;
  this->IsBroken = false;
  std::vector<std::thread> threads;
  for (int rank = 0; rank < this->GetCount(); ++rank)
  {
    threads.emplace_back(
      [this, rank, &function]()
      {
        {
          std::unique_lock<std::mutex> lock(this->Mutex);
          this->Changed.wait(lock, [&]() { return this->Turn == rank; });
        }
        function(rank);
        const std::unique_lock<std::mutex> lock(this->Mutex);
        this->States[rank] = State::Ended;
        this->Pass(rank);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return !this->IsBroken;
}

void Ranks::Pass(int rank)
{
  const auto find = [&]()
  {
    for (int i = 1; i <= this->GetCount(); ++i)
    {
      const int next = (rank + i) % this->GetCount();
      if (this->States[next] == State::Ready)
      {
        return next;
      }
    }
    return -1;
  };
  int next = find();
  const auto waiting = std::count(this->States.begin(), this->States.end(), State::Waiting);
  if (next < 0 && waiting > 0)
  {
    const std::size_t size = std::max_element(this->Values.begin(), this->Values.end(),
      [](const auto& a, const auto& b) {
        return a.size() < b.size();
      })->size();
    this->Minima.assign(size, 2.0e9F);
    this->IsBroken = this->IsBroken || waiting < this->GetCount();
    for (const std::vector<float>& values : this->Values)
    {
      this->IsBroken = this->IsBroken || values.size() != size;
      std::transform(values.begin(), values.end(), this->Minima.begin(), this->Minima.begin(),
        [](float a, float b) { return std::min(a, b); });
    }
    std::replace(this->States.begin(), this->States.end(), State::Waiting, State::Ready);
    next = find();
  }
  this->Turn = next;
  this->Changed.notify_all();
}

bool Ranks::Reduce(int rank, const float* values, float* minima, int count)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Values[rank].assign(values, values + count);
  this->States[rank] = State::Waiting;
  this->Pass(rank);
  this->Changed.wait(
    lock, [&]() { return this->Turn == rank && this->States[rank] == State::Ready; });
  std::copy_n(this->Minima.begin(), count, minima);
  return !this->IsBroken;
}

TestScene::Picture Composite(const std::vector<TestScene::Picture>& pictures)
{
  TestScene::Picture result = pictures.front();
  for (const TestScene::Picture& picture : pictures)
  {
    for (std::size_t i = 0; i < result.Depths.size(); ++i)
    {
      if (picture.Depths[i] < result.Depths[i])
      {
        result.Depths[i] = picture.Depths[i];
        std::copy_n(picture.GetColor(i), 4, &result.Colors[4 * i]);
      }
    }
  }
  return result;
}
