// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOwnDraw.h"

#include "vtkNBufferGL.h"

#include "vtkCommand.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferOwnDraw::SetNext(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream,
  bool hasIndices, const std::function<bool()>& draw)
{
  this->Restore();
  this->Mapper = mapper;
  this->Stream = stream;
  this->HasIndices = hasIndices;
  this->Function = draw;
  this->Observer =
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this, &vtkNBufferOwnDraw::Draw);
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
    if (this->Nothing == 0)
    {
      glGenQueries(1, &this->Nothing);
      glBeginQuery(GL_SAMPLES_PASSED, this->Nothing);
      glEndQuery(GL_SAMPLES_PASSED);
    }
    glBeginConditionalRender(this->Nothing, GL_QUERY_WAIT);
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

void vtkNBufferOwnDraw::ReleaseGraphicsResources()
{
  if (this->Nothing != 0)
  {
    glDeleteQueries(1, &this->Nothing);
    this->Nothing = 0;
  }
}
VTK_ABI_NAMESPACE_END
