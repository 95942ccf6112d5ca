// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferForEachProp.h
 * @brief Work that is done for each of many props: shared out to VTK's threads, and what it will
 * read fetched ahead.
 */
#ifndef vtkNBufferForEachProp_h
#define vtkNBufferForEachProp_h

#include "vtkSMPTools.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferForEachProp
{
/// Props that one thread looks at before another is worth waking.
constexpr vtkIdType PropsPerThread = 2048;

/// How far ahead of its use an object must be asked for to be there in time.
constexpr vtkIdType PropsToFetchAhead = 4;

/// Have the processor fetch what is there.
inline void Fetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/// functor(first, end) for ranges of 0 to count - 1, in parallel when there are enough for it.
template <typename Functor>
void Run(std::size_t count, Functor&& functor, vtkIdType perThread = PropsPerThread)
{
  const auto size = static_cast<vtkIdType>(count);
  if (size < 2 * perThread)
  {
    functor(0, size);
    return;
  }
  vtkSMPTools::For(0, size, perThread, functor);
}
}

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferForEachProp.h
