// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EarlyDepthPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"

namespace NBufferPeers
{

vtkStandardNewMacro(EarlyDepthPass);

void EarlyDepthPass::Render(const vtkRenderState* state)
{
  {
    vtkOpenGLState* openGL =
      static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow())->GetState();
    const vtkOpenGLState::ScopedglColorMask mask(openGL);
    openGL->vtkglColorMask(false, false, false, false);
    this->Opaque->Render(state);
  }
  this->Opaque->Render(state);
  this->NumberOfRenderedProps = this->Opaque->GetNumberOfRenderedProps();
}

} // namespace NBufferPeers
