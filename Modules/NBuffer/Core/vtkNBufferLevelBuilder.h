// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferLevelBuilder.h
 * @brief Building the levels of an N-buffer in host memory, whatever a texel is.
 *
 * vtkNBufferMath.h says what a texel covers and what a merge is. vtkNBufferLevels has floats and
 * an extremum, vtkShadowLitmap has extents of receivers and their union.
 *
 * The levels of a width x height base follow each other in one array, row by row.
 */
#ifndef vtkNBufferLevelBuilder_h
#define vtkNBufferLevelBuilder_h

#include "vtkNBufferMath.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferLevelBuilder
{
/// Below this many texels a level is built serially. Waking threads for 691,200 pixels made it
/// slower on two cores; where it begins to pay has not been measured.
constexpr vtkIdType TexelsWorthAThread = 1 << 22;

/// functor(first row, end of rows), in parallel when there is work enough for it.
template <typename Functor>
void ForEachRow(int rows, vtkIdType texels, Functor&& functor)
{
  if (texels < TexelsWorthAThread)
  {
    functor(0, rows);
    return;
  }
  vtkSMPTools::For(0, rows, 16,
    [&functor](vtkIdType begin, vtkIdType end)
    { functor(static_cast<int>(begin), static_cast<int>(end)); });
}

/// One row of a level from the rows y and y + step of the level below. (All compilers that VTK
/// supports know __restrict; it spares them a test for overlap in every row.)
template <typename Merge, typename Texel>
void BuildRow(const Texel* a, const Texel* b, int width, int step, Texel* __restrict out)
{
  const Merge merge{};
  const int inside = std::max(width - step, 0);
  for (int x = 0; x < inside; ++x)
  {
    out[x] = merge(merge(a[x], a[x + step]), merge(b[x], b[x + step]));
  }
  const Texel last = merge(a[width - 1], b[width - 1]);
  for (int x = inside; x < width; ++x)
  {
    out[x] = merge(merge(a[x], b[x]), last);
  }
}

/// Level i + 1 from level i, whose squares have side `step`.
template <typename Merge, typename Texel>
void BuildLevel(const Texel* below, int width, int height, int step, Texel* level)
{
  ForEachRow(height, static_cast<vtkIdType>(width) * height,
    [=](int begin, int end)
    {
      for (int y = begin; y < end; ++y)
      {
        BuildRow<Merge>(below + static_cast<std::size_t>(y) * width,
          below + static_cast<std::size_t>(std::min(y + step, height - 1)) * width, width, step,
          level + static_cast<std::size_t>(y) * width);
      }
    });
}

/// Levels first to end - 1, each from the one below; first > 0.
template <typename Merge, typename Texel>
void BuildLevels(Texel* texels, int width, int height, int first, int end)
{
  const std::size_t size = static_cast<std::size_t>(width) * height;
  for (int i = first; i < end; ++i)
  {
    BuildLevel<Merge>(texels + (i - 1) * size, width, height, 1 << (i - 1), texels + i * size);
  }
}
}

VTK_ABI_NAMESPACE_END
#endif
