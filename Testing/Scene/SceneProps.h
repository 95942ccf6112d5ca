// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneProps.h
 * @brief VTK's props from their descriptions, and the changes that they suffer.
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
/// Some: every second texel lets through what is behind it.
vtkSmartPointer<vtkTexture> MakeTexture(Translucency translucency);

/// `camera` is what followers follow.
vtkSmartPointer<vtkProp> MakeProp(const Prop& prop, vtkCamera* camera);

/// Changes that do not fit the kind of prop leave it as it is.
void ChangeProp(vtkProp* prop, const Prop& description, const Change& change);
}

#endif
