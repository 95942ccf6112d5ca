// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Fill.h
 * @brief Puts parts of a scenario into a renderer that the caller has made.
 */
#ifndef Fill_h
#define Fill_h

#include "Scenario.h"

class vtkProp;
class vtkRenderer;

namespace TestScene
{
/// Gives `prop` the mapper of `other` if both are actors. Returns whether they are.
bool ShareMapper(vtkProp* prop, vtkProp* other);

/// Adds a prop to the parts of an assembly, or removes it if not `present`. Returns false, and does
/// nothing, if `whole` is not a vtkAssembly or `prop` is not a vtkProp3D.
bool SetPart(vtkProp* whole, vtkProp* prop, bool present);

/// Sets the renderer's camera as the view describes it.
void SetView(vtkRenderer* renderer, const View& view);

/// Sets the viewport, the props, the lights and the camera of the first frame of a scenario with
/// one renderer, and applies the changes of props in that frame. The renderer does not refer to the
/// scenario afterwards.
void Fill(vtkRenderer* renderer, const Scenario& scenario);
}

#endif
