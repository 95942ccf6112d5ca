// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Spread.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
struct KdTree
{
  std::vector<glm::dvec3> Centers;
  std::vector<int> Order; ///< The actors; each part of the tree is a range of it.
  std::vector<int> Ranks;

  /// Give the actors from `begin` to `end` to `count` ranks from `first` on.
  void Split(std::ptrdiff_t begin, std::ptrdiff_t end, int first, int count)
  {
    const auto at = [this](std::ptrdiff_t i) { return this->Order.begin() + i; };
    if (count == 1 || end - begin < 2)
    {
      std::for_each(at(begin), at(end), [&](int i) { this->Ranks[i] = first; });
      return;
    }
    int longest = 0;
    double length = -1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] = std::minmax_element(at(begin), at(end), this->Compare(axis));
      const double here = this->Centers[*high][axis] - this->Centers[*low][axis];
      longest = here > length ? axis : longest;
      length = std::max(here, length);
    }
    const std::ptrdiff_t middle = begin + (end - begin) * (count / 2) / count;
    std::nth_element(at(begin), at(middle), at(end), this->Compare(longest));
    this->Split(begin, middle, first, count / 2);
    this->Split(middle, end, first + count / 2, count - count / 2);
  }

  std::function<bool(int, int)> Compare(int axis) const
  {
    return [this, axis](int a, int b) { return this->Centers[a][axis] < this->Centers[b][axis]; };
  }
};
}

std::vector<int> SpreadActors(const Scene& scene, const std::string& how, int ranks)
{
  KdTree tree;
  tree.Ranks.resize(scene.Actors.size());
  if (how == "random")
  {
    std::mt19937 random(1);
    std::generate(tree.Ranks.begin(), tree.Ranks.end(),
      [&]() { return static_cast<int>(random() % static_cast<unsigned int>(ranks)); });
    return tree.Ranks;
  }
  if (how != "kd")
  {
    throw std::runtime_error("actors are spread by kd or random, not by " + how);
  }
  for (vtkActor* actor : scene.Actors)
  {
    const double* center = actor->GetCenter();
    tree.Centers.emplace_back(center ? glm::dvec3(center[0], center[1], center[2]) : glm::dvec3(0));
  }
  tree.Order.resize(scene.Actors.size());
  std::iota(tree.Order.begin(), tree.Order.end(), 0);
  tree.Split(0, static_cast<std::ptrdiff_t>(tree.Order.size()), 0, ranks);
  return tree.Ranks;
}

} // namespace NBufferExamples
