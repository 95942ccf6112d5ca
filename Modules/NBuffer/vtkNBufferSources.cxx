// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSources.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Naming the protected member through a derived class is the one way to look without making.
struct ShaderPropertyAccess : vtkProp
{
  static vtkShaderProperty* Get(vtkProp* prop)
  {
    return prop->*(&ShaderPropertyAccess::ShaderProperty);
  }
};

/// An object's own time, without what a subclass adds.
vtkMTimeType GetOwnTime(const vtkObject* object)
{
  return const_cast<vtkObject*>(object)->vtkObject::GetMTime();
}

void FetchLine(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}
}

vtkShaderProperty* vtkNBufferSources::GetShaderProperty(vtkActor* actor)
{
  return ShaderPropertyAccess::Get(actor);
}

bool vtkNBufferSources::Add(const vtkObject* object)
{
  if (!object)
  {
    return true;
  }
  if (this->Count == static_cast<int>(this->Objects.size()))
  {
    return false;
  }
  this->Objects[this->Count++] = object;
  return true;
}

bool vtkNBufferSources::AddFields(vtkFieldData* fields)
{
  bool fits = this->Add(fields);
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    fits = fits && this->Add(fields->GetAbstractArray(i));
  }
  return fits;
}

bool vtkNBufferSources::Take(
  vtkActor* actor, vtkMapper* mapper, vtkAlgorithm* producer, vtkPolyData* input)
{
  this->Actor = actor;
  this->Mapper = mapper;
  this->Shaders = GetShaderProperty(actor);
  this->Count = 0;
  bool fits = this->Add(actor) && this->Add(actor->GetProperty()) &&
    this->Add(actor->GetBackfaceProperty()) && this->Add(actor->GetUserMatrix()) &&
    this->Add(this->Shaders);
  this->BeforeMapper = this->Count;
  vtkPoints* points = input->GetPoints();
  fits = fits && this->Add(producer) && this->Add(input) && this->Add(points) &&
    this->Add(points ? points->GetData() : nullptr) && this->Add(input->GetVerts()) &&
    this->Add(input->GetLines()) && this->Add(input->GetPolys()) &&
    this->Add(input->GetStrips()) && this->AddFields(input->GetPointData()) &&
    this->AddFields(input->GetCellData()) && this->AddFields(input->GetFieldData());

  this->Time = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    this->Time = std::max(this->Time, GetOwnTime(this->Objects[i]));
  }
  const vtkMTimeType shaders = this->Shaders ? this->Shaders->GetMTime() : 0;
  const bool same = this->Time == std::max({ actor->GetMTime(), producer->GetMTime(), shaders });
  this->Time = std::max(this->Time, mapper->GetMTime());
  return fits && same;
}

bool vtkNBufferSources::HasChanged() const
{
  // In this order: each object is known to be alive only if the one before it has not changed.
  for (int i = 0; i < this->BeforeMapper; ++i)
  {
    if (GetOwnTime(this->Objects[i]) > this->Time)
    {
      return true;
    }
  }
  if (GetShaderProperty(this->Actor) != this->Shaders || this->Mapper->GetMTime() > this->Time)
  {
    return true;
  }
  for (int i = this->BeforeMapper; i < this->Count; ++i)
  {
    if (GetOwnTime(this->Objects[i]) > this->Time)
    {
      return true;
    }
  }
  return false;
}

void vtkNBufferSources::Prefetch() const
{
  for (int i = 0; i < this->Count; ++i)
  {
    FetchLine(this->Objects[i]);
    // The time lies in the first 64 bytes of an object, which may begin anywhere in a line.
    FetchLine(reinterpret_cast<const char*>(this->Objects[i]) + 48);
  }
  FetchLine(this->Mapper);
}
VTK_ABI_NAMESPACE_END
