// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferOcclusionTest
 * @brief Whether a box lies behind what has been drawn. No OpenGL.
 *
 * A box is hidden if its nearest depth is farther than the farthest depth drawn in its rectangle
 * (Decoret 2005, section 3.1), four lookups. When that says visible and the box is long on the
 * screen, it is cut along its longest axis, and each piece is tested with its own rectangle and
 * nearest depth: one nearest depth for the whole length is what keeps most hidden props that an
 * exact test would drop. Cutting halves the props kept in scenes of pipes, halls and streets.
 */
#ifndef vtkNBufferOcclusionTest_h
#define vtkNBufferOcclusionTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferOcclusionTest
{
public:
  /**
   * Both arguments are kept by reference and must outlive the test. `levels` holds the farthest
   * stored depths of the projection's viewport and convention (vtkNBufferMath::GetFarthest), with
   * all levels that the boxes need (see GetLevelsNeeded).
   */
  vtkNBufferOcclusionTest(
    const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, int maximumPieces);

  /**
   * True only if nothing of the box can be seen. `screen` is what projection.Project gave for it.
   */
  bool IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);

  /// Number of levels that answers a rectangle of pixels over a base of the given factor.
  static int GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor);

  ///@{
  /// Rectangles asked and texels looked up so far.
  long long GetQueries() const { return this->Queries; }
  long long GetLookups() const { return this->Lookups; }
  ///@}

private:
  bool IsBehind(const vtkNBufferScreenBox& screen);

  const vtkNBufferProjection& Projection;
  const vtkNBufferLevels& Levels;
  int MaximumPieces;
  long long Queries = 0;
  long long Lookups = 0;
};

VTK_ABI_NAMESPACE_END
#endif
