// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterList.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"

#include <typeinfo>

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkCompositePolyDataMapper.h"
#endif

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// In world coordinates, as VTK has them.
std::vector<vtkShadowCaster::Plane> GetPlanes(vtkMapper* mapper)
{
  std::vector<vtkShadowCaster::Plane> result;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const double* normal = plane->GetNormal();
    result.push_back(
      { normal[0], normal[1], normal[2], -vtkMath::Dot(normal, plane->GetOrigin()) });
  }
  return result;
}

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
using CompositeMapper = vtkCompositePolyDataMapper2;
#else
using CompositeMapper = vtkCompositePolyDataMapper;
#endif
}

void vtkShadowCasterList::Update(vtkRenderer* renderer, vtkInformation* requiredKeys)
{
  ++this->Round;
  this->Casters.clear();
  this->Skipped.fill(0);
  this->Updates = 0;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility() && prop->HasKeys(requiredKeys))
    {
      this->AddProp(prop);
    }
  }
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    entry = entry->second.Round == this->Round ? std::next(entry) : this->Entries.erase(entry);
  }
}

void vtkShadowCasterList::AddProp(vtkProp* prop)
{
  if (vtkActor2D::SafeDownCast(prop))
  {
    return;
  }
  // Paths cost more than all the rest.
  if (typeid(*prop) == typeid(vtkOpenGLActor))
  {
    auto* actor = static_cast<vtkActor*>(prop);
    this->AddActor(actor, 0, actor->GetMatrix());
    return;
  }
  int path = 0;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* nodes = prop->GetNextPath())
  {
    vtkAssemblyNode* last = nodes->GetLastNode();
    auto* actor = vtkActor::SafeDownCast(last->GetViewProp());
    if (!actor)
    {
      this->Skip(vtkShadowSkip::NotAnActor);
    }
    else if (actor->GetVisibility())
    {
      this->AddActor(actor, path, last->GetMatrix() ? last->GetMatrix() : actor->GetMatrix());
    }
    ++path;
  }
}

void vtkShadowCasterList::AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    this->Skip(vtkShadowSkip::NotASurface);
    return;
  }
  if (actor->HasTranslucentPolygonalGeometry())
  {
    this->Skip(vtkShadowSkip::Translucent);
    return;
  }
  vtkAlgorithm* producer = mapper->GetInputAlgorithm();
  if (!mapper->GetStatic() && producer && typeid(*producer) != typeid(vtkTrivialProducer))
  {
    // Without a pipeline there is nothing to update, which takes longer than all the rest.
    mapper->Update();
  }
  if (CompositeMapper::SafeDownCast(mapper))
  {
    this->AddData(actor, path, matrix, mapper->GetInputDataObject(0, 0), true, 1.0);
    return;
  }
  vtkPolyData* mesh = vtkPolyDataMapper::SafeDownCast(mapper)
    ? static_cast<vtkPolyDataMapper*>(mapper)->GetInput()
    : nullptr;
  if (!mesh)
  {
    this->Skip(vtkShadowSkip::NotAPlainMapper);
    return;
  }
  this->AddMesh(actor, path, matrix, mesh);
}

void vtkShadowCasterList::AddData(vtkActor* actor, int path, vtkMatrix4x4* matrix,
  vtkDataObject* data, bool visible, double opacity)
{
  vtkCompositeDataDisplayAttributes* attributes =
    static_cast<CompositeMapper*>(actor->GetMapper())->GetCompositeDataDisplayAttributes();
  if (data && attributes && attributes->HasBlockVisibility(data))
  {
    visible = attributes->GetBlockVisibility(data);
  }
  if (data && attributes && attributes->HasBlockOpacity(data))
  {
    opacity = attributes->GetBlockOpacity(data);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      this->AddData(actor, path, matrix, child, visible, opacity);
    }
  }
  else if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    if (visible && opacity < 1.0)
    {
      this->Skip(vtkShadowSkip::Translucent);
    }
    else if (visible)
    {
      this->AddMesh(actor, path, matrix, mesh);
    }
  }
}

void vtkShadowCasterList::AddMesh(
  vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkPolyData* mesh)
{
  Entry& entry = this->Entries[Key(actor, path, mesh)];
  if (!entry.Caster)
  {
    entry.Caster = std::make_unique<vtkShadowCaster>();
  }
  entry.Round = this->Round;
  this->Updates += entry.Caster->Update(mesh, matrix, GetPlanes(actor->GetMapper())) ? 1 : 0;
  if (entry.Caster->GetNumberOfTriangles() > 0)
  {
    this->Casters.push_back(entry.Caster.get());
  }
}
VTK_ABI_NAMESPACE_END
