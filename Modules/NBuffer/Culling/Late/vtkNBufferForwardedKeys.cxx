// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferForwardedKeys.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferForwardedKeys::vtkNBufferForwardedKeys(vtkInformation* from, vtkProp* to)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  vtkInformationIntegerKey* depthMask = vtkOpenGLActor::GLDepthMaskOverride();
  if (!from || (passes->Length(from) == 0 && !from->Has(depthMask)))
  {
    return;
  }
  if (!to->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    to->SetPropertyKeys(keys);
  }
  this->From = from;
  this->To = to->GetPropertyKeys();
  for (int i = 0; i < passes->Length(from); ++i)
  {
    passes->Append(this->To, passes->Get(from, i));
  }
  this->DepthMask = from->Has(depthMask) && !this->To->Has(depthMask);
  if (this->DepthMask)
  {
    this->To->Set(depthMask, from->Get(depthMask));
  }
}

vtkNBufferForwardedKeys::~vtkNBufferForwardedKeys()
{
  if (!this->To)
  {
    return;
  }
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < passes->Length(this->From); ++i)
  {
    passes->Remove(this->To, passes->Get(this->From, i));
  }
  if (passes->Length(this->To) == 0)
  {
    this->To->Remove(passes);
  }
  if (this->DepthMask)
  {
    this->To->Remove(vtkOpenGLActor::GLDepthMaskOverride());
  }
}
VTK_ABI_NAMESPACE_END
