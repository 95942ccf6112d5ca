// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleUnits.h"

#include "CompositeMapper.h"
#include "VisibleProps.h"
#include "vtkNBufferCuller.h"
#include "vtkNBufferUnits.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace NBufferBench
{
namespace
{
/// Makes an actor that draws a part of a large prop: the units of which these cells, or blocks by
/// their flat indices, own a pixel.
using PartMaker = std::function<vtkSmartPointer<vtkActor>(const std::set<vtkIdType>&)>;

/// A mesh that vtkNBufferCuller divides, and its units.
struct LargeMesh
{
  vtkActor* Actor = nullptr;
  vtkPolyData* Data = nullptr;
  vtkNBufferUnits::Mesh Mesh;
  vtkNBufferUnits Units;
  std::vector<std::size_t> UnitOfPrimitive;

  vtkSmartPointer<vtkActor> MakePart(const std::set<vtkIdType>& primitives) const
  {
    std::vector<unsigned char> drawn(this->Units.GetSize());
    for (const vtkIdType primitive : primitives)
    {
      drawn[this->UnitOfPrimitive[static_cast<std::size_t>(primitive)]] = 1;
    }
    std::vector<unsigned int> indices;
    this->Units.GetIndices(drawn, this->Mesh.Indices, indices);
    vtkNew<vtkCellArray> cells;
    const auto corners = static_cast<vtkIdType>(this->Mesh.Corners);
    cells->AllocateExact(
      static_cast<vtkIdType>(indices.size()) / corners, static_cast<vtkIdType>(indices.size()));
    std::vector<vtkIdType> cell(this->Mesh.Corners);
    for (std::size_t i = 0; i < indices.size(); i += this->Mesh.Corners)
    {
      std::copy_n(
        indices.begin() + static_cast<std::ptrdiff_t>(i), this->Mesh.Corners, cell.begin());
      cells->InsertNextCell(corners, cell.data());
    }
    vtkNew<vtkPolyData> part;
    part->ShallowCopy(this->Data);
    part->SetVerts(corners == 1 ? cells.Get() : nullptr);
    part->SetPolys(corners == 3 ? cells.Get() : nullptr);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->ShallowCopy(this->Actor->GetMapper());
    mapper->SetInputData(part);
    mapper->SetStatic(true);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->ShallowCopy(this->Actor);
    actor->SetMapper(mapper);
    return actor;
  }
};

/// Only one list of triangles or of points is divided.
vtkCellArray* GetOnlyCells(vtkPolyData* data)
{
  const vtkIdType count = data->GetNumberOfCells();
  vtkCellArray* cells = data->GetNumberOfVerts() == count ? data->GetVerts() : data->GetPolys();
  const int corners = cells == data->GetVerts() ? 1 : 3;
  return cells->GetNumberOfCells() == count && cells->IsHomogeneous() == corners ? cells : nullptr;
}

PartMaker MakeMeshMaker(vtkActor* actor, vtkPolyData* data, std::size_t unitSize)
{
  vtkCellArray* cells = GetOnlyCells(data);
  if (!cells)
  {
    return nullptr;
  }
  auto found = std::make_shared<LargeMesh>();
  found->Actor = actor;
  found->Data = data;
  found->Mesh.Corners = static_cast<std::size_t>(cells->IsHomogeneous());
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    found->Mesh.Indices.insert(found->Mesh.Indices.end(), points, points + size);
  }
  found->Mesh.Points.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < found->Mesh.Points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), glm::value_ptr(found->Mesh.Points[i]));
  }
  found->Units = vtkNBufferUnits::Make(found->Mesh, unitSize);
  found->UnitOfPrimitive = found->Units.GetUnitsOfPrimitives();
  return [found](const std::set<vtkIdType>& primitives) { return found->MakePart(primitives); };
}

PartMaker MakeBlockMaker(vtkActor* actor, vtkMultiBlockDataSet* data)
{
  return [actor, data](const std::set<vtkIdType>& flatIndices)
  {
    vtkNew<vtkMultiBlockDataSet> part;
    for (unsigned int i = 0; i < data->GetNumberOfBlocks(); ++i)
    {
      // The root has flat index 0.
      part->SetBlock(i, flatIndices.count(i + 1) > 0 ? data->GetBlock(i) : nullptr);
    }
    auto* original = static_cast<CompositeMapper*>(actor->GetMapper());
    vtkNew<CompositeMapper> mapper;
    mapper->SetCompositeDataDisplayAttributes(original->GetCompositeDataDisplayAttributes());
    mapper->SetInputDataObject(part);
    mapper->SetStatic(true);
    auto copy = vtkSmartPointer<vtkActor>::New();
    copy->ShallowCopy(actor);
    copy->SetMapper(mapper);
    return copy;
  };
}

struct LargeProp
{
  PartMaker MakePart;
  bool HasBlocks = false;
};

std::map<vtkProp*, LargeProp> FindLargeProps(Session& session)
{
  vtkNew<vtkNBufferCuller> culler;
  const auto minimum = static_cast<vtkIdType>(culler->GetTuning().MinimumNumberOfPrimitives);
  const auto unitSize = static_cast<std::size_t>(culler->GetTuning().UnitSize);
  std::map<vtkProp*, LargeProp> large;
  for (vtkProp* prop : session.GetProps())
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    vtkDataObject* data = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
    if (!data || data->GetNumberOfElements(vtkDataObject::CELL) < minimum)
    {
      continue;
    }
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
    auto* mesh = vtkPolyData::SafeDownCast(data);
    LargeProp found;
    found.HasBlocks = blocks != nullptr;
    found.MakePart = blocks ? MakeBlockMaker(actor, blocks)
      : mesh                ? MakeMeshMaker(actor, mesh, unitSize)
                            : nullptr;
    if (found.MakePart)
    {
      large.emplace(prop, std::move(found));
    }
  }
  return large;
}
}

std::vector<vtkSmartPointer<vtkActor>> ReplaceByVisibleUnits(Session& session,
  const NBufferExamples::CameraPath& path, std::vector<std::vector<vtkProp*>>& visible)
{
  const std::map<vtkProp*, LargeProp> large = FindLargeProps(session);
  std::vector<vtkSmartPointer<vtkActor>> parts;
  if (large.empty())
  {
    return parts;
  }
  const int* size = session.GetWindow()->GetActualSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(session.GetRenderer());
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    session.SetCuller(vtkNew<vtkFrustumCoverageCuller>());
    session.SetPose(path[frame]);
    if (!selector->CaptureBuffers())
    {
      throw std::runtime_error("the cells that own a pixel could not be found: no selection");
    }
    std::map<vtkProp*, std::set<vtkIdType>> owners;
    for (unsigned int y = 0; y < static_cast<unsigned int>(size[1]); ++y)
    {
      for (unsigned int x = 0; x < static_cast<unsigned int>(size[0]); ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const vtkHardwareSelector::PixelInformation owner = selector->GetPixelInformation(pixel, 0);
        const auto found = owner.Valid ? large.find(owner.Prop) : large.end();
        if (found != large.end())
        {
          const bool byBlock = found->second.HasBlocks;
          owners[owner.Prop].insert(byBlock ? owner.CompositeID : owner.AttributeID);
        }
      }
    }
    for (vtkProp*& prop : visible[frame])
    {
      const auto found = large.find(prop);
      if (found != large.end())
      {
        parts.push_back(found->second.MakePart(owners[prop]));
        prop = parts.back();
      }
    }
    RenderOnly(session, visible[frame]);
    ShowProgress("finding which units own a pixel: frame " + std::to_string(frame + 1) + " of " +
      std::to_string(path.size()));
  }
  return parts;
}

} // namespace NBufferBench
