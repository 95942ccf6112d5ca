// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferStandIn.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
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
  if (!to->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    to->SetPropertyKeys(keys);
  }
  this->To = to->GetPropertyKeys();
  const auto has = [this, passes](vtkObjectBase* pass)
  {
    for (int i = 0; i < passes->Length(this->To); ++i)
    {
      if (passes->Get(this->To, i) == pass)
      {
        return true;
      }
    }
    return false;
  };
  for (int i = 0; i < passes->Length(from); ++i)
  {
    if (vtkObjectBase* pass = passes->Get(from, i); !has(pass))
    {
      passes->Append(this->To, pass);
      this->Added.push_back(pass);
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
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (vtkObjectBase* pass : this->Added)
  {
    passes->Remove(this->To, pass);
  }
  if (passes->Length(this->To) == 0)
  {
    this->To->Remove(passes);
  }
  if (this->SetsDepthMask)
  {
    this->To->Remove(vtkOpenGLActor::GLDepthMaskOverride());
  }
}
VTK_ABI_NAMESPACE_END
