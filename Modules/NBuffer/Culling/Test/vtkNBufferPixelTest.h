// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPixelTest
 * @brief Whether a box lies behind every pixel that its outline covers. No OpenGL.
 *
 * The second opinion on boxes that four lookups did not find hidden. Where the whole depth image
 * is in host memory anyway, looking at the pixels costs far less than drawing a prop for nothing:
 *
 *     +---------------------+      The rectangle of a box also covers what is beside its outline
 *     |     .--------.      |      (the sky above a hidden house), and its nearest depth is that
 *     |   .'          `.    |      of one corner. Here only squares that touch the outline count,
 *     |  '--------------'   |      each against the depth of the box's front faces there.
 *     +---------------------+
 *
 * Squares of 8 pixels are answered by one lookup in the levels, and only those that do not hide
 * their part of the box are looked at pixel by pixel, from the top, where houses, masts and trees
 * stick out. The test stops at the first pixel in which the box may be seen.
 */
#ifndef vtkNBufferPixelTest_h
#define vtkNBufferPixelTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferPixelTest
{
public:
  /**
   * All arguments are kept by reference and must outlive the test. `levels` holds the
   * farthest stored depths of the projection's viewport and convention; `depth` is the depth image
   * that they were made from, row 0 at the bottom.
   */
  vtkNBufferPixelTest(
    const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, const float* depth);

  /// True only if nothing of the box can be seen. `screen` is what projection.Project gave for it.
  bool IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);

  /// Texels and pixels looked at so far.
  long long GetLookups() const { return this->Lookups; }

private:
  struct Edge
  {
    double X;
    double Y;
    double Offset;
  };

  void SetEdges(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  void SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  bool IsBeside(double x, double y, double halfSide) const;
  double GetNearest(double x, double y, double halfSide) const;
  bool IsSquareHidden(int x, int y, const vtkNBufferRectangle& pixels);

  const vtkNBufferProjection& Projection;
  const vtkNBufferLevels& Levels;
  const float* Depth;
  int SquareLevel;
  Edge Edges[8];
  int NumberOfEdges = 0;
  vtkNBufferProjection::FacePlane Planes[3];
  int NumberOfPlanes = 0;
  double Nearest = 0.0;
  long long Lookups = 0;
};

VTK_ABI_NAMESPACE_END
#endif
