// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OracleCuller.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"

#include <algorithm>

namespace NBufferBench
{

vtkStandardNewMacro(OracleCuller);

double OracleCuller::Cull(
  vtkRenderer* vtkNotUsed(renderer), vtkProp** propList, int& listLength, int& initialized)
{
  if (!this->Props || this->Props->size() > static_cast<std::size_t>(listLength))
  {
    return listLength;
  }
  std::copy(this->Props->begin(), this->Props->end(), propList);
  listLength = static_cast<int>(this->Props->size());
  for (vtkProp* prop : *this->Props)
  {
    prop->SetRenderTimeMultiplier(1.0);
  }
  initialized = 1;
  return listLength;
}

} // namespace NBufferBench
