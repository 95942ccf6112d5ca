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

namespace TestScene
{
/// The same to the bit for equal shapes. `scalars`: one RGBA colour for each point, translucent in
/// places or opaque, or none.
vtkSmartPointer<vtkPolyData> MakeShape(
  const Shape& shape, Translucency scalars = Translucency::None);

/// A box whose faces have points and normals of their own. `precision`: VTK_FLOAT or VTK_DOUBLE.
vtkSmartPointer<vtkPolyData> MakeBox(
  const glm::dvec3& center, const glm::dvec3& size, int precision = VTK_FLOAT);

/// Moves all points, in place, and shears them by so much along x for each unit of z.
void MovePoints(vtkPoints* points, const glm::dvec3& way, double shear = 0.0);

/// Gives the points, and their values, the reverse order. The cells stay as they are.
void ReversePoints(vtkPolyData* data);
}

#endif
