// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawStage.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

namespace NBufferPeers
{

vtkStandardNewMacro(DrawStage);

int DrawStage::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return renderer && this->Function ? this->Function(renderer) : 0;
}

} // namespace NBufferPeers
