// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStandIn.h"

#include "vtkNBufferPropertyKeys.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderPass.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferStandIn::ForwardedKeys::ForwardedKeys(vtkNBufferStandIn* standIn, vtkProp* to)
{
  vtkInformation* from = standIn->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  vtkInformationIntegerKey* depthMask = vtkOpenGLActor::GLDepthMaskOverride();
  if (!from || (passes->Length(from) == 0 && !from->Has(depthMask)))
  {
    return;
  }
  this->To = vtkNBufferPropertyKeys::Get(to);
  for (int i = 0; i < passes->Length(from); ++i)
  {
    if (vtkNBufferPropertyKeys::AddPass(this->To, passes->Get(from, i)))
    {
      this->Added.push_back(passes->Get(from, i));
    }
  }
  this->SetsDepthMask = from->Has(depthMask) && !this->To->Has(depthMask);
  if (this->SetsDepthMask)
  {
    this->To->Set(depthMask, from->Get(depthMask));
  }
}

vtkNBufferStandIn::ForwardedKeys::~ForwardedKeys()
{
  if (!this->To)
  {
    return;
  }
  for (vtkObjectBase* pass : this->Added)
  {
    vtkNBufferPropertyKeys::RemovePass(this->To, pass);
  }
  if (this->SetsDepthMask)
  {
    this->To->Remove(vtkOpenGLActor::GLDepthMaskOverride());
  }
}
VTK_ABI_NAMESPACE_END
