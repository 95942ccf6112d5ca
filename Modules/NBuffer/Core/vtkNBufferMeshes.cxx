// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferMeshes.h"

#include "vtkNBufferTriangles.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int FramesToKeep = 256;

vtkNBufferMesh MakeMesh(vtkPolyData* data)
{
  vtkNBufferMesh mesh;
  if (!data->GetPoints())
  {
    return mesh;
  }
  mesh.Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), glm::value_ptr(mesh.Points[i]));
  }
  const std::vector<unsigned int> indices = vtkNBufferTriangles::Get(data);
  mesh.Triangles.resize(indices.size() / 3);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    mesh.Triangles[i] = { indices[3 * i], indices[3 * i + 1], indices[3 * i + 2] };
  }
  return mesh;
}
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

void vtkNBufferMeshes::Add(vtkPolyData* data)
{
  // A polydata made at the address of a deleted one has a newer time.
  const vtkMTimeType time = data->GetMTime();
  Entry& entry = this->Entries[data];
  if (entry.Time != time)
  {
    entry.Time = time;
    entry.Mesh = MakeMesh(data);
  }
  entry.Frame = this->Frame;
  this->Found.push_back(&entry.Mesh);
}

const std::vector<const vtkNBufferMesh*>& vtkNBufferMeshes::Get(vtkActor* actor)
{
  this->Found.clear();
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  vtkDataObject* input = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
  if (auto* data = vtkPolyData::SafeDownCast(input))
  {
    this->Add(data);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      if (auto* block = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()))
      {
        this->Add(block);
      }
    }
  }
  return this->Found;
}
VTK_ABI_NAMESPACE_END
