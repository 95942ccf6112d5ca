// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneKinds.h"

#include "Compressed.h"
#include "Parts.h"

#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExtractCells.h"
#include "vtkGLTFImporter.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkOBJImporter.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSTLReader.h"
#include "vtkVRMLImporter.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
namespace fs = std::filesystem;
using Actors = std::vector<vtkSmartPointer<vtkActor>>;

[[noreturn]] void FailEmpty(const std::string& name)
{
  throw std::runtime_error(
    name + ": nothing to draw was read; messages of VTK above, if any, say why");
}

/// Returns the ending of a name in lower case; of a .gz, that of the file inside.
std::string GetEnding(const std::string& name)
{
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".gz" ? GetEnding(fs::path(name).stem().string()) : ending;
}

/// A file or, if it is a .gz, a decompressed copy that lives as long as this object.
class PlainFile
{
public:
  explicit PlainFile(const std::string& name)
    : Path(name)
  {
    std::ifstream test(name, std::ios::binary);
    if (!test || fs::is_directory(name))
    {
      throw std::runtime_error("cannot open " + name);
    }
    if (fs::path(name).extension() != ".gz")
    {
      return;
    }
    const std::string contents = ReadMaybeCompressed(name);
    std::random_device random;
    this->Folder = fs::temp_directory_path() / ("nbuffer-" + std::to_string(random()));
    fs::create_directory(this->Folder);
    this->Path = this->Folder / fs::path(name).stem();
    std::ofstream file(this->Path, std::ios::binary);
    file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    if (!file.flush())
    {
      throw std::runtime_error("cannot write " + this->Path.string() + " to decompress " + name);
    }
  }
  ~PlainFile()
  {
    std::error_code ignored;
    if (!this->Folder.empty())
    {
      fs::remove_all(this->Folder, ignored);
    }
  }
  PlainFile(const PlainFile&) = delete;
  void operator=(const PlainFile&) = delete;

  std::string GetPath() const { return this->Path.string(); }

private:
  fs::path Path;
  fs::path Folder;
};

/// Parts without colours of their own get one each.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data, std::size_t index)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(MakePartMapper(data));
  PaintPart(actor, index, 0.85);
  return actor;
}

/// Returns some cells of a mesh with the points that they use.
vtkSmartPointer<vtkPolyData> ExtractCells(vtkPolyData* data, const std::vector<vtkIdType>& cells)
{
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellIds(cells.data(), static_cast<vtkIdType>(cells.size()));
  vtkNew<vtkGeometryFilter> surface;
  surface->SetInputConnection(extract->GetOutputPort());
  surface->Update();
  return surface->GetOutput();
}

/// Returns a reader that has read a file.
template <class Reader>
vtkSmartPointer<Reader> Read(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader;
}

template <class Importer>
Actors Import(const std::string& path, std::size_t = 0)
{
  vtkNew<Importer> importer;
  importer->SetFileName(path.c_str());
  return ImportActors(importer);
}

Actors ReadObj(const std::string& path, std::size_t)
{
  const auto reader = Read<vtkOBJReader>(path);
  vtkPolyData* data = reader->GetOutput();
  vtkDataArray* groups = data->GetCellData()->GetArray("GroupIds");
  std::map<int, std::vector<vtkIdType>> cellsByGroup;
  // Lines and points come first in the cell data and have no groups.
  if (groups && groups->GetNumberOfTuples() == data->GetNumberOfPolys())
  {
    for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
    {
      cellsByGroup[static_cast<int>(groups->GetTuple1(cell))].push_back(cell);
    }
  }
  if (cellsByGroup.size() < 2)
  {
    return data->GetNumberOfCells() == 0 ? Actors() : Import<vtkOBJImporter>(path);
  }
  Actors actors;
  for (const auto& [group, cells] : cellsByGroup)
  {
    actors.push_back(MakeActor(ExtractCells(data, cells), actors.size()));
  }
  return actors;
}

template <class Reader>
Actors ReadSingle(const std::string& path, std::size_t index)
{
  const auto reader = Read<Reader>(path);
  Actors actors;
  if (reader->GetOutput()->GetNumberOfCells() > 0)
  {
    actors.push_back(MakeActor(reader->GetOutput(), index));
  }
  return actors;
}

template <class Reader>
Actors ReadComposite(const std::string& path, std::size_t)
{
  const auto reader = Read<Reader>(path);
  Actors actors;
  auto* composite = vtkCompositeDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!composite)
  {
    return actors;
  }
  const auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(leaf);
    if (!surface)
    {
      vtkNew<vtkGeometryFilter> filter;
      filter->SetInputData(leaf);
      filter->Update();
      surface = filter->GetOutput();
    }
    if (surface->GetNumberOfCells() > 0)
    {
      actors.push_back(MakeActor(surface, actors.size()));
    }
  }
  return actors;
}

/// Reads a file whose first part has a number in the scene.
using Reader = Actors (*)(const std::string& path, std::size_t number);
const std::map<std::string, Reader> Readers = { { ".obj", ReadObj },
  { ".stl", ReadSingle<vtkSTLReader> }, { ".ply", ReadSingle<vtkPLYReader> },
  { ".vtm", ReadComposite<vtkXMLMultiBlockDataReader> },
  { ".vtpc", ReadComposite<vtkXMLPartitionedDataSetCollectionReader> },
  { ".wrl", Import<vtkVRMLImporter> }, { ".glb", Import<vtkGLTFImporter> },
  { ".gltf", Import<vtkGLTFImporter> } };

Actors ReadOne(const std::string& name, const std::string& ending, std::size_t number)
{
  const PlainFile file(name);
  const auto reader = Readers.find(ending);
  if (reader == Readers.end())
  {
    std::string message = "cannot tell how to read " + name + ": known are .city";
    for (const auto& known : Readers)
    {
      message += " " + known.first;
    }
    throw std::runtime_error(message);
  }
  return reader->second(file.GetPath(), number);
}
}

Actors ImportActors(vtkImporter* importer)
{
  // The window is only a place for the importer to put its actors; it never gets a context.
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();
  Actors actors;
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

Scene ImportFiles(const std::vector<std::string>& names, const Progress& progress)
{
  Scene scene;
  for (const std::string& name : names)
  {
    const std::string ending = GetEnding(name);
    if (names.size() > 1 && ending != ".stl" && ending != ".ply")
    {
      throw std::runtime_error(name + " is a scene by itself; only .stl and .ply go together");
    }
    progress("reading " + name);
    const Actors actors = ReadOne(name, ending, scene.Actors.size());
    if (actors.empty())
    {
      FailEmpty(name);
    }
    scene.Actors.insert(scene.Actors.end(), actors.begin(), actors.end());
    const bool yUp = ending == ".glb" || ending == ".gltf" || ending == ".wrl";
    scene.UpAxis = yUp ? 1 : 2;
    scene.Name += (scene.Name.empty() ? "" : " ") + fs::path(name).filename().string();
  }
  if (!scene.GetBounds().IsValid())
  {
    FailEmpty(scene.Name);
  }
  return scene;
}

} // namespace NBufferExamples
