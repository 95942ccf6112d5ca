// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTriangleErrors.h
 * @brief How a device may draw one triangle of a box: vtkNBufferBoxError computes it. No OpenGL.
 */
#ifndef vtkNBufferTriangleErrors_h
#define vtkNBufferTriangleErrors_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
/**
 * What is known of how a device draws one triangle of a box. Lengths are in pixels, depths in
 * order of distance. See vtkNBufferSliverTest.h for how they are used.
 */
struct VTKNBUFFER_EXPORT vtkNBufferTriangleErrors
{
  /// How far a vertex may be from its exact place before it is snapped, in x and in y.
  double PositionError;
  /// The lower left corner of the viewport in the window, in pixels.
  glm::dvec2 Origin;
  /// Whether a vertex is known to be snapped to the nearest multiple of
  /// vtkNBufferBoxError::GridStep.
  bool IsSnappedToGrid;
  /// How far a sample may be outside of the triangle that it belongs to, beyond PositionError.
  double Overshoot;
  /// The error of any sample's depth that does not grow with the slope of the triangle.
  double DepthError;
  /// The error of a sample's depth for each unit of the slope of the triangle's plane.
  double DepthErrorPerSlope;
  ///@{
  /// The error of a sample's depth because the slopes themselves are rounded. With q the depth
  /// range of the triangle divided by its height, and l its longest side, it is at most
  /// SlopeRounding q and at most SlopeRoundingPerLength l q.
  double SlopeRounding;
  double SlopeRoundingPerLength;
  ///@}
  /// The last term of the slack of the box, which allows for the errors of the slope above.
  double BoxSlack;
  /// The largest depth range divided by height for which BoxSlack is enough for any triangle.
  double CoveredSlope;
  /// The height, in units of the longest side, below which rounding leaves no plane at all.
  double LowestRelativeHeight;

  /**
   * E' of vtkNBufferSliverTest.h: how far corners may be from their exact places before they are
   * snapped, in x and in y, in pixels. `ofPlace` and `ofW` are their errors E of x, y and w, x
   * and y times the size of a pixel; `inverseW` is 1 / w for the smallest w that a device may
   * have for any of them, `aside` how far they are from the middle of the view at most, and
   * `half` half the size of the view.
   */
  glm::dvec2 GetPlaceError(const glm::dvec2& ofPlace, double ofW, double inverseW,
    const glm::dvec2& aside, const glm::dvec2& half) const;
};
VTK_ABI_NAMESPACE_END
#endif
