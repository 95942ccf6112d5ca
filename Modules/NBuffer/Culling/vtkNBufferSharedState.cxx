// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSharedState.h"

#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSetMapper.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkInformationKeyMacro(vtkNBufferSharedState, OTHER_SHADERS, Double);

namespace
{
void Combine(std::size_t& hash, std::size_t value)
{
  hash ^= value + 0x9e3779b97f4a7c15 + (hash << 6) + (hash >> 2);
}

/**
 * A hash of what vtkOpenGLPolyDataMapper::ReplaceShaderValues() reads of an actor. A mapper keeps
 * one set of shaders. It makes them for the first actor that it draws and makes them again when a
 * property is modified, but not when the next actor needs other shaders.
 */
std::size_t GetWayOfShading(vtkActor* actor)
{
  std::size_t way = 0;
  vtkProperty* property = actor->GetProperty();
  Combine(way, static_cast<std::size_t>(property->GetRepresentation()));
  Combine(way, static_cast<std::size_t>(property->GetInterpolation()));
  for (const bool value : { property->GetLighting(), property->GetEdgeVisibility() != 0,
         property->GetVertexVisibility() != 0, property->GetRenderPointsAsSpheres(),
         property->GetRenderLinesAsTubes(), property->GetLineWidth() > 1.0F,
         property->GetCoatStrength() > 0.0, property->GetAnisotropy() != 0.0,
         actor->GetBackfaceProperty() != nullptr, vtkNBufferSurface::HasReplacedShaders(actor) })
  {
    Combine(way, value);
  }
  Combine(way, std::hash<vtkTexture*>()(actor->GetTexture()));
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    Combine(way, std::hash<std::string>()(name));
    Combine(way, std::hash<vtkTexture*>()(texture));
  }
  return way;
}

/// The table with which a mapper maps scalars. If the array has a table, VTK uses that one.
vtkScalarsToColors* GetLookupTable(vtkMapper* mapper)
{
  int isCellArray = 0;
  auto* scalars = vtkDataArray::SafeDownCast(
    vtkAbstractMapper::GetAbstractScalars(mapper->GetInput(), mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isCellArray));
  return scalars && scalars->GetLookupTable() ? scalars->GetLookupTable()
                                              : vtkNBufferProtectedMembers::GetLookupTable(mapper);
}

/// A mapper sets the range of its table before it maps scalars, unless it has to use the range that
/// it finds there (UseLookupTableScalarRange). A texture uses the range that it finds as well.
vtkNBufferSharedState::Use GetTableUse(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkScalarsToColors* table = mapper->GetScalarVisibility() ? GetLookupTable(mapper) : nullptr;
  if (!table)
  {
    return { actor->GetTexture() ? actor->GetTexture()->GetLookupTable() : nullptr, 0 };
  }
  std::size_t way = 0;
  if (!mapper->GetUseLookupTableScalarRange())
  {
    Combine(way, std::hash<double>()(mapper->GetScalarRange()[0]));
    Combine(way, std::hash<double>()(mapper->GetScalarRange()[1]));
  }
  return { table, way };
}

/// The mappers of a window share one vertex buffer for an array. Only the first of them shifts it.
vtkNBufferSharedState::Use GetPointsUse(vtkMapper* mapper)
{
  vtkPolyData* data = vtkNBufferSurface::GetOnlyPolyData(mapper);
  if (!data || !data->GetPoints())
  {
    return {};
  }
  auto* shifts = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  return { data->GetPoints()->GetData(),
    static_cast<std::size_t>(shifts
        ? shifts->GetVBOShiftScaleMethod()
        : static_cast<int>(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE)) };
}
}

vtkNBufferSharedState::Uses vtkNBufferSharedState::GetUses(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return mapper
    ? Uses{ Use{ mapper, GetWayOfShading(actor) }, GetTableUse(actor), GetPointsUse(mapper) }
    : Uses();
}

void vtkNBufferSharedState::Add(const Uses& uses)
{
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    const auto [object, way] = uses[i];
    if (object && !this->Common[i].Object)
    {
      this->Common[i] = uses[i];
    }
    if (object && way != this->Common[i].Way)
    {
      Entry& entry = this->Uncommon.try_emplace(object, Entry{ way, false }).first->second;
      entry.IsMixed = entry.IsMixed || entry.Way != way;
    }
  }
}

void vtkNBufferSharedState::AddCommon(const Uses& uses)
{
  for (std::size_t i = 0; i < uses.size() && !this->Uncommon.empty(); ++i)
  {
    const auto found = this->Uncommon.find(uses[i].Object);
    if (found != this->Uncommon.end() && uses[i].Way == this->Common[i].Way)
    {
      found->second.IsMixed = true;
    }
  }
}

bool vtkNBufferSharedState::IsMixed(const Uses& uses) const
{
  return !this->Uncommon.empty() &&
    std::any_of(uses.begin(), uses.end(),
      [this](const Use& use)
      {
        const auto found = this->Uncommon.find(use.Object);
        return found != this->Uncommon.end() && found->second.IsMixed;
      });
}

bool vtkNBufferSharedState::HasMixed() const
{
  return std::any_of(this->Uncommon.begin(), this->Uncommon.end(),
    [](const auto& entry) { return entry.second.IsMixed; });
}

bool vtkNBufferSharedState::HasNewShaders(vtkMapper* mapper)
{
  auto* extracts = vtkDataSetMapper::SafeDownCast(mapper);
  auto* draws =
    vtkOpenGLPolyDataMapper::SafeDownCast(extracts ? extracts->GetPolyDataMapper() : mapper);
  return draws &&
    static_cast<double>(vtkNBufferProtectedMembers::GetShaderTime(draws)) >
    mapper->GetInformation()->Get(OTHER_SHADERS());
}

bool vtkNBufferSharedState::HasOtherShaders(vtkMapper* mapper, bool isMixed)
{
  vtkInformation* marks = mapper->GetInformation();
  if (isMixed)
  {
    marks->Set(OTHER_SHADERS(), VTK_DOUBLE_MAX);
  }
  else if (!marks->Has(OTHER_SHADERS()))
  {
    return false;
  }
  else if (marks->Get(OTHER_SHADERS()) == VTK_DOUBLE_MAX)
  {
    vtkTimeStamp now;
    now.Modified();
    marks->Set(OTHER_SHADERS(), static_cast<double>(now.GetMTime()));
  }
  else if (HasNewShaders(mapper))
  {
    marks->Remove(OTHER_SHADERS());
    return false;
  }
  return true;
}
VTK_ABI_NAMESPACE_END
