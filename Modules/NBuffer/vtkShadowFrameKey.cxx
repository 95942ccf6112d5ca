// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowFrameKey.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferViewKey.h"

#include "vtkAlgorithm.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkTrivialProducer.h"

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkCompositePolyDataMapper.h"
#endif

#include <algorithm>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
using CompositeMapper = vtkCompositePolyDataMapper;
#endif

/// Of data and, if it is composite, of its parts.
vtkMTimeType GetDataTime(vtkDataObject* data)
{
  vtkMTimeType time = data ? data->GetMTime() : 0;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* part : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      time = std::max(time, GetDataTime(part));
    }
  }
  return time;
}

/// Of a mapper or texture, and of what it shows.
vtkMTimeType GetPipelineTime(vtkAlgorithm* algorithm)
{
  vtkAlgorithm* producer =
    algorithm->GetNumberOfInputConnections(0) > 0 ? algorithm->GetInputAlgorithm() : nullptr;
  // Without a pipeline there is nothing to update.
  if (producer && typeid(*producer) != typeid(vtkTrivialProducer))
  {
    producer->Update();
  }
  return std::max(algorithm->GetMTime(), GetDataTime(algorithm->GetInputDataObject(0, 0)));
}

/// The time of the last change of what an actor draws; 0 where times do not tell.
vtkMTimeType GetTime(vtkProp* prop)
{
  auto* actor = typeid(*prop) == typeid(vtkOpenGLActor) ? static_cast<vtkActor*>(prop) : nullptr;
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper ||
    (typeid(*mapper) != typeid(vtkOpenGLPolyDataMapper) && !CompositeMapper::SafeDownCast(mapper)))
  {
    return 0;
  }
  vtkMTimeType time = std::max(actor->GetMTime(), GetPipelineTime(mapper));
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return actor->GetTexture() ? std::max(time, GetPipelineTime(actor->GetTexture())) : time;
}
}

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
  this->Complete = true;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    this->Props.emplace_back(prop, GetTime(prop));
    this->Complete = this->Complete && this->Props.back().second > 0;
  }
}

bool vtkShadowFrameKey::operator==(const vtkShadowFrameKey& other) const
{
  return this->Complete && other.Complete && this->Renderer == other.Renderer &&
    this->ContextTime == other.ContextTime && this->SettingsTime == other.SettingsTime &&
    this->Viewport == other.Viewport && this->WorldToClip == other.WorldToClip &&
    this->Lights == other.Lights && this->Casters == other.Casters && this->Props == other.Props;
}
VTK_ABI_NAMESPACE_END
