// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrameKey.h"

#include "vtkNBufferCullerTraits.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferStandIn.h"
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
/// Returns true if all props of `part`, except stand-ins, are in `whole`, in the same order.
bool IsPart(const std::vector<vtkProp*>& part, const std::vector<vtkProp*>& whole)
{
  auto next = whole.begin();
  return std::all_of(part.begin(), part.end(),
    [&](vtkProp* prop)
    {
      if ((next == whole.end() || *next != prop) && vtkNBufferStandIn::SafeDownCast(prop))
      {
        return true;
      }
      const auto found = std::find(next, whole.end(), prop);
      next = found == whole.end() ? found : found + 1;
      return found != whole.end();
    });
}

/// Returns true if at least one culler promises to remove only props that show in no pixel, and all
/// others are VTK's frustum cullers. `settingsTime` is raised to the time of the last change of the
/// cullers that were looked at.
bool CullersPreserveImage(vtkRenderer* renderer, vtkMTimeType& settingsTime)
{
  bool preserve = false;
  vtkCullerCollection* cullers = renderer->GetCullers();
  for (int i = 0; i < cullers->GetNumberOfItems(); ++i)
  {
    vtkObject* culler = cullers->GetItemAsObject(i);
    const auto* traits = dynamic_cast<const vtkNBufferCullerTraits*>(culler);
    if (traits && traits->PreservesImage())
    {
      preserve = true;
    }
    // The frustum culler decides by the camera, the props and its own settings, all of which are
    // part of the key.
    else if (typeid(*culler) != typeid(vtkFrustumCoverageCuller))
    {
      return false;
    }
    settingsTime = std::max(settingsTime, culler->GetMTime());
  }
  return preserve;
}
}

vtkShadowFrameKey::vtkShadowFrameKey(const vtkRenderState* state,
  const std::vector<vtkShadowLightSource>& lights, const vtkShadowCasterList& props,
  vtkMTimeType settingsTime)
  : Renderer(state->GetRenderer())
  , SettingsTime(settingsTime)
  , View(vtkNBufferViewKey::Make(state->GetRenderer()))
  , Lights(lights)
  , PropsVersion(props.GetVersion())
  , Drawn(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount())
{
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
    this->SettingsTime == other.SettingsTime && this->Viewport == other.Viewport &&
    this->Samples == other.Samples && this->View.HasSameView(other.View) &&
    this->Lights == other.Lights && this->PropsVersion == other.PropsVersion &&
    this->Drawn == other.Drawn;
}
VTK_ABI_NAMESPACE_END
