// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLObjects.h
 * @brief Counts the OpenGL objects of each kind in the current context.
 *
 * Every name up to 4096 beyond the newest one is tested by glIsTexture() and the like. A name that
 * was generated and never bound is not an object yet. Sync objects are not counted, because they
 * have no names; the module makes none.
 */
#ifndef GLObjects_h
#define GLObjects_h

#include <map>
#include <string>

namespace GLObjects
{
/// The numbers of objects by kind: "textures", "buffers", "framebuffers", "renderbuffers", "vertex
/// arrays", "queries", "programs", "shaders".
using Counts = std::map<std::string, int>;

/// Waits until the device has finished all commands, and counts.
Counts Count();
}

#endif
