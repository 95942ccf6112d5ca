// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferLevelBuilder.h
 * @brief Builds the levels of an N-buffer in host memory, for any type of texel.
 *
 * vtkNBufferMath.h defines which squares a texel covers and how texels are merged. The texels of
 * vtkNBufferLevels are floats, and merging takes the extremum; those of vtkShadowLitmap are extents
 * of receivers, and merging takes the union.
 *
 * The levels of a width x height base follow each other in one array, each row by row.
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
/// A level with fewer texels is built by one thread. Waking threads for 691,200 pixels made the
/// build slower on two cores; the size at which threads begin to help has not been measured.
constexpr vtkIdType TexelsWorthAThread = 1 << 22;

/// Call functor(begin, end) for ranges that cover the rows 0 to rows - 1, in parallel if the rows
/// have so many texels in total.
template <typename Functor>
void ForEachRow(
  int rows, vtkIdType texels, Functor&& functor, vtkIdType worthAThread = TexelsWorthAThread)
{
  if (texels < worthAThread)
  {
    functor(0, rows);
    return;
  }
  vtkSMPTools::For(0, rows, 16,
    [&functor](vtkIdType begin, vtkIdType end)
    { functor(static_cast<int>(begin), static_cast<int>(end)); });
}

/// Build one row of a level from two rows of the level below, `a` (row y) and `b` (row y + step).
/// All compilers that VTK supports know __restrict, which saves a test for overlap in every row.
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

/// Build the levels first to end - 1, each from the level below it; `first` is at least 1. Several
/// threads build a level of at least `worthAThread` texels.
template <typename Merge, typename Texel>
void BuildLevels(Texel* texels, int width, int height, int first, int end,
  vtkIdType worthAThread = TexelsWorthAThread)
{
  const auto size = static_cast<vtkIdType>(width) * height;
  for (int i = first; i < end; ++i)
  {
    Texel* const level = texels + i * size;
    const Texel* const below = level - size;
    const int step = 1 << (i - 1); // The side of the squares of the level below.
    ForEachRow(
      height, size,
      [=](int beginOfRows, int endOfRows)
      {
        for (int y = beginOfRows; y < endOfRows; ++y)
        {
          BuildRow<Merge>(below + static_cast<std::size_t>(y) * width,
            below + static_cast<std::size_t>(std::min(y + step, height - 1)) * width, width, step,
            level + static_cast<std::size_t>(y) * width);
        }
      },
      worthAThread);
  }
}
}

VTK_ABI_NAMESPACE_END
#endif
