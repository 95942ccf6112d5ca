// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCandidate.h"

#include "vtkActor2D.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
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
/// VTK writes the largest float or something near it where it means infinity.
constexpr double Infinite = 1e30;

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

bool HasLines(vtkDataSet* data)
{
  if (auto* polys = vtkPolyData::SafeDownCast(data))
  {
    return polys->GetNumberOfLines() > 0;
  }
  vtkNew<vtkCellTypes> types;
  data->VTKNBUFFER_GET_CELL_TYPES(types);
  vtkNew<vtkGenericCell> cell;
  for (int i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    cell->SetCellType(types->GetCellType(i));
    if (cell->GetCellDimension() == 1)
    {
      return true;
    }
  }
  return false;
}

/// Whether the mapper draws lines, as far as its input is at hand.
bool DrawsLines(vtkMapper* mapper)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    return HasLines(data);
  }
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      auto* data = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject());
      if (data && HasLines(data))
      {
        return true;
      }
    }
  }
  return false;
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

/// What vtkActor::HasTranslucentPolygonalGeometry asks when nothing is forced.
bool IsTranslucentByItself(vtkActor* actor)
{
  vtkTexture* texture = actor->GetTexture();
  vtkMapper* mapper = actor->GetMapper();
  return actor->GetProperty()->GetOpacity() < 1.0 || (texture && texture->IsTranslucent()) ||
    (mapper && mapper->HasTranslucentPolygonalGeometry());
}

/// A plane that moves leaves the time of the mapper that it clips as it is.
vtkMTimeType GetTimeOfClippingPlanes(vtkMapper* mapper)
{
  vtkMTimeType time = 0;
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    for (int i = 0; i < planes->GetNumberOfItems(); ++i)
    {
      time = std::max(time, planes->GetItem(i)->GetMTime());
    }
  }
  return time;
}

/// Where the zero of a mapper's vertex buffer lies in model coordinates, and how far its vertices
/// reach from there.
struct BufferCoordinates
{
  bool Known = true;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double HalfRange[3] = { 0.0, 0.0, 0.0 };
};

/// Range of one component as vtkDataArray::GetRange gives it. That caches its result behind some
/// microseconds of dispatch, which for thousands of small meshes is most of a first frame.
void GetRange(vtkDataArray* points, int component, double range[2])
{
  constexpr vtkIdType few = 1024;
  auto* floats = vtkFloatArray::FastDownCast(points);
  if (floats && floats->GetNumberOfComponents() == 3 && floats->GetNumberOfTuples() > 0 &&
    floats->GetNumberOfTuples() <= few)
  {
    const float* values = floats->GetPointer(0);
    float low = values[component];
    float high = low;
    bool finite = true;
    for (vtkIdType i = 0; i < floats->GetNumberOfTuples(); ++i)
    {
      const float value = values[3 * i + component];
      low = std::min(low, value);
      high = std::max(high, value);
      finite = finite && std::isfinite(value);
    }
    if (finite)
    {
      range[0] = low;
      range[1] = high;
      return;
    }
  }
  points->GetRange(range, component);
}

/// Whether vtkOpenGLVertexBufferObject::UpdateShiftScale moves points with these ranges.
bool IsShifted(vtkOpenGLPolyDataMapper* mapper, const double ranges[3][2])
{
  using Method = vtkOpenGLVertexBufferObject;
  switch (mapper->GetVBOShiftScaleMethod())
  {
    case Method::ALWAYS_AUTO_SHIFT_SCALE:
    case Method::AUTO_SHIFT:
      return true;
    case Method::AUTO_SHIFT_SCALE:
    {
      double size2 = 0.0;
      double distance2 = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double size = ranges[k][1] - ranges[k][0];
        const double middle = 0.5 * (ranges[k][1] + ranges[k][0]);
        size2 += size * size;
        distance2 += middle * middle;
      }
      return size2 > 0.0 ? distance2 / size2 > 1.0e6 || std::abs(std::log10(size2)) > 3.0
                         : distance2 > 1.0e6;
    }
    default:
      return false;
  }
}

BufferCoordinates GetBufferCoordinates(vtkMapper* mapper)
{
  BufferCoordinates result;
  auto* plain = typeid(*mapper) == typeid(vtkOpenGLPolyDataMapper)
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : nullptr;
  vtkPolyData* input = plain ? plain->GetInput() : nullptr;
  if (!input || !input->GetPoints())
  {
    // The buffers are made from points that are not at hand. Moved or not, their vertices and the
    // place of their zero are within twice the bounds.
    const double* bounds = mapper->GetBounds();
    for (int k = 0; k < 3; ++k)
    {
      result.HalfRange[k] = 2.0 * std::max(std::abs(bounds[2 * k]), std::abs(bounds[2 * k + 1]));
    }
    return result;
  }
  const int method = plain->GetVBOShiftScaleMethod();
  result.Known = method != vtkOpenGLVertexBufferObject::NEAR_PLANE_SHIFT_SCALE &&
    method != vtkOpenGLVertexBufferObject::FOCAL_POINT_SHIFT_SCALE;
  // All points, used by cells or not, rule the scale of the buffer.
  double ranges[3][2];
  for (int k = 0; k < 3; ++k)
  {
    GetRange(input->GetPoints()->GetData(), k, ranges[k]);
  }
  const bool shifted =
    vtkOpenGLVertexBufferObject::GetGlobalCoordShiftAndScaleEnabled() && IsShifted(plain, ranges);
  for (int k = 0; k < 3; ++k)
  {
    if (shifted)
    {
      result.Origin[k] = 0.5 * (ranges[k][0] + ranges[k][1]);
      result.HalfRange[k] = 0.5 * (ranges[k][1] - ranges[k][0]);
    }
    else
    {
      result.HalfRange[k] = std::max(std::abs(ranges[k][0]), std::abs(ranges[k][1]));
    }
  }
  return result;
}

bool HasUsableBounds(const double* bounds)
{
  return bounds && vtkMath::AreBoundsInitialized(bounds) &&
    std::all_of(bounds, bounds + 6, [](double value) { return std::abs(value) < Infinite; });
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

bool vtkNBufferCandidate::Refresh(bool globalStateChanged)
{
  if (this->PipelineTaken && !globalStateChanged && !this->Pipeline.HasChanged())
  {
    return false;
  }
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
  this->Blended = this->Actor->GetForceOpaque() && IsTranslucentByItself(this->Actor);
  this->Unlit = !this->Actor->GetProperty()->GetLighting();
  this->TakeSources(this->Actor);
  return this->Time != timeBefore || this->Verdict != verdictBefore;
}

void vtkNBufferCandidate::TakeSources(vtkActor* actor)
{
  this->PipelineTaken = false;
  if (!this->Mapper)
  {
    this->Volatile = true;
    this->Time = actor->GetMTime();
    return;
  }
  this->Volatile = !this->Sources.Take(actor);
  if (!this->Volatile)
  {
    this->Time = this->Sources.GetTime();
    return;
  }
  this->Time = std::max(
    { actor->GetMTime(), this->Mapper->GetMTime(), GetTimeOfClippingPlanes(this->Mapper) });
  if (vtkShaderProperty* shaders = vtkNBufferSources::GetShaderProperty(actor))
  {
    this->Time = std::max(this->Time, shaders->GetMTime());
  }
  vtkDataObject* input =
    this->Mapper->GetNumberOfInputPorts() > 0 ? this->Mapper->GetInputDataObject(0, 0) : nullptr;
  if (input)
  {
    this->Time = std::max(this->Time, input->GetMTime());
  }
  this->PipelineTaken = this->Pipeline.Take(actor);
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
    property->GetRenderLinesAsTubes() || this->HasLines)
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
  if (!this->BufferIsKnown)
  {
    return vtkNBufferVerdict::NotAPlainMapper;
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
  this->HasLines = this->Box.Margin > 0.0 && DrawsLines(this->Mapper);
  const BufferCoordinates buffer = GetBufferCoordinates(this->Mapper);
  this->BufferIsKnown = buffer.Known;
  vtkMatrix4x4* matrix = actor->GetMatrix();
  for (int j = 0; j < 3; ++j)
  {
    this->Box.Origin[j] = matrix->GetElement(j, 3);
    this->Box.Magnitude[j] = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double element = matrix->GetElement(j, k);
      this->Box.Origin[j] += element * buffer.Origin[k];
      this->Box.Magnitude[j] += std::abs(element) * buffer.HalfRange[k];
    }
    // VTK's bounds leave infinite points out; the device does not.
    this->BoxIsUsable = this->BoxIsUsable && std::isfinite(this->Box.Origin[j]) &&
      std::isfinite(this->Box.Magnitude[j]);
  }
}
VTK_ABI_NAMESPACE_END
