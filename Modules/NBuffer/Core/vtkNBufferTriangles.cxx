// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTriangles.h"

#include "vtkCellArray.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferTriangles
{
std::vector<unsigned int> Get(vtkPolyData* mesh)
{
  std::vector<unsigned int> indices;
  if (mesh->GetNumberOfPoints() == 0)
  {
    return indices;
  }
  if (mesh->GetNumberOfPolys() > 0)
  {
    vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
      indices, mesh->GetPolys(), mesh->GetPoints(), 0, nullptr, nullptr);
  }
  if (mesh->GetNumberOfStrips() > 0)
  {
    vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(indices, mesh->GetStrips(), 0, false);
  }
  return indices;
}
}
VTK_ABI_NAMESPACE_END
