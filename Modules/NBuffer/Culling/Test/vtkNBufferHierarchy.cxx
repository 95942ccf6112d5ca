// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferHierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The union of boxes, and the rounding that bounds that of all of them.
class Union
{
public:
  void Add(const vtkNBufferBox& box)
  {
    const glm::dvec3 low = box.Center - box.HalfSize;
    const glm::dvec3 high = box.Center + box.HalfSize;
    // The origin of the union is 0, not the box's own o: |M o + M_3| <= |M| |o| + |M_3|.
    const glm::dvec3 magnitude = vtkNBufferGLM::Abs(box.Origin) + box.Magnitude;
    this->Low = glm::min(this->Low, low);
    this->High = glm::max(this->High, high);
    this->Magnitude = glm::max(this->Magnitude, magnitude);
    this->Margin = std::max(this->Margin, box.Margin);
    this->Known = this->Known && vtkNBufferGLM::IsFinite(low) && vtkNBufferGLM::IsFinite(high) &&
      vtkNBufferGLM::IsFinite(magnitude) && low.x <= high.x && low.y <= high.y && low.z <= high.z &&
      std::isfinite(box.Margin);
  }

  vtkNBufferBox Get() const
  {
    vtkNBufferBox box;
    if (this->Known)
    {
      box.Center = 0.5 * (this->Low + this->High);
      // Rounding must not make the box too small.
      box.HalfSize = 0.5 * (this->High - this->Low) +
        (vtkNBufferGLM::Abs(this->Low) + vtkNBufferGLM::Abs(this->High)) * 0x1p-51;
    }
    else
    {
      // Every comparison of the projection treats NaN as "unknown".
      box.Center = box.HalfSize = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    }
    box.Magnitude = this->Magnitude;
    box.Margin = this->Margin;
    return box;
  }

private:
  glm::dvec3 Low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 High = glm::dvec3(-std::numeric_limits<double>::infinity());
  glm::dvec3 Magnitude = glm::dvec3(0.0);
  double Margin = 0.0;
  bool Known = true;
};

double GetExtent(const vtkNBufferBox& box)
{
  return box.HalfSize.x + box.HalfSize.y + box.HalfSize.z;
}
}

/// The search for the median sorts these instead of boxes: they are small, so less memory moves.
struct vtkNBufferHierarchy::Key
{
  glm::dvec3 Center = glm::dvec3(0.0);
  int Place = 0;
};

void vtkNBufferHierarchy::Clear()
{
  this->Nodes.clear();
  this->Dirty.clear();
  this->Order.clear();
  this->Slots.clear();
  this->Boxes.clear();
  this->Extent = this->BuiltExtent = 0.0;
}

void vtkNBufferHierarchy::Build(const std::vector<vtkNBufferBox>& boxes, int leafSize)
{
  std::vector<int> places(boxes.size());
  std::iota(places.begin(), places.end(), 0);
  this->Build(boxes, std::move(places), leafSize);
}

void vtkNBufferHierarchy::Build(
  const std::vector<vtkNBufferBox>& boxes, std::vector<int> places, int leafSize)
{
  this->Clear();
  if (places.empty())
  {
    return;
  }
  std::vector<Key> keys(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const vtkNBufferBox& box = boxes[places[i]];
    for (int j = 0; j < 3; ++j)
    {
      // NaN cannot be sorted.
      keys[i].Center[j] = std::isfinite(box.Center[j]) ? box.Center[j] : 0.0;
    }
    keys[i].Place = places[i];
  }
  this->Split(keys, 0, static_cast<int>(keys.size()), std::max(leafSize, 1));
  this->Order = std::move(places);
  this->Slots.assign(boxes.size(), -1);
  this->Boxes.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    this->Order[i] = keys[i].Place;
    this->Slots[keys[i].Place] = static_cast<int>(i);
    this->Boxes[i] = boxes[keys[i].Place];
  }
  this->Dirty.assign(this->Nodes.size(), 1);
  this->Refit();
  this->BuiltExtent = this->Extent;
}

int vtkNBufferHierarchy::Split(std::vector<Key>& keys, int begin, int end, int leafSize)
{
  const auto index = static_cast<int>(this->Nodes.size());
  this->Nodes.emplace_back();
  Node node;
  node.Begin = begin;
  node.End = end;
  if (end - begin > leafSize)
  {
    glm::dvec3 low = keys[begin].Center;
    glm::dvec3 high = low;
    for (int i = begin; i < end; ++i)
    {
      low = glm::min(low, keys[i].Center);
      high = glm::max(high, keys[i].Center);
    }
    const glm::dvec3 size = high - low;
    const double* sizes = glm::value_ptr(size);
    const auto axis = static_cast<int>(std::max_element(sizes, sizes + 3) - sizes);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(keys.begin() + begin, keys.begin() + middle, keys.begin() + end,
      [axis](const Key& a, const Key& b) { return a.Center[axis] < b.Center[axis]; });
    node.Left = this->Split(keys, begin, middle, leafSize);
    node.Right = this->Split(keys, middle, end, leafSize);
  }
  node.Next = static_cast<int>(this->Nodes.size());
  this->Nodes[index] = node;
  return index;
}

void vtkNBufferHierarchy::Move(int place, const vtkNBufferBox& box)
{
  const int slot = this->Slots[place];
  this->Boxes[slot] = box;
  for (int i = 0; i >= 0;)
  {
    const Node& node = this->Nodes[i];
    this->Dirty[i] = 1;
    i = node.Left < 0 || slot < this->Nodes[node.Left].End ? node.Left : node.Right;
  }
}

int vtkNBufferHierarchy::Refit()
{
  int fitted = 0;
  const bool isAnyDirty = !this->Nodes.empty() && this->Dirty[0]; // Move() marks the root, too.
  for (std::size_t i = isAnyDirty ? this->Nodes.size() : 0; i-- > 0;)
  {
    if (this->Dirty[i])
    {
      this->FitNode(i);
      this->Dirty[i] = 0;
      ++fitted;
    }
  }
  return fitted;
}

void vtkNBufferHierarchy::FitNode(std::size_t place)
{
  Node& node = this->Nodes[place];
  Union all;
  if (node.Left >= 0)
  {
    all.Add(this->Nodes[node.Left].Box);
    all.Add(this->Nodes[node.Right].Box);
    node.Box = all.Get();
    return;
  }
  for (int slot = node.Begin; slot < node.End; ++slot)
  {
    all.Add(this->Boxes[slot]);
  }
  const double before = GetExtent(node.Box);
  node.Box = all.Get();
  const double change = GetExtent(node.Box) - before;
  // Leaves without a finite box do not count in the sum.
  this->Extent += std::isfinite(change) ? change : 0.0;
}

double vtkNBufferHierarchy::GetGrowth() const
{
  return this->BuiltExtent > 0.0 ? this->Extent / this->BuiltExtent : 1.0;
}
VTK_ABI_NAMESPACE_END
