// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferMeshes.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"

#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int FramesToKeep = 256;
}

void vtkNBufferMeshes::BeginFrame(std::vector<OfProp>& kept)
{
  this->CopiesLeft = CopiesPerFrame;
  if (++this->Frame % FramesToKeep != 0)
  {
    return;
  }
  for (OfProp& one : kept)
  {
    if (this->Frame - one.Frame > FramesToKeep)
    {
      one = {};
    }
  }
  this->ReleaseUnused();
}

void vtkNBufferMeshes::ReleaseUnused()
{
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    entry = entry->second.Mesh.expired() ? this->Entries.erase(entry) : std::next(entry);
  }
}

const std::vector<vtkNBufferMeshes::Placed>& vtkNBufferMeshes::Get(
  vtkProp* prop, vtkIdType limit, OfProp& kept)
{
  kept.Frame = this->Frame;
  if (kept.Limit == limit)
  {
    return kept.Meshes;
  }
  kept.Meshes.clear();
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  std::vector<vtkNBufferSurface::Part> parts;
  if (!actor || !vtkNBufferSurface::GetPartsAtHand(actor, actor->GetMatrix(), parts))
  {
    parts.clear();
  }
  vtkIdType count = 0;
  for (const vtkNBufferSurface::Part& part : parts)
  {
    count += part.Mesh->GetNumberOfPolys() + part.Mesh->GetNumberOfStrips();
  }
  if (count < limit)
  {
    for (const vtkNBufferSurface::Part& part : parts)
    {
      kept.Meshes.push_back({ this->Update(part.Mesh), part.ToWorld });
    }
  }
  // Blocks of composite data may change without a newer time of the data.
  kept.Limit = actor && vtkNBufferSurface::IsComposite(actor->GetMapper()) ? -1 : limit;
  return kept.Meshes;
}

bool vtkNBufferMeshes::FindSmall(vtkProp* prop, bool mayCopy, OfProp& kept)
{
  kept.Frame = this->Frame;
  if (!kept.Small && !kept.IsTooLarge && mayCopy && this->CopiesLeft > 0)
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    auto* data = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
    kept.IsTooLarge =
      !data || data->GetNumberOfPolys() > MaximumNumberOfPolygons || data->GetNumberOfStrips() > 0;
    if (!kept.IsTooLarge)
    {
      --this->CopiesLeft;
      kept.Small = this->Update(data);
    }
  }
  return kept.Small != nullptr;
}

std::shared_ptr<const vtkNBufferMesh> vtkNBufferMeshes::Update(vtkPolyData* data)
{
  // A polydata at the address of a deleted one is not mistaken for it: its time is newer.
  Entry& entry = this->Entries[data];
  const vtkMTimeType time = data->GetMTime();
  std::shared_ptr<const vtkNBufferMesh> mesh = entry.Mesh.lock();
  if (!mesh || entry.Time != time)
  {
    mesh = std::make_shared<vtkNBufferMesh>(vtkNBufferSurface::GetMesh(data));
    entry.Time = time;
    entry.Mesh = mesh;
  }
  return mesh;
}
VTK_ABI_NAMESPACE_END
