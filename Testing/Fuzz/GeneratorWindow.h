// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GeneratorWindow.h
 * @brief The window, the renderers and the culler of random scenarios.
 */
#ifndef GeneratorWindow_h
#define GeneratorWindow_h

#include "Writer.h"

namespace TestScene
{
void MakeWindow(Writer& writer);
void MakeCuller(Writer& writer);
/// Makes one renderer, or sometimes two, of scenes whose props and views are complete.
void MakeRenderers(Writer& writer);
}

#endif
