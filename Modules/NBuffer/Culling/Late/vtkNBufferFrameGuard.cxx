// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferFrameGuard.h"

#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN

void vtkNBufferFrameGuard::Attach(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->Props = renderer->GetViewProps();
  renderer->AddObserver(vtkCommand::EndEvent, this);
  renderer->AddObserver(vtkCommand::DeleteEvent, this);
  this->Props->AddObserver(vtkCommand::ModifiedEvent, this);
}

void vtkNBufferFrameGuard::Detach()
{
  if (this->Props)
  {
    this->Props->RemoveObserver(this);
  }
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this);
  }
  this->DropProps();
}

void vtkNBufferFrameGuard::BeginFrame(vtkObject* culler)
{
  this->Culler = culler;
  if (this->Holding)
  {
    return;
  }
  this->Holding = true;
  vtkCollectionSimpleIterator cookie;
  this->Props->InitTraversal(cookie);
  while (vtkProp* prop = this->Props->GetNextProp(cookie))
  {
    this->References.emplace_back(prop);
  }
}

void vtkNBufferFrameGuard::DropProps()
{
  // Destructors may run anything.
  std::vector<vtkSmartPointer<vtkProp>> references;
  references.swap(this->References);
  this->Holding = false;
}

void vtkNBufferFrameGuard::Execute(vtkObject*, unsigned long event, void*)
{
  if (event != vtkCommand::EndEvent)
  {
    this->Holding = false;
  }
  // A change while a frame is drawn waits for its end.
  const bool isOver = event != vtkCommand::ModifiedEvent;
  if (!this->Holding && (isOver || !this->Culler))
  {
    this->DropProps();
  }
  if (isOver)
  {
    // Its last reference may be this one; the guard itself is kept by whoever calls.
    const vtkSmartPointer<vtkObject> culler = this->Culler;
    this->Culler = nullptr;
  }
}
VTK_ABI_NAMESPACE_END
