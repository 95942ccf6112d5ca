// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPropertyKeys.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

VTK_ABI_NAMESPACE_BEGIN
vtkInformation* vtkNBufferPropertyKeys::Get(vtkProp* prop)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  return prop->GetPropertyKeys();
}

bool vtkNBufferPropertyKeys::HasPass(vtkInformation* keys, const vtkObjectBase* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; keys && i < passes->Length(keys); ++i)
  {
    if (passes->Get(keys, i) == pass)
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferPropertyKeys::AddPass(vtkInformation* keys, vtkObjectBase* pass)
{
  const bool isMissing = !HasPass(keys, pass);
  if (isMissing)
  {
    vtkOpenGLRenderPass::RenderPasses()->Append(keys, pass);
  }
  return isMissing;
}

void vtkNBufferPropertyKeys::RemovePass(vtkInformation* keys, vtkObjectBase* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  if (keys && passes->Length(keys) > 0)
  {
    passes->Remove(keys, pass);
    if (passes->Length(keys) == 0)
    {
      keys->Remove(passes);
    }
  }
}
VTK_ABI_NAMESPACE_END
