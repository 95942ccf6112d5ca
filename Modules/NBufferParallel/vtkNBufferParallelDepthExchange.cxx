// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferParallelDepthExchange.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferParallelDepthExchange);

vtkNBufferParallelDepthExchange::vtkNBufferParallelDepthExchange() = default;

vtkNBufferParallelDepthExchange::~vtkNBufferParallelDepthExchange() = default;

void vtkNBufferParallelDepthExchange::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkNBufferParallelDepthExchange::GetController() const
{
  return this->Controller;
}

int vtkNBufferParallelDepthExchange::GetNumberOfRanks()
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

int vtkNBufferParallelDepthExchange::GetRank()
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

bool vtkNBufferParallelDepthExchange::ReduceToMinimum(const float* values, float* minima, int count)
{
  return this->Controller &&
    this->Controller->AllReduce(values, minima, count, vtkCommunicator::MIN_OP) != 0;
}

void vtkNBufferParallelDepthExchange::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.GetPointer() << "\n";
}
VTK_ABI_NAMESPACE_END
