// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnits.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Box = vtkNBufferUnits::Box;

/// Groups in space take memory for their order, which has to be worth it: their boxes must have
/// less than this share of the surface of the runs' boxes.
constexpr double WorthAnOrder = 0.95;

/// Where each range of neighbours is a draw of its own, the ranges of groups have to have this many
/// primitives on average. A draw takes as long as some fifty triangles.
constexpr std::size_t WorthDraws = 4;

/// The largest number of groups that GetGroups() returns.
constexpr std::size_t MaximumNumberOfGroups = 16;

Box GetEmpty()
{
  const float infinity = std::numeric_limits<float>::infinity();
  return { glm::vec3(infinity), glm::vec3(-infinity) };
}

void Include(Box& box, const Box& other)
{
  box.Low = glm::min(box.Low, other.Low);
  box.High = glm::max(box.High, other.High);
}

void Include(Box& box, const glm::dvec3& point)
{
  const bool isFinite = vtkNBufferGLM::IsFinite(point);
  for (int k = 0; k < 3; ++k)
  {
    const float infinity = std::numeric_limits<float>::infinity();
    box.Low[k] = isFinite ? std::min(box.Low[k], -vtkNBufferGLM::RoundUp(-point[k])) : -infinity;
    box.High[k] = isFinite ? std::max(box.High[k], vtkNBufferGLM::RoundUp(point[k])) : infinity;
  }
}

double GetSurface(const Box& box)
{
  const glm::dvec3 size = glm::dvec3(box.High) - glm::dvec3(box.Low);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

double GetSurface(const std::vector<Box>& boxes)
{
  double sum = 0.0;
  for (const Box& box : boxes)
  {
    sum += GetSurface(box);
  }
  return sum;
}

/// The number of ranges of primitives that have the same unit.
std::size_t CountRanges(const std::vector<std::uint32_t>& units)
{
  std::size_t count = 1;
  for (std::size_t i = 1; i < units.size(); ++i)
  {
    count += units[i] != units[i - 1];
  }
  return count;
}

struct Entry
{
  glm::vec3 Middle;
  unsigned int Primitive;
};

/// Bring primitives into an order in which those of each unit, and of each node of the hierarchy,
/// are neighbours in space.
void SplitAtMedian(Entry* begin, Entry* end, std::size_t unitSize)
{
  const auto size = static_cast<std::size_t>(end - begin);
  if (size <= unitSize)
  {
    return;
  }
  Box all = GetEmpty();
  for (const Entry* entry = begin; entry != end; ++entry)
  {
    Include(all, Box{ entry->Middle, entry->Middle });
  }
  const glm::vec3 extent = all.High - all.Low;
  int axis = extent.y > extent.x ? 1 : 0;
  axis = extent.z > extent[axis] ? 2 : axis;
  // The number of units of the first part is a power of 2 and at least half of all. A node has a
  // power of 8 units, so that no node has units of both parts.
  std::size_t first = unitSize;
  while (2 * first < size)
  {
    first *= 2;
  }
  std::nth_element(begin, begin + first, end,
    [axis](const Entry& a, const Entry& b) { return a.Middle[axis] < b.Middle[axis]; });
  SplitAtMedian(begin, begin + first, unitSize);
  SplitAtMedian(begin + first, end, unitSize);
}

/// The primitives in the order of a k-d tree of their middles (J. L. Bentley, "Multidimensional
/// binary search trees used for associative searching", Communications of the ACM 18(9), 1975).
std::vector<unsigned int> GetOrderInSpace(const vtkNBufferUnits::Mesh& mesh, std::size_t unitSize)
{
  std::vector<Entry> entries(mesh.Indices.size() / mesh.Corners);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    Box box = GetEmpty();
    for (std::size_t k = 0; k < mesh.Corners; ++k)
    {
      Include(box, mesh.Points[mesh.Indices[mesh.Corners * i + k]]);
    }
    const glm::vec3 middle = 0.5F * box.Low + 0.5F * box.High;
    const bool isFinite = vtkNBufferGLM::IsFinite(glm::dvec3(middle)); // NaN has no order.
    entries[i] = { isFinite ? middle : glm::vec3(0.0F), static_cast<unsigned int>(i) };
  }
  SplitAtMedian(entries.data(), entries.data() + entries.size(), unitSize);
  std::vector<unsigned int> order(entries.size());
  std::transform(entries.begin(), entries.end(), order.begin(),
    [](const Entry& entry) { return entry.Primitive; });
  return order;
}
}

vtkNBufferUnits vtkNBufferUnits::Make(const Mesh& mesh, std::size_t unitSize)
{
  const bool isInRange = std::all_of(mesh.Indices.begin(), mesh.Indices.end(),
    [&mesh](unsigned int index) { return index < mesh.Points.size(); });
  vtkNBufferUnits runs;
  if (!isInRange || mesh.Indices.size() < mesh.Corners)
  {
    return runs;
  }
  runs.UnitSize = unitSize;
  runs.MakeBoxes(mesh);
  vtkNBufferUnits groups;
  groups.UnitSize = unitSize;
  groups.Order = GetOrderInSpace(mesh, unitSize);
  groups.MakeBoxes(mesh);
  // The boxes of single primitives are the same in any order.
  const std::size_t level = unitSize == 1 && runs.Levels.size() > 1 ? 1 : 0;
  const bool isSmaller =
    GetSurface(groups.Levels[level]) < WorthAnOrder * GetSurface(runs.Levels[level]);
  const bool isScattered = mesh.IsDrawnInRanges &&
    CountRanges(groups.GetUnitsOfPrimitives()) * WorthDraws > groups.Order.size();
  return isSmaller && !isScattered ? groups : runs;
}

void vtkNBufferUnits::MakeBoxes(const Mesh& mesh)
{
  const std::size_t size = mesh.Indices.size() / mesh.Corners;
  this->NumberOfPrimitives = size;
  std::vector<Box> boxes((size + this->UnitSize - 1) / this->UnitSize, GetEmpty());
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t primitive = this->Order.empty() ? i : this->Order[i];
    for (std::size_t k = 0; k < mesh.Corners; ++k)
    {
      Include(boxes[i / this->UnitSize], mesh.Points[mesh.Indices[mesh.Corners * primitive + k]]);
    }
  }
  this->Levels.push_back(std::move(boxes));
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Box>& below = this->Levels.back();
    std::vector<Box> level((below.size() + Fanout - 1) / Fanout, GetEmpty());
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      Include(level[i / Fanout], below[i]);
    }
    this->Levels.push_back(std::move(level));
  }
}

std::vector<Box> vtkNBufferUnits::GetGroups(const std::vector<unsigned char>& marked) const
{
  std::vector<std::size_t> nodes; // The node of each group.
  std::vector<Box> groups;
  for (std::size_t i = 0; i < marked.size(); ++i)
  {
    if (marked[i])
    {
      nodes.push_back(i);
      groups.push_back(this->Levels[0][i]);
    }
  }
  while (groups.size() > MaximumNumberOfGroups)
  {
    std::size_t last = 0;
    nodes[0] /= Fanout;
    for (std::size_t n = 1; n < groups.size(); ++n)
    {
      if (nodes[n] / Fanout == nodes[last])
      {
        Include(groups[last], groups[n]);
        continue;
      }
      ++last;
      nodes[last] = nodes[n] / Fanout;
      groups[last] = groups[n];
    }
    nodes.resize(last + 1);
    groups.resize(last + 1);
  }
  return groups;
}

std::size_t vtkNBufferUnits::FindUnit(std::size_t primitive)
{
  if (primitive >= this->NumberOfPrimitives)
  {
    return this->GetSize();
  }
  if (this->Order.empty())
  {
    return primitive / this->UnitSize;
  }
  if (this->UnitOfPrimitive.empty())
  {
    this->UnitOfPrimitive = this->GetUnitsOfPrimitives();
  }
  return this->UnitOfPrimitive[primitive];
}

std::vector<std::uint32_t> vtkNBufferUnits::GetUnitsOfPrimitives() const
{
  std::vector<std::uint32_t> units(this->NumberOfPrimitives);
  for (std::size_t i = 0; i < units.size(); ++i)
  {
    units[this->AreSpatial() ? this->Order[i] : i] = static_cast<std::uint32_t>(i / this->UnitSize);
  }
  return units;
}

namespace
{
/// The number of the lowest bit that is 1; there must be one.
std::size_t FindLowestBit(std::uint64_t bits)
{
#if defined(__GNUC__) || defined(__clang__)
  return static_cast<std::size_t>(__builtin_ctzll(bits));
#else
  std::size_t number = 0;
  for (; !(bits & 1U); bits >>= 1)
  {
    ++number;
  }
  return number;
#endif
}
}

std::vector<vtkNBufferUnits::Range> vtkNBufferUnits::GetRanges(
  const std::vector<unsigned char>& drawn) const
{
  const std::size_t size = this->NumberOfPrimitives;
  std::vector<Range> ranges;
  const auto add = [&ranges](std::size_t begin, std::size_t end)
  {
    if (ranges.empty() || begin > ranges.back().End)
    {
      ranges.push_back({ begin, end });
    }
    ranges.back().End = end;
  };
  if (!this->AreSpatial())
  {
    for (std::size_t unit = 0; unit < this->GetSize(); ++unit)
    {
      if (drawn[unit])
      {
        add(unit * this->UnitSize, std::min((unit + 1) * this->UnitSize, size));
      }
    }
    return ranges;
  }
  // One bit for each primitive puts the primitives of the units back into the order of drawing.
  constexpr std::size_t bits = 64;
  std::vector<std::uint64_t> marked((size + bits - 1) / bits);
  for (std::size_t unit = 0; unit < this->GetSize(); ++unit)
  {
    const std::size_t end = std::min((unit + 1) * this->UnitSize, size);
    for (std::size_t i = unit * this->UnitSize; drawn[unit] && i < end; ++i)
    {
      marked[this->Order[i] / bits] |= std::uint64_t(1) << (this->Order[i] % bits);
    }
  }
  for (std::size_t word = 0; word < marked.size(); ++word)
  {
    for (std::uint64_t left = marked[word]; left != 0; left &= left - 1)
    {
      const std::size_t primitive = word * bits + FindLowestBit(left);
      add(primitive, primitive + 1);
    }
  }
  return ranges;
}

std::vector<vtkNBufferUnits::Range> vtkNBufferUnits::Clip(
  const std::vector<Range>& ranges, const Range& part)
{
  std::vector<Range> clipped;
  auto range = std::partition_point(
    ranges.begin(), ranges.end(), [&part](const Range& other) { return other.End <= part.Begin; });
  for (; range != ranges.end() && range->Begin < part.End; ++range)
  {
    clipped.push_back({ std::max(range->Begin, part.Begin) - part.Begin,
      std::min(range->End, part.End) - part.Begin });
  }
  return clipped;
}
VTK_ABI_NAMESPACE_END
