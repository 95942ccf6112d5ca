// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSources.h"

#include "vtkNBufferForEachProp.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTimeStamp.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Naming protected members through derived classes is the one way to look at them as they are:
/// the getters make what is missing, or are virtual and combine other objects' times.
struct PropAccess : vtkProp
{
  static vtkShaderProperty* const& GetShaders(vtkProp* prop)
  {
    return prop->*(&PropAccess::ShaderProperty);
  }
};
struct MapperAccess : vtkMapper
{
  static vtkScalarsToColors* const& GetTable(vtkMapper* mapper)
  {
    return mapper->*(&MapperAccess::LookupTable);
  }
};
struct ObjectAccess : vtkObject
{
  static const vtkTimeStamp& GetStamp(const vtkObject* object)
  {
    return object->*(&ObjectAccess::MTime);
  }
};

/// Whether asking for its time only reads. vtkProp3D wraps a user's matrix in the second kind.
bool IsPlain(vtkLinearTransform* transform)
{
  return !transform || typeid(*transform) == typeid(vtkTransform) ||
    typeid(*transform) == typeid(vtkMatrixToLinearTransform);
}
}

vtkShaderProperty* vtkNBufferSources::GetShaderProperty(vtkActor* actor)
{
  return PropAccess::GetShaders(actor);
}

bool vtkNBufferSources::Add(const vtkObject* object)
{
  if (!object)
  {
    return true;
  }
  if (this->Count == static_cast<int>(this->Stamps.size()))
  {
    return false;
  }
  this->Stamps[this->Count++] = &ObjectAccess::GetStamp(object);
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

bool vtkNBufferSources::Take(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper ||
    (typeid(*mapper) != typeid(vtkOpenGLPolyDataMapper) &&
      typeid(*mapper) != typeid(vtkDataSetMapper)) ||
    mapper->GetNumberOfInputConnections(0) != 1)
  {
    return false;
  }
  vtkAlgorithm* producer = mapper->GetInputAlgorithm(0, 0);
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  // A texture's translucency, other transforms' pipelines and shared clipping planes are beyond
  // what may be asked of several props at a time.
  return producer && input && typeid(*producer) == typeid(vtkTrivialProducer) &&
    typeid(*input) == typeid(vtkPolyData) && !actor->GetTexture() &&
    IsPlain(actor->GetUserTransform()) && !mapper->GetClippingPlanes() &&
    this->TakeAll(actor, mapper, producer, static_cast<vtkPolyData*>(input));
}

bool vtkNBufferSources::TakeAll(
  vtkActor* actor, vtkMapper* mapper, vtkAlgorithm* producer, vtkPolyData* input)
{
  this->Actor = actor;
  this->UserTransform = actor->GetUserTransform();
  this->Shaders = GetShaderProperty(actor);
  // A lookup table that is missing now is made when there are scalars to map, and such a change
  // shows in the data.
  vtkScalarsToColors* table = MapperAccess::GetTable(mapper);
  this->Count = 0;
  bool fits = this->Add(actor) && this->Add(actor->GetProperty()) &&
    this->Add(actor->GetBackfaceProperty()) && this->Add(actor->GetUserMatrix()) &&
    this->Add(this->Shaders);
  this->BeforeMapper = this->Count;
  vtkPoints* points = input->GetPoints();
  fits = fits && this->Add(mapper) && this->Add(table) && this->Add(producer) && this->Add(input) &&
    this->Add(points) && this->Add(points ? points->GetData() : nullptr) &&
    this->Add(input->GetVerts()) && this->Add(input->GetLines()) && this->Add(input->GetPolys()) &&
    this->Add(input->GetStrips()) && this->AddFields(input->GetPointData()) &&
    this->AddFields(input->GetCellData()) && this->AddFields(input->GetFieldData());

  this->Time = this->UserTransform ? this->UserTransform->GetMTime() : 0;
  for (int i = 0; i < this->Count; ++i)
  {
    this->Time = std::max(this->Time, this->Stamps[i]->GetMTime());
  }
  const vtkMTimeType shaders = this->Shaders ? this->Shaders->GetMTime() : 0;
  // Classes that combine the times of still other objects.
  const bool plain = (!table || typeid(*table) == typeid(vtkLookupTable)) &&
    (!points || typeid(*points) == typeid(vtkPoints));
  return fits && plain &&
    this->Time ==
    std::max({ actor->GetMTime(), mapper->GetMTime(), producer->GetMTime(), shaders });
}

bool vtkNBufferSources::HasNewer(int begin, int end) const
{
  for (int i = begin; i < end; ++i)
  {
    if (this->Stamps[i]->GetMTime() > this->Time)
    {
      return true;
    }
  }
  return false;
}

bool vtkNBufferSources::HasChanged() const
{
  // In this order: each object is known to be alive only if the one before it has not changed.
  return this->HasNewer(0, this->BeforeMapper) ||
    PropAccess::GetShaders(this->Actor) != this->Shaders ||
    (this->UserTransform && this->UserTransform->GetMTime() > this->Time) ||
    this->HasNewer(this->BeforeMapper, this->Count);
}

void vtkNBufferSources::Prefetch() const
{
  for (int i = 0; i < this->Count; ++i)
  {
    vtkNBufferForEachProp::Fetch(this->Stamps[i]);
  }
  vtkNBufferForEachProp::Fetch(&PropAccess::GetShaders(this->Actor));
}
VTK_ABI_NAMESPACE_END
