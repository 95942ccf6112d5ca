// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferForEachProp.h
 * @brief Runs work for each of many props in VTK's threads, and prefetches what it will read.
 *
 * A culled frame may read a little from each of 15,000 props, which are scattered in memory.
 * Without prefetching, it spends most of its time waiting for memory.
 */
#ifndef vtkNBufferForEachProp_h
#define vtkNBufferForEachProp_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkSMPTools.h"

#include <cstddef>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferForEachProp
{
/// The number of props that is worth a thread of its own.
constexpr vtkIdType PropsPerThread = 2048;

/// How many props in advance the memory of a prop must be requested to arrive in time.
constexpr vtkIdType PropsToFetchAhead = 16;

/// Request the cache line at an address from memory, without waiting for it.
inline void Fetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

/// Call functor(begin, end) for ranges that cover 0 to count - 1. The ranges run in parallel if
/// there are at least twice `perThread` props.
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

/// Call functor(i) for each i from 0 to count - 1, in parallel like Run().
template <typename Functor>
void RunEach(std::size_t count, Functor&& functor, vtkIdType perThread = PropsPerThread)
{
  Run(
    count,
    [&functor](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        functor(i);
      }
    },
    perThread);
}

/// Call functor() with VTK's own loops in one thread: where each of thousands of props runs a short
/// loop of VTK, waking threads takes ten times as long as the loops.
template <typename Functor>
void RunInOneThread(Functor&& functor)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("Sequential")), functor);
}

/// Like RunEach(), but also calls prefetch(i) for a prop when functor() begins with the prop that
/// is PropsToFetchAhead before it. The first props of all are not prefetched.
template <typename Prefetch, typename Functor>
void RunAhead(
  std::size_t count, Prefetch&& prefetch, Functor&& functor, vtkIdType perThread = PropsPerThread)
{
  const auto size = static_cast<vtkIdType>(count);
  RunEach(
    count,
    [&](vtkIdType i)
    {
      if (i + PropsToFetchAhead < size)
      {
        prefetch(i + PropsToFetchAhead);
      }
      functor(i);
    },
    perThread);
}
}

VTK_ABI_NAMESPACE_END
#endif
