// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneFiles.h
 * @brief Many actors from the files that VTK reads or imports.
 */
#ifndef SceneFiles_h
#define SceneFiles_h

#include "Scene.h"

namespace NBufferExamples
{

/**
 * As LoadScene, for files other than cities. `upAxis` is -1 for what is usual: y for .glb, .gltf
 * and .wrl, z for the others. An .obj file becomes an actor per group if it has several groups,
 * else one per material.
 */
Scene ImportFiles(const std::vector<std::string>& names, int upAxis,
  const std::function<void(const std::string&)>& progress);

} // namespace NBufferExamples

#endif
