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
  this->ReleaseProps();
}

void vtkNBufferFrameGuard::BeginFrame(vtkObject* culler)
{
  this->Culler = culler;
  // An application that removes its own observers may remove the guard with them.
  if (!this->Renderer->HasObserver(vtkCommand::EndEvent, this) ||
    !this->Renderer->HasObserver(vtkCommand::DeleteEvent, this) ||
    !this->Props->HasObserver(vtkCommand::ModifiedEvent, this))
  {
    this->Detach();
    this->Attach(this->Renderer);
  }
  if (this->IsComplete)
  {
    return;
  }
  this->IsComplete = true;
  this->References.clear();
  vtkCollectionSimpleIterator cookie;
  this->Props->InitTraversal(cookie);
  while (vtkProp* prop = this->Props->GetNextProp(cookie))
  {
    this->References.emplace_back(prop);
  }
}

void vtkNBufferFrameGuard::ReleaseProps()
{
  // Destructors of props may run any code, this function included.
  std::vector<vtkSmartPointer<vtkProp>> references;
  references.swap(this->References);
  this->IsComplete = false;
}

void vtkNBufferFrameGuard::Execute(vtkObject*, unsigned long event, void*)
{
  if (event != vtkCommand::EndEvent)
  {
    this->IsComplete = false;
  }
  // If the props change while a frame is drawn, the references are released at its end.
  const bool isOver = event != vtkCommand::ModifiedEvent;
  if (!this->IsComplete && (isOver || !this->Culler))
  {
    this->ReleaseProps();
  }
  if (isOver)
  {
    // This may be the last reference to the culler. The guard itself is kept alive by the caller.
    const vtkSmartPointer<vtkObject> culler = this->Culler;
    this->Culler = nullptr;
  }
}
VTK_ABI_NAMESPACE_END
