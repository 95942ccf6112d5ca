// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferScissor.h
 * @brief Restricts drawing to rectangles of pixels.
 */
#ifndef vtkNBufferScissor_h
#define vtkNBufferScissor_h

#include "vtkNBufferGL.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
/**
 * While it lives, drawing (by VTK or not) changes only the pixels inside a rectangle. OpenGL
 * guarantees that the fragments inside are the same as without a rectangle (OpenGL 4.6, appendix
 * A.3, rule 2: scissor parameters).
 */
class VTKNBUFFER_EXPORT ScopedScissor : public Scope
{
public:
  ScopedScissor();

  /// Set the rectangle, in pixels of the viewport that was set when the scope began. The renderer's
  /// own scissor box, if there is one, still applies.
  void Set(const vtkNBufferRectangle& pixels) const;

private:
  vtkNBufferRectangle Viewport;
  vtkNBufferRectangle Outer; ///< Where drawing was allowed before, in framebuffer pixels.
};

/// Call draw() once for each region (in pixels of the viewport), and restrict it to that region. If
/// `regions` is empty, call it once without a restriction. Returns the number of calls.
template <typename Functor>
int DrawIn(const std::vector<vtkNBufferRectangle>& regions, Functor&& draw)
{
  if (regions.empty())
  {
    draw();
    return 1;
  }
  const ScopedScissor scissor;
  for (const vtkNBufferRectangle& region : regions)
  {
    scissor.Set(region);
    draw();
  }
  return static_cast<int>(regions.size());
}
}
VTK_ABI_NAMESPACE_END
#endif
