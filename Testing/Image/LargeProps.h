// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeProps.h
 * @brief What the tests of props that are drawn unit by unit share.
 */
#ifndef LargeProps_h
#define LargeProps_h

#include "CullerTest.h"

namespace LargeProps
{
/// Units of so many triangles, made without delay.
ComparisonOptions MakeOptions(int unitSize = 8);

/// Two walls in a scene of about 60 x 60.
void AddWalls(Stage& stage);

/// Walk through a scene of about 60 x 60 at eye height, from `start` on the x axis, then look at it
/// from above, from the x coordinate `above`.
void Walk(vtkRenderer* renderer, int frame, double start = -20.0, double above = 0.0);

/// How many units were hidden on a walk, and fresh after its first three frames.
struct Units
{
  int Hidden = 0;
  int Fresh = 0;
};

/// Compare 14 frames, the cameras of which `walk` sets. From the third one on there are units.
Units CompareWalk(Comparison& comparison, const std::function<void(vtkRenderer*, int)>& walk);

/// A selection of all cells that are seen finds the same ones in both stages, and at least one.
void ExpectSamePicks(Comparison& comparison);
}

#endif
