// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThinSides.h
 * @brief Sides of shadow volumes that are so thin on the screen that a rasteriser may draw them
 * with a depth far from the exact one. No OpenGL.
 *
 * From every edge of a caster at which the light sees the outline of some of the caster's
 * triangles, a side of the volume reaches away from the light to infinity. If it is seen almost
 * edge-on, it covers a sliver of the screen, which ends at the borders of the view. The depth of a
 * sample in the sliver may be off by the bound of DrawnPolygon.h, so that the side may be drawn
 * before or behind a receiver that is closer to it than the bound.
 *
 * Only sides that are less than a pixel thick count, because for thicker sides the bound is far
 * larger than the errors that occur. A sliver that is thinner than two steps of the subpixel grid
 * (1/256 pixel), or that is seen edge-on, has no plane on the screen after its corners were
 * snapped. If it is drawn at all, its samples may get any depth, even one before or behind the
 * whole side. (Often the bound corresponds to a move of the side by a small part of a pixel. Rays
 * through moved samples still cannot replace the bound: beyond the end of the side they do not meet
 * its plane.)
 */
#ifndef ThinSides_h
#define ThinSides_h

#include <vector>

struct OracleLight;
struct RenderedTriangles;

class ThinSides
{
public:
  /// The view in which the sides are drawn. Positions are relative to the eye, as the vertices of
  /// volumes are.
  struct View
  {
    double Eye[3];
    double EyeToClip[4][4];
    int Width;
    int Height;
  };

  /// `casts` says for each actor of the triangles whether it casts shadows.
  ThinSides(const RenderedTriangles& triangles, const std::vector<unsigned char>& casts,
    const OracleLight& light, const View& view);

  ///@{
  /// Return the thicknesses, in pixels, between which a side is a sliver that has a plane (above).
  static double GetLeastThickness() { return 2.0 / 256; }
  static double GetLargestThickness() { return 1.0; }
  ///@}

  /// Returns whether a side that covers the middle of pixel (x, y) may be drawn on the wrong side
  /// of a receiver. The window depth of the receiver is `depth`, uncertain by `slack`.
  bool AreNear(int x, int y, double depth, double slack) const;

private:
  struct Crossing
  {
    double Depth;
    double Bound;
  };

  void AddSide(const double a[3], const double b[3], const OracleLight& light, const View& view);

  int Width;
  std::vector<std::vector<Crossing>> Pixels;
};

#endif
