// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawPass.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferDrawPass);

void vtkNBufferDrawPass::Attach(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  vtkOpenGLRenderPass::RenderPasses()->Append(prop->GetPropertyKeys(), this);
}

void vtkNBufferDrawPass::Detach(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  if (keys && passes->Length(keys) > 0)
  {
    passes->Remove(keys, this);
    if (passes->Length(keys) == 0)
    {
      keys->Remove(passes);
    }
  }
}

bool vtkNBufferDrawPass::SetShaderParameters(
  vtkShaderProgram*, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->Callback)
  {
    this->Callback(mapper, prop);
  }
  return true;
}
VTK_ABI_NAMESPACE_END
