// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viridis.h"

namespace NBufferBench
{

vtkSmartPointer<vtkColorTransferFunction> MakeViridis()
{
  constexpr double samples[][3] = { { 0.267, 0.005, 0.329 }, { 0.254, 0.265, 0.530 },
    { 0.164, 0.471, 0.558 }, { 0.135, 0.659, 0.518 }, { 0.478, 0.821, 0.318 },
    { 0.993, 0.906, 0.144 } };
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  double place = 0.0;
  for (const double* color : samples)
  {
    colors->AddRGBPoint(place / 5.0, color[0], color[1], color[2]);
    place += 1.0;
  }
  return colors;
}

} // namespace NBufferBench
