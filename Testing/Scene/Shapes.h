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
/// Makes the mesh of a shape; equal shapes give the same bits. Unless `scalars` is None, each point
/// has an RGBA colour, translucent in places (Some) or opaque (Opaque).
vtkSmartPointer<vtkPolyData> MakeShape(
  const Shape& shape, Translucency scalars = Translucency::None);

/// Makes a box whose faces share no points, with normals. `precision` is VTK_FLOAT or VTK_DOUBLE.
vtkSmartPointer<vtkPolyData> MakeBox(
  const glm::dvec3& center, const glm::dvec3& size, int precision = VTK_FLOAT);

/// Adds `way` to all points, in place, and `shear` times z to x.
void MovePoints(vtkPoints* points, const glm::dvec3& way, double shear = 0.0);

/// Reverses the order of the points and of their values. Every cell keeps its place in the list and
/// its shape.
void ReversePoints(vtkPolyData* data);
}

#endif
