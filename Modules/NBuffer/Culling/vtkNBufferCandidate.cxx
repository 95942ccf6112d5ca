// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidate.h"

#include "vtkNBufferDrawOrder.h"
#include "vtkNBufferInstanceStream.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferScalars.h"
#include "vtkNBufferSurface.h"
#include "vtkNBufferVertexCoordinates.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// VTK writes the largest float or something near it where it means infinity.
constexpr double Infinite = 1e30;

bool HasUsableBounds(const double* bounds)
{
  return bounds && vtkMath::AreBoundsInitialized(bounds) &&
    std::all_of(bounds, bounds + 6, [](double value) { return std::abs(value) < Infinite; });
}

/// Whether a matrix leaves w as it is. VTK's bounds of what other ones project are not those of
/// what the device draws.
bool IsAffine(vtkMatrix4x4* matrix)
{
  const double* row = matrix->Element[3];
  return row[0] == 0.0 && row[1] == 0.0 && row[2] == 0.0 && row[3] == 1.0;
}
}

bool vtkNBufferCandidate::HasParts() const
{
  return this->Verdict == vtkNBufferVerdict::NotAPlainActor &&
    (this->DepthWriter || vtkActor2D::SafeDownCast(this->Prop));
}

bool vtkNBufferCandidate::ReadParts(std::vector<vtkNBufferSharedState::Uses>& uses) const
{
  bool isBlended = false;
  this->Prop->InitPathTraversal();
  while (vtkAssemblyPath* path = this->Prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    isBlended = isBlended || vtkNBufferDrawOrder::MattersTo(part);
    if (auto* actor = vtkActor::SafeDownCast(part))
    {
      uses.push_back(vtkNBufferSharedState::GetUses(actor));
    }
  }
  return isBlended;
}

bool vtkNBufferCandidate::Refresh(bool globalStateChanged)
{
  if (!globalStateChanged && !this->Watch.HasChanged())
  {
    return false;
  }
  const vtkNBufferVerdict verdictBefore = this->Verdict;
  vtkActor* actor = vtkNBufferKnownClasses::GetPlainActor(this->Prop);
  if (!actor)
  {
    // The prop may be a new one, at the address of a plain actor that has been deleted.
    this->Watch.Track(this->Prop);
    this->Verdict = vtkNBufferVerdict::NotAPlainActor;
    // A caption may have a leader in the world.
    this->DepthWriter = this->Prop->IsA("vtkCaptionActor2D") ||
      (!vtkActor2D::SafeDownCast(this->Prop) && !vtkVolume::SafeDownCast(this->Prop));
    this->Blended = this->Unlit = this->Offset = false;
    this->Class = &typeid(*this->Prop);
    this->Uses = {};
    return globalStateChanged || this->Verdict != verdictBefore;
  }
  const vtkMTimeType timeBefore = this->Watch.GetTime();
  const vtkMapper* mapperBefore = this->Watch.GetMapper();
  const vtkNBufferVerdict box = this->ReadBox(actor);
  vtkNBufferSharedState::MarkIfShadersStay(actor, this->Uses);
  this->Uses = vtkNBufferSharedState::GetUses(actor);
  this->HasInstances = vtkNBufferInstanceStream::MayBeDivided(actor, true);
  this->Verdict = this->HasInstances ? vtkNBufferVerdict::Translucent : this->Classify(actor, box);
  this->DepthWriter = actor->GetMapper() && actor->HasOpaqueGeometry();
  this->Blended = vtkNBufferDrawOrder::MattersTo(actor);
  this->Offset = vtkNBufferSurface::HasOffset(actor);
  this->Unlit = !actor->GetProperty()->GetLighting();
  // Composite data never counts as unchanged (IsTracked()). The times of its blocks, which would
  // have to be read in every frame, are therefore not needed.
  this->Watch.Track(actor, false);
  // An actor with levels of detail may change its mapper without a newer time.
  return globalStateChanged || this->Watch.GetTime() != timeBefore ||
    this->Watch.GetMapper() != mapperBefore || this->Verdict != verdictBefore;
}

vtkNBufferVerdict vtkNBufferCandidate::Classify(vtkActor* actor, vtkNBufferVerdict box) const
{
  if (vtkNBufferSurface::HasOtherCoordinates(actor))
  {
    return vtkNBufferVerdict::OtherCoordinates;
  }
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || !vtkNBufferSurface::IsPlain(mapper))
  {
    return vtkNBufferVerdict::NotAPlainMapper;
  }
  const bool linesOrPoints = this->Box.Margin > 0.0;
  if (!vtkNBufferSurface::DrawsAsSurface(actor->GetProperty(), linesOrPoints) ||
    (linesOrPoints && vtkNBufferSurface::DrawsLines(mapper)) ||
    vtkNBufferDrawOrder::DrawsSelection(mapper))
  {
    return vtkNBufferVerdict::NotASurface;
  }
  if (vtkNBufferSurface::HasReplacedShaders(actor))
  {
    return vtkNBufferVerdict::ShaderReplaced;
  }
  if (vtkNBufferSurface::HasOffsetTowardsEye(actor, linesOrPoints))
  {
    return vtkNBufferVerdict::DepthOffset;
  }
  if (box != vtkNBufferVerdict::Visible)
  {
    return box;
  }
  if (vtkNBufferScalars::ChangeTable(mapper))
  {
    return vtkNBufferVerdict::SharedMapper;
  }
  if (actor->HasTranslucentPolygonalGeometry() || !actor->HasOpaqueGeometry())
  {
    return vtkNBufferVerdict::Translucent;
  }
  return vtkNBufferVerdict::Visible;
}

void vtkNBufferCandidate::ReadBlocks(vtkActor* actor)
{
  if (!this->Blocks)
  {
    this->Blocks = std::make_unique<vtkNBufferBlocks>();
  }
  this->Blocks->Update(actor->GetMapper());
  const vtkBoundingBox& visible = this->Blocks->GetVisible();
  if (!vtkBoundingBox(actor->GetMapper()->GetBounds()).Contains(visible))
  {
    double b[6];
    visible.GetBounds(b);
    this->Box.SetPlace(vtkNBufferGLM::ToMatrix(actor->GetMatrix()->GetData()), { b[0], b[2], b[4] },
      { b[1], b[3], b[5] });
  }
}

vtkNBufferVerdict vtkNBufferCandidate::ReadBox(vtkActor* actor)
{
  // GetBounds() also brings the pipeline and the actor's matrix up to date.
  vtkMapper* mapper = actor->GetMapper();
  const double* bounds = mapper ? actor->GetBounds() : nullptr;
  this->Box = vtkNBufferBox();
  if (!HasUsableBounds(bounds) || !IsAffine(actor->GetMatrix()))
  {
    return vtkNBufferVerdict::NoBounds;
  }
  this->Box = vtkNBufferBox::FromBounds(bounds);
  if (vtkNBufferBlocks::AreNeeded(mapper))
  {
    this->ReadBlocks(actor);
  }
  else
  {
    this->Blocks.reset();
  }
  this->Box.Margin = vtkNBufferSurface::GetMargin(actor);
  const auto buffer =
    vtkNBufferVertexCoordinates::Get(mapper, this->Blocks ? &this->Blocks->GetAll() : nullptr);
  if (!buffer)
  {
    return vtkNBufferVerdict::NotAPlainMapper;
  }
  this->Box.SetRounding(
    vtkNBufferGLM::ToMatrix(actor->GetMatrix()->GetData()), buffer->Origin, buffer->HalfRange);
  // VTK leaves infinite points out of the bounds, but the device draws them.
  const bool isFinite =
    vtkNBufferGLM::IsFinite(this->Box.Origin) && vtkNBufferGLM::IsFinite(this->Box.Magnitude);
  return isFinite ? vtkNBufferVerdict::Visible : vtkNBufferVerdict::NoBounds;
}
VTK_ABI_NAMESPACE_END
