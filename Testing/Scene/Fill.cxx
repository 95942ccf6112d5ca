// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fill.h"

#include "LightRig.h"
#include "SceneProps.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <map>

namespace TestScene
{
bool ShareMapper(vtkProp* prop, vtkProp* other)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* owner = vtkActor::SafeDownCast(other);
  if (actor && owner)
  {
    actor->SetMapper(owner->GetMapper());
  }
  return actor && owner;
}

bool SetPart(vtkProp* whole, vtkProp* prop, bool present)
{
  auto* assembly = vtkAssembly::SafeDownCast(whole);
  auto* part = vtkProp3D::SafeDownCast(prop);
  if (assembly && part)
  {
    present ? assembly->AddPart(part) : assembly->RemovePart(part);
  }
  return assembly && part;
}

void SetView(vtkRenderer* renderer, const View& view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(glm::value_ptr(view.Position));
  camera->SetFocalPoint(glm::value_ptr(view.FocalPoint));
  camera->SetViewUp(glm::value_ptr(view.ViewUp));
  camera->SetViewAngle(view.ViewAngle);
  camera->SetParallelProjection(view.Parallel);
  camera->SetParallelScale(view.ParallelScale);
  camera->SetWindowCenter(view.WindowCenter[0], view.WindowCenter[1]);
  camera->SetEyeAngle(view.EyeAngle);
  if (view.Stretch != View().Stretch || camera->GetUserTransform())
  {
    vtkNew<vtkTransform> stretch;
    stretch->Scale(view.Stretch[0], view.Stretch[1], 1.0);
    camera->SetUserTransform(stretch);
  }
  if (view.Near == 0.0 && view.Far == 0.0)
  {
    renderer->ResetCameraClippingRange();
  }
  else
  {
    camera->SetClippingRange(view.Near, view.Far);
  }
}

void Fill(vtkRenderer* renderer, const Scenario& scenario)
{
  renderer->SetViewport(scenario.Renderers.at(0).Viewport.data());
  std::map<int, vtkProp*> props;
  for (const Prop& prop : scenario.Props)
  {
    vtkSmartPointer<vtkProp> made = MakeProp(prop, renderer->GetActiveCamera());
    ShareMapper(made, props[prop.MapperOf]);
    if (!SetPart(props[prop.PartOf], made, true))
    {
      renderer->AddViewProp(made);
    }
    props[prop.Id] = made;
  }
  for (const Change& change : scenario.Changes)
  {
    if (change.Frame == 0 && props[change.Target])
    {
      ChangeProp(props[change.Target], scenario.Props.at(change.Target), change);
    }
  }
  for (const Light& light : scenario.Lights)
  {
    renderer->AddLight(MakeLight(light));
  }
  for (const View& view : scenario.Views)
  {
    if (view.Frame == 0)
    {
      SetView(renderer, view);
    }
  }
}
}
