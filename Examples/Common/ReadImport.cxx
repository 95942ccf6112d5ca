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
#include "vtkGLTFImporter.h"
#include "vtkNew.h"
#include "vtkOBJImporter.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVRMLImporter.h"

#include <map>

namespace NBufferExamples
{
namespace
{
template <class Importer>
void Import(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<Importer> importer;
  importer->SetFileName(path.c_str());
  for (vtkActor* actor : ImportActors(importer))
  {
    AddNamedPart(
      scene, actor, options.Title + ", part " + std::to_string(scene.Actors.size() + 1));
  }
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
  for (vtkPolyData* part : SplitMesh(data, numbers, count))
  {
    AddNamedPart(
      scene, part, options.Title + ", group " + std::to_string(scene.Actors.size() + 1));
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
  return { { ".obj", "Wavefront OBJ, a part for each group or material", ReadObj, z },
    { ".wrl", "VRML 2.0", Import<vtkVRMLImporter>, y },
    { ".vrml", "VRML 2.0", Import<vtkVRMLImporter>, y },
    { ".3ds", "3D Studio", Import<vtk3DSImporter>, z },
    { ".glb", "glTF 2.0", Import<vtkGLTFImporter>, y },
    { ".gltf", "glTF 2.0", Import<vtkGLTFImporter>, y } };
}

} // namespace NBufferExamples
