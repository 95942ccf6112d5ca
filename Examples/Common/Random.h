// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Random.h
 * @brief Random numbers that are the same with every compiler; those of std::*_distribution are
 * not.
 */
#ifndef Random_h
#define Random_h

#include <cstddef>
#include <cstdint>
#include <random>

namespace NBufferExamples
{

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  /// Returns a number in [low, high).
  double Between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() >> 11) / 9007199254740992.0);
  }
  /// Returns a number in [0, count).
  std::size_t Index(std::size_t count)
  {
    return static_cast<std::size_t>(this->Between(0.0, static_cast<double>(count)));
  }

private:
  std::mt19937_64 Engine;
};

} // namespace NBufferExamples

#endif
