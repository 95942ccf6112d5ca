// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthFamily.h"

namespace NBufferStudy
{

std::string DepthFamily::GetName() const
{
  std::string name = this->Taps == DepthTaps::All ? "one level"
    : this->Grid == DepthGrid::Mips               ? "mips"
    : this->Grid == DepthGrid::FatMips            ? "fat mips"
    : this->Band == 0                             ? "squares"
                                                  : "rectangles";
  if (this->Taps != DepthTaps::All)
  {
    if (this->Band > 0 && this->Band < AllShapes)
    {
      name += " band " + std::to_string(this->Band);
    }
    if (this->Grid == DepthGrid::Windows && this->Stride < FullStride)
    {
      name += " s=" + std::to_string(this->Stride);
    }
    const char* const taps[] = { "x1", "x4", "2x2", "4x4" };
    name += std::string(" ") + taps[static_cast<int>(this->Taps)];
  }
  name += " 1/" + std::to_string(this->Factor);
  return this->Separable ? name + " separable" : name;
}

} // namespace NBufferStudy
