// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DrawnPolygon.h
 * @brief How far the depth that a rasteriser gives a polygon that it has clipped may be from the
 * exact one. No OpenGL.
 *
 * With u = 2^-24, a rasteriser computes with floats:
 *
 *  - A clip coordinate of a corner is a sum of four products. The vertex is rounded (u), each
 *    product and three sums are (4 u): E = 5 u times the sum of the terms' magnitudes. The matrix
 *    is rounded, too, but that moves the whole polygon, as if the camera were another one, by u
 *    where the sample is and not by u where the corners are.
 *  - What reaches out of the view is cut at its planes. A new corner r = a + t (b - a), 0 <= t <=
 * 1, of an edge inherits at most the larger error of a and b and adds that of the difference, the
 *    product and the sum: u (2 |b - a| + |r|). That is in proportion to the whole edge, not to what
 *    is seen of it: near the eye, where w is small, corners of an edge of kilometres come out
 *    centimetres off. An error of t moves the corner along the edge, which changes no plane.
 *  - What is left is drawn as triangles of its corners; which ones is not defined. Divided by w and
 *    measured across the polygon's plane, a corner's error is e_i, in window depth. Inside of one
 *    triangle depth is off by at most sum_i l_i e_i with the sample's barycentric coordinates l.
 *  - The plane's coefficients are rounded: 8 u n R / t, with n the largest window coordinate, R the
 *    triangle's depth range and t its smallest height (vtkNBufferProjection.h). Clipping makes thin
 *    triangles out of what is not.
 *  - Samples are chosen with corners snapped to a grid of 1/256 pixel, the plane may be that of the
 *    corners as they were: 2^-8.5 times the slope.
 *
 * The bound is the largest sum of these over all triangles of corners that contain the sample.
 * Storing a depth is not part of it.
 */
#ifndef DrawnPolygon_h
#define DrawnPolygon_h

#include <array>
#include <vector>

class DrawnPolygon
{
public:
  struct Corner
  {
    std::array<double, 4> Clip;   ///< x, y, z, w; w = 0: at infinity.
    std::array<double, 4> Errors; ///< E of each.
  };

  /// A point (w = 1) or direction (w = 0) that the device has as floats, under the matrix, row by
  /// row, that it has as floats.
  static Corner Transform(const double matrix[4][4], const double x[3], double w = 1.0);

  /// Which planes cut besides the four sides of the view.
  enum class Planes
  {
    NearAndFar,
    Near ///< Depth is clamped at the far plane.
  };

  /// Corners of a planar convex polygon, in order; the size of the viewport in pixels.
  DrawnPolygon(std::vector<Corner> corners, Planes planes, int width, int height);

  /// False if nothing of it is in view, or if it is seen edge-on.
  bool IsVisible() const { return this->Visible; }

  /// Something of it is in view and has no area on the screen: it has no plane there, only its
  /// place (GetBoundsY, GetRow) is known.
  bool IsEdgeOn() const { return this->EdgeOn; }

  /// Least and largest y of what is in view, in pixels.
  const std::array<double, 2>& GetBoundsY() const { return this->BoundsY; }

  /// Pixels across, of what is in view: twice its area by its longest diagonal.
  double GetThickness() const;

  /// The range of x on the line y that it covers, widened by `margin` pixels in x and y. False if
  /// it covers none of it.
  bool GetRow(double y, double margin, double& x0, double& x1) const;

  /// Exact window depth of its plane.
  double GetDepth(double x, double y) const;

  /// Window depth. For a place that is not inside, the largest of all.
  double GetBound(double x, double y) const;

private:
  struct WindowCorner
  {
    double X;
    double Y;
    double Depth;
    double Error;
  };

  static void Clip(std::vector<Corner>& corners, int axis, double sign);
  bool SetPlane();
  /// Twice the area, negative if clockwise.
  static double GetArea(const WindowCorner& a, const WindowCorner& b, double x, double y);
  double GetRounding(const WindowCorner& a, const WindowCorner& b, const WindowCorner& c) const;

  std::vector<WindowCorner> Corners;
  std::array<double, 2> BoundsY = {};
  double Largest; ///< Window coordinate.
  double Slope[2] = {};
  double LargestBound = 0.0;
  bool Visible = false;
  bool EdgeOn = false;
};

#endif
