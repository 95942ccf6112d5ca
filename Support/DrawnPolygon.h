// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DrawnPolygon.h
 * @brief A bound on the error of the depth that a rasteriser gives to a polygon that it clips. No
 * OpenGL.
 *
 * A rasteriser computes with floats. With u = 2^-24:
 *
 *  - A clip coordinate of a corner is a sum of four products. The vertex is rounded (u), and so are
 *    each product and three sums (4 u): E = 5 u times the sum of the terms' magnitudes. The matrix
 *    is rounded, too, but that is as if the camera were slightly different: a sample moves in
 *    proportion to its own coordinates, however far away the corners are.
 *  - A polygon that reaches out of the view is cut at the planes of the view. A new corner
 *    r = a + t (b - a) of an edge, with t in [0, 1], inherits at most the larger error of a and b
 *    and adds that of the difference, the product and the sum: u (2 |b - a| + |r|). That is in
 *    proportion to the whole edge, not to the visible part of it: near the eye, where w is small,
 *    the new corners of an edge of kilometres are centimetres off. An error of t moves the corner
 *    along the edge, and so inside of the polygon's plane.
 *  - The rest of the polygon is drawn as triangles of its corners; which triangles is not defined.
 *    Divided by w and measured across the polygon's plane, the error of corner i is e_i, in window
 *    depth. Inside one triangle the depth is off by at most sum_i l_i e_i with the sample's
 *    barycentric coordinates l_i.
 *  - The plane's coefficients are rounded: 8 u n R / t, with n the largest window coordinate, R the
 *    triangle's depth range and t its smallest height (vtkNBufferBoxError.h). Clipping can make
 *    thin triangles out of thick ones.
 *  - Samples are chosen with corners that are snapped to a grid of 1/256 pixel, while the plane may
 *    be that of the corners before they were snapped: 2^-8.5 times the slope.
 *
 * The bound is the largest sum of these errors over all triangles of corners that contain the
 * sample, in window depth (0 to 1). It does not include the rounding of the depth that is stored.
 * Coordinates x and y are pixels, from the lower left corner of the viewport.
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
    std::array<double, 4> Clip;   ///< x, y, z, w; w is 0 for a corner at infinity.
    std::array<double, 4> Errors; ///< The error E of each coordinate.
  };

  /// Returns the corner of a point (w = 1) or direction (w = 0) under a matrix, given row by row.
  /// The errors are those of a device on which both are floats.
  static Corner Transform(const double matrix[4][4], const double x[3], double w = 1.0);

  /// The planes that cut the polygon in addition to the four sides of the view.
  enum class Planes
  {
    NearAndFar,
    Near ///< Depth is clamped at the far plane.
  };

  /// `corners` are those of a planar convex polygon, in order; `width` and `height` are the size of
  /// the viewport in pixels.
  DrawnPolygon(std::vector<Corner> corners, Planes planes, int width, int height);

  /// Returns false if no part of the polygon is in view, or if it is seen edge-on.
  bool IsVisible() const { return this->Visible; }

  /// Returns whether a part of the polygon is in view and has no area on the screen. Then its depth
  /// is unknown, and only GetBoundsY() and GetRow() have a meaning.
  bool IsEdgeOn() const { return this->EdgeOn; }

  /// Returns the least and the largest y of the part in view, in pixels.
  const std::array<double, 2>& GetBoundsY() const { return this->BoundsY; }

  /// Returns how many pixels thick the part in view is: twice its area divided by its longest
  /// diagonal.
  double GetThickness() const;

  /// Sets [x0, x1] to the interval of the line `y` in which the polygon is at most `margin` pixels
  /// away in x and in y. Returns false if there is none.
  bool GetRow(double y, double margin, double& x0, double& x1) const;

  /// Returns the exact window depth of the polygon's plane.
  double GetDepth(double x, double y) const;

  /// Returns the bound of the error; for a place outside of the polygon, the largest of all bounds.
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
  /// Returns twice the area, negative if the corners are clockwise.
  static double GetArea(const WindowCorner& a, const WindowCorner& b, double x, double y);
  double GetRounding(const WindowCorner& a, const WindowCorner& b, const WindowCorner& c) const;

  std::vector<WindowCorner> Corners;
  std::array<double, 2> BoundsY = {};
  double Largest; ///< The largest window coordinate.
  double Slope[2] = {};
  double LargestBound = 0.0;
  bool Visible = false;
  bool EdgeOn = false;
};

#endif
