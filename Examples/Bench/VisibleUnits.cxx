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
#include "vtkGlyph3DMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cstdint>
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
/// Lets an actor have one color everywhere, whatever the lights are.
void SetUnlit(vtkActor* actor)
{
  vtkNew<vtkProperty> property;
  property->DeepCopy(actor->GetProperty());
  property->LightingOff();
  property->SetColor(0.0, 0.0, 0.0);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  actor->SetProperty(property);
}

vtkPolyData* GetPoints(vtkGlyph3DMapper* mapper)
{
  return vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

/**
 * Finds the visible instances by drawing each instance in a colour that is its number, and
 * everything else black. A hardware selection would make a draw of each instance, which takes
 * seconds.
 *
 * The scenes of the examples have instances of one source at points, without arrays that scale,
 * turn or color them, and no other prop of their scenes has colors of its own.
 */
class VisibleInstances
{
public:
  /// The actor and its mapper must outlive this object. The points are the input of the mapper.
  VisibleInstances(vtkActor* actor, vtkGlyph3DMapper* mapper);

  /// Returns the instances that own a pixel (without multisampling) from the present pose.
  /// `visible` are the props that own a pixel.
  std::set<vtkIdType> Find(Session& session, const std::vector<vtkProp*>& visible) const;

  /// Makes an actor with its own vtkGlyph3DMapper that draws only these instances, in their order.
  vtkSmartPointer<vtkActor> MakePart(const std::set<vtkIdType>& instances) const;

private:
  vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* points) const;

  vtkActor* Actor;
  vtkGlyph3DMapper* Mapper;
  vtkSmartPointer<vtkActor> Numbered; ///< The instances in the colours of their numbers.
};

VisibleInstances::VisibleInstances(vtkActor* actor, vtkGlyph3DMapper* mapper)
  : Actor(actor)
  , Mapper(mapper)
{
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(GetPoints(mapper));
  const vtkIdType count = numbered->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("number");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType number = i + 1; // The background is 0.
    for (int k = 0; k < 3; ++k)
    {
      colors->SetTypedComponent(i, k, static_cast<unsigned char>(number >> (8 * k) & 255));
    }
  }
  numbered->GetPointData()->SetScalars(colors);
  this->Numbered = this->MakeActor(numbered);
  this->Numbered->GetMapper()->ScalarVisibilityOn();
  this->Numbered->GetMapper()->SetScalarModeToUsePointData();
  SetUnlit(this->Numbered);
}

vtkSmartPointer<vtkActor> VisibleInstances::MakeActor(vtkPolyData* points) const
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceData(this->Mapper->GetSource());
  mapper->SetScaling(this->Mapper->GetScaling());
  mapper->SetScaleFactor(this->Mapper->GetScaleFactor());
  mapper->SetScaleMode(this->Mapper->GetScaleMode());
  mapper->SetOrient(this->Mapper->GetOrient());
  mapper->ScalarVisibilityOff();
  mapper->SetStatic(true);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->ShallowCopy(this->Actor);
  actor->SetMapper(mapper);
  return actor;
}

std::set<vtkIdType> VisibleInstances::Find(
  Session& session, const std::vector<vtkProp*>& visible) const
{
  std::vector<vtkSmartPointer<vtkActor>> copies;
  std::vector<vtkProp*> drawn;
  for (vtkProp* prop : visible)
  {
    if (prop == this->Actor)
    {
      drawn.push_back(this->Numbered);
    }
    else if (auto* actor = vtkActor::SafeDownCast(prop))
    {
      copies.push_back(vtkSmartPointer<vtkActor>::New());
      copies.back()->ShallowCopy(actor);
      SetUnlit(copies.back());
      drawn.push_back(copies.back());
    }
  }
  double background[3];
  session.GetRenderer()->GetBackground(background);
  const int samples = session.GetWindow()->GetMultiSamples();
  session.GetRenderer()->SetBackground(0.0, 0.0, 0.0);
  session.GetWindow()->SetMultiSamples(0);
  RenderOnly(session, drawn);
  const vtkSmartPointer<vtkUnsignedCharArray> pixels = session.ReadPixels();
  session.GetWindow()->SetMultiSamples(samples);
  session.GetRenderer()->SetBackground(background);

  std::set<vtkIdType> instances;
  const unsigned char* rgba = pixels->GetPointer(0);
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i, rgba += 4)
  {
    instances.insert((rgba[0] | rgba[1] << 8 | rgba[2] << 16) - 1);
  }
  instances.erase(-1); // The background.
  return instances;
}

vtkSmartPointer<vtkActor> VisibleInstances::MakePart(const std::set<vtkIdType>& instances) const
{
  vtkPoints* all = GetPoints(this->Mapper)->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetDataType());
  for (vtkIdType instance : instances)
  {
    points->InsertNextPoint(all->GetPoint(instance));
  }
  vtkNew<vtkPolyData> part;
  part->SetPoints(points);
  return this->MakeActor(part);
}

/// The part of a large prop that is drawn, and how many units it consists of.
struct Part
{
  vtkSmartPointer<vtkActor> Actor;
  std::size_t Count = 0;
};

/// Makes the part of a large prop with the units of which these cells, blocks by their flat
/// indices, or instances own a pixel.
using PartMaker = std::function<Part(const std::set<vtkIdType>&)>;

/// A mesh that vtkNBufferCuller divides, and its units.
struct LargeMesh
{
  vtkActor* Actor = nullptr;
  vtkPolyData* Data = nullptr;
  vtkNBufferUnits::Mesh Mesh;
  vtkNBufferUnits Units;
  std::vector<std::uint32_t> UnitOfPrimitive;

  Part MakePart(const std::set<vtkIdType>& primitives) const
  {
    std::vector<unsigned char> drawn(this->Units.GetSize());
    for (const vtkIdType primitive : primitives)
    {
      drawn[this->UnitOfPrimitive[static_cast<std::size_t>(primitive)]] = 1;
    }
    vtkNew<vtkCellArray> cells;
    const auto corners = static_cast<vtkIdType>(this->Mesh.Corners);
    std::vector<vtkIdType> cell(this->Mesh.Corners);
    for (const vtkNBufferUnits::Range& range : this->Units.GetRanges(drawn))
    {
      for (std::size_t i = range.Begin; i < range.End; ++i)
      {
        std::copy_n(
          this->Mesh.Indices.data() + this->Mesh.Corners * i, this->Mesh.Corners, cell.begin());
        cells->InsertNextCell(corners, cell.data());
      }
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
    return { actor, static_cast<std::size_t>(std::count(drawn.begin(), drawn.end(), 1)) };
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
    return Part{ copy, flatIndices.size() };
  };
}

struct LargeProp
{
  PartMaker MakePart;
  bool HasBlocks = false;
  std::shared_ptr<const VisibleInstances> Instances; ///< Of a prop that has instances.
};

/// Returns nullptr for an actor without instances, or with few of them.
std::shared_ptr<const VisibleInstances> MakeInstances(vtkActor* actor, vtkIdType minimum)
{
  auto* mapper = actor ? vtkGlyph3DMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  auto* points = mapper ? vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) : nullptr;
  const bool isLarge = points && mapper->GetSource() &&
    points->GetNumberOfPoints() * mapper->GetSource()->GetNumberOfPolys() >= minimum;
  return isLarge ? std::make_shared<const VisibleInstances>(actor, mapper) : nullptr;
}

std::map<vtkProp*, LargeProp> FindLargeProps(Session& session)
{
  vtkNew<vtkNBufferCuller> culler;
  const auto minimum = static_cast<vtkIdType>(culler->GetTuning().MinimumNumberOfPrimitives);
  const auto unitSize = static_cast<std::size_t>(culler->GetTuning().UnitSize);
  std::map<vtkProp*, LargeProp> large;
  for (vtkProp* prop : session.GetProps())
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (const std::shared_ptr<const VisibleInstances> instances = MakeInstances(actor, minimum))
    {
      const auto make = [instances](const std::set<vtkIdType>& visible) {
        return Part{ instances->MakePart(visible), visible.size() };
      };
      large.emplace(prop, LargeProp{ make, false, instances });
      continue;
    }
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

/// Finds what owns a pixel of large props: cells, or blocks by their flat indices.
class CellFinder
{
public:
  CellFinder(Session& session, const std::map<vtkProp*, LargeProp>& large)
    : Where(session)
    , Large(large)
  {
    this->Selector->SetRenderer(session.GetRenderer());
    this->Selector->SetArea(0, 0, this->GetSize(0) - 1, this->GetSize(1) - 1);
    this->Selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  }

  std::map<vtkProp*, std::set<vtkIdType>> Find()
  {
    this->Where.SetCuller(vtkNew<vtkFrustumCoverageCuller>());
    if (!this->Selector->CaptureBuffers())
    {
      throw std::runtime_error("the cells that own a pixel could not be found: no selection");
    }
    std::map<vtkProp*, std::set<vtkIdType>> owners;
    for (unsigned int y = 0; y < this->GetSize(1); ++y)
    {
      for (unsigned int x = 0; x < this->GetSize(0); ++x)
      {
        const unsigned int pixel[2] = { x, y };
        const vtkHardwareSelector::PixelInformation owner =
          this->Selector->GetPixelInformation(pixel, 0);
        const auto found = owner.Valid ? this->Large.find(owner.Prop) : this->Large.end();
        if (found != this->Large.end())
        {
          const bool byBlock = found->second.HasBlocks;
          owners[owner.Prop].insert(byBlock ? owner.CompositeID : owner.AttributeID);
        }
      }
    }
    return owners;
  }

private:
  unsigned int GetSize(int axis)
  {
    return static_cast<unsigned int>(this->Where.GetWindow()->GetActualSize()[axis]);
  }

  Session& Where;
  const std::map<vtkProp*, LargeProp>& Large;
  vtkNew<vtkHardwareSelector> Selector;
};
}

VisibleUnits ReplaceByVisibleUnits(Session& session, const NBufferExamples::CameraPath& path,
  std::vector<std::vector<vtkProp*>>& visible)
{
  const std::map<vtkProp*, LargeProp> large = FindLargeProps(session);
  VisibleUnits units;
  if (large.empty())
  {
    return units;
  }
  const bool hasCells = std::any_of(
    large.begin(), large.end(), [](const auto& entry) { return !entry.second.Instances; });
  CellFinder cells(session, large);
  for (std::size_t frame = 0; frame < path.size(); ++frame)
  {
    session.SetPose(path[frame]);
    std::map<vtkProp*, std::set<vtkIdType>> owners;
    if (hasCells)
    {
      owners = cells.Find();
    }
    for (const auto& [prop, entry] : large)
    {
      if (entry.Instances)
      {
        owners[prop] = entry.Instances->Find(session, visible[frame]);
      }
    }
    units.Counts.push_back(0.0);
    for (vtkProp*& prop : visible[frame])
    {
      const auto found = large.find(prop);
      if (found != large.end())
      {
        const Part part = found->second.MakePart(owners[prop]);
        units.Actors.push_back(part.Actor);
        units.Counts.back() += static_cast<double>(part.Count);
        prop = part.Actor;
      }
    }
    RenderOnly(session, visible[frame]);
    ShowProgress("finding which units own a pixel: frame " + std::to_string(frame + 1) + " of " +
      std::to_string(path.size()));
  }
  return units;
}

} // namespace NBufferBench
