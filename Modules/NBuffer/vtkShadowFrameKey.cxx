// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrameKey.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferViewKey.h"

#include "vtkOpenGLActor.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
vtkShadowFrameKey::vtkShadowFrameKey(const vtkRenderState* state,
  const std::vector<vtkShadowLightSource>& lights, const std::vector<vtkShadowCaster*>& casters,
  vtkMTimeType settingsTime)
  : Renderer(state->GetRenderer())
  , SettingsTime(settingsTime)
  , Lights(lights)
  , Casters(casters)
{
  const vtkNBufferViewKey view = vtkNBufferViewKey::Make(state->GetRenderer());
  this->ContextTime = view.ContextTime;
  this->WorldToClip = view.WorldToClip;
  glGetIntegerv(GL_VIEWPORT, this->Viewport.data());
}

void vtkShadowFrameKey::AddProps(const vtkRenderState* state)
{
  this->Complete = true;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    this->Complete = this->Complete && typeid(*prop) == typeid(vtkOpenGLActor);
    this->Props.emplace_back(prop, prop->GetRedrawMTime());
  }
}

bool vtkShadowFrameKey::HasSameView(const vtkShadowFrameKey& other) const
{
  return this->Renderer == other.Renderer && this->ContextTime == other.ContextTime &&
    this->SettingsTime == other.SettingsTime && this->Viewport == other.Viewport &&
    this->WorldToClip == other.WorldToClip && this->Lights == other.Lights &&
    this->Casters == other.Casters;
}

bool vtkShadowFrameKey::operator==(const vtkShadowFrameKey& other) const
{
  return this->Complete && other.Complete && this->HasSameView(other) && this->Props == other.Props;
}
VTK_ABI_NAMESPACE_END
