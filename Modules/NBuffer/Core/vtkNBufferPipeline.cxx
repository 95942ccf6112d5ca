// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPipeline.h"

#include "vtkNBufferSources.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkDataObject.h"
#include "vtkDataSetMapper.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkShaderProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The executive of what feeds the mapper if it is one whose rules are known, or nullptr.
vtkDemandDrivenPipeline* GetExecutive(vtkMapper* mapper)
{
  vtkExecutive* executive = mapper->GetInputExecutive(0, 0);
  return executive &&
      (typeid(*executive) == typeid(vtkStreamingDemandDrivenPipeline) ||
        typeid(*executive) == typeid(vtkCompositeDataPipeline))
    ? static_cast<vtkDemandDrivenPipeline*>(executive)
    : nullptr;
}

/// Whether requests decide about what the filters make, and not their parameters alone.
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
}

bool vtkNBufferPipeline::Take(vtkActor* actor)
{
  this->Actor = actor;
  this->Mapper = actor->GetMapper();
  if (!this->Mapper ||
    (typeid(*this->Mapper) != typeid(vtkOpenGLPolyDataMapper) &&
      typeid(*this->Mapper) != typeid(vtkDataSetMapper)) ||
    this->Mapper->GetNumberOfInputConnections(0) != 1)
  {
    return false;
  }
  this->Input = this->Mapper->GetInputDataObject(0, 0);
  this->Shaders = vtkNBufferSources::GetShaderProperty(actor);
  // A texture's translucency has a pipeline of its own, and planes are not part of the mapper's
  // time.
  return this->Input && typeid(*this->Input) == typeid(vtkPolyData) && !actor->GetTexture() &&
    !this->Mapper->GetClippingPlanes() && this->GetTime(this->Time);
}

bool vtkNBufferPipeline::GetTime(vtkMTimeType& time) const
{
  // The actor keeps its mapper alive, the mapper what feeds it, and that its data.
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

bool vtkNBufferPipeline::HasChanged() const
{
  vtkMTimeType time = 0;
  return this->Actor->GetMapper() != this->Mapper ||
    vtkNBufferSources::GetShaderProperty(this->Actor) != this->Shaders ||
    this->Mapper->GetNumberOfInputConnections(0) != 1 || !this->GetTime(time) || time > this->Time;
}
VTK_ABI_NAMESPACE_END
