// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPropWatch.h"

#include "vtkNBufferForEachChild.h"
#include "vtkNBufferForEachProp.h"
#include "vtkNBufferGlyphs.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferObservedObjects.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <typeinfo>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
using vtkNBufferProtectedMembers::GetOwnTime;

namespace
{
/// Whether GetMTime() of a user's transform modifies no object, so that it may be called in
/// parallel. vtkProp3D wraps a user's matrix in a vtkMatrixToLinearTransform.
bool IsPlain(vtkLinearTransform* transform)
{
  return !transform || typeid(*transform) == typeid(vtkTransform) ||
    typeid(*transform) == typeid(vtkMatrixToLinearTransform);
}

/// The executive of the mapper's input if the rules of its class are known, otherwise nullptr.
vtkDemandDrivenPipeline* GetExecutive(vtkMapper* mapper)
{
  vtkExecutive* executive = mapper->GetInputExecutive(0, 0);
  return executive &&
      (typeid(*executive) == typeid(vtkStreamingDemandDrivenPipeline) ||
        typeid(*executive) == typeid(vtkCompositeDataPipeline))
    ? static_cast<vtkDemandDrivenPipeline*>(executive)
    : nullptr;
}

/// Whether the output of the filters depends on requests, and not only on their parameters.
bool DependsOnRequests(vtkInformation* request)
{
#if VTKNBUFFER_HAS_ABORTED_FILTERS
  if (request->Get(vtkAlgorithm::ABORTED()) != 0)
  {
    return true;
  }
#endif
  return request->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()) ||
    request->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
}

/// The time of a mapper or texture, and of all data that it shows.
vtkMTimeType GetTimeWithData(vtkAlgorithm* algorithm, bool withBlocks)
{
  vtkMTimeType time = algorithm->GetMTime();
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      // A producer may get other data that is older than all else.
      time = std::max({ time, algorithm->GetInputAlgorithm(port, i)->GetMTime(),
        vtkNBufferPropWatch::GetDataTime(algorithm->GetInputDataObject(port, i), withBlocks) });
    }
  }
  return time;
}

/// The newest time of an actor whose pipeline is up to date.
vtkMTimeType GetTimeOfAll(vtkActor* actor, vtkShaderProperty* shaders, bool withBlocks)
{
  // This comes first, because an actor creates a property that is missing.
  const std::vector<vtkTexture*> textures = vtkNBufferSurface::GetTextures(actor);
  vtkMTimeType time = std::max(actor->GetMTime(), shaders ? shaders->GetMTime() : 0);
  for (vtkTexture* texture : textures)
  {
    // A transform that changes leaves the time of its texture as it is.
    vtkTransform* transform = texture->GetTransform();
    time = std::max(
      { time, GetTimeWithData(texture, withBlocks), transform ? transform->GetMTime() : 0 });
  }
  if (vtkMapper* mapper = actor->GetMapper())
  {
    time = std::max(time, GetTimeWithData(mapper, withBlocks));
    // A plane that moves leaves the time of the mapper that it clips as it is.
    vtkPlaneCollection* planes = mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      time = std::max(time, planes->GetItem(i)->GetMTime());
    }
  }
  return time;
}
}

vtkMTimeType vtkNBufferPropWatch::GetDataTime(vtkDataObject* data, bool withBlocks)
{
  vtkMTimeType time = 0;
  vtkNBufferAnyNode(data,
    [&time, withBlocks](vtkDataObject* node)
    {
      time = std::max(time, node->GetMTime());
      return !withBlocks;
    });
  return time;
}

vtkNBufferPropWatch::GlobalState vtkNBufferPropWatch::GetGlobalState()
{
  GlobalState state{};
  state[0] = vtkMapper::GetResolveCoincidentTopology();
  state[1] = vtkMapper::GetResolveCoincidentTopologyZShift();
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(state[2], state[3]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(state[4], state[5]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(state[6]);
  state[7] = vtkNBufferKnownClasses::GetVersion();
  return state;
}

void vtkNBufferPropWatch::Track(vtkProp* prop, bool withBlocks)
{
  this->How = Means::None;
  this->Time = 0;
  this->Complete = this->IsSettled = false;
  this->Forget();
  this->Actor = vtkNBufferKnownClasses::GetPlainActor(prop);
  this->Mapper = this->Actor ? this->Actor->GetMapper() : nullptr;
  if (!this->Actor)
  {
    return;
  }
  this->Shaders = vtkNBufferProtectedMembers::GetShaderProperty(this->Actor);
  if (this->Mapper && !vtkNBufferSurface::IsPlain(this->Mapper))
  {
    this->Time = GetTimeOfAll(this->Actor, this->Shaders, withBlocks);
    this->How = vtkNBufferGlyphs::GetMapper(this->Mapper) ? Means::Times : Means::None;
    return;
  }
  this->UserTransform = this->Actor->GetUserTransform();
  this->Complete = !this->Mapper ||
    (!vtkNBufferSurface::IsComposite(this->Mapper) && !this->Mapper->GetSelection() &&
      !vtkNBufferSurface::HasReplacedShaders(this->Actor) &&
      !vtkNBufferSurface::HasOtherCoordinates(this->Actor));
  // Whether a texture is translucent depends on a pipeline of its own, and the time of a mapper
  // does not include those of its clipping planes.
  vtkPolyData* input = this->Mapper && vtkNBufferSurface::GetTextures(this->Actor).empty() &&
      !this->Mapper->GetClippingPlanes()
    ? vtkNBufferSurface::GetOnlyPolyData(this->Mapper)
    : nullptr;
  this->Input = input;
  if (input && vtkNBufferKnownClasses::HaveKnownTimes(this->Actor) &&
    this->TrackStamps(this->Mapper, input))
  {
    this->How = Means::Stamps;
    return;
  }
  this->Time = GetTimeOfAll(this->Actor, this->Shaders, withBlocks);
  this->How = input && this->GetPipelineTime(this->PipelineTime) ? Means::Pipeline : Means::Times;
}

bool vtkNBufferPropWatch::Add(vtkObject* object)
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

bool vtkNBufferPropWatch::AddFields(vtkFieldData* fields)
{
  bool fits = this->Add(fields);
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    fits = fits && this->Add(fields->GetAbstractArray(i));
  }
  return fits;
}

bool vtkNBufferPropWatch::TrackStamps(vtkMapper* mapper, vtkPolyData* input)
{
  vtkAlgorithm* producer = mapper->GetInputAlgorithm(0, 0);
  if (!producer || typeid(*producer) != typeid(vtkTrivialProducer) || !IsPlain(this->UserTransform))
  {
    return false;
  }
  // A lookup table that is missing now is made when there are scalars to map, and such a change
  // shows in the data.
  vtkScalarsToColors* table = vtkNBufferProtectedMembers::GetLookupTable(mapper);
  this->Count = 0;
  vtkPoints* points = input->GetPoints();
  const bool fits = this->Add(this->Actor->GetProperty()) &&
    this->Add(this->Actor->GetBackfaceProperty()) && this->Add(this->Actor->GetUserMatrix()) &&
    this->Add(this->Shaders) && this->Add(mapper) && this->Add(table) && this->Add(producer) &&
    this->Add(input) && this->Add(points) && this->Add(points ? points->GetData() : nullptr) &&
    this->Add(input->GetVerts()) && this->Add(input->GetLines()) && this->Add(input->GetPolys()) &&
    this->Add(input->GetStrips()) && this->AddFields(input->GetPointData()) &&
    this->AddFields(input->GetCellData()) && this->AddFields(input->GetFieldData());

  this->Time =
    std::max(GetOwnTime(this->Actor), this->UserTransform ? this->UserTransform->GetMTime() : 0);
  for (int i = 0; i < this->Count; ++i)
  {
    this->Time = std::max(this->Time, GetOwnTime(this->Objects[i]));
  }
  const vtkMTimeType shaders = this->Shaders ? this->Shaders->GetMTime() : 0;
  // Other classes combine the times of still other objects.
  const bool plain = (!table || typeid(*table) == typeid(vtkLookupTable)) &&
    (!points || typeid(*points) == typeid(vtkPoints));
  return fits && plain &&
    this->Time ==
    std::max({ this->Actor->GetMTime(), mapper->GetMTime(), producer->GetMTime(), shaders });
}

bool vtkNBufferPropWatch::ActorHasChanged() const
{
  return GetOwnTime(this->Actor) > this->Time ||
    vtkNBufferProtectedMembers::GetShaderProperty(this->Actor) != this->Shaders ||
    (this->UserTransform && this->UserTransform->GetMTime() > this->Time);
}

bool vtkNBufferPropWatch::ObjectsHaveChanged() const
{
  // The order matters: an object is known to be alive only if the objects before it have not
  // changed.
  for (int i = 0; i < this->Count; ++i)
  {
    if (GetOwnTime(this->Objects[i]) > this->Time)
    {
      return true;
    }
  }
  return false;
}

void vtkNBufferPropWatch::Prefetch(bool observedAreUnchanged) const
{
  if (this->How != Means::Stamps)
  {
    return;
  }
  vtkNBufferForEachProp::Fetch(&vtkNBufferProtectedMembers::GetTimeStamp(this->Actor));
  vtkNBufferForEachProp::Fetch(&vtkNBufferProtectedMembers::GetShaderProperty(this->Actor));
  for (int i = 0; !(observedAreUnchanged && this->Observed) && i < this->Count; ++i)
  {
    vtkNBufferForEachProp::Fetch(&vtkNBufferProtectedMembers::GetTimeStamp(this->Objects[i]));
  }
}

void vtkNBufferPropWatch::Observe(
  vtkNBufferObservedObjects& objects, vtkNBufferObservedObjects& actors)
{
  if (this->How != Means::Stamps || this->Observed || !std::exchange(this->IsSettled, true))
  {
    return;
  }
  // Another thread may have modified an object since it was compared in this frame.
  this->Observed = std::all_of(this->Objects.begin(), this->Objects.begin() + this->Count,
                     [&objects](vtkObject* object) { return objects.Add(object); }) &&
    !this->MayHaveChanged();
  this->ActorObserved = this->Observed && this->Shaders && !this->UserTransform &&
    actors.Add(this->Actor) && !this->ActorHasChanged();
}

bool vtkNBufferPropWatch::GetPipelineTime(vtkMTimeType& time) const
{
  // The actor keeps its mapper alive, the mapper its input algorithm, and the algorithm its data.
  vtkDemandDrivenPipeline* executive = GetExecutive(this->Mapper);
  if (!executive || DependsOnRequests(this->Mapper->GetInputInformation(0, 0)) ||
    !executive->UpdatePipelineMTime() || this->Mapper->GetInputDataObject(0, 0) != this->Input ||
    this->Input->GetDataReleased())
  {
    return false;
  }
  time = std::max({ this->Actor->GetMTime(), this->Mapper->GetMTime(),
    executive->GetPipelineMTime(), this->Input->GetMTime() });
  if (this->Shaders)
  {
    time = std::max(time, this->Shaders->GetMTime());
  }
  return true;
}

bool vtkNBufferPropWatch::PipelineHasChanged() const
{
  vtkMTimeType time = 0;
  // Another prop may have been made at the address of the actor. Its stamp is newer, and must be
  // checked first, because no function of an actor may be called for it.
  return GetOwnTime(this->Actor) > this->Time || this->Actor->GetMapper() != this->Mapper ||
    vtkNBufferProtectedMembers::GetShaderProperty(this->Actor) != this->Shaders ||
    this->Mapper->GetNumberOfInputConnections(0) != 1 || !this->GetPipelineTime(time) ||
    time > this->PipelineTime;
}
VTK_ABI_NAMESPACE_END
