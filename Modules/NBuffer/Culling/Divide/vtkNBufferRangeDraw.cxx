// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferRangeDraw.h"

#include "vtkNBufferGL.h"

#include "vtkCommand.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkShaderProgram.h"

#include <utility>

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

void vtkNBufferRangeDraw::DrawNext(const std::vector<vtkNBufferUnits::Range>& ranges,
  vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream)
{
  this->Restore();
  this->Mapper = mapper;
  this->Stream = stream;
  this->Ranges = &ranges;
  this->Observer =
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this, &vtkNBufferRangeDraw::Draw);
}

void vtkNBufferRangeDraw::Draw()
{
  if (this->IndexCount > 0 || this->Ranges->empty())
  {
    return; // VTK draws everything, or these ranges have been drawn.
  }
  const bool isPoints = this->Stream->PrimitiveType == vtkOpenGLPolyDataMapper::PrimitivePoints;
  const std::size_t corners = isPoints ? 1 : 3;
  this->Stream->IBO->Bind();
  for (const vtkNBufferUnits::Range& range : *this->Ranges)
  {
    this->Stream->Program->SetUniformi(Offset, static_cast<int>(range.Begin));
    glDrawElements(isPoints ? GL_POINTS : GL_TRIANGLES,
      static_cast<GLsizei>(corners * (range.End - range.Begin)), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(corners * range.Begin * sizeof(unsigned int)));
  }
  this->Stream->Program->SetUniformi(Offset, 0);
  this->Stream->IBO->Release();
  this->IndexCount = std::exchange(this->Stream->IBO->IndexCount, 0);
}

void vtkNBufferRangeDraw::Restore()
{
  if (this->Mapper)
  {
    this->Mapper->RemoveObserver(this->Observer);
    if (this->IndexCount > 0)
    {
      this->Stream->IBO->IndexCount = std::exchange(this->IndexCount, 0);
    }
    this->Mapper = nullptr;
    this->Stream = nullptr;
  }
}
VTK_ABI_NAMESPACE_END
