// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOwnDraw.h"

#include "vtkCommand.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferOwnDraw::SetNext(
  vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, const std::function<bool()>& draw)
{
  this->Restore();
  this->Mapper = mapper;
  this->Stream = stream;
  this->Function = draw;
  this->Observer =
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this, &vtkNBufferOwnDraw::Draw);
}

void vtkNBufferOwnDraw::Draw()
{
  if (this->IndexCount == 0 && this->Function())
  {
    this->IndexCount = std::exchange(this->Stream->IBO->IndexCount, 0);
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
}
VTK_ABI_NAMESPACE_END
