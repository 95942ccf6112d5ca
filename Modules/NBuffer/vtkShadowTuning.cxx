// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTuning.h"

#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

bool vtkShadowTuning::operator==(const vtkShadowTuning& other) const
{
  const auto tie = [](const vtkShadowTuning& t)
  {
    return std::tie(t.LitmapResolution, t.SlabGap, t.BoxCost, t.CountFragments, t.MeasureDeviceTime,
      t.LitmapSource);
  };
  return tie(*this) == tie(other);
}

std::string vtkShadowTuning::FindFault() const
{
  if (this->LitmapResolution < 1 || this->LitmapResolution > 4096)
  {
    return "LitmapResolution must be 1 to 4096, not " + std::to_string(this->LitmapResolution);
  }
  if (this->SlabGap < 1 || this->SlabGap > 64)
  {
    return "SlabGap must be 1 to 64, not " + std::to_string(this->SlabGap);
  }
  if (this->BoxCost < 0 || this->BoxCost > 1000000000)
  {
    return "BoxCost must be 0 to 1e9, not " + std::to_string(this->BoxCost);
  }
  return "";
}

void vtkShadowTuning::PrintSelf(ostream& os, vtkIndent indent) const
{
  os << indent << "LitmapResolution: " << this->LitmapResolution << "\n";
  os << indent << "SlabGap: " << this->SlabGap << "\n";
  os << indent << "BoxCost: " << this->BoxCost << "\n";
  os << indent << "CountFragments: " << this->CountFragments << "\n";
  os << indent << "MeasureDeviceTime: " << this->MeasureDeviceTime << "\n";
  os << indent << "LitmapSource: " << this->LitmapSource.get() << "\n";
}

VTK_ABI_NAMESPACE_END
