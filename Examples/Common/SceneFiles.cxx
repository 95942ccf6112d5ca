// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFiles.h"

#include "Compressed.h"
#include "Imported.h"
#include "Parts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkGLTFImporter.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkOBJImporter.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
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

/// The ending in lower case, and of the file inside a .gz.
std::string GetEnding(const std::string& name)
{
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".gz" ? GetEnding(fs::path(name).stem().string()) : ending;
}

/// The file itself or, of a .gz, a decompressed copy that lives as long as this object.
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

/// The cells of `data` whose group is `group`, with the points that they use.
vtkSmartPointer<vtkPolyData> TakeGroup(
  vtkPolyData* data, const std::vector<vtkIdType>& cells, std::vector<vtkIdType>& newIds)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  points->SetDataType(data->GetPoints()->GetDataType());
  part->GetPointData()->CopyAllocate(data->GetPointData());
  std::vector<vtkIdType> used;
  std::vector<vtkIdType> polygon;
  for (vtkIdType cell : cells)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    data->GetPolys()->GetCellAtId(cell, count, ids);
    polygon.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      vtkIdType& newId = newIds[static_cast<std::size_t>(ids[i])];
      if (newId < 0)
      {
        newId = points->InsertNextPoint(data->GetPoint(ids[i]));
        part->GetPointData()->CopyData(data->GetPointData(), ids[i], newId);
        used.push_back(ids[i]);
      }
      polygon.push_back(newId);
    }
    polys->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  for (vtkIdType id : used)
  {
    newIds[static_cast<std::size_t>(id)] = -1;
  }
  part->SetPoints(points);
  part->SetPolys(polys);
  return part;
}

Actors ReadObj(const std::string& path)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
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
    if (data->GetNumberOfCells() == 0)
    {
      return Actors();
    }
    vtkNew<vtkOBJImporter> importer;
    importer->SetFileName(path.c_str());
    return ImportActors(importer);
  }
  Actors actors;
  std::vector<vtkIdType> newIds(static_cast<std::size_t>(data->GetNumberOfPoints()), -1);
  for (const auto& [group, cells] : cellsByGroup)
  {
    actors.push_back(MakeActor(TakeGroup(data, cells, newIds), actors.size()));
  }
  return actors;
}

template <class Reader>
Actors ReadSingle(const std::string& path, std::size_t index)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  Actors actors;
  if (reader->GetOutput()->GetNumberOfCells() > 0)
  {
    actors.push_back(MakeActor(reader->GetOutput(), index));
  }
  return actors;
}

template <class Reader>
Actors ReadComposite(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
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

Actors ReadOne(const std::string& name, const std::string& ending, std::size_t index)
{
  const PlainFile file(name);
  const std::string path = file.GetPath();
  if (ending == ".obj")
  {
    return ReadObj(path);
  }
  if (ending == ".stl")
  {
    return ReadSingle<vtkSTLReader>(path, index);
  }
  if (ending == ".ply")
  {
    return ReadSingle<vtkPLYReader>(path, index);
  }
  if (ending == ".vtm")
  {
    return ReadComposite<vtkXMLMultiBlockDataReader>(path);
  }
  if (ending == ".vtpc")
  {
    return ReadComposite<vtkXMLPartitionedDataSetCollectionReader>(path);
  }
  if (ending == ".wrl")
  {
    vtkNew<vtkVRMLImporter> importer;
    importer->SetFileName(path.c_str());
    return ImportActors(importer);
  }
  if (ending == ".glb" || ending == ".gltf")
  {
    vtkNew<vtkGLTFImporter> importer;
    importer->SetFileName(path.c_str());
    return ImportActors(importer);
  }
  throw std::runtime_error("cannot tell how to read " + name +
    ": known are .city, .osm, .pbf, .glb, .gltf, .obj, .wrl, .vtm, .vtpc, .stl and .ply");
}
}

Scene ImportFiles(const std::vector<std::string>& names, int upAxis,
  const std::function<void(const std::string&)>& progress)
{
  Scene scene;
  for (const std::string& name : names)
  {
    const std::string ending = GetEnding(name);
    if (names.size() > 1 && ending != ".stl" && ending != ".ply")
    {
      throw std::runtime_error(name + " is a scene by itself; only .stl and .ply go together");
    }
    if (progress)
    {
      progress("reading " + name);
    }
    const Actors actors = ReadOne(name, ending, scene.Actors.size());
    if (actors.empty())
    {
      FailEmpty(name);
    }
    scene.Actors.insert(scene.Actors.end(), actors.begin(), actors.end());
    const bool yUp = ending == ".glb" || ending == ".gltf" || ending == ".wrl";
    scene.UpAxis = upAxis >= 0 ? upAxis : (yUp ? 1 : 2);
    scene.Name += (scene.Name.empty() ? "" : " ") + fs::path(name).filename().string();
  }
  if (!scene.GetBounds().IsValid())
  {
    FailEmpty(scene.Name);
  }
  return scene;
}

} // namespace NBufferExamples
