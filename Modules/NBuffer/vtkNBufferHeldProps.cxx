// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferHeldProps.h"

#include "vtkNBufferView.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferHeldProps);

namespace
{
/**
 * Lends the render passes of one prop's keys to another while it is drawn. The other's own
 * information object is used where it has one: SetPropertyKeys() marks a prop as modified.
 */
class ScopedRenderPasses
{
public:
  ScopedRenderPasses(vtkInformation* from, vtkProp* to)
  {
    vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
    if (!from || key->Length(from) == 0)
    {
      return;
    }
    this->Passes = from;
    if (!to->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      to->SetPropertyKeys(keys);
    }
    this->Keys = to->GetPropertyKeys();
    for (int i = 0; i < key->Length(from); ++i)
    {
      key->Append(this->Keys, key->Get(from, i));
    }
  }

  ~ScopedRenderPasses()
  {
    if (!this->Keys)
    {
      return;
    }
    vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
    for (int i = 0; i < key->Length(this->Passes); ++i)
    {
      key->Remove(this->Keys, key->Get(this->Passes, i));
    }
    if (key->Length(this->Keys) == 0)
    {
      this->Keys->Remove(key);
    }
  }

  ScopedRenderPasses(const ScopedRenderPasses&) = delete;
  void operator=(const ScopedRenderPasses&) = delete;

private:
  vtkInformation* Passes = nullptr;
  vtkInformation* Keys = nullptr;
};
}

void vtkNBufferHeldProps::SetBounds(const double bounds[6])
{
  std::copy(bounds, bounds + 6, this->Bounds);
}

int vtkNBufferHeldProps::Draw(vtkProp* prop, vtkRenderer* renderer, double time)
{
  const ScopedRenderPasses passes(this->GetPropertyKeys(), prop);
  prop->SetAllocatedRenderTime(time, renderer);
  return prop->RenderOpaqueGeometry(renderer);
}

bool vtkNBufferHeldProps::HasKeys(vtkInformation* requiredKeys)
{
  return !requiredKeys || (this->View && this->View->HasHeldPropWithKeys(requiredKeys));
}

int vtkNBufferHeldProps::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer ? this->View->DrawHeldProps(renderer, nullptr) : 0;
}

bool vtkNBufferHeldProps::RenderFilteredOpaqueGeometry(
  vtkViewport* viewport, vtkInformation* requiredKeys)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer && this->View->DrawHeldProps(renderer, requiredKeys) > 0;
}

void vtkNBufferHeldProps::RestoreEstimatedRenderTime()
{
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp([](vtkProp* prop) { prop->RestoreEstimatedRenderTime(); });
  }
}

double vtkNBufferHeldProps::GetEstimatedRenderTime()
{
  double time = 0.0;
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp(
      [&time](vtkProp* prop) { time += prop->GetEstimatedRenderTime(); });
  }
  return time;
}

double vtkNBufferHeldProps::GetEstimatedRenderTime(vtkViewport*)
{
  return this->GetEstimatedRenderTime();
}

void vtkNBufferHeldProps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
}
VTK_ABI_NAMESPACE_END
