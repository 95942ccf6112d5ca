// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTuning.h"

#include "vtkNBufferNamedMembers.h"
#include "vtkNBufferStatistics.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkNBufferNamedMember<vtkNBufferTuning> Members[] = {
  { "BaseFactor", &vtkNBufferTuning::BaseFactor, 1, 8 },
  { "MinimumNumberOfCandidates", &vtkNBufferTuning::MinimumNumberOfCandidates, 1, VTK_INT_MAX },
  { "MaximumNumberOfRounds", &vtkNBufferTuning::MaximumNumberOfRounds, 1,
    vtkNBufferStatistics::MaximumNumberOfRounds },
  { "RoundSize", &vtkNBufferTuning::RoundSize, 1, VTK_INT_MAX },
  { "HierarchySize", &vtkNBufferTuning::HierarchySize, 0, VTK_INT_MAX },
  { "ObserveAfter", &vtkNBufferTuning::ObserveAfter, 0, VTK_INT_MAX },
  { "MinimumNumberOfPrimitives", &vtkNBufferTuning::MinimumNumberOfPrimitives, 1, VTK_INT_MAX },
  { "UnitSize", &vtkNBufferTuning::UnitSize, 1, 65536 },
  { "DivideAfter", &vtkNBufferTuning::DivideAfter, 0, VTK_INT_MAX },
  { "DivideInBackground", &vtkNBufferTuning::DivideInBackground },
  { "MinimumNumberOfUnitsOnDevice", &vtkNBufferTuning::MinimumNumberOfUnitsOnDevice, 1,
    VTK_INT_MAX },
  { "TimeUnits", &vtkNBufferTuning::TimeUnits },
  { "TestTriangles", &vtkNBufferTuning::TestTriangles },
  { "TestPixels", &vtkNBufferTuning::TestPixels },
  { "AllowFloatTextures", &vtkNBufferTuning::AllowFloatTextures },
  { "ReuseWhenStill", &vtkNBufferTuning::ReuseWhenStill },
  { "BackOff", &vtkNBufferTuning::BackOff },
  { "TakeOverFrustumCulling", &vtkNBufferTuning::TakeOverFrustumCulling },
};
}

std::vector<std::string> vtkNBufferTuning::GetNames()
{
  return vtkNBufferNamedMembers::GetNames(Members);
}

int vtkNBufferTuning::Get(const std::string& name) const
{
  const vtkNBufferNamedMember<vtkNBufferTuning>* member =
    vtkNBufferNamedMembers::Find(Members, name);
  return member ? member->Get(*this) : -1;
}

bool vtkNBufferTuning::Set(const std::string& name, int value)
{
  return vtkNBufferNamedMembers::Set(Members, *this, name, value);
}

bool vtkNBufferTuning::operator==(const vtkNBufferTuning& other) const
{
  return vtkNBufferNamedMembers::AreEqual(Members, *this, other);
}

std::string vtkNBufferTuning::FindFault() const
{
  const int factor = this->BaseFactor;
  if (factor != 1 && factor != 2 && factor != 4 && factor != 8)
  {
    return "BaseFactor must be 1, 2, 4 or 8, not " + std::to_string(factor);
  }
  return vtkNBufferNamedMembers::FindFault(Members, *this);
}

void vtkNBufferTuning::PrintSelf(ostream& os, vtkIndent indent) const
{
  vtkNBufferNamedMembers::Print(Members, *this, os, indent);
}

VTK_ABI_NAMESPACE_END
