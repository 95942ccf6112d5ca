// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterList.h"

#include "vtkNBufferForEachProp.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkGeometryFilter.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <functional>
#include <typeinfo>
#include <unordered_map>

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

/// Of data and, if it is composite, of its parts.
vtkMTimeType GetDataTime(vtkDataObject* data)
{
  vtkMTimeType time = data ? data->GetMTime() : 0;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* part : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      time = std::max(time, GetDataTime(part));
    }
  }
  return time;
}

/// Without a pipeline there is nothing to update, which takes longer than all the rest.
void UpdatePipeline(vtkAlgorithm* algorithm)
{
  vtkAlgorithm* producer =
    algorithm->GetNumberOfInputConnections(0) > 0 ? algorithm->GetInputAlgorithm() : nullptr;
  if (producer && typeid(*producer) != typeid(vtkTrivialProducer))
  {
    producer->Update();
  }
}

/// Of a mapper or texture, and of what it shows.
vtkMTimeType GetPipelineTime(vtkAlgorithm* algorithm)
{
  UpdatePipeline(algorithm);
  return std::max(algorithm->GetMTime(), GetDataTime(algorithm->GetInputDataObject(0, 0)));
}

/// The time of the last change of what an actor draws; 0 where times do not tell.
vtkMTimeType GetTime(vtkActor* actor)
{
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper ||
    (typeid(*mapper) != typeid(vtkOpenGLPolyDataMapper) &&
      typeid(*mapper) != typeid(vtkDataSetMapper) && !CompositeMapper::SafeDownCast(mapper)))
  {
    return 0;
  }
  vtkMTimeType time = std::max(actor->GetMTime(), GetPipelineTime(mapper));
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return actor->GetTexture() ? std::max(time, GetPipelineTime(actor->GetTexture())) : time;
}

template <typename Counts>
void Skip(Counts& skipped, vtkShadowSkip reason)
{
  ++skipped[static_cast<std::size_t>(reason)];
}
}

void vtkShadowCasterList::Update(vtkRenderer* renderer, vtkInformation* requiredKeys)
{
  this->Found.clear();
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      this->Found.push_back(prop);
    }
  }
  bool changed = this->Found != this->Props;
  if (changed)
  {
    this->Synchronize(this->Found);
  }
  const vtkNBufferCandidate::GlobalState state = vtkNBufferCandidate::GetGlobalState();
  changed = changed || state != this->GlobalState;
  this->GlobalState = state;

  const vtkMTimeType requiredTime = requiredKeys ? requiredKeys->GetMTime() : 0;
  const bool sameRequired =
    requiredKeys == this->RequiredKeys && requiredTime == this->RequiredTime;
  this->RequiredKeys = requiredKeys;
  this->RequiredTime = requiredTime;

  this->FindChanges(sameRequired);
  this->Updates = 0;
  bool looked = changed;
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    Member& member = this->Members[i];
    const bool casts =
      member.HasNewKeys ? TakeKeys(this->Props[i], requiredKeys, member) : member.Casts;
    if (member.HasChanged || casts != member.Casts)
    {
      member.Casts = casts;
      changed = this->Look(this->Props[i], member) || changed;
      looked = true;
    }
  }
  this->Version += changed ? 1 : 0;
  if (looked)
  {
    this->Casters.clear();
    this->Skipped.fill(0);
    for (const Member& member : this->Members)
    {
      for (const Mesh& mesh : member.Meshes)
      {
        if (mesh.Caster->GetNumberOfTriangles() > 0)
        {
          this->Casters.push_back(mesh.Caster.get());
        }
      }
      std::transform(member.Skipped.begin(), member.Skipped.end(), this->Skipped.begin(),
        this->Skipped.begin(), std::plus<int>());
    }
  }
}

void vtkShadowCasterList::FindChanges(bool sameRequired)
{
  vtkNBufferForEachProp::Run(this->Members.size(),
    [this, sameRequired](vtkIdType begin, vtkIdType end)
    {
      constexpr vtkIdType ahead = vtkNBufferForEachProp::PropsToFetchAhead;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (i + ahead < end && this->Members[i + ahead].Watched)
        {
          this->Members[i + ahead].Sources.Prefetch();
        }
        Member& member = this->Members[i];
        vtkInformation* keys = this->Props[i]->GetPropertyKeys();
        member.HasNewKeys = !sameRequired || !member.Looked || keys != member.Keys ||
          (keys && keys->GetMTime() != member.KeysTime);
        member.HasChanged = !member.Watched || member.Sources.HasChanged();
      }
    });
}

bool vtkShadowCasterList::TakeKeys(vtkProp* prop, vtkInformation* required, Member& member)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  member.Looked = true;
  member.Keys = keys;
  member.KeysTime = keys ? keys->GetMTime() : 0;
  return prop->HasKeys(required);
}

void vtkShadowCasterList::Synchronize(std::vector<vtkProp*>& props)
{
  std::unordered_map<vtkProp*, Member*> old;
  old.reserve(this->Props.size());
  for (std::size_t i = 0; i < this->Props.size(); ++i)
  {
    old.emplace(this->Props[i], &this->Members[i]);
  }
  std::vector<Member> members(props.size());
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    const auto found = old.find(props[i]);
    if (found != old.end())
    {
      members[i] = std::move(*found->second);
      old.erase(found);
    }
  }
  this->Props = props;
  this->Members = std::move(members);
}

bool vtkShadowCasterList::Look(vtkProp* prop, Member& member)
{
  const int updatesBefore = this->Updates;
  const vtkMTimeType timeBefore = member.Time;
  const std::size_t meshesBefore = member.Meshes.size();
  this->OldMeshes = std::move(member.Meshes);
  member.Meshes.clear();
  member.Skipped.fill(0);
  if (member.Casts)
  {
    this->AddProp(prop, member);
  }
  this->OldMeshes.clear();
  auto* actor =
    typeid(*prop) == typeid(vtkOpenGLActor) ? static_cast<vtkOpenGLActor*>(prop) : nullptr;
  member.Watched = actor && member.Sources.Take(actor);
  member.Time = member.Watched ? member.Sources.GetTime() : GetTime(actor);
  return member.Time == 0 || member.Time != timeBefore || this->Updates != updatesBefore ||
    member.Meshes.size() != meshesBefore;
}

void vtkShadowCasterList::AddProp(vtkProp* prop, Member& member)
{
  if (vtkActor2D::SafeDownCast(prop))
  {
    return;
  }
  // Paths cost more than all the rest.
  if (typeid(*prop) == typeid(vtkOpenGLActor))
  {
    auto* actor = static_cast<vtkActor*>(prop);
    this->AddActor(actor, 0, actor->GetMatrix(), member);
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
      Skip(member.Skipped, vtkShadowSkip::NotAnActor);
    }
    else if (actor->GetVisibility())
    {
      this->AddActor(
        actor, path, last->GetMatrix() ? last->GetMatrix() : actor->GetMatrix(), member);
    }
    ++path;
  }
}

void vtkShadowCasterList::AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix, Member& member)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    Skip(member.Skipped, vtkShadowSkip::NotASurface);
    return;
  }
  if (actor->HasTranslucentPolygonalGeometry())
  {
    Skip(member.Skipped, vtkShadowSkip::Translucent);
    return;
  }
  if (!mapper->GetStatic())
  {
    UpdatePipeline(mapper);
  }
  if (CompositeMapper::SafeDownCast(mapper))
  {
    this->AddData(actor, path, matrix, mapper->GetInputDataObject(0, 0), true, 1.0, member);
    return;
  }
  vtkDataObject* input =
    vtkPolyDataMapper::SafeDownCast(mapper) || vtkDataSetMapper::SafeDownCast(mapper)
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(input);
  if (input && !mesh)
  {
    vtkSmartPointer<vtkGeometryFilter>& surface = member.Surfaces[path];
    if (!surface)
    {
      surface = vtkSmartPointer<vtkGeometryFilter>::New();
    }
    surface->SetInputData(input);
    surface->Update();
    mesh = surface->GetOutput();
  }
  if (!mesh)
  {
    Skip(member.Skipped, vtkShadowSkip::NotAPlainMapper);
    return;
  }
  this->AddMesh(actor, path, matrix, mesh, member);
}

void vtkShadowCasterList::AddData(vtkActor* actor, int path, vtkMatrix4x4* matrix,
  vtkDataObject* data, bool visible, double opacity, Member& member)
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
      this->AddData(actor, path, matrix, child, visible, opacity, member);
    }
  }
  else if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    if (visible && opacity < 1.0)
    {
      Skip(member.Skipped, vtkShadowSkip::Translucent);
    }
    else if (visible)
    {
      this->AddMesh(actor, path, matrix, mesh, member);
    }
  }
}

void vtkShadowCasterList::AddMesh(
  vtkActor* actor, int path, vtkMatrix4x4* matrix, vtkPolyData* mesh, Member& member)
{
  Mesh entry{ path, mesh, nullptr };
  // As a rule blocks come in the order of the last time.
  const std::size_t count = this->OldMeshes.size();
  for (std::size_t k = 0; k < count && !entry.Caster; ++k)
  {
    Mesh& old = this->OldMeshes[(member.Meshes.size() + k) % count];
    if (old.Path == path && old.Block == mesh)
    {
      entry.Caster = std::move(old.Caster);
    }
  }
  if (!entry.Caster)
  {
    entry.Caster = std::make_unique<vtkShadowCaster>();
  }
  this->Updates += entry.Caster->Update(mesh, matrix, GetPlanes(actor->GetMapper())) ? 1 : 0;
  member.Meshes.push_back(std::move(entry));
}
VTK_ABI_NAMESPACE_END
