// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadImport.cxx
 * @brief Files of whole scenes, with parts and colours of their own, read by VTK's importers.
 */
#include "FileFormats.h"
#include "MeshParts.h"
#include "SceneKinds.h"

#include "vtk3DSImporter.h"
#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataAssembly.h"
#include "vtkGLTFImporter.h"
#include "vtkNew.h"
#include "vtkOBJImporter.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVRMLImporter.h"

#include <fstream>
#include <map>

namespace NBufferExamples
{
namespace
{
using Names = std::map<std::size_t, std::string>; ///< By the place of the actor.

/// Returns the names that the file has for its parts. Importers of old versions of VTK have no
/// hierarchy, and so no names; the other function is chosen for them.
template <class Importer>
auto GetNames(Importer* importer, int)
  -> decltype(static_cast<void>(importer->GetSceneHierarchy()), Names())
{
  Names names;
  vtkDataAssembly* tree = importer->GetSceneHierarchy();
  if (!tree)
  {
    return names;
  }
  for (int node : tree->GetChildNodes(vtkDataAssembly::GetRootNode(), true))
  {
    int actor = -1;
    if (tree->GetAttribute(node, "flat_actor_id", actor) && actor >= 0)
    {
      const char* usual =
        tree->GetAttributeOrDefault(node, "parent_node_name", tree->GetNodeName(node));
      names[static_cast<std::size_t>(actor)] = tree->GetAttributeOrDefault(node, "label", usual);
    }
  }
  return names;
}
template <class Importer>
Names GetNames(Importer*, long)
{
  return Names();
}

template <class Importer>
void Import(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<Importer> importer;
  importer->SetFileName(path.c_str());
  const std::vector<vtkSmartPointer<vtkActor>> actors = ImportActors(importer);
  Names names = GetNames(importer.Get(), 0);
  Scene parts;
  for (std::size_t i = 0; i < actors.size(); ++i)
  {
    const std::string& name = names[i];
    AddNamedPart(
      parts, actors[i], name.empty() ? options.Title + ", part " + std::to_string(i + 1) : name);
  }
  AddParts(scene, parts, options);
}

/// Returns the names of the groups of an .obj file: the rest of each line that begins with g.
std::vector<std::string> ReadGroupNames(const std::string& path)
{
  std::vector<std::string> names;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, 2, "g ") == 0)
    {
      line.erase(0, line.find_first_not_of(' ', 1));
      line.erase(line.find_last_not_of(" \r\t") + 1);
      names.push_back(line);
    }
  }
  return names;
}

void ReadObj(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  vtkDataArray* groups = data->GetCellData()->GetArray("GroupIds");
  std::map<int, int> parts; // From the number of a group to that of its part.
  std::vector<int> numbers(static_cast<std::size_t>(data->GetNumberOfCells()), -1);
  // Points and lines come before the polygons, and only polygons have groups.
  const vtkIdType first = data->GetNumberOfCells() - data->GetNumberOfPolys();
  if (groups && groups->GetNumberOfTuples() == data->GetNumberOfPolys())
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
    {
      parts.emplace(static_cast<int>(groups->GetTuple1(cell)), 0);
    }
    int count = 0;
    for (auto& part : parts)
    {
      part.second = count++;
    }
    for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
    {
      numbers[static_cast<std::size_t>(first + cell)] =
        parts[static_cast<int>(groups->GetTuple1(cell))];
    }
  }
  if (parts.size() < 2)
  {
    if (data->GetNumberOfCells() > 0)
    {
      Import<vtkOBJImporter>(path, options, scene);
    }
    return;
  }
  const auto count = static_cast<int>(parts.size());
  const std::vector<vtkSmartPointer<vtkPolyData>> meshes = SplitMesh(data, numbers, count);
  const std::vector<std::string> names = ReadGroupNames(path);
  for (const auto& [group, part] : parts)
  {
    const bool isNamed = group >= 0 && group < static_cast<int>(names.size());
    AddNamedPart(scene, meshes[static_cast<std::size_t>(part)],
      isNamed ? names[static_cast<std::size_t>(group)]
              : options.Title + ", group " + std::to_string(group));
  }
}
}

std::vector<vtkSmartPointer<vtkActor>> ImportActors(vtkImporter* importer)
{
  // The window is only a place for the importer to put its actors; it never gets a context.
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();
  std::vector<vtkSmartPointer<vtkActor>> actors;
  if (vtkRenderer* filled = importer->GetRenderer())
  {
    vtkActorCollection* collection = filled->GetActors();
    collection->InitTraversal();
    while (vtkActor* actor = collection->GetNextActor())
    {
      actors.emplace_back(actor);
    }
    filled->RemoveAllViewProps();
  }
  return actors;
}

std::vector<FileFormat> GetImportFormats()
{
  constexpr int y = 1;
  constexpr int z = 2;
  return { { ".obj", "Wavefront OBJ, a part for each group or material", ReadObj, z, false, true },
    { ".wrl", "VRML 2.0", Import<vtkVRMLImporter>, y },
    { ".vrml", "VRML 2.0", Import<vtkVRMLImporter>, y },
    { ".3ds", "3D Studio", Import<vtk3DSImporter>, z },
    { ".glb", "glTF 2.0", Import<vtkGLTFImporter>, y, false, true },
    { ".gltf", "glTF 2.0", Import<vtkGLTFImporter>, y, false, true } };
}

} // namespace NBufferExamples
