// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace NBufferStudy
{
namespace
{
/// The union of boxes, and of what rounding does to them.
class Union
{
public:
  void Add(const vtkNBufferBox& box)
  {
    for (int j = 0; j < 3; ++j)
    {
      this->Low[j] = std::min(this->Low[j], box.Center[j] - box.HalfSize[j]);
      this->High[j] = std::max(this->High[j], box.Center[j] + box.HalfSize[j]);
      // Around the origin o = 0 instead of the box's own: |M o + M_3| <= |M| |o| + |M_3|.
      this->Magnitude[j] = std::max(this->Magnitude[j], std::abs(box.Origin[j]) + box.Magnitude[j]);
    }
    this->Margin = std::max(this->Margin, box.Margin);
  }

  vtkNBufferBox Get() const
  {
    vtkNBufferBox box;
    for (int j = 0; j < 3; ++j)
    {
      box.Center[j] = 0.5 * (this->Low[j] + this->High[j]);
      // Rounding must not cut anything off.
      box.HalfSize[j] = 0.5 * (this->High[j] - this->Low[j]) +
        (std::abs(this->Low[j]) + std::abs(this->High[j])) * 0x1p-51;
      box.Magnitude[j] = this->Magnitude[j];
    }
    box.Margin = this->Margin;
    return box;
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  double Low[3] = { Infinity, Infinity, Infinity };
  double High[3] = { -Infinity, -Infinity, -Infinity };
  double Magnitude[3] = { 0.0, 0.0, 0.0 };
  double Margin = 0.0;
};
}

void BoxTree::Build(const std::vector<vtkNBufferBox>& boxes, int leafSize)
{
  this->Nodes.clear();
  this->Order.resize(boxes.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  if (!boxes.empty())
  {
    this->Split(boxes, 0, static_cast<int>(boxes.size()), leafSize);
    this->Refit(boxes);
  }
}

int BoxTree::Split(const std::vector<vtkNBufferBox>& boxes, int begin, int end, int leafSize)
{
  const int place = static_cast<int>(this->Nodes.size());
  this->Nodes.emplace_back();
  int left = -1;
  int right = -1;
  if (end - begin > leafSize)
  {
    double low[3];
    double high[3];
    for (int j = 0; j < 3; ++j)
    {
      const auto [least, greatest] =
        std::minmax_element(this->Order.begin() + begin, this->Order.begin() + end,
          [&boxes, j](int a, int b) { return boxes[a].Center[j] < boxes[b].Center[j]; });
      low[j] = boxes[*least].Center[j];
      high[j] = boxes[*greatest].Center[j];
    }
    int axis = 0;
    for (int j = 1; j < 3; ++j)
    {
      axis = high[j] - low[j] > high[axis] - low[axis] ? j : axis;
    }
    const int middle = begin + (end - begin) / 2;
    std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
      this->Order.begin() + end,
      [&boxes, axis](int a, int b) { return boxes[a].Center[axis] < boxes[b].Center[axis]; });
    left = this->Split(boxes, begin, middle, leafSize);
    right = this->Split(boxes, middle, end, leafSize);
  }
  Node& node = this->Nodes[static_cast<std::size_t>(place)];
  node.Begin = begin;
  node.End = end;
  node.Left = left;
  node.Right = right;
  node.Next = static_cast<int>(this->Nodes.size());
  return place;
}

void BoxTree::Refit(const std::vector<vtkNBufferBox>& boxes)
{
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    Union all;
    if (node->Left < 0)
    {
      for (int place = node->Begin; place < node->End; ++place)
      {
        all.Add(boxes[static_cast<std::size_t>(this->Order[static_cast<std::size_t>(place)])]);
      }
    }
    else
    {
      all.Add(this->Nodes[static_cast<std::size_t>(node->Left)].Box);
      all.Add(this->Nodes[static_cast<std::size_t>(node->Right)].Box);
    }
    node->Box = all.Get();
  }
}

} // namespace NBufferStudy
