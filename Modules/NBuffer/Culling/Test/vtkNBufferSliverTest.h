// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSliverTest
 * @brief Whether a hidden mesh has triangles that may be drawn before its box. No OpenGL.
 *
 * vtkNBufferProjection grants a box the depth error of triangles that are at least 1/16 pixel high,
 * as they are drawn. A lower one seldom owns a sample. Where it does, a rasteriser that takes the
 * depth plane of vertices before they are snapped (Mesa's llvmpipe) extrapolates along a slope that
 * grows without bound, and stock VTK shows a stray pixel through the wall before it: every curved
 * surface has such triangles along its outline.
 *
 * Here each triangle of a mesh whose box was found hidden is looked at. On the screen, with L its
 * longest side, h its height over that less what its vertices may err, R its depth range and r the
 * depth between its third corner and the side below,
 *
 *     h < 64 u L      its plane is lost in rounding: its samples may have any depth,
 *     h >= 64 u L     they are nearer than it is by at most
 *
 *                         (2^-8.5 + 8 u n) s + min(8 u n, 32 u L) R / h
 *
 *                     with s <= R / L + r / h the slope of its plane, along and across; most
 *                     often no more than the slack of the box grants, which is enough.
 *
 * The last term is what rounding does to the slopes: sums of two products of sides of L and
 * depths of R, divided by an area of L h, each with some 6 u, over a distance of L. It holds as
 * long as the area itself is not lost, 6 u L^2 << L h.
 *
 * Of those that the slack of the box does not cover, the samples that they may own (no farther than
 * 2^-8.5 pixels beside them) are compared with the depth in their texel of level 0. Only if one of
 * these may be seen the mesh is to be drawn.
 *
 * Not covered: what a device makes of triangles by cutting them (near plane, sides of the view,
 * clipping planes), which may be lower than they were.
 *
 * Costs some 50 ns per point and triangle.
 */
#ifndef vtkNBufferSliverTest_h
#define vtkNBufferSliverTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Triangles as a mapper draws them, in model coordinates.
struct vtkNBufferMesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<unsigned int, 3>> Triangles;
};

class VTKNBUFFER_EXPORT vtkNBufferSliverTest
{
public:
  /**
   * Both are kept by reference and must outlive the test. `levels` holds the farthest stored depths
   * of the projection's viewport and convention. `sampleReach`: how far a sample may be from the
   * middle of its pixel in x and y, 0 without multisampling, else 0.5 pixels.
   */
  vtkNBufferSliverTest(
    const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, double sampleReach);

  /**
   * False only if nothing of the mesh can be seen, given that its box, which is Inside, was found
   * hidden. `toWorld`: row-major, from model to world.
   */
  bool MayBeSeen(const vtkNBufferMesh& mesh, const double toWorld[16], const vtkNBufferBox& box,
    const vtkNBufferScreenBox& screen);

private:
  /// Pixels and order of distance; NaN behind the eye.
  struct WindowPoint
  {
    double X;
    double Y;
    double Order;
  };
  using Errors = vtkNBufferProjection::TriangleErrors;

  void Project(const vtkNBufferMesh& mesh, const double toWorld[16]);
  bool MayBeSeen(
    const WindowPoint* const corners[3], double heightError, const Errors& errors) const;
  /// Samples within `reach` of a line, at depths of `allowance` before it and farther.
  bool MayBeSeen(
    const WindowPoint& from, const WindowPoint& to, double reach, double allowance) const;

  const vtkNBufferProjection& Projection;
  const vtkNBufferLevels& Levels;
  double SampleReach;
  std::vector<WindowPoint> Points;
};

VTK_ABI_NAMESPACE_END
#endif
