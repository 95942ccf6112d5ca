// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileFormats.h"

#include "MeshParts.h"
#include "Parts.h"

#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace NBufferExamples
{
namespace
{
/// More regions than this are no parts that somebody made: such a mesh stays whole.
constexpr int MaximumNumberOfRegions = 100000;

std::vector<FileFormat> MakeFormats()
{
  std::vector<FileFormat> formats = { { ".city", "city of Scripts/make-city.py", {} },
    { ".bsp", "map of Quake III Arena or OpenArena", {} },
    { ".kicad_pcb", "printed board of KiCad, or a folder of them", {} } };
  // The first reader of an ending is used: VTK's own before assimp's.
  for (const std::vector<FileFormat>& more :
    { GetImportFormats(), GetDataFormats(), GetAssimpFormats() })
  {
    for (const FileFormat& format : more)
    {
      const bool isKnown = std::any_of(formats.begin(), formats.end(),
        [&format](const FileFormat& other) { return other.Ending == format.Ending; });
      if (!isKnown)
      {
        formats.push_back(format);
      }
    }
  }
  std::sort(formats.begin(), formats.end(),
    [](const FileFormat& a, const FileFormat& b) { return a.Ending < b.Ending; });
  return formats;
}
}

const std::vector<FileFormat>& GetFileFormats()
{
  static const std::vector<FileFormat> formats = MakeFormats();
  return formats;
}

const FileFormat* FindFileFormat(const std::string& ending)
{
  const std::vector<FileFormat>& formats = GetFileFormats();
  const auto found = std::find_if(formats.begin(), formats.end(),
    [&ending](const FileFormat& format) { return format.Ending == ending; });
  return found == formats.end() ? nullptr : &*found;
}

std::string ListEndings(bool onlyParts)
{
  std::string list;
  for (const FileFormat& format : GetFileFormats())
  {
    if (format.IsPart || !onlyParts)
    {
      list += (list.empty() ? "" : " ") + format.Ending;
    }
  }
  return list;
}

void AddNamedPart(Scene& scene, vtkPolyData* mesh, const std::string& name)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    return;
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(MakePartMapper(mesh));
  PaintPart(actor, scene.Actors.size(), 0.85);
  AddNamedPart(scene, actor, name);
}

void AddNamedPart(Scene& scene, vtkActor* actor, const std::string& name)
{
  scene.Actors.emplace_back(actor);
  scene.PartNames.push_back(name);
}

void AddMesh(Scene& scene, vtkPolyData* mesh, const ReadOptions& options)
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

void AddParts(Scene& scene, const Scene& parts, const ReadOptions& options)
{
  Scene regions;
  if (parts.Actors.size() == 1 && options.SplitRegions)
  {
    vtkActor* whole = parts.Actors.front();
    auto* mesh = vtkPolyData::SafeDownCast(whole->GetMapper()->GetInputDataObject(0, 0));
    if (mesh)
    {
      AddMesh(regions, mesh, options);
    }
    for (vtkActor* region : regions.Actors)
    {
      vtkNew<vtkMatrix4x4> place;
      place->DeepCopy(whole->GetMatrix());
      region->SetUserMatrix(place);
      if (whole->GetTexture())
      {
        region->SetProperty(whole->GetProperty());
        region->SetTexture(whole->GetTexture());
      }
    }
  }
  const Scene& chosen = regions.Actors.size() > 1 ? regions : parts;
  for (std::size_t i = 0; i < chosen.Actors.size(); ++i)
  {
    AddNamedPart(scene, chosen.Actors[i], chosen.PartNames[i]);
  }
}

} // namespace NBufferExamples
