// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOwnDraw.h"

#include "vtkNBufferGL.h"

#include "vtkCommand.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkShaderProgram.h"

#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// VTK adds this uniform variable to the numbers of primitives. It is 0 for the first primitives
/// that a mapper draws, and those that are divided are the only ones.
const char* const Offset = "PrimitiveIDOffset";
}

void vtkNBufferOwnDraw::SetNext(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream,
  bool hasIndices, const std::function<bool()>& draw)
{
  this->Restore();
  this->Mapper = mapper;
  this->Stream = stream;
  this->HasIndices = hasIndices;
  this->Function = draw;
  // After the observers of the application, which may set uniforms.
  this->Observer = mapper->AddObserver(vtkCommand::UpdateShaderEvent, this,
    &vtkNBufferOwnDraw::Draw, std::numeric_limits<float>::lowest());
}

void vtkNBufferOwnDraw::Draw()
{
  if (this->IndexCount > 0 || !this->Function())
  {
    return;
  }
  this->IndexCount = std::exchange(this->Stream->IBO->IndexCount, 0);
  if (!this->HasIndices)
  {
    if (this->Nothing.GetName() == 0 && vtkNBufferGL::IsCountingSamples())
    {
      return; // No query can begin now. All of the splats are drawn.
    }
    if (this->Nothing.GetName() == 0)
    {
      glBeginQuery(GL_SAMPLES_PASSED, this->Nothing.Create());
      glEndQuery(GL_SAMPLES_PASSED);
    }
    glBeginConditionalRender(this->Nothing.GetName(), GL_QUERY_WAIT);
    this->IsDiscarding = true;
  }
}

void vtkNBufferOwnDraw::Restore()
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
  if (std::exchange(this->IsDiscarding, false))
  {
    glEndConditionalRender();
  }
}

bool vtkNBufferOwnDraw::NumbersPrimitives(vtkOpenGLHelper* stream)
{
  return stream->Program->IsUniformUsed(Offset);
}

bool vtkNBufferOwnDraw::DrawRanges(
  const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLHelper* stream)
{
  const bool arePoints = stream->PrimitiveType == vtkOpenGLPolyDataMapper::PrimitivePoints;
  const std::size_t corners = arePoints ? 1 : 3;
  stream->IBO->Bind();
  for (const vtkNBufferUnits::Range& range : ranges)
  {
    stream->Program->SetUniformi(Offset, static_cast<int>(range.Begin));
    glDrawElements(arePoints ? GL_POINTS : GL_TRIANGLES,
      static_cast<GLsizei>(corners * (range.End - range.Begin)), GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(corners * range.Begin * sizeof(unsigned int)));
  }
  stream->Program->SetUniformi(Offset, 0);
  stream->IBO->Release();
  return !ranges.empty();
}
VTK_ABI_NAMESPACE_END
