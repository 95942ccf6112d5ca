// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Undefined.h
 * @brief What VTK leaves undefined, so that it does not even repeat itself, taken out of scenarios.
 */
#ifndef Undefined_h
#define Undefined_h

#include "Scenario.h"

namespace TestScene
{
/// What VTK leaves undefined, so that it does not even repeat itself: with a render pass a selector
/// draws props without having set their number; an overlay inside of an SSAO pass writes to one of
/// its three attachments only; ambient occlusion does not clear its own framebuffer where the
/// renderer does not erase, before 9.7 shows what it has not drawn of it in a part of a window, and
/// blends normals, so that what lies before a flat triangle without extent gets its normal, which
/// is no number; split stereo squeezes the whole window, and the next frame what of that is left
/// outside of the viewports, so that pictures depend on how many frames there were, which with
/// shadows is not the same; a billboard of several renderers is drawn where it was in another one,
/// and splats with the global offset of the time when their shaders were made; where splats are
/// drawn and the context is replaced, VTK crashes.
void RemoveUndefined(Scenario& scene);
}

#endif
