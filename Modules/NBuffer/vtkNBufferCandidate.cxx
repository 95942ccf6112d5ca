// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidate.h"

#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTrivialProducer.h"
#include "vtkVolume.h"

#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
#include "vtkCompositePolyDataMapper2.h"
#endif

#include <algorithm>
#include <cmath>
#include <typeinfo>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
bool HasReplacedShaders(vtkShaderProperty* shaders)
{
  return shaders &&
    (shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode() ||
      shaders->HasGeometryShaderCode() || shaders->GetNumberOfShaderReplacements() > 0);
}

bool IsCompositeMapper(vtkMapper* mapper)
{
  const std::type_info& type = typeid(*mapper);
#if VTKNBUFFER_HAS_COMPOSITE_MAPPER_2
  if (type == typeid(vtkCompositePolyDataMapper2))
  {
    return true;
  }
#endif
  return type == typeid(vtkCompositePolyDataMapper);
}

/// Exactly these classes: a subclass may draw outside of its bounds.
bool IsPlainMapper(vtkMapper* mapper)
{
  const std::type_info& type = typeid(*mapper);
  return type == typeid(vtkOpenGLPolyDataMapper) || type == typeid(vtkDataSetMapper) ||
    IsCompositeMapper(mapper);
}

bool HasOtherCoordinates(vtkActor* actor)
{
#if VTKNBUFFER_HAS_COORDINATE_SYSTEMS
  return actor->GetCoordinateSystem() != vtkProp3D::WORLD;
#else
  (void)actor;
  return false;
#endif
}

/// What is drawn as lines or points is as wide as the property says, in pixels.
double GetMargin(vtkMapper* mapper, vtkProperty* property)
{
  vtkPolyData* input = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (input && input->GetNumberOfVerts() == 0 && input->GetNumberOfLines() == 0)
  {
    return 0.0;
  }
  return 0.5 * std::max(property->GetLineWidth(), property->GetPointSize()) + 1.0;
}

/// Whether the mapper's parameters may pull a surface nearer than its vertices. Parameters that
/// push it away are harmless, and without global resolution only visible edges switch them on.
bool HasOffsetTowardsEye(vtkMapper* mapper, bool linesOrPoints)
{
  switch (vtkMapper::GetResolveCoincidentTopology())
  {
    case VTK_RESOLVE_OFF:
      return false;
    case VTK_RESOLVE_POLYGON_OFFSET:
    {
      double factor = 0.0;
      double units = 0.0;
      mapper->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
      return linesOrPoints || !(factor >= 0.0 && units >= 0.0);
    }
    default:
      return true;
  }
}

bool HasUsableBounds(const double* bounds)
{
  return bounds && vtkMath::AreBoundsInitialized(bounds) &&
    std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); });
}
}

vtkNBufferCandidate::GlobalState vtkNBufferCandidate::GetGlobalState()
{
  GlobalState state{};
  state[0] = vtkMapper::GetResolveCoincidentTopology();
  state[1] = vtkMapper::GetResolveCoincidentTopologyZShift();
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(state[2], state[3]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(state[4], state[5]);
  return state;
}

bool vtkNBufferCandidate::Refresh()
{
  // Nothing else is known of a subclass or another kind of prop, and never will be.
  if (typeid(*this->Prop) != typeid(vtkOpenGLActor))
  {
    const bool first = this->Verdict != vtkNBufferVerdict::NotAPlainActor;
    this->Verdict = vtkNBufferVerdict::NotAPlainActor;
    this->Actor = nullptr;
    this->Volatile = false;
    this->DepthWriter =
      !vtkActor2D::SafeDownCast(this->Prop) && !vtkVolume::SafeDownCast(this->Prop);
    this->Tracked = !this->DepthWriter;
    return first;
  }

  const vtkMTimeType timeBefore = this->Time;
  const vtkNBufferVerdict verdictBefore = this->Verdict;
  this->Actor = static_cast<vtkActor*>(this->Prop);
  this->Mapper = this->Actor->GetMapper();
  this->TakeBounds(this->Actor);
  this->Verdict = this->Classify(this->Actor);
  // A composite mapper's blocks have attributes of their own.
  this->Tracked = this->Mapper == nullptr ||
    (IsPlainMapper(this->Mapper) && !IsCompositeMapper(this->Mapper) &&
      this->Verdict != vtkNBufferVerdict::ShaderReplaced &&
      this->Verdict != vtkNBufferVerdict::OtherCoordinates);
  this->DepthWriter = this->Mapper && this->Actor->HasOpaqueGeometry();
  this->TakeSources(this->Actor);
  return this->Time != timeBefore || this->Verdict != verdictBefore;
}

void vtkNBufferCandidate::TakeSources(vtkActor* actor)
{
  this->Volatile = true;
  if (!this->Mapper)
  {
    this->Time = actor->GetMTime();
    return;
  }
  vtkAlgorithm* producer = this->Mapper->GetNumberOfInputPorts() > 0 &&
      this->Mapper->GetNumberOfInputConnections(0) == 1
    ? this->Mapper->GetInputAlgorithm(0, 0)
    : nullptr;
  vtkDataObject* input = this->Mapper->GetInputDataObject(0, 0);
  if (producer && input && typeid(*producer) == typeid(vtkTrivialProducer) &&
    typeid(*input) == typeid(vtkPolyData) && IsPlainMapper(this->Mapper) &&
    !IsCompositeMapper(this->Mapper))
  {
    // A texture's translucency, a transform's pipeline and shared clipping planes are beyond what
    // may be asked of several props at a time.
    this->Volatile = actor->GetTexture() || actor->GetUserTransform() ||
      this->Mapper->GetClippingPlanes() ||
      !this->Sources.Take(actor, this->Mapper, producer, static_cast<vtkPolyData*>(input));
  }
  if (!this->Volatile)
  {
    this->Time = this->Sources.GetTime();
    return;
  }
  this->Time = std::max(actor->GetMTime(), this->Mapper->GetMTime());
  if (vtkShaderProperty* shaders = vtkNBufferSources::GetShaderProperty(actor))
  {
    this->Time = std::max(this->Time, shaders->GetMTime());
  }
  if (input)
  {
    this->Time = std::max(this->Time, input->GetMTime());
  }
}

vtkNBufferVerdict vtkNBufferCandidate::Classify(vtkActor* actor) const
{
  if (HasOtherCoordinates(actor))
  {
    return vtkNBufferVerdict::OtherCoordinates;
  }
  if (!this->Mapper || !IsPlainMapper(this->Mapper))
  {
    return vtkNBufferVerdict::NotAPlainMapper;
  }
  vtkProperty* property = actor->GetProperty();
  if (property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility() || property->GetRenderPointsAsSpheres() ||
    property->GetRenderLinesAsTubes())
  {
    return vtkNBufferVerdict::NotASurface;
  }
  if (HasReplacedShaders(vtkNBufferSources::GetShaderProperty(actor)))
  {
    return vtkNBufferVerdict::ShaderReplaced;
  }
  if (HasOffsetTowardsEye(this->Mapper, this->Box.Margin > 0.0))
  {
    return vtkNBufferVerdict::DepthOffset;
  }
  if (!this->BoxIsUsable)
  {
    return vtkNBufferVerdict::NoBounds;
  }
  if (actor->HasTranslucentPolygonalGeometry() || !actor->HasOpaqueGeometry())
  {
    return vtkNBufferVerdict::Translucent;
  }
  return vtkNBufferVerdict::Visible;
}

void vtkNBufferCandidate::TakeBounds(vtkActor* actor)
{
  // GetBounds() also brings the pipeline and the actor's matrix up to date.
  const double* bounds = this->Mapper ? actor->GetBounds() : nullptr;
  this->BoxIsUsable = HasUsableBounds(bounds);
  if (!this->BoxIsUsable)
  {
    return;
  }
  this->Box = vtkNBufferBox::FromBounds(bounds);
  this->Box.Margin = GetMargin(this->Mapper, actor->GetProperty());
  // sum_k |A_jk| |v_k|, see vtkNBufferProjection.h. The mapper's bounds are model coordinates.
  const double* model = this->Mapper->GetBounds();
  vtkMatrix4x4* matrix = actor->GetMatrix();
  for (int j = 0; j < 3; ++j)
  {
    double magnitude = std::abs(matrix->GetElement(j, 3));
    for (int k = 0; k < 3; ++k)
    {
      magnitude += std::abs(matrix->GetElement(j, k)) *
        std::max(std::abs(model[2 * k]), std::abs(model[2 * k + 1]));
    }
    this->Box.Magnitude[j] = std::max(this->Box.Magnitude[j], magnitude);
  }
}
VTK_ABI_NAMESPACE_END
