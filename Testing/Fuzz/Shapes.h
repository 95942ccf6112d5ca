// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Shapes.h
 * @brief The data sets that scenarios are made of.
 */
#ifndef Shapes_h
#define Shapes_h

#include "Scenario.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace NBufferFuzz
{
/// The same to the bit for equal shapes. `scalars`: one RGBA colour for each point, translucent in
/// places or opaque, or none.
vtkSmartPointer<vtkPolyData> MakeShape(
  const Shape& shape, Translucency scalars = Translucency::None);
}

#endif
