// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferOcclusionTest
 * @brief Whether a box lies behind what has been drawn. No OpenGL.
 *
 * A box is hidden if its nearest depth is farther than the farthest depth drawn in its rectangle
 * (Decoret 2005, section 3.1), which takes at most four lookups. Equal depth counts as visible.
 * This test leaves some props false-visible, above all long ones, mainly because one nearest depth
 * stands for the whole box. vtkNBufferPixelTest compares the faces of such boxes with the pixels.
 */
#ifndef vtkNBufferOcclusionTest_h
#define vtkNBufferOcclusionTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferScreenBox.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferOcclusionTest
{
public:
  /**
   * `levels` are kept by reference and must outlive the test. They hold the largest orders of depth
   * of a viewport (vtkNBufferDepthConvention.h). A box that needs a level that was not built
   * (GetLevelsNeeded) counts as visible. `sampleDistance` is how far from the middle of its pixel a
   * sample may be in x and in y: 0 with one sample, at most 0.5 pixels otherwise.
   */
  explicit vtkNBufferOcclusionTest(const vtkNBufferLevels& levels, double sampleDistance = 0.5)
    : Levels(levels)
    , SampleDistance(sampleDistance)
  {
  }

  /**
   * By how much the nearest depth of the box is beyond the farthest depth in its rectangle, in
   * orders of depth. Positive only if nothing of the box can be seen; infinite for a box without
   * samples. `screen` is what vtkNBufferProjection::Project() gave for it in this viewport.
   */
  double GetClearance(const vtkNBufferScreenBox& screen);
  bool IsHidden(const vtkNBufferScreenBox& screen) { return this->GetClearance(screen) > 0.0; }

  /// Find where a box that is not hidden may be seen: the pixels of the texel of level 0 with the
  /// farthest depth. Returns false for a box that is hidden or needs a level that was not built.
  bool FindVisiblePixels(const vtkNBufferScreenBox& screen, vtkNBufferRectangle& pixels);

  /// The number of levels, level 0 included, that it takes to test a rectangle of pixels. `factor`
  /// is the side of a texel of level 0 in pixels.
  static int GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor);

  /// The number of rectangles compared with the levels so far.
  long long GetQueries() const { return this->Queries; }

  /// The number of texels read for these rectangles.
  long long GetLookups() const { return this->Lookups; }

private:
  /// The texels that cover the samples of a box; none if it has no samples.
  vtkNBufferCover GetCover(const vtkNBufferScreenBox& screen) const;

  const vtkNBufferLevels& Levels;
  double SampleDistance;
  long long Queries = 0;
  long long Lookups = 0;
};

VTK_ABI_NAMESPACE_END
#endif
