// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitCulling.h"

#include "vtkNBufferForEachProp.h"
#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Drawn units are compared with the levels in each frame, and with pixels in one of this many, in
/// groups of vtkNBufferUnits::Fanout.
constexpr std::size_t Turns = 8;

/// The threads share the nodes of the highest level that is tested in groups of this size.
constexpr vtkIdType NodesPerThread = 4;

/**
 * A unit that was dropped and is visible again in the next test is kept through this many tests
 * that find it hidden. It owns a few pixels between other units, in some frames none. Whenever it
 * is not kept, the test finds a hole there, and all units visible that the hole shows: of 200,000
 * cubes in a cloud, 4,080 in each frame, where 270 have come into view.
 */
constexpr unsigned char MostPatience = 15;
}

/// The tests of one thread in a call of Test().
struct vtkNBufferUnitCulling::Tests
{
  const vtkNBufferProjection& Projection;
  vtkNBufferOcclusionTest Levels;
  std::optional<vtkNBufferPixelTest> Pixels;
  const vtkNBufferUnitAnswers* Answers = nullptr;
};

/// Call function(level, begin, end) for ranges of nodes that together have all units, in parallel
/// if there are many.
template <typename Function>
void vtkNBufferUnitCulling::RunInThreads(const Function& function)
{
  const auto& levels = this->Units.GetLevels();
  const std::size_t level = std::min(vtkNBufferUnitAnswers::HighestLevel, levels.size() - 1);
  vtkNBufferForEachProp::Run(
    levels[level].size(),
    [&function, level](vtkIdType begin, vtkIdType end)
    { function(level, static_cast<std::size_t>(begin), static_cast<std::size_t>(end)); },
    NodesPerThread);
}

void vtkNBufferUnitCulling::SetUnits(vtkNBufferUnits units)
{
  this->Units = std::move(units);
  const std::size_t size = this->Units.GetSize();
  this->Marks.assign(size, 0);
  this->Patience.assign(size, 0);
  this->DrawnUnits.assign(size, 0);
  this->FreshUnits.assign(size, 0);
  this->Choice.Clear();
}

vtkNBufferBox vtkNBufferUnitCulling::MakeBox(const vtkNBufferUnits::Box& bounds) const
{
  const double values[6] = { bounds.Low.x, bounds.High.x, bounds.Low.y, bounds.High.y, bounds.Low.z,
    bounds.High.z };
  vtkNBufferBox box = vtkNBufferBox::FromBounds(values);
  box.Origin = this->Errors.Origin;
  box.Magnitude = this->Errors.Magnitude;
  box.Margin = this->Errors.Margin;
  return box;
}

bool vtkNBufferUnitCulling::Project(
  const vtkNBufferProjection& projection, std::size_t unit, vtkNBufferScreenBox& screen) const
{
  return projection.Project(this->MakeBox(this->Units.GetLevels()[0][unit]), screen) ==
    vtkNBufferPlacement::Inside;
}

void vtkNBufferUnitCulling::FindKept(const vtkNBufferProjection& projection)
{
  for (unsigned char& mark : this->Marks)
  {
    mark &= static_cast<unsigned char>(~Outside);
  }
  this->RunInThreads(
    [this, &projection](std::size_t level, std::size_t begin, std::size_t end)
    {
      for (std::size_t n = begin; n < end; ++n)
      {
        this->MarkOutside(level, n, projection);
      }
    });
  this->Number = {};
  this->FreshBefore = this->KeptInVain = 0;
  this->Number.Units = static_cast<int>(this->Units.GetSize());
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    this->DrawnUnits[i] = (this->Marks[i] & (Kept | Outside)) == Kept;
    this->Number.Outside += (this->Marks[i] & Outside) != 0;
    this->Number.Kept += this->DrawnUnits[i];
  }
  const int inside = this->Number.Units - this->Number.Outside;
  const bool isNew = this->Choice.IsNew(inside, this->Number.Kept);
  const bool isFromElsewhere =
    this->Choice.IsFromElsewhere(projection, this->Units, this->DrawnUnits);
  if (isFromElsewhere)
  {
    for (unsigned char& mark : this->Marks)
    {
      mark &= Outside;
    }
    this->ClearDrawn();
  }
  if (isNew || isFromElsewhere)
  {
    const auto project = [this, &projection](std::size_t i, vtkNBufferScreenBox& screen)
    { return !(this->Marks[i] & (Kept | Outside)) && this->Project(projection, i, screen); };
    for (const std::size_t i :
      vtkNBufferUnitChoice::FindOccluders(this->Units.GetSize(), projection, project))
    {
      this->Keep(i);
    }
  }
  if (this->Number.Kept == 0 && inside > 0)
  {
    // VTK notices some changes only while it draws.
    const auto first = std::find_if(
      this->Marks.begin(), this->Marks.end(), [](unsigned char mark) { return !(mark & Outside); });
    this->Keep(static_cast<std::size_t>(first - this->Marks.begin()));
  }
}

void vtkNBufferUnitCulling::MarkOutside(
  std::size_t level, std::size_t n, const vtkNBufferProjection& projection)
{
  const vtkNBufferBox box = this->MakeBox(this->Units.GetLevels()[level][n]);
  vtkNBufferScreenBox screen;
  const vtkNBufferPlacement placement = projection.Place(box, screen);
  if (placement == vtkNBufferPlacement::Outside)
  {
    const std::size_t end = this->Units.GetEnd(level, n);
    for (std::size_t i = this->Units.GetBegin(level, n); i < end; ++i)
    {
      this->Marks[i] = Outside;
    }
    return;
  }
  if (level == 0 || (placement == vtkNBufferPlacement::Inside && projection.IsWhollyInside(screen)))
  {
    return;
  }
  const std::size_t end =
    std::min((n + 1) * vtkNBufferUnits::Fanout, this->Units.GetLevels()[level - 1].size());
  for (std::size_t child = n * vtkNBufferUnits::Fanout; child < end; ++child)
  {
    this->MarkOutside(level - 1, child, projection);
  }
}

void vtkNBufferUnitCulling::Keep(std::size_t unit)
{
  this->Marks[unit] = Kept;
  this->DrawnUnits[unit] = 1;
  ++this->Number.Kept;
}

void vtkNBufferUnitCulling::ClearDrawn()
{
  std::fill(this->DrawnUnits.begin(), this->DrawnUnits.end(), 0);
  this->Number.Kept = this->FreshBefore = 0;
}

int vtkNBufferUnitCulling::Test(
  const vtkNBufferProjection& projection, const Depth& depth, const vtkNBufferUnitAnswers* answers)
{
  std::fill(this->FreshUnits.begin(), this->FreshUnits.end(), 0);
  this->Turn = (this->Turn + 1) % Turns;
  this->RunInThreads(
    [this, &projection, &depth, answers](std::size_t level, std::size_t begin, std::size_t end)
    {
      Tests tests = { projection, vtkNBufferOcclusionTest(depth.Levels, depth.SampleDistance), {},
        answers };
      if (depth.Pixels)
      {
        tests.Pixels.emplace(projection, depth.Levels, depth.Pixels, depth.SampleDistance);
      }
      for (std::size_t n = begin; n < end; ++n)
      {
        this->TestNode(level, n, tests);
      }
    });
  const auto fresh = std::count(this->FreshUnits.begin(), this->FreshUnits.end(), 1);
  this->Number.Fresh = this->FreshBefore + static_cast<int>(fresh);
  for (std::size_t i = 0; i < this->Marks.size(); ++i)
  {
    this->KeptInVain += this->DrawnUnits[i] && (this->Marks[i] & Dropped);
  }
  const auto seen = std::count_if(
    this->Marks.begin(), this->Marks.end(), [](unsigned char mark) { return (mark & Kept) != 0; });
  this->Choice.SetTested(
    projection, this->Number.Units - this->Number.Outside, static_cast<int>(seen));
  return static_cast<int>(fresh);
}

bool vtkNBufferUnitCulling::PostponeFar(const vtkNBufferProjection& projection)
{
  const int fresh = this->CountFresh();
  if (!vtkNBufferUnitChoice::AreMany(fresh, this->CountDrawn()))
  {
    return false;
  }
  const auto project = [this, &projection](std::size_t i, vtkNBufferScreenBox& screen)
  { return this->FreshUnits[i] && this->Project(projection, i, screen); };
  const std::vector<std::size_t> occluders =
    vtkNBufferUnitChoice::FindOccluders(this->Units.GetSize(), projection, project);
  const auto number = static_cast<int>(occluders.size());
  if (number == 0 || number == fresh)
  {
    return false; // All of them reach the near plane, or none hides another one.
  }
  for (std::size_t i = 0; i < this->FreshUnits.size(); ++i)
  {
    if (this->FreshUnits[i])
    {
      this->Marks[i] &= static_cast<unsigned char>(~Kept);
    }
  }
  std::fill(this->FreshUnits.begin(), this->FreshUnits.end(), 0);
  for (const std::size_t i : occluders)
  {
    this->FreshUnits[i] = 1;
    this->Marks[i] |= Kept;
  }
  this->Number.Fresh = this->FreshBefore + number;
  return true;
}

void vtkNBufferUnitCulling::TestNode(std::size_t level, std::size_t n, Tests& tests)
{
  if (level == 0 && (this->Marks[n] & Outside))
  {
    return;
  }
  auto answer = tests.Answers ? tests.Answers->Get(level, n) : vtkNBufferUnitAnswers::None;
  if (answer == vtkNBufferUnitAnswers::None)
  {
    answer = this->TestBox(level, n, tests);
  }
  if (answer == vtkNBufferUnitAnswers::Outside)
  {
    return;
  }
  if (answer == vtkNBufferUnitAnswers::Hidden)
  {
    const std::size_t end = this->Units.GetEnd(level, n);
    for (std::size_t i = this->Units.GetBegin(level, n); i < end; ++i)
    {
      this->SetHidden(i);
    }
    return;
  }
  if (level == 0)
  {
    this->SetVisible(n);
    return;
  }
  const std::size_t end =
    std::min((n + 1) * vtkNBufferUnits::Fanout, this->Units.GetLevels()[level - 1].size());
  for (std::size_t child = n * vtkNBufferUnits::Fanout; child < end; ++child)
  {
    this->TestNode(level - 1, child, tests);
  }
}

void vtkNBufferUnitCulling::SetHidden(std::size_t unit)
{
  unsigned char& mark = this->Marks[unit];
  const bool isDropped = (mark & Kept) != 0 && this->Patience[unit] == 0;
  this->Patience[unit] -= this->Patience[unit] > 0;
  mark &= static_cast<unsigned char>(~Dropped);
  if (isDropped)
  {
    mark = static_cast<unsigned char>((mark & ~Kept) | Dropped);
  }
}

void vtkNBufferUnitCulling::SetVisible(std::size_t unit)
{
  unsigned char& mark = this->Marks[unit];
  if (mark & Dropped || this->Patience[unit] > 0)
  {
    this->Patience[unit] = MostPatience;
  }
  mark = static_cast<unsigned char>((mark & ~Dropped) | Kept);
  this->FreshUnits[unit] = !this->DrawnUnits[unit];
}

vtkNBufferUnitAnswers::Answer vtkNBufferUnitCulling::TestBox(
  std::size_t level, std::size_t n, Tests& tests) const
{
  const vtkNBufferBox box = this->MakeBox(this->Units.GetLevels()[level][n]);
  vtkNBufferScreenBox screen;
  const vtkNBufferPlacement placement = tests.Projection.Project(box, screen);
  if (placement == vtkNBufferPlacement::Outside)
  {
    return vtkNBufferUnitAnswers::Outside;
  }
  const bool isInside = placement == vtkNBufferPlacement::Inside;
  bool isHidden = isInside && tests.Levels.IsHidden(screen);
  const bool isDue = n / vtkNBufferUnits::Fanout % Turns == this->Turn;
  if (level == 0 && isInside && !isHidden && tests.Pixels && (!this->DrawnUnits[n] || isDue))
  {
    isHidden = tests.Pixels->IsHidden(box, screen);
  }
  return isHidden ? vtkNBufferUnitAnswers::Hidden : vtkNBufferUnitAnswers::Visible;
}

std::size_t vtkNBufferUnitCulling::CountInDoubt(
  const vtkNBufferProjection& projection, const Depth& depth) const
{
  Tests tests = { projection, vtkNBufferOcclusionTest(depth.Levels, depth.SampleDistance), {} };
  const auto& levels = this->Units.GetLevels();
  const std::size_t level = std::min(vtkNBufferUnitAnswers::HighestLevel, levels.size() - 1);
  std::size_t units = 0;
  for (std::size_t n = 0; n < levels[level].size(); ++n)
  {
    const bool isLeft = this->TestBox(level, n, tests) == vtkNBufferUnitAnswers::Visible;
    units += isLeft ? this->Units.GetEnd(level, n) - this->Units.GetBegin(level, n) : 0;
  }
  return units;
}

bool vtkNBufferUnitCulling::AreRight(const vtkNBufferUnitAnswers& answers,
  const vtkNBufferProjection& projection, const Depth& depth) const
{
  Tests tests = { projection, vtkNBufferOcclusionTest(depth.Levels, depth.SampleDistance), {} };
  const std::size_t levels = answers.FirstOfLevel.size();
  for (std::size_t level = 0; level < levels; ++level)
  {
    for (std::size_t n = 0; n < this->Units.GetLevels()[level].size(); ++n)
    {
      const vtkNBufferUnitAnswers::Answer answer = answers.Get(level, n);
      if (answer != vtkNBufferUnitAnswers::None && answer != this->TestBox(level, n, tests))
      {
        return false;
      }
    }
  }
  return true;
}

int vtkNBufferUnitCulling::CountHidden(
  const vtkNBufferProjection& projection, const Depth& depth) const
{
  Tests tests = { projection, vtkNBufferOcclusionTest(depth.Levels, depth.SampleDistance), {} };
  int count = 0;
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    count +=
      !(this->Marks[i] & Outside) && this->TestBox(0, i, tests) == vtkNBufferUnitAnswers::Hidden;
  }
  return count;
}

void vtkNBufferUnitCulling::AddFreshToDrawn()
{
  std::transform(this->FreshUnits.begin(), this->FreshUnits.end(), this->DrawnUnits.begin(),
    this->DrawnUnits.begin(), std::bit_or<unsigned char>());
  this->FreshBefore = this->Number.Fresh;
}

int vtkNBufferUnitCulling::CountDrawn() const
{
  return static_cast<int>(std::count(this->DrawnUnits.begin(), this->DrawnUnits.end(), 1));
}

vtkNBufferVerdict vtkNBufferUnitCulling::GetVerdict(std::size_t primitive)
{
  const std::size_t unit = this->Units.FindUnit(primitive);
  if (unit == this->Units.GetSize())
  {
    return vtkNBufferVerdict::Unknown;
  }
  const bool isOutside = (this->Marks[unit] & Outside) != 0;
  const auto inView =
    this->DrawnUnits[unit] ? vtkNBufferVerdict::Visible : vtkNBufferVerdict::Hidden;
  return isOutside ? vtkNBufferVerdict::Outside : inView;
}
VTK_ABI_NAMESPACE_END
