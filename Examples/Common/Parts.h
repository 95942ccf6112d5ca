// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Parts.h
 * @brief Scenes put together from few shapes, each the mapper of many actors.
 */
#ifndef Parts_h
#define Parts_h

#include "Scene.h"

#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <cstddef>

class vtkPolyData;

namespace NBufferExamples
{

/// A mapper that draws in the colour of the actor.
vtkSmartPointer<vtkPolyDataMapper> MakePartMapper(vtkPolyData* data);

/// A colour for the part of a number: hues by the golden ratio, little saturated.
void PaintPart(vtkActor* actor, std::size_t number, double value = 0.9);

/// A part of unit size at the origin, coloured by its number, and seen where no light falls, too.
vtkActor* AddPart(Scene& scene, vtkPolyDataMapper* mapper);

/// The same at a place in a size.
vtkActor* AddPart(Scene& scene, vtkPolyDataMapper* mapper, double x, double y, double z,
  double sizeX, double sizeY, double sizeZ);

} // namespace NBufferExamples

#endif
