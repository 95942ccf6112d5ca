// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BspScene.h
 * @brief A map as actors, with ways through it and its compiler's table of visibility.
 */
#ifndef BspScene_h
#define BspScene_h

#include "Scene.h"

#include <string>

namespace NBufferExamples
{

/// Returns whether a name ends with .bsp or .bsp.gz, or with one of these and ":faces" or
/// ":clusters".
bool IsBspName(const std::string& name);

/**
 * Loads a map. With ":faces" (the default) each face is an actor. With ":clusters" all faces of a
 * cluster are one actor; a face that lies in several clusters belongs to the first one.
 *
 * Everything is drawn opaque and from both sides, including the sky. Flares are left out, and each
 * piece of a patch is drawn as 4 x 4 quads. z points up; a unit is about 2.5 cm.
 *
 * The scene has the path "walk": the camera is at the eyes of a player who walks from the players'
 * starts, 12 units a frame, and turns at opaque walls. It stays 16 units away from them, so that
 * the near plane at 4 units cuts none.
 */
Scene LoadBsp(const std::string& name);

} // namespace NBufferExamples

#endif
