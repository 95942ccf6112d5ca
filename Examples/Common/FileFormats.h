// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileFormats.h
 * @brief The one list of the files that this build reads, by their endings.
 *
 * Some readers are only in some builds of VTK, or need assimp. GetFileFormats() has what this
 * program was built with, so that help and messages never name a format that is not read.
 */
#ifndef FileFormats_h
#define FileFormats_h

#include "ReaderMessages.h"
#include "Scene.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace NBufferExamples
{

/// What a reader needs to know in addition to the file.
struct ReadOptions
{
  /// What to call the file in the names of its parts.
  std::string Title;
  /// Whether a file that holds one mesh becomes an actor for each connected region of the mesh.
  bool SplitRegions = false;
  /// What the readers of VTK report.
  const ReaderMessages& Messages;
};

struct FileFormat
{
  /// Adds the parts of a file to a scene; throws std::runtime_error if the file is damaged or is
  /// not what its ending says. Errors that VTK reports may also be left to the caller.
  using Reader = std::function<void(const std::string& path, const ReadOptions&, Scene&)>;

  std::string Ending; ///< In lower case, with the dot.
  std::string Kind;   ///< What such a file is, in a few words.
  /// Empty for the kinds of SceneKinds.h, which LoadScene() recognises before it looks at endings.
  Reader Read;
  int UpAxis = 2; ///< The axis that points up in such files: 0, 1 or 2 for x, y or z.
  /// Whether several files of this kind make one scene.
  bool IsPart = false;
  /// Whether such a file names others, such as pictures, so that an error need not mean that
  /// something is wrong with the file itself. Otherwise files with errors are refused.
  bool NamesFiles = false;
};

/// Returns all formats, sorted by their endings.
const std::vector<FileFormat>& GetFileFormats();

/// Returns the format of an ending, or nullptr if it is not read.
const FileFormat* FindFileFormat(const std::string& ending);

/// Returns the endings of all formats, or of those of which several files make one scene, with
/// blanks between them.
std::string ListEndings(bool onlyParts = false);

///@{
/// Add an actor that draws a mesh, or what an importer has made, under a name. A mesh gets a
/// colour by its number in the scene. Meshes without cells are left out.
void AddNamedPart(Scene& scene, vtkPolyData* mesh, const std::string& name);
void AddNamedPart(Scene& scene, vtkActor* actor, const std::string& name);
///@}

/// Adds the one mesh of a file: as a part for each of its connected regions if the options say so,
/// else as one part.
void AddMesh(Scene& scene, vtkPolyData* mesh, const ReadOptions& options);

/// Adds the parts of a file. If there is only one, it is treated as by AddMesh(), at its place; its
/// regions get colours of their own unless it has a texture.
void AddParts(Scene& scene, const Scene& parts, const ReadOptions& options);

///@{
/// The lists of single libraries, from which GetFileFormats() is put together.
std::vector<FileFormat> GetDataFormats();   ///< VTK's readers of data.
std::vector<FileFormat> GetImportFormats(); ///< VTK's readers of scenes.
std::vector<FileFormat> GetAssimpFormats(); ///< Assimp's readers; empty in a build without assimp.
///@}

} // namespace NBufferExamples

#endif
