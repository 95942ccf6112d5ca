// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Undefined.h
 * @brief What VTK or a documented limit leaves undefined, taken out of scenarios.
 */
#ifndef Undefined_h
#define Undefined_h

#include "Scenario.h"

namespace TestScene
{
/// What VTK leaves undefined, so that it does not even repeat itself: with a render pass a selector
/// draws props without having set their number; an overlay inside of an SSAO pass writes to one of
/// its three attachments only; ambient occlusion does not clear its own framebuffer where the
/// renderer does not erase, and before 9.7 shows what it has not drawn of it in a part of a window;
/// split stereo squeezes the whole window, and the next frame what of that is left outside of the
/// viewports, so that pictures depend on how many frames there were: with shadows not the same.
///
/// And what the shadow pass leaves undefined: shadow at the edge of a spot's cone on surfaces whose
/// shaders draw them elsewhere than where they are lit (docs/shadows.md).
void RemoveUndefined(Scenario& scene);
}

#endif
