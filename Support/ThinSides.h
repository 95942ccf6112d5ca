// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThinSides.h
 * @brief Sides of shadow volumes that are so thin on the screen that a rasteriser may draw them far
 * from where they are. No OpenGL.
 *
 * From every edge of a caster at which the light sees the outline of some of its triangles a side
 * reaches away from the light to infinity. Seen almost edge-on it covers a sliver of the screen,
 * cut off at the borders of the view. The depth that a sample in it is given may be off by the
 * bound of DrawnPolygon.h, and the side counts as before or behind a receiver that close to it.
 *
 * Only slivers of less than a pixel across count: the bound of wider sides is far above what is
 * seen of them. What is thinner than two steps of the subpixel grid, and what is seen edge-on, has
 * no plane on the screen after its corners were snapped, if it is not gone: its samples may be
 * given any depth, also one before or behind all of it. (A bound may be worth no more than a small
 * part of a pixel by which the side is moved. But moved samples do not stand for it: they do not
 * see its plane where the side has ended.)
 */
#ifndef ThinSides_h
#define ThinSides_h

#include <vector>

struct OracleLight;
struct RenderedTriangles;

class ThinSides
{
public:
  /// From the world, relative to the eye, as volumes' vertices are, to the window.
  struct View
  {
    double Eye[3];
    double EyeToClip[4][4];
    int Width;
    int Height;
  };

  /// `casts`: for each actor of the triangles.
  ThinSides(const RenderedTriangles& triangles, const std::vector<unsigned char>& casts,
    const OracleLight& light, const View& view);

  ///@{
  /// Pixels, see above.
  static double GetLeastThickness() { return 2.0 / 256; }
  static double GetLargestThickness() { return 1.0; }
  ///@}

  /// Whether a side that covers the middle of pixel (x, y) may be drawn on the other side of a
  /// receiver with this window depth, which is uncertain by `slack` itself.
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
