// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RandomBoxes.h
 * @brief Random boxes; the same seed gives the same boxes.
 */
#ifndef RandomBoxes_h
#define RandomBoxes_h

#include "vtkNBufferProjection.h"

#include <random>
#include <vector>

/// Returns boxes that begin anywhere in a block of 120 x 140 x 20 units around (0, 60, 0). Each is
/// up to 2 units long in x, 4 in y and 1 in z.
inline std::vector<vtkNBufferBox> MakeRandomBoxes(int count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<vtkNBufferBox> boxes;
  for (int i = 0; i < count; ++i)
  {
    const double x = 60.0 * uniform(random);
    const double y = 60.0 + 70.0 * uniform(random);
    const double z = 10.0 * uniform(random);
    const double size = 1.0 + uniform(random);
    const double bounds[6] = { x, x + size, y, y + 2.0 * size, z, z + 0.5 * size };
    boxes.push_back(vtkNBufferBox::FromBounds(bounds));
  }
  return boxes;
}

#endif
