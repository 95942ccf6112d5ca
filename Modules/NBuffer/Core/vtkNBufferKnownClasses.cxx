// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferKnownClasses.h"

#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRenderPass.h"

#include VTKNBUFFER_COMPOSITE_MAPPER_HEADER

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
struct Lists
{
  std::mutex Mutex;
  std::atomic<int> Version{ 0 };
  std::array<std::set<std::string, std::less<>>, 3> Names = { {
    // VTK's passes that draw the renderer's own props from its own camera, and the pass by which
    // ParaView draws what vtkRenderer draws without a pass. Whether a pass draws in another size or
    // with another camera is checked later, when the proxy is drawn.
    { "vtkSequencePass", "vtkCameraPass", "vtkRenderStepsPass", "vtkSSAOPass", "vtkSSAAPass",
      "vtkOpenGLFXAAPass", "vtkToneMappingPass", "vtkLightsPass", "vtkDefaultPass", "vtkOpaquePass",
      "vtkTranslucentPass", "vtkVolumetricPass", "vtkOverlayPass", "vtkClearZPass",
      "vtkDepthPeelingPass", "vtkDualDepthPeelingPass", "vtkOrderIndependentTranslucentPass",
      "vtkFramebufferPass", "vtkPVDefaultPass" },
    {},
    // ParaView's actor. Its GetMapper() returns the one of its two mappers that it would draw, and
    // a vtkOpenGLActor with its property, texture, shaders and matrix draws that one.
    { "vtkPVLODActor" },
  } };
};

Lists& GetLists()
{
  static Lists lists;
  return lists;
}

bool IsListed(vtkNBufferKnownClasses::List list, vtkObjectBase* object)
{
  Lists& lists = GetLists();
  const std::lock_guard<std::mutex> lock(lists.Mutex);
  return lists.Names[list].count(object->GetClassName()) > 0;
}
}

namespace vtkNBufferKnownClasses
{
/// Whether a mapper of polydata draws in several pieces. Its bounds and its input are those of one
/// piece.
static bool DrawsInPieces(vtkMapper* mapper)
{
  return static_cast<vtkPolyDataMapper*>(mapper)->GetNumberOfSubPieces() > 1;
}

static MapperKind GetOwnKind(vtkMapper* mapper)
{
  const std::type_info& type = typeid(*mapper);
  if (type == typeid(vtkOpenGLPolyDataMapper))
  {
    return MapperKind::PolyData;
  }
  if (type == typeid(vtkDataSetMapper))
  {
    return MapperKind::DataSet;
  }
  return type == typeid(VTKNBUFFER_COMPOSITE_MAPPER) || type == typeid(vtkCompositePolyDataMapper)
    ? MapperKind::Composite
    : MapperKind::Other;
}

/// The kind of the known class from which a mapper is derived.
static MapperKind GetKindOfBase(vtkMapper* mapper)
{
  // It comes first, because vtkCompositePolyDataMapper2 is a vtkOpenGLPolyDataMapper as well.
  if (VTKNBUFFER_COMPOSITE_MAPPER::SafeDownCast(mapper) ||
    vtkCompositePolyDataMapper::SafeDownCast(mapper))
  {
    return MapperKind::Composite;
  }
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    return MapperKind::PolyData;
  }
  return vtkDataSetMapper::SafeDownCast(mapper) ? MapperKind::DataSet : MapperKind::Other;
}

bool Add(List list, const char* name)
{
  if (!name || !*name)
  {
    return false;
  }
  Lists& lists = GetLists();
  const std::lock_guard<std::mutex> lock(lists.Mutex);
  lists.Version += lists.Names[list].insert(name).second ? 1 : 0;
  return true;
}

int GetVersion()
{
  return GetLists().Version;
}

bool IsKnown(vtkRenderPass* pass)
{
  return IsListed(Passes, pass);
}

MapperKind GetKind(vtkMapper* mapper)
{
  const MapperKind own = GetOwnKind(mapper);
  const MapperKind kind =
    own == MapperKind::Other && IsListed(Mappers, mapper) ? GetKindOfBase(mapper) : own;
  return kind == MapperKind::PolyData && DrawsInPieces(mapper) ? MapperKind::Other : kind;
}

bool DrawsPolygons(vtkMapper* mapper)
{
  const char* const names[] = { "vtkPointGaussianMapper", "vtkOpenGLSphereMapper",
    "vtkOpenGLStickMapper", "vtkFastLabeledDataMapper" };
  return vtkPolyDataMapper::SafeDownCast(mapper) && !DrawsInPieces(mapper) &&
    std::none_of(std::begin(names), std::end(names),
      [mapper](const char* name) { return mapper->IsA(name) != 0; });
}

vtkActor* GetPlainActor(vtkProp* prop)
{
  if (typeid(*prop) == typeid(vtkOpenGLActor))
  {
    return static_cast<vtkActor*>(prop);
  }
  return IsListed(Actors, prop) ? vtkActor::SafeDownCast(prop) : nullptr;
}

bool HaveKnownTimes(vtkActor* actor)
{
  return typeid(*actor) == typeid(vtkOpenGLActor) &&
    GetOwnKind(actor->GetMapper()) != MapperKind::Other;
}
}
VTK_ABI_NAMESPACE_END
