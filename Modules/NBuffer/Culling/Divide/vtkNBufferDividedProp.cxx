// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDividedProp.h"

#include "vtkNBufferDrawPass.h"
#include "vtkNBufferPropWatch.h"
#include "vtkNBufferSplatStream.h"
#include "vtkNBufferSurface.h"
#include "vtkNBufferTuning.h"
#include "vtkNBufferVertexCoordinates.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
/// Drawing one prop takes about as long as drawing this many units.
static constexpr int UnitsPerProp = 16;

vtkNBufferDividedProp::vtkNBufferDividedProp(vtkActor* actor, vtkNBufferDrawPass* pass)
  : Actor(actor)
  , Pass(pass)
  , Hook(pass)
{
  this->Pass->Attach(actor);
}

vtkNBufferDividedProp::~vtkNBufferDividedProp()
{
  this->Pending = {}; // A thread that is still building reads the mesh.
  if (this->Actor)
  {
    this->Pass->Detach(this->Actor);
  }
}

void vtkNBufferDividedProp::Release()
{
  // A thread that is still building is awaited here. That takes less time than reading the mesh
  // again.
  this->Pending = {};
  this->State = Phase::Waiting;
  this->StillFrames = 0;
  this->IsOutdated = false;
  this->Culling.SetUnits({});
  this->Mesh = {};
}

void vtkNBufferDividedProp::BeginFrame(bool changed, vtkOpenGLRenderWindow* window,
  vtkNBufferUnitDevice* device, const vtkNBufferTuning& tuning)
{
  const bool isLost = this->Pass->AttachAgain(this->Actor);
  const bool isStale =
    isLost || (this->State == Phase::Ready && (this->Hook.IsStale() || this->IsOutdated));
  if (changed && !isLost && this->State == Phase::Ready && this->HasSameData())
  {
    this->ReadRounding();
  }
  else if (changed || isStale)
  {
    this->Release();
  }
  this->Hook.BeginFrame(window, device);
  this->MinimumNumberOfUnitsOnDevice =
    static_cast<std::size_t>(tuning.MinimumNumberOfUnitsOnDevice);
  this->IsDrawn = this->FreshIsNext = this->Settled = this->Postponed = this->TestedOnDevice =
    false;
  if (this->State == Phase::Waiting && this->StillFrames++ >= tuning.DivideAfter)
  {
    this->State = Phase::Reading;
    this->BlockTime =
      vtkNBufferPropWatch::GetDataTime(this->Actor->GetMapper()->GetInputDataObject(0, 0), true);
    this->Hook.ReadNext();
  }
  else if (this->State == Phase::Reading && this->Hook.GetSource().Mapper)
  {
    this->Build(tuning);
  }
  if (this->State == Phase::Building &&
    this->Pending.wait_for(std::chrono::seconds(0)) != std::future_status::timeout)
  {
    this->Adopt();
  }
}

bool vtkNBufferDividedProp::HasChangedBlocks()
{
  this->IsOutdated = this->Hook.GetSource().HasBlocks() &&
    vtkNBufferPropWatch::GetDataTime(this->Actor->GetMapper()->GetInputDataObject(0, 0), true) !=
      this->BlockTime;
  return this->IsOutdated;
}

bool vtkNBufferDividedProp::HasSameData() const
{
  const vtkNBufferDrawHook::Source& source = this->Hook.GetSource();
  vtkMapper* mapper = this->Actor->GetMapper();
  // Other mappers draw a polydata that they make themselves.
  const bool isOwn = static_cast<vtkObjectBase*>(mapper) == source.Mapper;
  vtkDataObject* data = isOwn ? mapper->GetInputDataObject(0, 0) : nullptr;
  return data && data == source.Data && data->GetMTime() == source.DataTime;
}

void vtkNBufferDividedProp::ReadRounding()
{
  if (this->Hook.GetSource().AreInstances)
  {
    this->Culling.SetRounding({ glm::dvec3(0.0), this->Hook.GetInstances().GetMagnitude(), 0.0 });
    return;
  }
  if (vtkNBufferSplatStream::MayBeDivided(this->Actor))
  {
    const double* bounds = vtkNBufferSplatStream::GetData(this->Actor)->GetPoints()->GetBounds();
    const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
    // A buffer that a mapper of the same points has made may be shifted. Its origin is not farther.
    this->Culling.SetRounding({ glm::dvec3(0.0), 2.0 * box.Magnitude,
      vtkNBufferSurface::GetMarginOfLines(this->Actor->GetProperty()) });
    return;
  }
  const auto buffer = vtkNBufferVertexCoordinates::Get(this->Actor->GetMapper());
  if (!buffer)
  {
    this->State = Phase::Refused;
    return;
  }
  this->Culling.SetRounding(
    { buffer->Origin, buffer->HalfRange, vtkNBufferSurface::GetMargin(this->Actor) });
}

void vtkNBufferDividedProp::Build(const vtkNBufferTuning& tuning)
{
  if (this->Hook.GetSource().Corners == 0)
  {
    this->State = Phase::Refused;
    return;
  }
  this->State = Phase::Building;
  this->Mesh = this->Hook.TakeMesh();
  const vtkNBufferDrawHook::Source& source = this->Hook.GetSource();
  const bool isSingle = source.HasBlocks() || source.AreInstances;
  const std::size_t size = isSingle ? 1 : static_cast<std::size_t>(tuning.UnitSize);
  // No other code uses the member Mesh until the units are made.
  const auto make = [this, size]() { return vtkNBufferUnits::Make(this->Mesh, size); };
  // If no thread can be started, the units are made when they are needed.
  this->Pending = std::async(
    tuning.DivideInBackground ? std::launch::async | std::launch::deferred : std::launch::deferred,
    make);
}

void vtkNBufferDividedProp::Adopt()
{
  vtkNBufferUnits units;
  try
  {
    units = this->Pending.get();
  }
  catch (const std::bad_alloc&)
  {
    // Without units the prop is drawn whole.
  }
  this->Culling.SetUnits(std::move(units));
  this->Mesh = {};
  this->State = this->Culling.GetUnits().GetSize() == 0 ? Phase::Refused : Phase::Ready;
  if (this->State == Phase::Ready)
  {
    this->ReadRounding();
  }
}

vtkNBufferVerdict vtkNBufferDividedProp::GetVerdict(int part)
{
  const vtkNBufferDrawHook::Source& source = this->Hook.GetSource();
  auto primitive = static_cast<std::size_t>(part);
  if (source.AreInstances)
  {
    primitive = this->Hook.GetInstances().FindInstance(primitive);
  }
  else if (source.HasBlocks())
  {
    primitive = this->Hook.GetBlocks().FindBlock(static_cast<unsigned int>(part));
  }
  return this->Culling.GetVerdict(primitive);
}

int vtkNBufferDividedProp::Test(
  const vtkNBufferProjection& projection, const Depth& depth, int limit)
{
  if (!this->IsDrawn)
  {
    this->Culling.ClearDrawn();
  }
  const int fresh = this->TestUnits(projection, depth);
  this->FreshIsNext = fresh > 0;
  this->Postponed =
    this->IsDrawn && fresh / UnitsPerProp > limit && this->Culling.PostponeFar(projection);
  this->Settled = this->IsDrawn && !this->Postponed;
  return fresh;
}

void vtkNBufferDividedProp::TestAll(const vtkNBufferProjection& projection, const Depth& depth)
{
  this->Culling.ClearDrawn();
  this->TestUnits(projection, depth);
  this->Culling.AddFreshToDrawn();
}

int vtkNBufferDividedProp::TestUnits(const vtkNBufferProjection& projection, const Depth& depth)
{
  this->TestedOnDevice = this->TestOnDevice(projection, depth);
  return this->Culling.Test(projection, depth, this->TestedOnDevice ? &this->Answers : nullptr);
}

bool vtkNBufferDividedProp::TestOnDevice(const vtkNBufferProjection& projection, const Depth& depth)
{
  const vtkNBufferUnits& units = this->Culling.GetUnits();
  vtkNBufferUnitDevice* device = this->Hook.GetDevice();
  const bool isWorthIt = device && device->IsRight() && device->CanTest(units.GetSize()) &&
    depth.GetTexture && units.GetSize() >= this->MinimumNumberOfUnitsOnDevice &&
    this->Culling.CountInDoubt(projection, depth) >= this->MinimumNumberOfUnitsOnDevice;
  const vtkNBufferTexture* texture = isWorthIt ? depth.GetTexture() : nullptr;
  if (!texture)
  {
    return false;
  }
  device->Test(units, this->Hook.GetBuffersOnDevice(), projection, this->Culling.MakeBox({}),
    texture, depth.Levels, depth.SampleDistance, this->Answers);
  if (!device->IsChecked())
  {
    device->SetChecked(this->Culling.AreRight(this->Answers, projection, depth));
  }
  return device->IsRight();
}

int vtkNBufferDividedProp::DrawList(vtkNBufferDrawHook::List list,
  const std::vector<unsigned char>& marked, const std::function<int()>& drawWhole)
{
  const auto count = std::count(marked.begin(), marked.end(), 1);
  if (static_cast<std::size_t>(count) == marked.size())
  {
    return drawWhole();
  }
  if (count == 0)
  {
    return 0;
  }
  this->Hook.SetList(list, this->Culling.GetUnits(), marked);
  const vtkNBufferDrawHook::Draw draw(&this->Hook, this->Actor, list);
  return drawWhole();
}

int vtkNBufferDividedProp::Draw(const std::function<int()>& drawWhole)
{
  if (this->State != Phase::Ready)
  {
    const vtkNBufferDrawHook::Draw draw(&this->Hook, this->Actor, vtkNBufferDrawHook::Whole);
    return drawWhole();
  }
  this->IsDrawn = true;
  if (!std::exchange(this->FreshIsNext, false))
  {
    return this->DrawAgain(drawWhole);
  }
  this->Settled = !this->Postponed;
  const int drawn = this->TryFresh(drawWhole);
  this->Culling.AddFreshToDrawn();
  return drawn;
}

void vtkNBufferDividedProp::SetPlace(
  const vtkNBufferUnits::Box& bounds, bool withRounding, vtkNBufferBox& box) const
{
  const glm::dmat4 toWorld = vtkNBufferGLM::ToMatrix(this->Actor->GetMatrix()->GetData());
  box.SetPlace(toWorld, glm::dvec3(bounds.Low), glm::dvec3(bounds.High));
  if (withRounding)
  {
    const vtkNBufferBox ofMesh = this->Culling.MakeBox(bounds);
    box.Margin = ofMesh.Margin;
    box.SetRounding(toWorld, ofMesh.Origin, ofMesh.Magnitude);
  }
}

int vtkNBufferDividedProp::TryFresh(const std::function<int()>& drawWhole)
{
  return this->DrawList(vtkNBufferDrawHook::Fresh, this->Culling.GetFresh(), drawWhole);
}

int vtkNBufferDividedProp::DrawAgain(const std::function<int()>& drawWhole)
{
  return this->DrawList(vtkNBufferDrawHook::Drawn, this->Culling.GetDrawn(), drawWhole);
}

void vtkNBufferDividedProp::AddTo(vtkNBufferStatistics& statistics) const
{
  const vtkNBufferUnitCulling::Counts& counts = this->Culling.GetCounts();
  statistics.Units += counts.Units;
  statistics.UnitsOutside += counts.Outside;
  statistics.UnitsKept += counts.Kept;
  statistics.UnitsFresh += counts.Fresh;
  statistics.UnitsOnDevice += this->TestedOnDevice ? counts.Units : 0;
}

bool vtkNBufferDividedProp::HasFewFresh() const
{
  return this->FreshIsNext && this->Culling.CountDrawn() > this->Culling.CountFresh();
}

bool vtkNBufferDividedProp::IsDrawnInPart() const
{
  const vtkNBufferUnitCulling::Counts& counts = this->Culling.GetCounts();
  return this->IsDrawn && this->Culling.CountDrawn() < counts.Units - counts.Outside;
}
VTK_ABI_NAMESPACE_END
