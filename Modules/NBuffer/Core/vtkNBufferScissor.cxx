// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferScissor.h"

#include "vtkNBufferGL.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
ScopedScissor::ScopedScissor()
  : Enabled(glIsEnabled(GL_SCISSOR_TEST))
{
  int box[4];
  glGetIntegerv(GL_VIEWPORT, box);
  this->Viewport = { box[0], box[1], box[0] + box[2], box[1] + box[3] };
  glGetIntegerv(GL_SCISSOR_BOX, this->Box);
  this->Outer = this->Viewport;
  if (this->Enabled)
  {
    this->Outer = this->Viewport.GetIntersection(
      { this->Box[0], this->Box[1], this->Box[0] + this->Box[2], this->Box[1] + this->Box[3] });
  }
  glEnable(GL_SCISSOR_TEST);
}

ScopedScissor::~ScopedScissor()
{
  glScissor(this->Box[0], this->Box[1], this->Box[2], this->Box[3]);
  if (!this->Enabled)
  {
    glDisable(GL_SCISSOR_TEST);
  }
}

void ScopedScissor::Set(const vtkNBufferRectangle& pixels) const
{
  const vtkNBufferRectangle box = this->Outer.GetIntersection({ this->Viewport.X0 + pixels.X0,
    this->Viewport.Y0 + pixels.Y0, this->Viewport.X0 + pixels.X1, this->Viewport.Y0 + pixels.Y1 });
  glScissor(box.X0, box.Y0, std::max(box.GetWidth(), 0), std::max(box.GetHeight(), 0));
}
}
VTK_ABI_NAMESPACE_END
