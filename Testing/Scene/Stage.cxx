// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCullerCollection.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>

namespace TestScene
{
Stage::Stage(int width, int height, int multiSamples)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(multiSamples);
  this->Window->SetSize(width, height);
  this->AddRenderer(0.0, 0.0, 1.0, 1.0);
}

vtkActor* Stage::GetActor(int index) const
{
  return vtkActor::SafeDownCast(this->Props[index]);
}

int Stage::FindIndex(const vtkObjectBase* prop) const
{
  const auto found = std::find(this->Props.begin(), this->Props.end(), prop);
  return found == this->Props.end() ? -1 : static_cast<int>(found - this->Props.begin());
}

vtkNBufferCuller* Stage::GetCuller(int renderer) const
{
  if (renderer >= static_cast<int>(this->Renderers.size()))
  {
    return nullptr; // Shrinking may leave a window without renderers.
  }
  vtkCullerCollection* cullers = this->Renderers[renderer]->GetCullers();
  for (int i = 0; i < cullers->GetNumberOfItems(); ++i)
  {
    if (auto* culler = vtkNBufferCuller::SafeDownCast(cullers->GetItemAsObject(i)))
    {
      return culler;
    }
  }
  return nullptr;
}

vtkRenderer* Stage::AddRenderer(double x0, double y0, double x1, double y1, int layer)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(x0, y0, x1, y1);
  renderer->SetLayer(layer);
  this->Window->AddRenderer(renderer);
  this->Renderers.emplace_back(renderer);
  return renderer;
}

void Stage::Add(vtkProp* prop, vtkRenderer* renderer)
{
  (renderer ? renderer : this->GetRenderer())->AddViewProp(prop);
  this->Props.emplace_back(prop);
  this->Draws.emplace_back(std::make_shared<int>(0));
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    this->CountDraws(actor);
  }
}

vtkActor* Stage::AddActor(vtkPolyData* data, const double color[3], vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  this->Add(actor, renderer);
  return actor;
}

bool Stage::AreDrawsCounted(int prop) const
{
  // Others draw by mappers of their own, or announce updates of their pipeline by the same event
  // (composite mappers when they are asked for translucent geometry, drawn or not). The draws of a
  // shared mapper are those of all of its props.
  vtkActor* actor = this->GetActor(prop);
  return actor && actor->GetMapper() && actor->GetMapper()->IsA("vtkOpenGLPolyDataMapper") &&
    !actor->GetMapper()->IsA("vtkCompositePolyDataMapper") &&
    !actor->GetMapper()->IsA("vtkCompositePolyDataMapper2") &&
    this->DrawnWithOthers.count(prop) == 0;
}

void Stage::CountDraws(vtkActor* actor)
{
  const int index = this->FindIndex(actor);
  if (index < 0 || !actor->GetMapper())
  {
    return;
  }
  // Polydata mappers announce every piece they draw by a StartEvent.
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* counter, void*) { ++*static_cast<int*>(counter); });
  observer->SetClientData(this->Draws[index].get());
  actor->GetMapper()->AddObserver(vtkCommand::StartEvent, observer);
}

void Stage::ResetDraws()
{
  for (const auto& draws : this->Draws)
  {
    *draws = 0;
  }
}

void Stage::MakeCurrent() const
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
  }
}
}
