// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLObjects.h
 * @brief How many OpenGL objects of each kind live in the context that is current.
 *
 * Every name up to a little beyond the newest one is tested (glIsTexture and the like). Names
 * that were generated and never bound are no objects yet. Sync objects have no names; the module
 * makes none.
 */
#ifndef GLObjects_h
#define GLObjects_h

#include <map>
#include <string>

namespace GLObjects
{
/// By kind: "textures", "buffers", "framebuffers", "renderbuffers", "vertex arrays", "queries",
/// "programs", "shaders".
using Counts = std::map<std::string, int>;

/// All commands are finished first.
Counts Count();
}

#endif
