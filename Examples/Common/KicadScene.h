// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KicadScene.h
 * @brief Printed boards with their parts as actors: one board, or a cage full of them.
 *
 * vtkVRMLImporter reads the models that the boards name, in VRML. The models are searched in the
 * folder kicad-3dmodels next to the board or its folder, in the folder that the environment
 * variable KICAD6_3DMODEL_DIR names, and in the folder of Debian's kicad-packages3d. Lengths are
 * millimetres.
 */
#ifndef KicadScene_h
#define KicadScene_h

#include "Scene.h"

#include <string>

namespace NBufferExamples
{

/// Returns whether a name is that of a .kicad_pcb file, or of a folder that has such files in it or
/// in its folder "boards", perhaps followed by ":actors".
bool IsKicadName(const std::string& name);

/**
 * Loads a board or a cage.
 *
 *     name              scene                                               up  paths
 *     a file            one board with all actors that VTK's importer       z   over
 *                       makes of its parts
 *     a folder          a cage of 80 boards, 22 mm apart, the boards of     y   outside, between
 *                       the folder by turns; one actor for each part
 *     a folder:actors   the same cage with all actors that the importer     y   outside, between
 *                       makes, some hundred thousand
 *
 * Parts whose model is missing or cannot be read are left out, and `progress` gets their number.
 * Throws std::runtime_error if no part is left.
 */
Scene LoadKicad(const std::string& name, const std::function<void(const std::string&)>& progress);

} // namespace NBufferExamples

#endif
