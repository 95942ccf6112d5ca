// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Fill.h
 * @brief Parts of a scenario in a renderer that somebody else made.
 */
#ifndef Fill_h
#define Fill_h

#include "Scenario.h"

class vtkProp;
class vtkRenderer;

namespace TestScene
{
/// If both are actors, the first one draws with the mapper of the other from now on. Returns
/// whether they are.
bool ShareMapper(vtkProp* prop, vtkProp* other);

/// If `whole` is an assembly, the prop becomes one of its parts or is none any more. Returns
/// whether it is an assembly.
bool SetPart(vtkProp* whole, vtkProp* prop, bool present);

/// The renderer's camera becomes that of the view.
void SetView(vtkRenderer* renderer, const View& view);

/// Props, lights, viewport and view of the first frame of a scenario with one renderer, and what
/// changes its props then. Nothing of the scenario is needed afterwards.
void Fill(vtkRenderer* renderer, const Scenario& scenario);
}

#endif
