// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Undefined.h
 * @brief Removes from scenarios what VTK leaves undefined.
 */
#ifndef Undefined_h
#define Undefined_h

#include "Scenario.h"

namespace TestScene
{
/**
 * Removes what VTK does not draw the same twice, or what makes it crash:
 *
 *  - With a render pass, a selector draws props before it has set their numbers.
 *  - An overlay inside of an SSAO pass writes to only one of three attachments.
 *  - Ambient occlusion does not clear its framebuffer if the renderer does not erase. Before
 *    VTK 9.7 it shows undrawn parts of it in a renderer that fills a part of a window. It blends
 *    normals, so that the NaN normal of a flat triangle without area spoils what is before it.
 *  - Split stereo scales the whole window, with what earlier frames left outside of the viewports.
 *    Windows that have drawn different numbers of frames differ, as they do with shadows.
 *  - A billboard in several renderers is drawn where it was in another one.
 *  - The shaders of splats keep the global polygon offset of the time when they were made. With
 *    splats and a new context VTK crashes.
 *  - Whether the scalars behind a filter are translucent is determined before the filter has run.
 *  - VTK 9.1 crashes with clipped glyphs that get edges.
 */
void RemoveUndefined(Scenario& scene);
}

#endif
