// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTuning.h"

#include "vtkNBufferStatistics.h"

#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

bool vtkNBufferTuning::operator==(const vtkNBufferTuning& other) const
{
  const auto tie = [](const vtkNBufferTuning& t)
  {
    return std::tie(t.BaseFactor, t.MinimumNumberOfCandidates, t.MaximumNumberOfRounds, t.RoundSize,
      t.HierarchySize, t.ObserveAfter, t.TestPixels, t.TestTriangles, t.AllowFloatTextures,
      t.ReuseWhenStill, t.BackOff, t.TakeOverFrustumCulling);
  };
  return tie(*this) == tie(other);
}

std::string vtkNBufferTuning::FindFault() const
{
  if (this->BaseFactor != 1 && this->BaseFactor != 2 && this->BaseFactor != 4 &&
    this->BaseFactor != 8)
  {
    return "BaseFactor must be 1, 2, 4 or 8, not " + std::to_string(this->BaseFactor);
  }
  struct Range
  {
    const char* Name;
    int Value;
    int Lowest;
    int Highest;
  };
  const Range ranges[] = {
    { "MinimumNumberOfCandidates", this->MinimumNumberOfCandidates, 1, VTK_INT_MAX },
    { "MaximumNumberOfRounds", this->MaximumNumberOfRounds, 1,
      vtkNBufferStatistics::MaximumNumberOfRounds },
    // The number doubles from round to round, at most seven times.
    { "RoundSize", this->RoundSize, 1, VTK_INT_MAX / 512 },
    { "HierarchySize", this->HierarchySize, 0, VTK_INT_MAX },
    { "ObserveAfter", this->ObserveAfter, 0, VTK_INT_MAX },
  };
  for (const Range& range : ranges)
  {
    if (range.Value < range.Lowest || range.Value > range.Highest)
    {
      return std::string(range.Name) + " must be " + std::to_string(range.Lowest) + " to " +
        std::to_string(range.Highest) + ", not " + std::to_string(range.Value);
    }
  }
  return "";
}

void vtkNBufferTuning::PrintSelf(ostream& os, vtkIndent indent) const
{
  os << indent << "BaseFactor: " << this->BaseFactor << "\n";
  os << indent << "MinimumNumberOfCandidates: " << this->MinimumNumberOfCandidates << "\n";
  os << indent << "MaximumNumberOfRounds: " << this->MaximumNumberOfRounds << "\n";
  os << indent << "RoundSize: " << this->RoundSize << "\n";
  os << indent << "HierarchySize: " << this->HierarchySize << "\n";
  os << indent << "ObserveAfter: " << this->ObserveAfter << "\n";
  os << indent << "TestPixels: " << this->TestPixels << "\n";
  os << indent << "TestTriangles: " << this->TestTriangles << "\n";
  os << indent << "AllowFloatTextures: " << this->AllowFloatTextures << "\n";
  os << indent << "ReuseWhenStill: " << this->ReuseWhenStill << "\n";
  os << indent << "BackOff: " << this->BackOff << "\n";
  os << indent << "TakeOverFrustumCulling: " << this->TakeOverFrustumCulling << "\n";
}

VTK_ABI_NAMESPACE_END
