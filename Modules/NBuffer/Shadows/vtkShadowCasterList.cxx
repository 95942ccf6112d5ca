// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasterList.h"

#include "vtkNBufferDrawOrder.h"
#include "vtkNBufferForEachProp.h"
#include "vtkNBufferGlyphs.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferVertexCoordinates.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIterator.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The lighting margin of props of which it is not known where they are lit.
constexpr double Anywhere = std::numeric_limits<double>::infinity();

/// Whether the inside of an actor may be seen through its surface: VTK's shader discards fragments
/// whose alpha is 0, and shaders of the application may discard any. A texture whose alpha is 0 or
/// 255 everywhere counts as opaque if it is not interpolated.
bool MayHaveHoles(vtkActor* actor)
{
  const std::vector<vtkTexture*> textures = vtkNBufferSurface::GetTextures(actor);
  return vtkNBufferDrawOrder::MattersTo(actor) || vtkNBufferSurface::HasReplacedShaders(actor) ||
    std::any_of(textures.begin(), textures.end(),
      [](vtkTexture* texture)
      {
        vtkImageData* image = texture->GetInput();
        vtkDataArray* colors = image ? image->GetPointData()->GetScalars() : nullptr;
        return colors && colors->GetNumberOfComponents() % 2 == 0; // the last one is alpha
      });
}

/// The m of vtkShadowCaster.h for a part of a mapper, in the coordinates of the part. Whether VTK
/// moves the origin of the buffer follows from all points of the mapper. If `mapper` is nullptr,
/// the part has a buffer of its own.
glm::dvec3 GetLargestCoordinates(vtkPolyData* part, vtkMapper* mapper)
{
  const vtkBoundingBox own(part->GetBounds());
  const vtkBoundingBox all(mapper ? mapper->GetBounds() : part->GetBounds());
  if (!own.IsValid() || !all.IsValid())
  {
    return glm::dvec3(0.0);
  }
  const auto low = [](const vtkBoundingBox& box) { return glm::make_vec3(box.GetMinPoint()); };
  const auto high = [](const vtkBoundingBox& box) { return glm::make_vec3(box.GetMaxPoint()); };
  const glm::dvec3 origin =
    vtkNBufferVertexCoordinates::Estimate(mapper, low(all), high(all)).Origin;
  return glm::max(vtkNBufferGLM::Abs(low(own) - origin), vtkNBufferGLM::Abs(high(own) - origin));
}

std::vector<vtkInformationKey*> GetKeys(vtkInformation* information)
{
  std::vector<vtkInformationKey*> keys;
  if (information)
  {
    vtkNew<vtkInformationIterator> key;
    key->SetInformation(information);
    for (key->GoToFirstItem(); !key->IsDoneWithTraversal(); key->GoToNextItem())
    {
      keys.push_back(key->GetCurrentKey());
    }
  }
  return keys;
}

/// Returns true if the prop has all of these keys. (vtkProp::HasKeys() makes an iterator for each
/// prop, which takes longer than all the rest.)
bool HasKeys(vtkProp* prop, const std::vector<vtkInformationKey*>& required)
{
  return std::all_of(required.begin(), required.end(),
    [prop](vtkInformationKey* key)
    {
      vtkInformation* keys = prop->GetPropertyKeys();
      return keys && keys->Has(key) != 0;
    });
}
}

void vtkShadowCasterList::Update(vtkRenderer* renderer, vtkInformation* requiredKeys)
{
  this->Visible.clear();
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      this->Visible.push_back(prop);
    }
  }
  bool changed = this->Members.Synchronize(this->Visible.data(), this->Visible.size());
  const vtkNBufferPropWatch::GlobalState state = vtkNBufferPropWatch::GetGlobalState();
  changed = changed || state != this->GlobalState;
  this->GlobalState = state;

  // Keys, modification times and pointers may be compared in parallel.
  const std::vector<vtkInformationKey*> required = GetKeys(requiredKeys);
  vtkNBufferForEachProp::RunAhead(
    this->Members.GetSize(), [this](vtkIdType i) { this->Members[i].Watch.Prefetch(); },
    [this, &required](vtkIdType i)
    {
      Member& member = this->Members[i];
      member.HasRequiredKeys = HasKeys(this->Members.GetProp(i), required);
      member.MayHaveChanged = member.Watch.MayHaveChanged();
    });
  this->Updates = 0;
  bool anyRead = changed;
  for (std::size_t i = 0; i < this->Members.GetSize(); ++i)
  {
    Member& member = this->Members[i];
    if ((member.MayHaveChanged && member.Watch.HasChanged()) ||
      member.Casts != member.HasRequiredKeys)
    {
      member.Casts = member.HasRequiredKeys;
      changed = this->ReadProp(this->Members.GetProp(i), member) || changed;
      anyRead = true;
    }
    changed = changed || member.MovesUnseen;
  }
  this->Version += changed ? 1 : 0;
  if (anyRead)
  {
    this->Casters.clear();
    this->Skipped.fill(0);
    this->LightingMargin = 0.0;
    for (const Member& member : this->Members.GetItems())
    {
      for (const Mesh& mesh : member.Meshes)
      {
        for (const std::unique_ptr<vtkShadowCaster>& caster : mesh.Casters)
        {
          if (caster->GetNumberOfTriangles() > 0)
          {
            this->Casters.push_back(caster.get());
          }
        }
      }
      std::transform(member.Skipped.begin(), member.Skipped.end(), this->Skipped.begin(),
        this->Skipped.begin(), std::plus<int>());
      this->LightingMargin = std::max(this->LightingMargin, member.LightingMargin);
    }
  }
}

bool vtkShadowCasterList::ReadProp(vtkProp* prop, Member& member)
{
  const int updatesBefore = this->Updates;
  const vtkMTimeType timeBefore = member.Watch.GetTime();
  const std::size_t meshesBefore = member.Meshes.size();
  this->OldMeshes = std::move(member.Meshes);
  member.Meshes.clear();
  member.Skipped.fill(0);
  member.LightingMargin = 0.0;
  member.MovesUnseen = false;
  if (vtkActor* actor = vtkNBufferKnownClasses::GetPlainActor(prop))
  {
    vtkNBufferSurface::UpdatePipeline(actor);
  }
  this->AddProp(prop, member);
  this->OldMeshes.clear();
  this->OldPlaces.clear();
  // The times of all blocks that may be seen have been compared if all of them cast.
  const bool allCast = member.Casts &&
    std::all_of(
      member.Skipped.begin(), member.Skipped.end(), [](int skipped) { return skipped == 0; });
  member.Watch.Track(prop, !allCast);
  return member.Watch.GetMeans() == vtkNBufferPropWatch::Means::None ||
    member.Watch.GetTime() != timeBefore || this->Updates != updatesBefore ||
    member.Meshes.size() != meshesBefore;
}

void vtkShadowCasterList::AddProp(vtkProp* prop, Member& member)
{
  if (vtkActor2D::SafeDownCast(prop))
  {
    return;
  }
  // Plain actors need no paths, which would take more time than all the rest.
  if (vtkActor* actor = vtkNBufferKnownClasses::GetPlainActor(prop))
  {
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
      member.LightingMargin = Anywhere;
      member.Skip(vtkShadowSkip::NotAnActor);
    }
    else if (actor->GetVisibility())
    {
      vtkNBufferSurface::UpdatePipeline(actor);
      this->AddActor(
        actor, path, last->GetMatrix() ? last->GetMatrix() : actor->GetMatrix(), member);
    }
    ++path;
  }
}

void vtkShadowCasterList::AddActor(vtkActor* actor, int path, vtkMatrix4x4* matrix, Member& member)
{
  if (!actor->GetMapper())
  {
    return;
  }
  // Through a prop that blends among opaque ones, surfaces behind the nearest one are seen, which
  // may be anywhere.
  member.LightingMargin = std::max(member.LightingMargin,
    vtkNBufferDrawOrder::MattersTo(actor) ? Anywhere : vtkNBufferSurface::GetLightingMargin(actor));
  member.MovesUnseen = member.MovesUnseen || vtkNBufferSurface::HasReplacedShaders(actor) ||
    vtkNBufferSurface::HasOtherCoordinates(actor);
  if (!member.Casts)
  {
    return;
  }
  // The mesh of a skybox fills the view, wherever it is in the scene.
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE || vtkSkybox::SafeDownCast(actor))
  {
    member.Skip(vtkShadowSkip::NotASurface);
    return;
  }
  if (actor->HasTranslucentPolygonalGeometry())
  {
    member.Skip(vtkShadowSkip::Translucent);
    return;
  }
  const std::vector<vtkNBufferSurface::Plane> planes =
    vtkNBufferSurface::GetClippingPlanes(actor->GetMapper());
  // A matrix that mirrors makes the device take front faces for back faces.
  vtkProperty* property = actor->GetProperty();
  const bool isInsideSeen = MayHaveHoles(actor) ||
    (matrix->Determinant() < 0.0 ? property->GetBackfaceCulling()
                                 : property->GetFrontfaceCulling());
  const auto addMesh = [&](const vtkNBufferSurface::Part& part, vtkGlyph3DMapper* glyphs)
  {
    this->AddMesh(part, glyphs, path, planes, member);
    const glm::dvec3 largest =
      GetLargestCoordinates(part.Mesh, glyphs ? nullptr : actor->GetMapper());
    for (const std::unique_ptr<vtkShadowCaster>& caster : member.Meshes.back().Casters)
    {
      caster->SetInsideIsSeen(isInsideSeen);
      caster->SetRounding(largest, glyphs ? &part.ToWorld : nullptr);
    }
  };
  vtkGlyph3DMapper* glyphs = vtkNBufferGlyphs::GetMapper(actor->GetMapper());
  if (glyphs && glyphs->GetNumberOfInputConnections(1) == 1)
  {
    vtkNBufferSurface::Part part;
    part.Mesh = glyphs->GetSource();
    std::copy_n(matrix->GetData(), 16, part.ToWorld.begin());
    addMesh(part, glyphs);
    return;
  }
  if (member.Surfaces.size() <= static_cast<std::size_t>(path))
  {
    member.Surfaces.resize(static_cast<std::size_t>(path) + 1);
  }
  if (!member.Surfaces[static_cast<std::size_t>(path)].GetParts(actor, matrix, this->Parts))
  {
    member.Skip(vtkShadowSkip::NotAPlainMapper);
    return;
  }
  for (const vtkNBufferSurface::Part& part : this->Parts)
  {
    if (part.IsVisible && part.IsTranslucent)
    {
      member.Skip(vtkShadowSkip::Translucent);
    }
    else if (part.IsVisible)
    {
      addMesh(part, nullptr);
    }
  }
}

void vtkShadowCasterList::AddMesh(const vtkNBufferSurface::Part& part, vtkGlyph3DMapper* glyphs,
  int path, const std::vector<vtkNBufferSurface::Plane>& planes, Member& member)
{
  Mesh& mesh = member.Meshes.emplace_back(this->TakeOldMesh(path, part.Mesh, member.Meshes.size()));
  const vtkMTimeType time = part.Mesh->GetMTime();
  const vtkMTimeType instancesTime = glyphs ? vtkNBufferGlyphs::GetTime(glyphs) : 0;
  if (!mesh.Topology || mesh.Time != time)
  {
    mesh.Topology = vtkShadowCaster::MakeTopology(part.Mesh);
  }
  else if (mesh.InstancesTime == instancesTime && mesh.ToWorld == part.ToWorld &&
    mesh.Planes == planes)
  {
    return;
  }
  mesh.Time = time;
  mesh.InstancesTime = instancesTime;
  mesh.ToWorld = part.ToWorld;
  mesh.Planes = planes;
  std::vector<std::array<double, 16>> places = { part.ToWorld };
  if (glyphs)
  {
    places = vtkNBufferGlyphs::GetMatrices(glyphs);
    for (std::array<double, 16>& place : places)
    {
      vtkMatrix4x4::Multiply4x4(part.ToWorld.data(), place.data(), place.data());
    }
  }
  mesh.Casters.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::unique_ptr<vtkShadowCaster>& caster = mesh.Casters[i];
    if (!caster)
    {
      caster = std::make_unique<vtkShadowCaster>();
    }
    this->Updates += caster->Update(mesh.Topology, places[i], planes) ? 1 : 0;
  }
}

vtkShadowCasterList::Mesh vtkShadowCasterList::TakeOldMesh(
  int path, const void* block, std::size_t place)
{
  const auto take = [this](std::size_t i)
  {
    Mesh mesh = std::move(this->OldMeshes[i]);
    this->OldMeshes[i].Block = nullptr;
    return mesh;
  };
  const auto isThere = [this, path, block](std::size_t i)
  { return this->OldMeshes[i].Block == block && this->OldMeshes[i].Path == path; };
  if (place < this->OldMeshes.size() && isThere(place))
  {
    return take(place);
  }
  if (this->OldPlaces.empty())
  {
    for (std::size_t i = 0; i < this->OldMeshes.size(); ++i)
    {
      this->OldPlaces.emplace(this->OldMeshes[i].Block, i);
    }
  }
  const auto [begin, end] = this->OldPlaces.equal_range(block);
  for (auto found = begin; found != end; ++found)
  {
    if (isThere(found->second))
    {
      return take(found->second);
    }
  }
  return { path, block };
}
VTK_ABI_NAMESPACE_END
