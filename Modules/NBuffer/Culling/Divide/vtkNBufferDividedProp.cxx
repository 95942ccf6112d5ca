// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDividedProp.h"

#include "vtkNBufferOcclusionTest.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Drawn units are compared with the levels in each frame, and with pixels in one of this many, in
/// groups of vtkNBufferUnits::Fanout.
constexpr std::size_t Turns = 8;

/// A view is new if fewer than one in this many units of the frustum are known to be visible. Then
/// that share of the units is drawn first.
constexpr std::size_t NewViewShare = 64;
}

/// The tests of one call of Test().
struct vtkNBufferDividedProp::Tests
{
  const vtkNBufferProjection& Projection;
  vtkNBufferOcclusionTest Levels;
  std::optional<vtkNBufferPixelTest> Pixels;
};

vtkNBufferDividedProp::vtkNBufferDividedProp(vtkActor* actor)
  : Actor(actor)
{
  this->Hook->Attach(actor);
  this->Proxy->SetProp(
    actor, [this](const std::function<int()>& drawWhole) { return this->Draw(drawWhole); });
}

vtkNBufferDividedProp::~vtkNBufferDividedProp()
{
  this->Pending = {}; // A thread that is still building reads the mesh.
  if (this->Actor)
  {
    this->Hook->Detach(this->Actor);
  }
}

void vtkNBufferDividedProp::BeginFrame(bool changed, const Settings& settings)
{
  const bool isStale = this->State == Phase::Ready && (this->Hook->IsStale() || this->IsOutdated);
  if (changed && this->State == Phase::Ready && this->HasSameData())
  {
    this->ReadRounding();
  }
  else if (changed || isStale)
  {
    // A thread that is still building finishes first, which takes less than reading again.
    this->Pending = {};
    this->State = Phase::Waiting;
    this->StillFrames = 0;
    this->IsOutdated = false;
    this->Units = {};
    this->Mesh = {};
  }
  this->Hook->SetWindow(settings.Window);
  this->IsDrawn = this->FreshIsNext = this->Settled = false;
  if (this->State == Phase::Waiting && this->StillFrames++ >= settings.DivideAfter)
  {
    this->State = Phase::Reading;
    this->BlockTime =
      vtkNBufferPropWatch::GetDataTime(this->Actor->GetMapper()->GetInputDataObject(0, 0), true);
    this->Hook->ReadNext();
  }
  else if (this->State == Phase::Reading && this->Hook->GetSource().Mapper)
  {
    this->Build(settings);
  }
  if (this->State == Phase::Building &&
    this->Pending.wait_for(std::chrono::seconds(0)) != std::future_status::timeout)
  {
    this->Adopt();
  }
}

bool vtkNBufferDividedProp::IsInstanced() const
{
  return this->Hook->GetSource().InstanceTime > 0;
}

bool vtkNBufferDividedProp::HasBlocks() const
{
  return this->Hook->GetSource().Corners == 2 && !this->IsInstanced();
}

bool vtkNBufferDividedProp::HasChangedBlocks()
{
  this->IsOutdated = this->HasBlocks() &&
    vtkNBufferPropWatch::GetDataTime(this->Actor->GetMapper()->GetInputDataObject(0, 0), true) !=
      this->BlockTime;
  return this->IsOutdated;
}

bool vtkNBufferDividedProp::HasSameData() const
{
  const vtkNBufferDrawHook::Source& source = this->Hook->GetSource();
  vtkMapper* mapper = this->Actor->GetMapper();
  // Other mappers draw a polydata that they make themselves.
  const bool isOwn = static_cast<vtkObjectBase*>(mapper) == source.Mapper;
  vtkDataObject* data = isOwn ? mapper->GetInputDataObject(0, 0) : nullptr;
  return data && data == source.Data && data->GetMTime() == source.DataTime;
}

void vtkNBufferDividedProp::ReadRounding()
{
  if (this->IsInstanced())
  {
    this->Origin = glm::dvec3(0.0);
    this->Magnitude = this->Hook->GetInstances().GetMagnitude();
    this->Margin = 0.0;
    return;
  }
  const auto buffer = vtkNBufferSurface::GetBufferCoordinates(this->Actor->GetMapper());
  if (!buffer)
  {
    this->State = Phase::Refused;
    return;
  }
  this->Origin = buffer->Origin;
  this->Magnitude = buffer->HalfRange;
  this->Margin = vtkNBufferSurface::GetMargin(this->Actor);
}

void vtkNBufferDividedProp::Build(const Settings& settings)
{
  if (this->Hook->GetSource().Corners == 0)
  {
    this->State = Phase::Refused;
    return;
  }
  this->State = Phase::Building;
  this->Mesh = this->Hook->TakeMesh();
  std::size_t size = this->HasBlocks() ? 1 : settings.UnitSize;
  if (this->IsInstanced())
  {
    size = vtkNBufferInstanceStream::GetUnitSize(this->Hook->GetSource().IndexCount, size);
  }
  // The member is not touched until the units are there.
  this->Pending = std::async(settings.InBackground ? std::launch::async : std::launch::deferred,
    [this, size]() { return vtkNBufferUnits::Make(this->Mesh, size); });
}

void vtkNBufferDividedProp::Adopt()
{
  this->Units = this->Pending.get();
  this->Mesh.Points = {};
  this->State = this->Units.GetSize() == 0 ? Phase::Refused : Phase::Ready;
  if (this->State == Phase::Refused)
  {
    return;
  }
  this->ReadRounding();
  const std::size_t size = this->Units.GetSize();
  this->Marks.assign(size, 0);
  this->DrawnUnits.assign(size, 0);
  this->FreshUnits.assign(size, 0);
  this->Open.clear();
  for (const auto& level : this->Units.GetLevels())
  {
    this->Open.emplace_back(level.size());
  }
}

vtkNBufferVerdict vtkNBufferDividedProp::GetVerdict(int part)
{
  const std::size_t primitive = this->HasBlocks()
    ? this->Hook->GetBlocks().FindBlock(static_cast<unsigned int>(part))
    : static_cast<std::size_t>(part);
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

vtkNBufferBox vtkNBufferDividedProp::MakeBox(const vtkNBufferUnits::Box& bounds) const
{
  const double values[6] = { bounds.Low.x, bounds.High.x, bounds.Low.y, bounds.High.y, bounds.Low.z,
    bounds.High.z };
  vtkNBufferBox box = vtkNBufferBox::FromBounds(values);
  box.Origin = this->Origin;
  box.Magnitude = this->Magnitude;
  box.Margin = this->Margin;
  return box;
}

void vtkNBufferDividedProp::FindKept(const vtkNBufferProjection& projection)
{
  for (unsigned char& mark : this->Marks)
  {
    mark &= static_cast<unsigned char>(~Outside);
  }
  this->MarkOutside(this->Units.GetLevels().size() - 1, 0, projection);
  this->Number = {};
  this->Number.Units = static_cast<int>(this->Units.GetSize());
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    this->DrawnUnits[i] = this->Marks[i] == Visible;
    this->Number.Outside += (this->Marks[i] & Outside) != 0;
    this->Number.Kept += this->DrawnUnits[i];
  }
  const auto limit =
    static_cast<std::size_t>(this->Number.Units - this->Number.Outside) / NewViewShare + 1;
  if (static_cast<std::size_t>(this->Number.Kept) < limit)
  {
    this->KeepNearest(projection, limit);
  }
}

void vtkNBufferDividedProp::MarkOutside(
  std::size_t level, std::size_t n, const vtkNBufferProjection& projection)
{
  const vtkNBufferBox box = this->MakeBox(this->Units.GetLevels()[level][n]);
  vtkNBufferScreenBox screen;
  const vtkNBufferPlacement placement =
    projection.IsOutside(box) ? vtkNBufferPlacement::Outside : projection.Project(box, screen);
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

void vtkNBufferDividedProp::KeepNearest(const vtkNBufferProjection& projection, std::size_t limit)
{
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    vtkNBufferScreenBox screen;
    if (this->Marks[i] == 0)
    {
      const bool isInside = projection.Project(this->MakeBox(this->Units.GetLevels()[0][i]),
                              screen) == vtkNBufferPlacement::Inside;
      nearest.emplace_back(isInside ? screen.Nearest : 0.0, i);
    }
  }
  limit = std::min(limit, nearest.size());
  std::nth_element(
    nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(limit), nearest.end());
  for (std::size_t k = 0; k < limit; ++k)
  {
    this->Marks[nearest[k].second] = Visible;
    this->DrawnUnits[nearest[k].second] = 1;
    ++this->Number.Kept;
  }
}

void vtkNBufferDividedProp::FindOpen()
{
  for (std::size_t i = 0; i < this->Units.GetSize(); ++i)
  {
    this->Open[0][i] = !(this->Marks[i] & Outside);
  }
  for (std::size_t level = 1; level < this->Open.size(); ++level)
  {
    std::fill(this->Open[level].begin(), this->Open[level].end(), 0);
    for (std::size_t i = 0; i < this->Open[level - 1].size(); ++i)
    {
      this->Open[level][i / vtkNBufferUnits::Fanout] |= this->Open[level - 1][i];
    }
  }
}

int vtkNBufferDividedProp::Test(const vtkNBufferProjection& projection, const Depth& depth)
{
  if (!this->IsDrawn)
  {
    std::fill(this->DrawnUnits.begin(), this->DrawnUnits.end(), 0);
    this->Number.Kept = 0;
  }
  std::fill(this->FreshUnits.begin(), this->FreshUnits.end(), 0);
  this->Number.Fresh = 0;
  this->Turn = (this->Turn + 1) % Turns;
  this->FindOpen();
  Tests tests = { projection, vtkNBufferOcclusionTest(depth.Levels, depth.SampleDistance), {} };
  if (depth.Pixels)
  {
    tests.Pixels.emplace(projection, depth.Levels, depth.Pixels, depth.SampleDistance);
  }
  this->TestNode(this->Units.GetLevels().size() - 1, 0, tests);
  this->FreshIsNext = this->Number.Fresh > 0;
  this->Settled = this->IsDrawn;
  return this->Number.Fresh;
}

void vtkNBufferDividedProp::TestNode(std::size_t level, std::size_t n, Tests& tests)
{
  if (!this->Open[level][n])
  {
    return;
  }
  const vtkNBufferBox box = this->MakeBox(this->Units.GetLevels()[level][n]);
  vtkNBufferScreenBox screen;
  const bool isInside = tests.Projection.Project(box, screen) == vtkNBufferPlacement::Inside;
  bool isHidden = isInside && tests.Levels.IsHidden(screen);
  const bool isDue = n / vtkNBufferUnits::Fanout % Turns == this->Turn;
  if (level == 0 && isInside && !isHidden && tests.Pixels && (!this->DrawnUnits[n] || isDue))
  {
    isHidden = tests.Pixels->IsHidden(box, screen);
  }
  if (isHidden)
  {
    const std::size_t end = this->Units.GetEnd(level, n);
    for (std::size_t i = this->Units.GetBegin(level, n); i < end; ++i)
    {
      this->Marks[i] &= static_cast<unsigned char>(~Visible);
    }
    return;
  }
  if (level == 0)
  {
    this->Marks[n] |= Visible;
    this->FreshUnits[n] = !this->DrawnUnits[n];
    this->Number.Fresh += this->FreshUnits[n];
    return;
  }
  const std::size_t end =
    std::min((n + 1) * vtkNBufferUnits::Fanout, this->Units.GetLevels()[level - 1].size());
  for (std::size_t child = n * vtkNBufferUnits::Fanout; child < end; ++child)
  {
    this->TestNode(level - 1, child, tests);
  }
}

int vtkNBufferDividedProp::DrawList(vtkNBufferDrawHook::List list,
  const std::vector<unsigned char>& marked, const std::function<int()>& drawWhole)
{
  const auto count = std::count(marked.begin(), marked.end(), 1);
  if (count == 0)
  {
    return 0;
  }
  if (static_cast<std::size_t>(count) == marked.size())
  {
    return drawWhole();
  }
  this->Hook->SetList(list, this->Units, this->Mesh.Indices, marked);
  const vtkNBufferDrawHook::Draw draw(this->Hook, this->Actor, list);
  return drawWhole();
}

int vtkNBufferDividedProp::Draw(const std::function<int()>& drawWhole)
{
  if (this->State != Phase::Ready)
  {
    const vtkNBufferDrawHook::Draw draw(this->Hook, this->Actor, vtkNBufferDrawHook::Whole);
    return drawWhole();
  }
  this->IsDrawn = true;
  if (!std::exchange(this->FreshIsNext, false))
  {
    return this->DrawAgain(drawWhole);
  }
  this->Settled = true;
  const int drawn = this->TryFresh(drawWhole);
  std::transform(this->FreshUnits.begin(), this->FreshUnits.end(), this->DrawnUnits.begin(),
    this->DrawnUnits.begin(), std::bit_or<unsigned char>());
  return drawn;
}

int vtkNBufferDividedProp::TryFresh(const std::function<int()>& drawWhole)
{
  return this->DrawList(vtkNBufferDrawHook::Fresh, this->FreshUnits, drawWhole);
}

int vtkNBufferDividedProp::DrawAgain(const std::function<int()>& drawWhole)
{
  return this->DrawList(vtkNBufferDrawHook::Drawn, this->DrawnUnits, drawWhole);
}

bool vtkNBufferDividedProp::HasFewFresh() const
{
  return this->FreshIsNext &&
    std::count(this->DrawnUnits.begin(), this->DrawnUnits.end(), 1) > this->Number.Fresh;
}

bool vtkNBufferDividedProp::IsDrawnInPart() const
{
  return this->IsDrawn &&
    std::count(this->DrawnUnits.begin(), this->DrawnUnits.end(), 1) <
    this->Number.Units - this->Number.Outside;
}
VTK_ABI_NAMESPACE_END
