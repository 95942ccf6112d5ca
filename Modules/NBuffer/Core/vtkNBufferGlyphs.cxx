// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferGlyphs.h"

#include "vtkNBufferProtectedGlyphs.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The scale by which VTK replaces a scale of 0.
constexpr double SmallestScale = 1.0e-10;

vtkDataSet* GetData(vtkGlyph3DMapper* mapper)
{
  return vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

/// Whether VTK can use an array: it has as many tuples as there are points, or is missing.
bool Fits(vtkAbstractArray* array, vtkIdType points)
{
  return !array || array->GetNumberOfTuples() >= points;
}

vtkQuaterniond MakeRotation(vtkDataArray* orientations, vtkIdType point, int mode)
{
  double values[4] = { 0.0, 0.0, 0.0, 0.0 };
  orientations->GetTuple(point, values);
  vtkQuaterniond rotation;
  switch (mode)
  {
    case vtkGlyph3DMapper::ROTATION:
    {
      const auto turn = [&values](int axis)
      {
        const double half = 0.5 * vtkMath::RadiansFromDegrees(values[axis]);
        double components[4] = { std::cos(half), 0.0, 0.0, 0.0 };
        components[axis + 1] = std::sin(half);
        return vtkQuaterniond(components);
      };
      rotation = turn(2) * turn(0) * turn(1);
      break;
    }
    case vtkGlyph3DMapper::DIRECTION:
      if (values[1] != 0.0 || values[2] != 0.0)
      {
        // Half a turn about the middle between the x axis and the direction.
        const double x = (values[0] + vtkMath::Norm(values)) / 2.0;
        const double y = values[1] / 2.0;
        const double z = values[2] / 2.0;
        const double factor = 1.0 / std::sqrt(x * x + y * y + z * z);
        rotation.Set(0.0, x * factor, y * factor, z * factor);
      }
      else if (values[0] < 0.0)
      {
        rotation.Set(0.0, 0.0, 1.0, 0.0);
      }
      break;
    default: // QUATERNION
      rotation.Set(values);
      break;
  }
  return rotation;
}

std::array<double, 3> GetScale(vtkGlyph3DMapper* mapper, vtkDataArray* scales, vtkIdType point)
{
  std::array<double, 3> scale = { 1.0, 1.0, 1.0 };
  if (!mapper->GetScaling())
  {
    return scale;
  }
  if (scales)
  {
    const double* values = scales->GetTuple(point);
    const int components = scales->GetNumberOfComponents();
    if (mapper->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      scale.fill(vtkMath::Norm(values, components));
    }
    else if (components == 3)
    {
      std::copy_n(values, 3, scale.begin());
    }
    if (mapper->GetClamping())
    {
      const double* range = mapper->GetRange();
      const double width = range[1] == range[0] ? 1.0 : range[1] - range[0];
      for (double& value : scale)
      {
        value = (std::min(std::max(value, range[0]), range[1]) - range[0]) / width;
      }
    }
  }
  for (double& value : scale)
  {
    value *= mapper->GetScaleFactor();
    value = value == 0.0 ? SmallestScale : value;
  }
  return scale;
}
}

namespace vtkNBufferGlyphs
{
vtkGlyph3DMapper* GetMapper(vtkMapper* mapper)
{
  // The class that the object factory makes has no header that may be included.
  if (!mapper || std::strcmp(mapper->GetClassName(), "vtkOpenGLGlyph3DMapper") != 0 ||
    mapper->GetNumberOfInputConnections(0) != 1 || mapper->GetNumberOfInputConnections(1) == 0)
  {
    return nullptr;
  }
  auto* glyphs = static_cast<vtkGlyph3DMapper*>(mapper);
  for (int i = 0; i < glyphs->GetNumberOfInputConnections(1); ++i)
  {
    if (!glyphs->GetSource(i))
    {
      return nullptr;
    }
  }
  return GetData(glyphs) && !glyphs->GetUseSourceTableTree() && !glyphs->GetCullingAndLOD() &&
      !glyphs->GetAbortExecute()
    ? glyphs
    : nullptr;
}

vtkMTimeType GetTime(vtkGlyph3DMapper* mapper)
{
  return std::max(mapper->GetMTime(), GetData(mapper)->GetMTime());
}

std::vector<int> GetSources(vtkGlyph3DMapper* mapper)
{
  vtkDataSet* data = GetData(mapper);
  vtkDataArray* indices = vtkNBufferProtectedMembers::GetGlyphArrays(mapper, data).SourceIndex;
  const int last = mapper->GetNumberOfInputConnections(1) - 1;
  std::vector<bool> isEmpty;
  for (int source = 0; source <= last; ++source)
  {
    isEmpty.push_back(mapper->GetSource(source)->GetNumberOfPoints() == 0);
  }
  std::vector<int> sources(static_cast<std::size_t>(data->GetNumberOfPoints()), 0);
  for (std::size_t point = 0; point < sources.size(); ++point)
  {
    const auto i = static_cast<vtkIdType>(point);
    if (indices && i < indices->GetNumberOfTuples())
    {
      const double value = vtkMath::Norm(indices->GetTuple(i), indices->GetNumberOfComponents());
      sources[point] = value < last ? static_cast<int>(value) : last;
    }
    sources[point] = isEmpty[sources[point]] ? -1 : sources[point];
  }
  return sources;
}

std::vector<std::array<double, 16>> GetMatrices(vtkGlyph3DMapper* mapper)
{
  std::vector<std::array<double, 16>> matrices;
  vtkDataSet* data = GetData(mapper);
  const vtkIdType points = data->GetNumberOfPoints();
  const auto arrays = vtkNBufferProtectedMembers::GetGlyphArrays(mapper, data);
  const int mode = mapper->GetOrientationMode();
  auto* mask = vtkBitArray::SafeDownCast(arrays.Mask); // VTK ignores masks of other types.
  const bool isUsable = (!arrays.Orientation ||
                          arrays.Orientation->GetNumberOfComponents() ==
                            (mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3)) &&
    (!mask || mask->GetNumberOfComponents() == 1) && Fits(arrays.Orientation, points) &&
    Fits(arrays.Scale, points) && Fits(mask, points);
  if (!isUsable)
  {
    return matrices;
  }
  matrices.reserve(static_cast<std::size_t>(points));
  for (vtkIdType point = 0; point < points; ++point)
  {
    if (mask && mask->GetValue(point) == 0)
    {
      continue;
    }
    double rotation[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    if (arrays.Orientation)
    {
      MakeRotation(arrays.Orientation, point, mode).ToMatrix3x3(rotation);
    }
    const std::array<double, 3> scale = GetScale(mapper, arrays.Scale, point);
    if (std::count(scale.begin(), scale.end(), SmallestScale) > 1)
    {
      continue;
    }
    double position[3];
    data->GetPoint(point, position);
    std::array<double, 16> matrix = {};
    matrix[15] = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        matrix[4 * i + j] = static_cast<float>(rotation[i][j] * scale[j]);
      }
      matrix[4 * i + 3] = static_cast<float>(position[i]);
    }
    if (std::all_of(
          matrix.begin(), matrix.end(), [](double value) { return std::isfinite(value); }))
    {
      matrices.push_back(matrix);
    }
  }
  return matrices;
}
}
VTK_ABI_NAMESPACE_END
