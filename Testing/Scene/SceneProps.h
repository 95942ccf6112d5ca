// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneProps.h
 * @brief Makes VTK's props from their descriptions, and changes them.
 */
#ifndef SceneProps_h
#define SceneProps_h

#include "Scenario.h"

#include "vtkProp.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;
class vtkPolyDataMapper;
class vtkProp3D;
class vtkTexture;

namespace TestScene
{
/// Makes a texture of 4 x 4 texels with alpha. With Translucency::Some every second texel is
/// translucent.
vtkSmartPointer<vtkTexture> MakeTexture(Translucency translucency);

/// Makes a prop. Followers turn towards `camera`.
vtkSmartPointer<vtkProp> MakeProp(const Prop& prop, vtkCamera* camera);

/// Makes the data of a prop and gives it to a mapper, if need be by a filter. With `reversePoints`
/// the points have the reverse order.
void SetInput(vtkPolyDataMapper* mapper, const Prop& prop, bool reversePoints);

/// Sets a prop's matrix. Does nothing unless there are 16 elements.
void SetMatrix(vtkProp3D* prop, const std::vector<double>& elements);

/// Applies a change to a prop. Ignores changes that do not fit the kind of prop.
void ChangeProp(vtkProp* prop, const Prop& description, const Change& change);
}

#endif
