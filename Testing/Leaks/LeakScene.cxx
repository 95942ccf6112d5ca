// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeakScene.h"

#include "SceneProps.h"

#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace LeakScene
{
vtkStandardNewMacro(Renderer);

vtkSmartPointer<vtkActor> MakeLeakBox(double x, double y, double z, double size, int kind)
{
  TestScene::Prop box;
  box.Kind = kind == 1 ? TestScene::PropKind::Piped : TestScene::PropKind::Actor;
  box.Shape.Center = { x, y, z };
  box.Shape.Size = glm::dvec3(size);
  box.Color = { 0.5 + 0.5 * std::sin(x), 0.5 + 0.5 * std::sin(y), 0.5 };
  box.Opacity = kind == 2 ? 0.5 : 1.0;
  return vtkActor::SafeDownCast(TestScene::MakeProp(box, nullptr));
}

void Build(vtkRenderer* renderer)
{
  vtkSmartPointer<vtkActor> wall = MakeLeakBox(0.0, 0.0, 0.0, 1.0, 0);
  wall->SetScale(12.0, 6.0, 0.5);
  renderer->AddActor(wall);
  for (int i = 0; i < BoxesBehind + TranslucentBehind; ++i)
  {
    renderer->AddActor(MakeLeakBox(-4.0 + 0.8 * (i % 11), -1.5 + 0.6 * (i / 11), -2.0 - 0.1 * i,
      0.5, i < BoxesBehind ? i % 2 : 2));
  }
  SetCamera(renderer, 0);
}

void SetCamera(vtkRenderer* renderer, int frame)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double shift = std::sin(0.37 * frame);
  camera->SetPosition(shift, 0.25 * shift, 20.0);
  camera->SetFocalPoint(0.5 * shift, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 100.0);
}

void WeakObjects::Add(vtkObject* object)
{
  if (std::find(this->Objects.begin(), this->Objects.end(), object) == this->Objects.end())
  {
    this->Objects.emplace_back(object);
  }
}

int WeakObjects::GetNumberOfLiving() const
{
  return static_cast<int>(std::count_if(this->Objects.begin(), this->Objects.end(),
    [](vtkObject* object) { return object != nullptr; }));
}

int Renderer::UpdateGeometry(vtkFrameBufferObjectBase* framebuffer)
{
  const int count = CountProps(this, this->PropArray);
  for (int i = 0; i < count; ++i)
  {
    if (!this->HasViewProp(this->PropArray[i]))
    {
      this->Foreign->Add(this->PropArray[i]);
    }
  }
  return this->Superclass::UpdateGeometry(framebuffer);
}

WeakObjects GetContents(vtkRenderer* renderer)
{
  WeakObjects objects;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    for (vtkObject* object : std::initializer_list<vtkObject*>{
           actor, actor->GetMapper(), actor->GetProperty(), actor->GetMapper()->GetInput() })
    {
      objects.Add(object);
    }
  }
  return objects;
}
}
