// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSplatStream.h"

#include "vtkNBufferDrawOrder.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cstring>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
vtkOpenGLPolyDataMapper* vtkNBufferSplatStream::GetHelper(vtkAbstractMapper* mapper)
{
  // The class is private before VTK 9.4. Subclasses may draw anything.
  return std::strcmp(mapper->GetClassName(), "vtkOpenGLPointGaussianMapperHelper") == 0
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : nullptr;
}

bool vtkNBufferSplatStream::DrawsSplats(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  // Subclasses of the class that the object factory makes may draw anything.
  if (!mapper || std::strcmp(mapper->GetClassName(), "vtkOpenGLPointGaussianMapper") != 0)
  {
    return false;
  }
  vtkPolyData* data = mapper->GetNumberOfInputConnections(0) == 1 ? GetData(actor) : nullptr;
  return data && data->GetPoints();
}

bool vtkNBufferSplatStream::MayBeDivided(vtkActor* actor)
{
  if (!DrawsSplats(actor))
  {
    return false;
  }
  auto* mapper = static_cast<vtkPointGaussianMapper*>(actor->GetMapper());
  return mapper->GetScaleFactor() == 0.0 && !vtkNBufferDrawOrder::MattersTo(actor) &&
    !vtkNBufferSurface::HasOtherCoordinates(actor) &&
    !vtkNBufferSurface::HasOffsetTowardsEye(actor, true) &&
    vtkNBufferSurface::DrawsAsSurface(actor->GetProperty(), true) &&
    !vtkNBufferSurface::HasReplacedShaders(actor) && !actor->HasTranslucentPolygonalGeometry() &&
    actor->HasOpaqueGeometry();
}

vtkPolyData* vtkNBufferSplatStream::GetData(vtkActor* actor)
{
  return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
}

bool vtkNBufferSplatStream::DrawsArrays(vtkOpenGLHelper* stream)
{
  return stream->PrimitiveType != vtkOpenGLPolyDataMapper::PrimitivePoints;
}

void vtkNBufferSplatStream::ReadVertices(vtkPolyData* data, vtkNBufferUnits::Mesh& mesh)
{
  const auto add = [&mesh, data](vtkIdType id)
  {
    glm::dvec3 point;
    data->GetPoint(id, glm::value_ptr(point));
    mesh.Points.push_back(point);
  };
  if (vtkCellArray* cells = data->GetVerts(); cells->GetNumberOfCells() > 0)
  {
    const vtkIdType* ids = nullptr;
    vtkIdType size = 0;
    for (cells->InitTraversal(); cells->GetNextCell(size, ids);)
    {
      std::for_each(ids, ids + size, add);
    }
  }
  else
  {
    for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
    {
      add(id);
    }
  }
  std::iota(mesh.Indices.begin(), mesh.Indices.end(), 0U);
}
VTK_ABI_NAMESPACE_END
