// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshParts.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStaticPointLocator.h"

#include <numeric>

namespace NBufferExamples
{
namespace
{
/// Sets of points that grow together.
class PointSets
{
public:
  explicit PointSets(vtkPolyData* mesh)
    : Parents(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
  {
    // Points in one place begin as one set.
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(mesh);
    locator->BuildLocator();
    locator->MergePoints(0.0, this->Parents.data());
  }

  vtkIdType Find(vtkIdType point)
  {
    while (this->Get(point) != point)
    {
      this->Get(point) = this->Get(this->Get(point));
      point = this->Get(point);
    }
    return point;
  }

  void Join(vtkIdType a, vtkIdType b) { this->Get(this->Find(a)) = this->Find(b); }

private:
  vtkIdType& Get(vtkIdType point) { return this->Parents[static_cast<std::size_t>(point)]; }

  std::vector<vtkIdType> Parents;
};
}

std::vector<vtkSmartPointer<vtkPolyData>> SplitMesh(
  vtkPolyData* mesh, const std::vector<int>& numbers, int parts)
{
  std::vector<std::vector<vtkIdType>> cells(static_cast<std::size_t>(parts));
  for (std::size_t cell = 0; cell < numbers.size(); ++cell)
  {
    if (numbers[cell] >= 0)
    {
      cells[static_cast<std::size_t>(numbers[cell])].push_back(static_cast<vtkIdType>(cell));
    }
  }
  std::vector<vtkSmartPointer<vtkPolyData>> result;
  // The place of each point in the part that is being made; -1 for points that it does not have.
  std::vector<vtkIdType> places(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1);
  vtkNew<vtkIdList> used;
  vtkNew<vtkIdList> corners;
  for (const std::vector<vtkIdType>& own : cells)
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    part->AllocateEstimate(static_cast<vtkIdType>(own.size()), 3);
    used->Reset();
    for (const vtkIdType cell : own)
    {
      mesh->GetCellPoints(cell, corners);
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      {
        const vtkIdType point = corners->GetId(i);
        vtkIdType& place = places[static_cast<std::size_t>(point)];
        if (place < 0)
        {
          place = points->InsertNextPoint(mesh->GetPoint(point));
          used->InsertNextId(point);
        }
        corners->SetId(i, place);
      }
      part->InsertNextCell(mesh->GetCellType(cell), corners);
    }
    part->SetPoints(points);
    part->GetPointData()->CopyAllocate(mesh->GetPointData(), used->GetNumberOfIds());
    for (vtkIdType i = 0; i < used->GetNumberOfIds(); ++i)
    {
      part->GetPointData()->CopyData(mesh->GetPointData(), used->GetId(i), i);
      places[static_cast<std::size_t>(used->GetId(i))] = -1;
    }
    part->Squeeze();
    result.push_back(part);
  }
  return result;
}

std::vector<int> FindRegions(vtkPolyData* mesh, int& count)
{
  count = 0;
  const vtkIdType cells = mesh->GetNumberOfCells();
  std::vector<int> regions(static_cast<std::size_t>(cells), -1);
  if (cells == 0 || mesh->GetNumberOfPoints() == 0)
  {
    return regions;
  }
  PointSets sets(mesh);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType i = 1; i < corners->GetNumberOfIds(); ++i)
    {
      sets.Join(corners->GetId(0), corners->GetId(i));
    }
  }
  std::vector<int> numbers(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() > 0)
    {
      int& number = numbers[static_cast<std::size_t>(sets.Find(corners->GetId(0)))];
      number = number < 0 ? count++ : number;
      regions[static_cast<std::size_t>(cell)] = number;
    }
  }
  return regions;
}

} // namespace NBufferExamples
