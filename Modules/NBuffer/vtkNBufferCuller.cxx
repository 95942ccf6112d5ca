// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCuller.h"
#include "vtkObjectFactory.h"
VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferCuller);
class vtkNBufferCuller::Internals
{
public:
  vtkNBufferStatistics Last;
};
vtkNBufferCuller::vtkNBufferCuller()
  : Implementation(new Internals)
{
}
vtkNBufferCuller::~vtkNBufferCuller() = default;
double vtkNBufferCuller::Cull(vtkRenderer*, vtkProp**, int& n, int&)
{
  return n;
}
void vtkNBufferCuller::SetBaseFactor(int f)
{
  this->BaseFactor = f;
}
vtkNBufferVerdict vtkNBufferCuller::GetVerdict(vtkProp*, vtkRenderer*) const
{
  return vtkNBufferVerdict::Unknown;
}
const vtkNBufferStatistics& vtkNBufferCuller::GetStatistics(vtkRenderer*) const
{
  return this->Implementation->Last;
}
int vtkNBufferCuller::GetBackendInUse() const
{
  return Auto;
}
const char* vtkNBufferCuller::GetBackendReason() const
{
  return "";
}
void vtkNBufferCuller::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
