// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferMeshes.h"

#include "vtkActor.h"
#include "vtkPolyData.h"

#include <iterator>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int FramesToKeep = 256;
}

void vtkNBufferMeshes::BeginFrame()
{
  if (++this->Frame % FramesToKeep != 0)
  {
    return;
  }
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    entry = this->Frame - entry->second.Frame > FramesToKeep ? this->Entries.erase(entry)
                                                             : std::next(entry);
  }
}

std::vector<vtkNBufferMeshes::Placed> vtkNBufferMeshes::Get(vtkActor* actor)
{
  std::vector<Placed> result;
  std::vector<vtkNBufferSurface::Part> parts;
  if (!actor || !vtkNBufferSurface::GetPartsAtHand(actor, actor->GetMatrix(), parts))
  {
    return result;
  }
  for (const vtkNBufferSurface::Part& part : parts)
  {
    // A polydata made at the address of a deleted one has a newer time.
    const vtkMTimeType time = part.Mesh->GetMTime();
    Entry& entry = this->Entries[part.Mesh];
    if (entry.Time != time)
    {
      entry.Time = time;
      entry.Mesh = vtkNBufferSurface::GetMesh(part.Mesh);
    }
    entry.Frame = this->Frame;
    result.push_back({ &entry.Mesh, part.ToWorld });
  }
  return result;
}
VTK_ABI_NAMESPACE_END
