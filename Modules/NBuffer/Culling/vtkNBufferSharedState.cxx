// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSharedState.h"

#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferScalars.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
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
vtkInformationKeyMacro(vtkNBufferSharedState, OTHER_PARAMETERS, Double);
vtkInformationKeyMacro(vtkNBufferSharedState, OTHER_SHADERS, Double);

namespace
{
constexpr int MaximumNumberOfTextures = 8;
constexpr int NumberOfGroups = MaximumNumberOfTextures + 4;

void Combine(std::size_t& hash, std::size_t value)
{
  hash ^= value + 0x9e3779b97f4a7c15 + (hash << 6) + (hash >> 2);
}

/**
 * A hash of what decides which parameters vtkOpenGLPolyDataMapper sets for an actor
 * (SetMapperShaderParameters, SetPropertyShaderParameters, SetCameraShaderParameters). Missing is
 * what makes the mapper make its shaders anew if it differs from the last actor's: lighting, coats
 * and anisotropy. The lowest NumberOfGroups bits say which groups of parameters are set.
 */
std::size_t GetWayOfSetting(vtkActor* actor)
{
  std::size_t way = 0;
  vtkProperty* property = actor->GetProperty();
  const bool hasOffset = vtkNBufferSurface::HasOffset(actor);
  const bool isWide = property->GetLineWidth() > 1.0F;
  Combine(way, hasOffset);
  Combine(way, property->GetRenderLinesAsTubes());
  // Whether edges, wide lines and depth offsets are drawn depends on the representation as well.
  if (hasOffset || isWide)
  {
    Combine(way, static_cast<std::size_t>(property->GetRepresentation()));
  }
  Combine(way, std::hash<vtkTexture*>()(actor->GetTexture()));
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    Combine(way, std::hash<std::string>()(name));
    Combine(way, std::hash<vtkTexture*>()(texture));
  }
  // A bit for each texture, and one for each other group of parameters that the actor sets.
  const int textures = property->GetNumberOfTextures() + (actor->GetTexture() ? 1 : 0);
  std::size_t groups = (std::size_t{ 1 } << std::min(textures, MaximumNumberOfTextures)) - 1;
  for (const bool value : { property->GetInterpolation() == VTK_PBR, isWide,
         property->GetEdgeVisibility() != 0, vtkNBufferSurface::HasReplacedShaders(actor) })
  {
    groups = 2 * groups + (value ? 1 : 0);
  }
  return (way << NumberOfGroups) + groups;
}

/**
 * A hash of what vtkOpenGLPolyDataMapper::ReplaceShaderValues() reads of an actor. A mapper keeps
 * one set of shaders. It makes them for the first actor that it draws and makes them again when a
 * property is modified, but not when the next actor needs other shaders.
 */
std::size_t GetWayOfShading(vtkActor* actor)
{
  std::size_t way = GetWayOfSetting(actor);
  vtkProperty* property = actor->GetProperty();
  Combine(way, static_cast<std::size_t>(property->GetRepresentation()));
  Combine(way, static_cast<std::size_t>(property->GetInterpolation()));
  for (const bool value : { property->GetLighting(), property->GetVertexVisibility() != 0,
         property->GetRenderPointsAsSpheres(), property->GetCoatStrength() > 0.0,
         property->GetAnisotropy() != 0.0, actor->GetBackfaceProperty() != nullptr })
  {
    Combine(way, value);
  }
  return way;
}

/// A mapper sets the range of its table before it maps scalars, unless it has to use the range that
/// it finds there (UseLookupTableScalarRange).
vtkNBufferSharedState::Use GetTableUse(vtkMapper* mapper)
{
  std::size_t way = 0;
  if (!mapper->GetUseLookupTableScalarRange())
  {
    Combine(way, std::hash<double>()(mapper->GetScalarRange()[0]));
    Combine(way, std::hash<double>()(mapper->GetScalarRange()[1]));
  }
  return { vtkNBufferScalars::GetLookupTable(mapper), way };
}

/// A texture uses the range that it finds in its table.
vtkNBufferSharedState::Use GetTextureTableUse(vtkActor* actor)
{
  const void* table = nullptr;
  for (vtkTexture* texture : vtkNBufferSurface::GetTextures(actor))
  {
    table = table ? table : texture->GetLookupTable();
  }
  return { table, 0 };
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

/// When a mapper has made its shaders. 0 if it has made none, or if that is not known.
double GetShaderTime(vtkMapper* mapper)
{
  vtkOpenGLPolyDataMapper* draws = vtkNBufferSurface::GetDrawingMapper(mapper);
  return draws ? static_cast<double>(vtkNBufferProtectedMembers::GetShaderTime(draws)) : 0.0;
}

/// Whether a mapper has a mark and has made all its shaders since.
bool HasMadeShadersSince(vtkMapper* mapper, vtkInformationDoubleKey* mark)
{
  vtkInformation* marks = mapper->GetInformation();
  return marks->Has(mark) && GetShaderTime(mapper) > marks->Get(mark);
}
}

vtkNBufferSharedState::Uses vtkNBufferSharedState::GetUses(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return mapper
    ? Uses{ Use{ mapper, GetWayOfSetting(actor) }, Use{ mapper, GetWayOfShading(actor) },
        GetTableUse(mapper), GetPointsUse(mapper), GetTextureTableUse(actor) }
    : Uses();
}

void vtkNBufferSharedState::Add(const Uses& uses)
{
  for (std::size_t place = 0; place < uses.size(); ++place)
  {
    const std::size_t kind = GetKind(place);
    const auto [object, way] = uses[place];
    if (object && !this->Common[kind].Object)
    {
      this->Common[kind] = uses[place];
    }
    if (object && way != this->Common[kind].Way)
    {
      Entry& entry = this->Uncommon[kind].try_emplace(object, Entry{ way, false }).first->second;
      entry.IsMixed = entry.IsMixed || entry.Way != way;
    }
  }
}

void vtkNBufferSharedState::AddCommon(const Uses& uses)
{
  for (std::size_t place = 0; place < uses.size(); ++place)
  {
    const std::size_t kind = GetKind(place);
    const auto found = this->Uncommon[kind].find(uses[place].Object);
    if (found != this->Uncommon[kind].end() && uses[place].Way == this->Common[kind].Way)
    {
      found->second.IsMixed = true;
    }
  }
}

bool vtkNBufferSharedState::IsMixed(const Uses& uses, std::size_t place) const
{
  const auto& uncommon = this->Uncommon[GetKind(place)];
  const auto found = uncommon.find(uses[place].Object);
  return found != uncommon.end() && found->second.IsMixed;
}

bool vtkNBufferSharedState::HasMixedData(const Uses& uses) const
{
  return this->IsMixed(uses, LookupTable) || this->IsMixed(uses, TextureTable) ||
    this->IsMixed(uses, Points);
}

bool vtkNBufferSharedState::IsMixed(const Uses& uses) const
{
  return this->IsMixed(uses, Shaders) || this->HasMixedData(uses);
}

bool vtkNBufferSharedState::HasNewShaders(vtkMapper* mapper)
{
  return HasMadeShadersSince(mapper, OTHER_PARAMETERS()) ||
    HasMadeShadersSince(mapper, OTHER_SHADERS());
}

bool vtkNBufferSharedState::HasOtherShaders(vtkMapper* mapper, std::size_t place, bool isMixed)
{
  vtkInformationDoubleKey* mark = place == Parameters ? OTHER_PARAMETERS() : OTHER_SHADERS();
  vtkInformation* marks = mapper->GetInformation();
  if (isMixed)
  {
    marks->Set(mark, VTK_DOUBLE_MAX);
  }
  else if (!marks->Has(mark))
  {
    return false;
  }
  else if (marks->Get(mark) == VTK_DOUBLE_MAX)
  {
    vtkTimeStamp now;
    now.Modified();
    marks->Set(mark, static_cast<double>(now.GetMTime()));
  }
  else if (HasMadeShadersSince(mapper, mark))
  {
    marks->Remove(mark);
    return false;
  }
  return true;
}

void vtkNBufferSharedState::MarkIfShadersStay(vtkActor* actor, const Uses& before)
{
  vtkMapper* mapper = actor->GetMapper();
  const Use& used = before[Parameters];
  if (!mapper || used.Object != mapper)
  {
    return;
  }
  const std::size_t noLongerSet = used.Way & ~GetWayOfSetting(actor);
  if (noLongerSet % (std::size_t{ 1 } << NumberOfGroups) != 0 &&
    GetShaderTime(mapper) > static_cast<double>(actor->GetProperty()->GetMTime()))
  {
    HasOtherShaders(mapper, Parameters, true);
  }
}
VTK_ABI_NAMESPACE_END
