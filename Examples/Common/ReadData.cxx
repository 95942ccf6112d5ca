// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadData.cxx
 * @brief Files of data: meshes, grids, and trees of them, read by VTK.
 */
#include "FileCheck.h"
#include "FileFormats.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeometryFilter.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkStringArray.h"
#include "vtkXMLGenericDataObjectReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"

#ifdef NBUFFER_HAS_CITYGML
#include "vtkCityGMLReader.h"
#endif
#ifdef NBUFFER_HAS_HDF
#include "vtkHDFReader.h"
#endif

#include <string>

namespace NBufferExamples
{
namespace
{
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataObject* data)
{
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    vtkNew<vtkGeometryFilter> filter;
    filter->SetInputData(data);
    filter->Update();
    surface = filter->GetOutput();
  }
  return surface;
}

/// Returns the name of a child of a tree, or that of the tree, with a number if it has several.
template <class Tree>
std::string GetName(Tree* tree, unsigned int number, unsigned int count, const std::string& above)
{
  vtkInformation* about = tree->HasMetaData(number) ? tree->GetMetaData(number) : nullptr;
  const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : count > 1 ? above + ", block " + std::to_string(number) : above;
}

/// Returns the name of an object of CityGML, or the name that it has in the tree.
std::string GetCityName(vtkDataObject* data, const std::string& usual)
{
  vtkFieldData* fields = data->GetFieldData();
  auto* ids = fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray("gml_id")) : nullptr;
  return ids && ids->GetNumberOfValues() > 0 ? std::string(ids->GetValue(0)) : usual;
}

/// Adds the leaves of a tree, each under the name of the nearest node above it that has one.
void AddTree(vtkDataObject* node, const std::string& usual, Scene& scene)
{
  if (!node)
  {
    return;
  }
  const std::string name = GetCityName(node, usual);
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
  {
    const unsigned int count = blocks->GetNumberOfBlocks();
    for (unsigned int i = 0; i < count; ++i)
    {
      AddTree(blocks->GetBlock(i), GetName(blocks, i, count, name), scene);
    }
  }
  else if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(node))
  {
    const unsigned int count = sets->GetNumberOfPartitionedDataSets();
    for (unsigned int i = 0; i < count; ++i)
    {
      AddTree(sets->GetPartitionedDataSet(i), GetName(sets, i, count, name), scene);
    }
  }
  else if (auto* tree = vtkCompositeDataSet::SafeDownCast(node))
  {
    // Pieces of one thing, or a tree without names.
    const auto leaf = vtk::TakeSmartPointer(tree->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      AddTree(leaf->GetCurrentDataObject(), name, scene);
    }
  }
  else if (vtkDataSet::SafeDownCast(node))
  {
    AddNamedPart(scene, MakeSurface(node), name);
  }
}

void AddData(vtkDataObject* data, const ReadOptions& options, Scene& scene)
{
  if (vtkDataSet::SafeDownCast(data))
  {
    AddMesh(scene, MakeSurface(data), options);
  }
  else
  {
    AddTree(data, options.Title, scene);
  }
}

template <class Reader>
void Read(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  options.Messages.Check();
  AddData(reader->GetOutputDataObject(0), options, scene);
}

void ReadPly(const std::string& path, const ReadOptions& options, Scene& scene)
{
  CheckPly(path);
  Read<vtkPLYReader>(path, options, scene);
}

void ReadLegacy(const std::string& path, const ReadOptions& options, Scene& scene)
{
  CheckLegacy(path);
  Read<vtkGenericDataObjectReader>(path, options, scene);
}

#ifdef NBUFFER_HAS_CITYGML
/// Reads the finest level of detail in which something can be drawn: the reader reads one at a
/// time.
void ReadCityModel(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<vtkCityGMLReader> reader;
  reader->SetFileName(path.c_str());
  for (int level = 4; level >= 0 && scene.Actors.empty(); --level)
  {
    reader->SetLOD(level);
    reader->Update();
    AddData(reader->GetOutputDataObject(0), options, scene);
  }
}
#endif
}

std::vector<FileFormat> GetDataFormats()
{
  constexpr int z = 2;
  std::vector<FileFormat> formats = { { ".stl", "STL", Read<vtkSTLReader>, z, true },
    { ".ply", "PLY", ReadPly, z, true }, { ".vtk", "VTK's legacy format", ReadLegacy, z, true } };
  for (const char* ending : { ".vtp", ".vtu", ".vts", ".vtr", ".vti" })
  {
    const bool isImage = std::string(ending) == ".vti";
    formats.push_back({ ending, isImage ? "VTK's XML, the faces of the box" : "VTK's XML",
      Read<vtkXMLGenericDataObjectReader>, z, true });
  }
  const char* kind = "VTK's XML, a part for each block";
  formats.push_back({ ".vtm", kind, Read<vtkXMLMultiBlockDataReader>, z, false });
  formats.push_back({ ".vtpc", kind, Read<vtkXMLPartitionedDataSetCollectionReader>, z, false });
#ifdef NBUFFER_HAS_HDF
  formats.push_back({ ".vtkhdf", "VTK's HDF", Read<vtkHDFReader>, z, true });
#endif
#ifdef NBUFFER_HAS_CITYGML
  for (const char* ending : { ".gml", ".citygml" })
  {
    formats.push_back({ ending, "CityGML, its finest level of detail", ReadCityModel, z, false });
  }
#endif
  return formats;
}

} // namespace NBufferExamples
