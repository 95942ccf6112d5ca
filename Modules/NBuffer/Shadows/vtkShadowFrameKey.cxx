// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrameKey.h"

#include "vtkNBufferCuller.h"
#include "vtkNBufferDeferredProxy.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferTranslucentProxy.h"
#include "vtkNBufferViewKey.h"
#include "vtkShadowCasterList.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What vtkNBufferCuller puts into the list in the place of the renderer's own props.
bool IsStandIn(vtkProp* prop)
{
  return typeid(*prop) == typeid(vtkNBufferDeferredProxy) ||
    typeid(*prop) == typeid(vtkNBufferTranslucentProxy);
}

/// Whether `part` is `whole` with some left out, in the same order, but for stand-ins.
bool IsPart(const std::vector<vtkProp*>& part, const std::vector<vtkProp*>& whole)
{
  auto next = whole.begin();
  for (vtkProp* prop : part)
  {
    if (IsStandIn(prop))
    {
      continue;
    }
    next = std::find(next, whole.end(), prop);
    if (next == whole.end())
    {
      return false;
    }
    ++next;
  }
  return true;
}

/// Whether what is left out of the list is hidden or outside: then it is all the same how much.
/// The frustum culler decides by camera, props and its own settings.
bool CullersPreserveImage(vtkRenderer* renderer, vtkMTimeType& settingsTime)
{
  bool keep = false;
  vtkCullerCollection* cullers = renderer->GetCullers();
  for (int i = 0; i < cullers->GetNumberOfItems(); ++i)
  {
    vtkObject* culler = cullers->GetItemAsObject(i);
    if (typeid(*culler) == typeid(vtkNBufferCuller))
    {
      keep = true;
    }
    else if (typeid(*culler) != typeid(vtkFrustumCoverageCuller))
    {
      return false;
    }
    settingsTime = std::max(settingsTime, culler->GetMTime());
  }
  return keep;
}
}

vtkShadowFrameKey::vtkShadowFrameKey(const vtkRenderState* state,
  const std::vector<vtkShadowLightSource>& lights, const vtkShadowCasterList& props,
  vtkMTimeType settingsTime)
  : Renderer(state->GetRenderer())
  , SettingsTime(settingsTime)
  , Lights(lights)
  , PropsVersion(props.GetVersion())
  , Drawn(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount())
{
  const vtkNBufferViewKey view = vtkNBufferViewKey::Make(state->GetRenderer());
  this->ContextTime = view.ContextTime;
  this->WorldToClip = view.WorldToClip;
  glGetIntegerv(GL_VIEWPORT, this->Viewport.data());
  glGetIntegerv(GL_SAMPLES, &this->Samples);
  this->Complete = IsPart(this->Drawn, props.GetProps());
  if (CullersPreserveImage(state->GetRenderer(), this->SettingsTime))
  {
    this->Drawn.clear();
  }
}

bool vtkShadowFrameKey::operator==(const vtkShadowFrameKey& other) const
{
  return this->Complete && other.Complete && this->Renderer == other.Renderer &&
    this->ContextTime == other.ContextTime && this->SettingsTime == other.SettingsTime &&
    this->Viewport == other.Viewport && this->Samples == other.Samples &&
    this->WorldToClip == other.WorldToClip && this->Lights == other.Lights &&
    this->PropsVersion == other.PropsVersion && this->Drawn == other.Drawn;
}
VTK_ABI_NAMESPACE_END
