// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferScissor.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
ScopedScissor::ScopedScissor()
{
  const auto getBox = [](GLenum name)
  {
    int box[4];
    glGetIntegerv(name, box);
    return vtkNBufferRectangle{ box[0], box[1], box[0] + box[2], box[1] + box[3] };
  };
  const vtkNBufferRectangle before = getBox(GL_SCISSOR_BOX);
  this->AtEnd([before] { glScissor(before.X0, before.Y0, before.GetWidth(), before.GetHeight()); });
  this->Viewport = this->Outer = getBox(GL_VIEWPORT);
  if (glIsEnabled(GL_SCISSOR_TEST))
  {
    this->Outer = this->Viewport.GetIntersection(before);
    return;
  }
  this->AtEnd([] { glDisable(GL_SCISSOR_TEST); });
  glEnable(GL_SCISSOR_TEST);
}

void ScopedScissor::Set(const vtkNBufferRectangle& pixels) const
{
  const vtkNBufferRectangle box = this->Outer.GetIntersection({ this->Viewport.X0 + pixels.X0,
    this->Viewport.Y0 + pixels.Y0, this->Viewport.X0 + pixels.X1, this->Viewport.Y0 + pixels.Y1 });
  glScissor(box.X0, box.Y0, std::max(box.GetWidth(), 0), std::max(box.GetHeight(), 0));
}
}
VTK_ABI_NAMESPACE_END
