// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOffsetPass.h"

#include "vtkNBufferGL.h"

#include "vtkObjectFactory.h"

namespace NBufferPeers
{

vtkStandardNewMacro(PolygonOffsetPass);

void PolygonOffsetPass::Set(vtkRenderPass* delegate, double factor, double units)
{
  this->Delegate = delegate;
  this->Factor = factor;
  this->Units = units;
}

void PolygonOffsetPass::Render(const vtkRenderState* state)
{
  // VTK neither switches offsets of polygons on nor keeps this state in its cache.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(static_cast<float>(this->Factor), static_cast<float>(this->Units));
  this->Delegate->Render(state);
  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
}

void PolygonOffsetPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Delegate->ReleaseGraphicsResources(window);
}

} // namespace NBufferPeers
