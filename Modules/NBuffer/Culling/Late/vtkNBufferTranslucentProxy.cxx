// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTranslucentProxy.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferTranslucentProxy);

vtkNBufferTranslucentProxy* vtkNBufferTranslucentProxy::Pool::Add(
  int place, vtkProp* prop, bool open, Drawer drawer)
{
  if (this->Count == this->Proxies.size())
  {
    this->Proxies.push_back(vtkSmartPointer<vtkNBufferTranslucentProxy>::New());
  }
  vtkNBufferTranslucentProxy* proxy = this->Proxies[this->Count++];
  proxy->Place = place;
  proxy->Prop = prop;
  proxy->DrawProp = std::move(drawer);
  proxy->Open = open;
  proxy->Drawn = false;
  return proxy;
}

vtkNBufferTranslucentProxy* vtkNBufferTranslucentProxy::Pool::Get(int place) const
{
  const auto end = this->Proxies.begin() + static_cast<std::ptrdiff_t>(this->Count);
  const auto found = std::lower_bound(this->Proxies.begin(), end, place,
    [](const auto& proxy, int wanted) { return proxy->Place < wanted; });
  return found != end && (*found)->Place == place ? found->Get() : nullptr;
}

int vtkNBufferTranslucentProxy::RenderOpaqueGeometry(vtkViewport* viewport)
{
  const ForwardedKeys keys(this, this->Prop);
  return this->Prop->RenderOpaqueGeometry(viewport);
}

int vtkNBufferTranslucentProxy::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  if (!this->Open)
  {
    return 0;
  }
  this->Drawn = true;
  const ForwardedKeys keys(this, this->Prop);
  return this->DrawProp(
    [this, viewport]() { return this->Prop->RenderTranslucentPolygonalGeometry(viewport); });
}

void vtkNBufferTranslucentProxy::SetAllocatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->SetAllocatedRenderTime(time, viewport);
}

void vtkNBufferTranslucentProxy::AddEstimatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->AddEstimatedRenderTime(time, viewport);
}

void vtkNBufferTranslucentProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Prop: " << this->Prop << "\n";
  os << indent << "Open: " << this->Open << "\n";
}
VTK_ABI_NAMESPACE_END
