// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneFiles.h
 * @brief Scenes of files that VTK's readers and importers read.
 */
#ifndef SceneFiles_h
#define SceneFiles_h

#include "Scene.h"

#include <functional>
#include <string>
#include <vector>

class vtkImporter;

namespace NBufferExamples
{

/// Returns the actors that an importer, which has the name of its file, makes of the file.
std::vector<vtkSmartPointer<vtkActor>> ImportActors(vtkImporter* importer);

/**
 * Reads one file, or several .stl or .ply files. An .obj file becomes an actor per group if it has
 * several groups, else an actor per material. The axis y points up in .glb, .gltf and .wrl, z in
 * all others. `progress`, if given, is called with what is being done. Throws std::runtime_error
 * with the name of the file and the cause.
 */
Scene ImportFiles(
  const std::vector<std::string>& names, const std::function<void(const std::string&)>& progress);

} // namespace NBufferExamples

#endif
