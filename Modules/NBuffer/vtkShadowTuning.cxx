// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTuning.h"

#include "vtkNBufferNamedMembers.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkNBufferNamedMember<vtkShadowTuning> ShadowMembers[] = {
  { "LitmapResolution", &vtkShadowTuning::LitmapResolution, 1, 4096 },
  { "SlabGap", &vtkShadowTuning::SlabGap, 1, 64 },
  { "BoxCost", &vtkShadowTuning::BoxCost, 0, 1000000000 },
  { "CountFragments", &vtkShadowTuning::CountFragments },
  { "MeasureDeviceTime", &vtkShadowTuning::MeasureDeviceTime },
};
}

std::vector<std::string> vtkShadowTuning::GetNames()
{
  return vtkNBufferNamedMembers::GetNames(ShadowMembers);
}

int vtkShadowTuning::Get(const std::string& name) const
{
  const auto* member = vtkNBufferNamedMembers::Find(ShadowMembers, name);
  return member ? member->Get(*this) : -1;
}

bool vtkShadowTuning::Set(const std::string& name, int value)
{
  return vtkNBufferNamedMembers::Set(ShadowMembers, *this, name, value);
}

bool vtkShadowTuning::operator==(const vtkShadowTuning& other) const
{
  return vtkNBufferNamedMembers::AreEqual(ShadowMembers, *this, other) &&
    this->LitmapSource == other.LitmapSource;
}

std::string vtkShadowTuning::FindFault() const
{
  return vtkNBufferNamedMembers::FindFault(ShadowMembers, *this);
}

void vtkShadowTuning::PrintSelf(ostream& os, vtkIndent indent) const
{
  vtkNBufferNamedMembers::Print(ShadowMembers, *this, os, indent);
  os << indent << "LitmapSource: " << this->LitmapSource.get() << "\n";
}

VTK_ABI_NAMESPACE_END
