// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferRangeDraw.h"

#include "vtkNBufferGL.h"

#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// VTK adds this uniform variable to the numbers of primitives. It is 0 for the first primitives
/// that a mapper draws, and those that are divided are the only ones.
const char* const Offset = "PrimitiveIDOffset";
}

bool vtkNBufferRangeDraw::IsNeeded(vtkOpenGLHelper* stream)
{
  return stream->Program->IsUniformUsed(Offset);
}

bool vtkNBufferRangeDraw::Draw(
  const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLHelper* stream)
{
  const bool isPoints = stream->PrimitiveType == vtkOpenGLPolyDataMapper::PrimitivePoints;
  const std::size_t corners = isPoints ? 1 : 3;
  stream->IBO->Bind();
  for (const vtkNBufferUnits::Range& range : ranges)
  {
    stream->Program->SetUniformi(Offset, static_cast<int>(range.Begin));
    glDrawElements(isPoints ? GL_POINTS : GL_TRIANGLES,
      static_cast<GLsizei>(corners * (range.End - range.Begin)), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(corners * range.Begin * sizeof(unsigned int)));
  }
  stream->Program->SetUniformi(Offset, 0);
  stream->IBO->Release();
  return !ranges.empty();
}
VTK_ABI_NAMESPACE_END
