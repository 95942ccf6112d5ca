// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferVertexCoordinates.h"

#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferSurface.h"

#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include VTKNBUFFER_COMPOSITE_MAPPER_HEADER

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using CompositeMapper = VTKNBUFFER_COMPOSITE_MAPPER;

/// The range of one component as vtkDataArray::GetRange() gives it. That function caches its result
/// behind some microseconds of dispatch, which for thousands of small meshes is most of a first
/// frame.
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

/// The mapper's VBOShiftScaleMethod.
int GetShiftScaleMethod(vtkMapper* mapper)
{
  auto* plain = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* composite = CompositeMapper::SafeDownCast(mapper);
  return plain  ? plain->GetVBOShiftScaleMethod()
    : composite ? composite->GetVBOShiftScaleMethod()
                : vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE;
}

/// Whether vtkOpenGLVertexBufferObject::UpdateShiftScale() moves points in this box.
bool IsShifted(vtkMapper* mapper, const glm::dvec3& low, const glm::dvec3& high)
{
  using Method = vtkOpenGLVertexBufferObject;
  if (!Method::GetGlobalCoordShiftAndScaleEnabled())
  {
    return false;
  }
  switch (GetShiftScaleMethod(mapper))
  {
    case Method::ALWAYS_AUTO_SHIFT_SCALE:
    case Method::AUTO_SHIFT:
      return true;
    case Method::AUTO_SHIFT_SCALE:
    {
      const glm::dvec3 size = high - low;
      const glm::dvec3 middle = 0.5 * (high + low);
      const double size2 = glm::dot(size, size);
      const double distance2 = glm::dot(middle, middle);
      return size2 > 0.0 ? distance2 / size2 > 1.0e6 || std::abs(std::log10(size2)) > 3.0
                         : distance2 > 1.0e6;
    }
    default:
      return false;
  }
}
}

std::optional<vtkNBufferVertexCoordinates> vtkNBufferVertexCoordinates::Get(
  vtkMapper* mapper, const vtkBoundingBox* all)
{
  auto* plain =
    vtkNBufferKnownClasses::GetKind(mapper) == vtkNBufferKnownClasses::MapperKind::PolyData
    ? static_cast<vtkOpenGLPolyDataMapper*>(mapper)
    : nullptr;
  const int method = GetShiftScaleMethod(mapper);
  if (method == vtkOpenGLVertexBufferObject::NEAR_PLANE_SHIFT_SCALE ||
    method == vtkOpenGLVertexBufferObject::FOCAL_POINT_SHIFT_SCALE)
  {
    return std::nullopt;
  }
  vtkPolyData* input = plain ? plain->GetInput() : nullptr;
  if (!input || !input->GetPoints())
  {
    // VTK may shift all points by one of them: vertices are within twice the bounds of all.
    const vtkBoundingBox box = all ? *all : vtkNBufferSurface::GetBoundsOfPoints(mapper, false);
    const glm::dvec3 low = glm::make_vec3(box.GetMinPoint());
    const glm::dvec3 high = glm::make_vec3(box.GetMaxPoint());
    return vtkNBufferVertexCoordinates{ glm::dvec3(0.0),
      3.0 * glm::max(vtkNBufferGLM::Abs(low), vtkNBufferGLM::Abs(high)) };
  }
  // All points, used by cells or not, determine the scale of the buffer.
  glm::dvec3 low(0.0);
  glm::dvec3 high(0.0);
  for (int k = 0; k < 3; ++k)
  {
    double range[2];
    GetRange(input->GetPoints()->GetData(), k, range);
    low[k] = range[0];
    high[k] = range[1];
  }
  return Estimate(mapper, low, high);
}

vtkNBufferVertexCoordinates vtkNBufferVertexCoordinates::Estimate(
  vtkMapper* mapper, const glm::dvec3& low, const glm::dvec3& high)
{
  return IsShifted(mapper, low, high)
    ? vtkNBufferVertexCoordinates{ 0.5 * (low + high), 0.5 * (high - low) }
    : vtkNBufferVertexCoordinates{ glm::dvec3(0.0),
        glm::max(vtkNBufferGLM::Abs(low), vtkNBufferGLM::Abs(high)) };
}
VTK_ABI_NAMESPACE_END
