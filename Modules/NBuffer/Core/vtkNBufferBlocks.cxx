// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBlocks.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferForEachProp.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
using vtkNBufferProtectedMembers::GetOwnTime;

/// The newest time of all points. GetMTime() would also look at cells and arrays.
static vtkMTimeType GetTimeOfPoints(vtkDataObject* data)
{
  vtkMTimeType time = 0;
  vtkNBufferAnyNode(data,
    [&time](vtkDataObject* node)
    {
      time = std::max(time, GetOwnTime(node));
      auto* mesh = vtkPointSet::SafeDownCast(node);
      if (vtkPoints* points = mesh ? mesh->GetPoints() : nullptr)
      {
        time = std::max({ time, GetOwnTime(points), GetOwnTime(points->GetData()) });
      }
      return false;
    });
  return time;
}

/// The bounds of all points of data, and of its blocks, computed from their coordinates.
static vtkBoundingBox GetBoundsOfValues(vtkDataObject* data)
{
  vtkBoundingBox box;
  vtkNBufferAnyNode(data,
    [&box](vtkDataObject* node)
    {
      auto* mesh = vtkPointSet::SafeDownCast(node);
      vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
      if (points && points->GetNumberOfPoints() > 0)
      {
        double bounds[6];
        vtkBoundingBox::ComputeBounds(points, bounds);
        box.AddBounds(bounds);
      }
      return false;
    });
  return box;
}

bool vtkNBufferBlocks::AreNeeded(vtkMapper* mapper)
{
  if (vtkNBufferSurface::IsComposite(mapper))
  {
    return true;
  }
  auto* extracts = vtkDataSetMapper::SafeDownCast(mapper);
  auto* grid = extracts && !vtkPolyData::SafeDownCast(extracts->GetInput())
    ? vtkPointSet::SafeDownCast(extracts->GetInput())
    : nullptr;
  vtkPolyDataMapper* draws = grid ? extracts->GetPolyDataMapper() : nullptr;
  vtkPolyData* surface = draws ? draws->GetInput() : nullptr;
  return grid && !(surface && surface->GetPoints() == grid->GetPoints());
}

void vtkNBufferBlocks::Update(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  const vtkDataObject* before = std::exchange(this->Data, data);
  const vtkMTimeType dataTime = GetTimeOfPoints(data);
  const vtkMTimeType time = std::max(mapper->GetMTime(), dataTime);
  if (std::exchange(this->Time, time) == time && before == data)
  {
    return;
  }
  if (std::exchange(this->DataTime, dataTime) != dataTime || before != data)
  {
    vtkNBufferForEachProp::RunInOneThread([&]() { this->OfValues = GetBoundsOfValues(data); });
  }
  this->Visible = vtkNBufferSurface::GetBoundsOfPoints(mapper, true);
  this->All = vtkNBufferSurface::GetBoundsOfPoints(mapper, false);
  if (this->OfValues.IsValid() && !this->All.Contains(this->OfValues))
  {
    this->Visible.AddBox(this->OfValues);
    this->All.AddBox(this->OfValues);
  }
}
VTK_ABI_NAMESPACE_END
