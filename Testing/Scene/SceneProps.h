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

class vtkCamera;

class vtkTexture;

namespace TestScene
{
/// Makes a texture of 4 x 4 texels with alpha. With Translucency::Some every second texel is
/// translucent.
vtkSmartPointer<vtkTexture> MakeTexture(Translucency translucency);

/// Makes a prop. Followers turn towards `camera`.
vtkSmartPointer<vtkProp> MakeProp(const Prop& prop, vtkCamera* camera);

/// Applies a change to a prop. Ignores changes that do not fit the kind of prop.
void ChangeProp(vtkProp* prop, const Prop& description, const Change& change);
}

#endif
