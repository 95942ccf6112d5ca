// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBlocks.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
using vtkNBufferProtectedMembers::GetOwnTime;

/// The newest time of all points. GetMTime() would also look at cells and arrays.
static vtkMTimeType GetTimeOfPoints(vtkDataObject* data)
{
  vtkMTimeType time = data ? GetOwnTime(data) : 0;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    vtkNBufferForEachChild(tree,
      [&time](vtkDataObject* child)
      {
        time = std::max(time, GetTimeOfPoints(child));
        return true;
      });
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  vtkPoints* points = mesh ? mesh->GetPoints() : nullptr;
  return points ? std::max({ time, GetOwnTime(points), GetOwnTime(points->GetData()) }) : time;
}

void vtkNBufferBlocks::Update(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  const vtkDataObject* before = std::exchange(this->Data, data);
  const vtkMTimeType time = std::max(mapper->GetMTime(), GetTimeOfPoints(data));
  if (std::exchange(this->Time, time) == time && before == data)
  {
    return;
  }
  this->Visible = vtkNBufferSurface::GetBoundsOfPoints(mapper, true);
  this->All = vtkNBufferSurface::GetBoundsOfPoints(mapper, false);
}
VTK_ABI_NAMESPACE_END
