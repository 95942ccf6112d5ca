// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SceneKinds.h
 * @brief The kinds of scenes, apart from the city, that LoadScene() chooses from. Each is made in a
 * file of its own.
 */
#ifndef SceneKinds_h
#define SceneKinds_h

#include "Scene.h"

class vtkImporter;
class vtkPolyData;

namespace NBufferExamples
{

using Progress = std::function<void(const std::string&)>;

/**
 * Makes a synthetic plant of 120 m by 70 m, z up, in metres: racks of pipes, tanks, vessels and
 * steel, every part an actor. It is a stress test of many thin parts that hide each other by their
 * number, where no single part hides much. The same seed gives the same plant. The scene has the
 * paths "inside", along the aisle under the pipes at 1.7 m, and "around", once around the plant at
 * 25 m.
 */
Scene MakePlant(std::uint64_t seed);

/// Makes an actor of a mesh that does not change.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data, const glm::dvec3& color);

/// Makes a path whose poses `look` returns by the number of the frame, from 0 on, and the number of
/// frames of the path.
Scene::PathMaker MakePathOf(std::function<CameraPose(int frame, int frames)> look);

/// Makes an isosurface of 0.9 million triangles that fills a cube, with the paths "outside", around
/// it, and "inside", through its channels.
Scene MakeIsosurface();

/// Makes points, in no order, behind a wall that hides all of them.
Scene MakePointsBehindWall(int count);

/// Makes hills of half a million triangles, row by row, with the paths "eye-height", at the height
/// of the eyes, and "above", from where nothing is hidden. If `points` is not 0, there are so many
/// points just above the ground, in no order.
Scene MakeTerrain(int points);

/**
 * Makes cubes, instances of one vtkGlyph3DMapper: "glyph-wall" behind a wall that hides
 * almost all of them, "glyph-cloud" as a dense cloud, or "glyph-open" as a layer seen from above,
 * of which nothing is hidden.
 */
Scene MakeGlyphs(const std::string& name, int count);

/// Makes 64 spheres, each inside a larger one whose radius it has to 50 to 95 %. The N-buffer paper
/// (Decoret 2005, section 3.1) expects that the inner spheres are not found hidden.
Scene MakeSpheresInSpheres();

/// Makes 96 crowns of 4,000 small leaves in front of 400 cubes. The same section expects that the
/// leaves hide the cubes together.
Scene MakeForest();

/// Returns whether a name ends with .bsp or .bsp.gz, or with one of these and ":faces" or
/// ":clusters".
bool IsBspName(const std::string& name);

/**
 * Loads a map (BspMap.h) as actors. With ":faces" (the default) each face is an actor. With
 * ":clusters" all faces of a cluster are one actor; a face that lies in several clusters belongs to
 * the first one.
 *
 * Everything is drawn opaque and from both sides, including the sky. Flares are left out, and each
 * piece of a patch is drawn as 4 x 4 quads. z points up; a unit is about 2.5 cm.
 *
 * The scene has the path "walk": the camera is at the eyes of a player who walks from the players'
 * starts, 12 units a frame, and turns at opaque walls. It stays 16 units away from them, so that
 * the near plane at 4 units cuts none.
 */
Scene LoadBsp(const std::string& name);

/// Returns whether a name is that of a .kicad_pcb file, or of a folder that has such files in it or
/// in its folder "boards", perhaps followed by ":actors".
bool IsKicadName(const std::string& name);

/**
 * Loads a printed board with its parts as actors, or a cage full of boards.
 *
 *     name              scene                                               up  paths
 *     a file            one board with all actors that VTK's importer       z   over
 *                       makes of its parts
 *     a folder          a cage of 80 boards, 22 mm apart, the boards of     y   outside, between
 *                       the folder by turns; one actor for each part
 *     a folder:actors   the same cage with all actors that the importer     y   outside, between
 *                       makes, some hundred thousand
 *
 * vtkVRMLImporter reads the models that the boards name, in VRML. The models are searched in the
 * folder kicad-3dmodels next to the board or its folder, in the folder that the environment
 * variable KICAD6_3DMODEL_DIR names, and in the folder of Debian's kicad-packages3d. Lengths are
 * millimetres.
 *
 * Parts whose model is missing or cannot be read are left out, and `progress` gets their number.
 * Throws std::runtime_error if no part is left.
 */
Scene LoadKicad(const std::string& name, const Progress& progress);

/// Returns the actors that an importer, which has the name of its file, makes of the file.
std::vector<vtkSmartPointer<vtkActor>> ImportActors(vtkImporter* importer);

/**
 * Reads one file, or several of the formats of which several make one scene (FileFormats.h). An
 * .obj file becomes an actor per group if it has several groups, else an actor per material. With
 * `splitRegions` a file with one mesh becomes an actor per connected region. `progress` is called
 * with what is being done. Throws std::runtime_error with the name of the file and the cause.
 */
Scene ImportFiles(
  const std::vector<std::string>& names, bool splitRegions, const Progress& progress);

} // namespace NBufferExamples

#endif
