// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadData.cxx
 * @brief Files of data: meshes, grids, and trees of them, read by VTK.
 */
#include "FileFormats.h"
#include "MeshParts.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeometryFilter.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkStringArray.h"
#include "vtkXMLGenericDataObjectReader.h"

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
/// More regions than this are no parts that somebody made: such a mesh stays whole.
constexpr int MaximumNumberOfRegions = 100000;

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

void AddMesh(vtkPolyData* mesh, const ReadOptions& options, Scene& scene)
{
  int regions = 1;
  std::vector<int> numbers;
  if (options.SplitRegions)
  {
    numbers = FindRegions(mesh, regions);
  }
  if (regions < 2 || regions > MaximumNumberOfRegions)
  {
    AddNamedPart(scene, mesh, options.Title);
    return;
  }
  int number = 0;
  for (vtkPolyData* part : SplitMesh(mesh, numbers, regions))
  {
    AddNamedPart(scene, part,
      options.Title + ", region " + std::to_string(++number) + " of " + std::to_string(regions));
  }
}

/// Returns the name of a leaf of a tree: that in the tree, its name in CityGML, or a number.
std::string GetLeafName(vtkCompositeDataIterator* leaf, const ReadOptions& options)
{
  vtkInformation* about = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
  const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
  if (name && *name)
  {
    return name;
  }
  vtkFieldData* fields = leaf->GetCurrentDataObject()->GetFieldData();
  const auto* ids =
    fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray("gml_id")) : nullptr;
  if (ids && ids->GetNumberOfValues() > 0)
  {
    return const_cast<vtkStringArray*>(ids)->GetValue(0);
  }
  return options.Title + ", block " + std::to_string(leaf->GetCurrentFlatIndex());
}

void AddData(vtkDataObject* data, const ReadOptions& options, Scene& scene)
{
  if (auto* tree = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaf = vtk::TakeSmartPointer(tree->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        AddNamedPart(
          scene, MakeSurface(leaf->GetCurrentDataObject()), GetLeafName(leaf, options));
      }
    }
  }
  else if (vtkDataSet::SafeDownCast(data))
  {
    AddMesh(MakeSurface(data), options, scene);
  }
}

template <class Reader>
void Read(const std::string& path, const ReadOptions& options, Scene& scene)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  AddData(reader->GetOutputDataObject(0), options, scene);
}
}

std::vector<FileFormat> GetDataFormats()
{
  constexpr int z = 2;
  std::vector<FileFormat> formats = { { ".stl", "STL", Read<vtkSTLReader>, z, true },
    { ".ply", "PLY", Read<vtkPLYReader>, z, true },
    { ".vtk", "VTK's legacy format", Read<vtkGenericDataObjectReader>, z, true } };
  for (const char* ending : { ".vtp", ".vtu", ".vts", ".vtr", ".vti" })
  {
    const bool isImage = std::string(ending) == ".vti";
    formats.push_back({ ending, isImage ? "VTK's XML, the faces of the box" : "VTK's XML",
      Read<vtkXMLGenericDataObjectReader>, z, true });
  }
  for (const char* ending : { ".vtm", ".vtpc" })
  {
    formats.push_back({ ending, "VTK's XML, a part for each block",
      Read<vtkXMLGenericDataObjectReader>, z, false });
  }
#ifdef NBUFFER_HAS_HDF
  formats.push_back({ ".vtkhdf", "VTK's HDF", Read<vtkHDFReader>, z, true });
#endif
#ifdef NBUFFER_HAS_CITYGML
  for (const char* ending : { ".gml", ".citygml" })
  {
    formats.push_back({ ending, "CityGML", Read<vtkCityGMLReader>, z, false });
  }
#endif
  return formats;
}

} // namespace NBufferExamples
