// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDeferredProxy.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferDeferredProxy);

int vtkNBufferDeferredProxy::Draw(vtkProp* prop, const std::function<int()>& draw)
{
  const ForwardedKeys keys(this, prop);
  return draw();
}

bool vtkNBufferDeferredProxy::HasKeys(vtkInformation* requiredKeys)
{
  return !requiredKeys || (this->TheOwner && this->TheOwner->HasHeldPropWithKeys(requiredKeys));
}

int vtkNBufferDeferredProxy::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->TheOwner && renderer ? this->TheOwner->DrawHeldProps(renderer, nullptr) : 0;
}

bool vtkNBufferDeferredProxy::RenderFilteredOpaqueGeometry(
  vtkViewport* viewport, vtkInformation* requiredKeys)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->TheOwner && renderer && this->TheOwner->DrawHeldProps(renderer, requiredKeys) > 0;
}
VTK_ABI_NAMESPACE_END
