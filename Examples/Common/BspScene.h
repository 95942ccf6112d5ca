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

/// How a map is cut into actors.
enum class BspParts
{
  Faces,
  /// All faces that lie in a cluster; those that lie in several go with the first.
  Clusters
};

/// ".bsp", ".bsp.gz", or one of these and ":faces" or ":clusters".
bool IsBspName(const std::string& name);

/**
 * Everything is drawn opaque and from both sides, the sky as well; flares are left out, and patches
 * are quads of 4 x 4 for each piece. z is up, a unit about 2.5 cm.
 *
 * Its path "walk": at the eyes of a player who walks from the players' starts, 12 units a frame,
 * and turns at opaque walls; always 16 units from them, so that the near plane at 4 cuts none.
 */
Scene LoadBsp(const std::string& name);

} // namespace NBufferExamples

#endif
