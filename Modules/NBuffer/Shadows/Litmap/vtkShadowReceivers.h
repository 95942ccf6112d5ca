// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowReceivers.h
 * @brief From a depth image to a litmap: which samples are receivers, and where they may lie. No
 * OpenGL.
 *
 * ## Which samples are receivers
 *
 * A sample of the depth image is a receiver if all of these hold:
 *
 *  - its depth is less than 1, which stands for the background (geometry so close to the far plane
 *    that its depth is rounded to 1 cannot be told from it);
 *  - the light can reach it: a spot in its cone (vtkShadowLight::GetConeCosine), a directional
 *    light everywhere; or VTK's shader may think so, see below;
 *  - a point light's frame takes in one face of a cube around the light, |p| <= 1 and |q| <= 1, a
 *    little widened: six frames make up all directions.
 *
 * Positional lights have receivers at s > 0 only.
 *
 * ## Where it may lie
 *
 * On the eye ray through the sample, in an interval: a stored depth is off by a quantum, what is
 * drawn against it by another one, and both by the transformation to clip coordinates in float.
 * In four million random points (views of 1 to 120 degrees, far / near 3 to 1e8) that was off by at
 * most 5.4 * 2^-24 in window depth; it grows with the distance of the image's corners from the eye.
 * With r, this distance in units of that of the image's centre, the interval reaches 2 quanta and
 * 4 (1 + r) 2^-24 to both sides. (Where the depth range is short for its distance, the error is
 * larger, but a quantum is so small a length that the next term covers it.)
 *
 * Around that, in all directions, by the rounding of a position, 2^-20 of its distance from the
 * eye, and of world coordinates in double, 2^-48 of theirs.
 *
 * VTK's shader has another place for it when it tells whether it lies in a spot's cone: corners as
 * floats, wherever their origin is, transformed to view coordinates in floats, while depth comes
 * from their transformation to clip coordinates. With u = 2^-24 and S the distances of eye and
 * sample from the origin and of eye and light from each other, summed up, each of these is off by
 * E = 5 u S times the length of its row in the matrix (DrawnPolygon.h in the tests derives that),
 * which the way back from clip coordinates multiplies. Where VTK shifts coordinates to the middle
 * of what they belong to, it is less. Receivers outside of the cone that this alone brings in may
 * have their shadow of casters that shadow nothing in the cone: vtkShadowLitmap::GetReach() says
 * how far off they are.
 *
 * With multisampling a fragment asks once whether it lies in a spot's cone: where its surface,
 * going on, is at the pixel's centre. How deep that is no sample knows. So a sample whose pixel's
 * centre is on a line of sight that meets the cone is such a receiver, too, if the cone is not
 * farther from it than 64 widths of a pixel: on surfaces that are seen at less than a degree it
 * might be.
 *
 * Litmaps and tiles (vtkShadowTiles.h) are to hold all samples for which a volume may be drawn, and
 * devices draw its sides a little beside their place, the receiver's edge as well: a quarter of a
 * pixel more in all directions. (A lexel may be smaller than that.)
 *
 * A tile's layers are parted halfway, in distances from the eye, between its nearest and its
 * farthest receiver.
 *
 * Intervals are projected to light coordinates end by end; where straight lines stay straight, that
 * loses nothing. The tests of the last two rules above are about the ball around the interval: what
 * may be reached is a receiver. Where it cannot be told on which side of the light's plane s = 0 an
 * interval lies, or how far off it is seen, it is put into all lexels.
 */
#ifndef vtkShadowReceivers_h
#define vtkShadowReceivers_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowLight.h"
#include "vtkShadowLitmap.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * The camera and the image that a depth image is of.
 */
struct vtkShadowView
{
  /// Row-major 4 x 4: the inverse of vtkCamera's world-to-clip matrix for z in [-w, w], with world
  /// coordinates relative to Origin.
  double ClipToWorld[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double Origin[3] = { 0.0, 0.0, 0.0 }; ///< World: the eye.
  int Width = 0;                        ///< Pixels, at most 65535.
  int Height = 0;
  double DepthQuantum = 0x1p-24; ///< Step of the depth format near 1.
  /// Places of the samples in a pixel, in [0, 1] from its lower left corner.
  std::vector<std::array<double, 2>> Samples = { { { 0.5, 0.5 } } };
};

namespace vtkShadowReceivers
{
/**
 * About what the receivers of a depth image take up: p in [range[0], range[1]], q in [range[2],
 * range[3]], s in [depths[0], depths[1]]. It is taken from every fourth row and column, or from all
 * where these have no receiver; without any the minima are infinity and the maxima -infinity.
 */
VTKNBUFFER_EXPORT void GetRange(const float* depth, const vtkShadowView& view,
  const vtkShadowLight& light, const vtkShadowLightSpace& frame, double range[4], double depths[2]);

/**
 * Fill `litmap` and its tiles with the receivers of a depth image as `frame` sees them, over about
 * the range of p, q and s that they take up, and return their number. The caller builds its levels
 * then.
 *
 * `depth`: window depths in [0, 1], one image of Width x Height for each sample of a pixel, row 0
 * at the bottom.
 *
 * About 30 ns for each sample, shared by the threads of vtkSMPTools; the litmap is the same with
 * any number of them.
 */
VTKNBUFFER_EXPORT vtkIdType Scatter(const float* depth, const vtkShadowView& view,
  const vtkShadowLight& light, const vtkShadowLightSpace& frame, int resolution,
  vtkShadowLitmap& litmap);
}

VTK_ABI_NAMESPACE_END
#endif
