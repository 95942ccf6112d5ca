// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGatedProp.h"

#include "vtkNBufferForwardedKeys.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferGatedProp);

void vtkNBufferGatedProp::SetProp(vtkProp* prop)
{
  this->Prop = prop;
  this->Open = true;
  this->Drawn = false;
}

int vtkNBufferGatedProp::RenderOpaqueGeometry(vtkViewport* viewport)
{
  const vtkNBufferForwardedKeys keys(this->GetPropertyKeys(), this->Prop);
  return this->Prop->RenderOpaqueGeometry(viewport);
}

int vtkNBufferGatedProp::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  if (!this->Open)
  {
    return 0;
  }
  this->Drawn = true;
  const vtkNBufferForwardedKeys keys(this->GetPropertyKeys(), this->Prop);
  return this->Prop->RenderTranslucentPolygonalGeometry(viewport);
}

void vtkNBufferGatedProp::SetAllocatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->SetAllocatedRenderTime(time, viewport);
}

void vtkNBufferGatedProp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Prop: " << this->Prop << "\n";
  os << indent << "Open: " << this->Open << "\n";
}
VTK_ABI_NAMESPACE_END
