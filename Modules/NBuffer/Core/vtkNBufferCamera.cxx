// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferCamera::vtkNBufferCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto toMatrix = [](vtkMatrix4x4* matrix)
  { return vtkNBufferGLM::ToMatrix(matrix->GetData()); };
  auto* drawing = vtkOpenGLCamera::SafeDownCast(camera);
  if (drawing && camera->GetStereo() == renderer->GetRenderWindow()->GetStereoRender())
  {
    vtkMatrix4x4* modelView = nullptr;
    vtkMatrix3x3* normals = nullptr;
    vtkMatrix4x4* projection = nullptr;
    vtkMatrix4x4* both = nullptr;
    drawing->GetKeyMatrices(renderer, modelView, normals, projection, both);
    this->WorldToClip = glm::transpose(toMatrix(projection)) * glm::transpose(toMatrix(modelView));
  }
  else
  {
    this->WorldToClip =
      toMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)) *
      toMatrix(camera->GetModelViewTransformMatrix());
  }
  camera->GetPosition(glm::value_ptr(this->Eye));
  // An explicit projection matrix may be of the other kind than the camera says.
  const glm::dvec4 w = glm::row(this->WorldToClip, 3);
  this->IsParallel = w.x == 0.0 && w.y == 0.0 && w.z == 0.0;
}

glm::dmat4 vtkNBufferCamera::GetEyeToClip() const
{
  glm::dmat4 result = this->WorldToClip;
  result[3] = vtkNBufferGLM::Multiply(this->WorldToClip, glm::dvec4(this->Eye, 1.0));
  return result;
}

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
