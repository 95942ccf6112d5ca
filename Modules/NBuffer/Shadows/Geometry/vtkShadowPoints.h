// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowPoints
 * @brief A view of points in world coordinates that are stored elsewhere. No OpenGL.
 *
 * It consists of a pointer and a number, like std::span of C++20. It is made from a vector or an
 * array, and is valid until that is changed or destroyed.
 */
#ifndef vtkShadowPoints_h
#define vtkShadowPoints_h

#include "vtkNBufferGLM.h"

#include <array>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkShadowPoints
{
public:
  vtkShadowPoints() = default;
  vtkShadowPoints(const glm::dvec3* points, std::size_t size)
    : Points(points)
    , Size(size)
  {
  }
  vtkShadowPoints(const std::vector<glm::dvec3>& points)
    : vtkShadowPoints(points.data(), points.size())
  {
  }
  template <std::size_t N>
  vtkShadowPoints(const std::array<glm::dvec3, N>& points)
    : vtkShadowPoints(points.data(), N)
  {
  }

  const glm::dvec3* begin() const { return this->Points; }
  const glm::dvec3* end() const { return this->Points + this->Size; }
  std::size_t size() const { return this->Size; }

  template <typename Index>
  const glm::dvec3& operator[](Index i) const
  {
    return this->Points[static_cast<std::size_t>(i)];
  }

private:
  const glm::dvec3* Points = nullptr;
  std::size_t Size = 0;
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowPoints.h
