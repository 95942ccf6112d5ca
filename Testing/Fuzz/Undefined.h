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
 * Removes what VTK does not draw the same twice, or what makes it crash. Undefined.cxx says at each
 * rule what VTK does there; docs/limits.md has those that concern applications, too. They are about
 *
 *  - render passes: selections, overlays inside of an SSAO pass, and shadow maps with unlit props;
 *  - ambient occlusion: renderers that do not erase or fill a part of a window, and flat triangles;
 *  - windows: split stereo with shadow volumes, and billboards that several renderers share;
 *  - splats: the global polygon offset, new contexts, and edges;
 *  - glyphs: changes of opacity, wireframes, and edges with clipping planes;
 *  - composite data: too many mappers for the texture units, and blocks that move;
 *  - selections of a mapper: edges, other actors of the mapper, and new contexts;
 *  - mappers that actors share with followers, back faces or props of other renderers;
 *  - filters whose scalars may be translucent before they have run.
 */
void RemoveUndefined(Scenario& scene);
}

#endif
