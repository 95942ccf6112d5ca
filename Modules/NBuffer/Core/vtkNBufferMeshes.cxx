// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferMeshes.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int FramesToKeep = 256;

/// Whether a mapper may go on drawing the triangles into which it has divided polygons before their
/// points moved. Those of triangles and quadrilaterals do not depend on the points.
bool MayHaveOldTriangles(vtkPolyData* data)
{
  vtkPoints* points = data->GetPoints();
  return points && points->GetMTime() > data->GetPolys()->GetMTime() &&
    data->GetPolys()->GetMaxCellSize() > 4;
}
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

bool vtkNBufferMeshes::FindSmall(vtkProp* prop, OfProp& kept)
{
  kept.Frame = this->Frame;
  if (!kept.Small && !kept.IsTooLarge && this->CopiesLeft > 0)
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    auto* data = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
    kept.IsTooLarge = !data || data->GetNumberOfPolys() > MaximumNumberOfPolygons ||
      data->GetNumberOfStrips() > 0 || MayHaveOldTriangles(data);
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
