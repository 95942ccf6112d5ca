// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferVertexCoordinates
 * @brief How large the coordinates in the vertex buffers of a mapper are.
 *
 * VTK may shift and scale vertices before it rounds them to floats, so the rounding error depends
 * on how far they are from `Origin`. No vertex is farther from it than `HalfRange`. Both are in
 * model coordinates.
 */
#ifndef vtkNBufferVertexCoordinates_h
#define vtkNBufferVertexCoordinates_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class vtkBoundingBox;
class vtkMapper;

struct VTKNBUFFER_EXPORT vtkNBufferVertexCoordinates
{
  /// Those of a plain mapper (vtkNBufferSurface::IsPlain()), or nullopt if the camera changes them.
  /// `all` may have all of its points.
  static std::optional<vtkNBufferVertexCoordinates> Get(
    vtkMapper* mapper, const vtkBoundingBox* all = nullptr);

  /// Those of points between `low` and `high` if they are all points of a mapper. This is an
  /// estimate for blocks, of which VTK moves all or none. `mapper` may be nullptr: one with VTK's
  /// defaults.
  static vtkNBufferVertexCoordinates Estimate(
    vtkMapper* mapper, const glm::dvec3& low, const glm::dvec3& high);

  glm::dvec3 Origin;
  glm::dvec3 HalfRange;
};

VTK_ABI_NAMESPACE_END
#endif
