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

int vtkNBufferPropertyKeys::CountPasses(vtkInformation* keys)
{
  return keys ? vtkOpenGLRenderPass::RenderPasses()->Length(keys) : 0;
}

bool vtkNBufferPropertyKeys::HasPass(vtkInformation* keys, const vtkObjectBase* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < CountPasses(keys); ++i)
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
  if (CountPasses(keys) > 0)
  {
    passes->Remove(keys, pass);
    if (passes->Length(keys) == 0)
    {
      keys->Remove(passes);
    }
  }
}

void vtkNBufferPropertyKeys::AddPassToCopy(vtkInformation* copy, vtkObjectBase* pass, int place)
{
  if (HasPass(copy, pass))
  {
    return;
  }
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  int i = CountPasses(copy);
  for (; i > place; --i)
  {
    passes->Set(copy, passes->Get(copy, i - 1), i);
  }
  passes->Set(copy, pass, i);
}

void vtkNBufferPropertyKeys::RemovePassFromCopy(vtkInformation* copy, vtkObjectBase* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  int kept = 0;
  for (int i = 0; i < CountPasses(copy); ++i)
  {
    vtkObjectBase* other = passes->Get(copy, i);
    if (other != pass)
    {
      passes->Set(copy, other, kept++);
    }
  }
  if (kept < CountPasses(copy))
  {
    passes->Resize(copy, kept);
  }
}
VTK_ABI_NAMESPACE_END
