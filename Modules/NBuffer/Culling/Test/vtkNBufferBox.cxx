// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferBox.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferBox vtkNBufferBox::FromBounds(const double bounds[6])
{
  vtkNBufferBox box;
  for (int i = 0; i < 3; ++i)
  {
    box.Center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    // Centre and half size are rounded, and so is their sum: a few steps outward.
    const double half = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]);
    box.HalfSize[i] = half + (std::abs(box.Center[i]) + half) * 0x1p-50;
    box.Magnitude[i] = std::abs(box.Center[i]) + box.HalfSize[i];
  }
  return box;
}
VTK_ABI_NAMESPACE_END
