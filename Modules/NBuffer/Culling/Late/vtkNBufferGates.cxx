// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGates.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferTranslucentProxy* vtkNBufferGates::Add(vtkProp* prop, bool open)
{
  if (this->Count == this->Gates.size())
  {
    this->Gates.push_back(vtkSmartPointer<vtkNBufferTranslucentProxy>::New());
  }
  vtkNBufferTranslucentProxy* gate = this->Gates[this->Count++];
  gate->SetProp(prop);
  gate->SetOpen(open);
  return gate;
}
VTK_ABI_NAMESPACE_END
