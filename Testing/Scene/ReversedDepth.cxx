// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReversedDepth.h"

#include "vtkNBufferGL.h"

#include "vtkCallbackCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPerspectiveTransform.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

namespace TestScene
{
vtkStandardNewMacro(ReversedCamera);
vtkStandardNewMacro(ReversedDepthPass);

void ReversedCamera::ComputeProjectionTransform(double aspect, double nearz, double farz)
{
  this->Superclass::ComputeProjectionTransform(aspect, nearz, farz);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(this->ProjectionTransform->GetMatrix());
  if (this->InfiniteFar && !this->ParallelProjection)
  {
    for (int j = 0; j < 4; ++j)
    {
      matrix->SetElement(2, j, j < 3 ? 0.0 : this->ClippingRange[0]);
    }
  }
  else
  {
    for (int j = 0; j < 4; ++j)
    {
      matrix->SetElement(2, j, 0.5 * (matrix->GetElement(3, j) - matrix->GetElement(2, j)));
    }
  }
  this->ProjectionTransform->SetMatrix(matrix);
}

namespace
{
/// Sets the state for reversed depth, or VTK's own.
void SetState(vtkRenderer* renderer, bool isReversed, GLenum depthFunction)
{
  // Without clip control VTK draws another reversed depth, which the culler does not know.
  if (vtkNBufferGL::HasFeature(4, 5, "GL_ARB_clip_control"))
  {
    glClipControl(GL_LOWER_LEFT, isReversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
  }
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetVTKWindow())->GetState();
  state->vtkglDepthFunc(depthFunction);
  state->vtkglClearDepth(isReversed ? 0.0 : 1.0);
  if (isReversed)
  {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  }
}
}

void ReverseByObservers(vtkRenderer* renderer)
{
  renderer->SetActiveCamera(vtkNew<ReversedCamera>());
  renderer->PreserveDepthBufferOn();
  for (const bool begins : { true, false })
  {
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(
      [](vtkObject* caller, unsigned long event, void*, void*)
      {
        const bool isReversed = event == vtkCommand::StartEvent;
        SetState(vtkRenderer::SafeDownCast(caller), isReversed, isReversed ? GL_GEQUAL : GL_LEQUAL);
      });
    renderer->AddObserver(begins ? vtkCommand::StartEvent : vtkCommand::EndEvent, observer);
  }
}

void ReversedDepthPass::Render(const vtkRenderState* s)
{
  SetState(s->GetRenderer(), true, this->DepthFunction);
  this->Delegate->Render(s);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  SetState(s->GetRenderer(), false, GL_LEQUAL);
}

void ReversedDepthPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Delegate->ReleaseGraphicsResources(window);
}
}
