// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferViewKey.h"

#include "vtkNBufferCamera.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferViewKey vtkNBufferViewKey::Make(vtkRenderer* renderer)
{
  vtkNBufferViewKey key;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  key.Camera = renderer->GetActiveCamera();
  key.WorldToClip = vtkNBufferGLM::ToRows(vtkNBufferCamera(renderer).WorldToClip);
  renderer->GetTiledSizeAndOrigin(
    &key.Viewport[2], &key.Viewport[3], &key.Viewport[0], &key.Viewport[1]);
  key.ContextTime = window->GetContextCreationTime();
  key.MultiSamples = window->GetMultiSamples();
  return key;
}
VTK_ABI_NAMESPACE_END
