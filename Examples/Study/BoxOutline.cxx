// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxOutline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace NBufferStudy
{

long long CountOutlinePixels(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen)
{
  const vtkNBufferRectangle& pixels = screen.Pixels;
  if (screen.Clipped)
  {
    return static_cast<long long>(pixels.GetWidth()) * pixels.GetHeight();
  }
  const std::array<glm::dvec2, 8> corners = projection.GetCorners(box);
  long long count = 0;
  for (int y = pixels.Y0; y < pixels.Y1; ++y)
  {
    // A row of a convex outline is what the segments between its corners reach.
    const double center = y + 0.5;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int a = 0; a < 8; ++a)
    {
      for (int b = a + 1; b < 8; ++b)
      {
        const double y0 = corners[a].y;
        const double y1 = corners[b].y;
        if ((y0 <= center) != (y1 <= center))
        {
          const double t = (center - y0) / (y1 - y0);
          const double x = corners[a].x + t * (corners[b].x - corners[a].x);
          low = std::min(low, x);
          high = std::max(high, x);
        }
      }
    }
    if (low <= high)
    {
      const double first = std::max(std::ceil(low - 0.5), static_cast<double>(pixels.X0));
      const double end = std::min(std::floor(high - 0.5) + 1.0, static_cast<double>(pixels.X1));
      count += end > first ? static_cast<long long>(end - first) : 0;
    }
  }
  return count;
}

} // namespace NBufferStudy
