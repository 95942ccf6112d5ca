// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Parts.h
 * @brief Parts of scenes that consist of a few shapes, each of them the mapper of many actors.
 */
#ifndef Parts_h
#define Parts_h

#include "Scene.h"

#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <cstddef>

class vtkPolyData;
class vtkPolyDataAlgorithm;

namespace NBufferExamples
{

///@{
/// Return a mapper that draws a mesh, or what a source makes, in the colour of the actor.
vtkSmartPointer<vtkPolyDataMapper> MakePartMapper(vtkPolyData* data);
vtkSmartPointer<vtkPolyDataMapper> MakePartMapper(vtkPolyDataAlgorithm* source);
///@}

/// Paints a part by its number: the hues follow the golden ratio, with little saturation.
void PaintPart(vtkActor* actor, std::size_t number, double value = 0.9);

/// Adds a part of unit size at the origin, painted by its number in the scene. It has an ambient
/// part, so that it is not black where no light falls.
vtkActor* AddPart(Scene& scene, vtkPolyDataMapper* mapper);

/// Adds such a part at a place and in a size.
vtkActor* AddPart(
  Scene& scene, vtkPolyDataMapper* mapper, const glm::dvec3& place, const glm::dvec3& size);

} // namespace NBufferExamples

#endif
