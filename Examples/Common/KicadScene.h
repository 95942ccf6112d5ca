// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KicadScene.h
 * @brief Printed boards with their parts as actors: one of them, or a cage full.
 *
 * Models are those that KiCad names, in VRML, read by vtkVRMLImporter. They are looked for in
 * kicad-3dmodels next to the board or its folder, in the folder that the environment's
 * KICAD6_3DMODEL_DIR names, and where Debian's kicad-packages3d puts them. Millimetres.
 */
#ifndef KicadScene_h
#define KicadScene_h

#include "Scene.h"

#include <string>

namespace NBufferExamples
{

/// A .kicad_pcb, or a folder with some in it or in its folder "boards", perhaps with :actors
/// behind.
bool IsKicadName(const std::string& name);

/**
 * A file: the board lying, and each of the many actors that VTK's importer makes of a part, z up;
 * path "over". A folder: a cage of 80 boards 22 mm apart, the folder's boards by turns, one actor
 * for each part, y up; paths "outside" and "between". With :actors behind the folder's name all
 * that the importer makes of each part, some hundred thousand actors. Parts whose model is missing
 * or cannot be read are left out, and a line says how many. Throws std::runtime_error if there is
 * no part at all.
 */
Scene LoadKicad(const std::string& name, const std::function<void(const std::string&)>& progress);

} // namespace NBufferExamples

#endif
