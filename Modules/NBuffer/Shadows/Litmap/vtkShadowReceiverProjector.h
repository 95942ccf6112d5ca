// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowReceiverProjector
 * @brief Where in light coordinates a sample of a depth image may lie. No OpenGL.
 *
 *        eye
 *         o
 *          \        a: as near as depth may be off      projected end by end
 *           \  ___                                       -------->   a'----b'  segment in
 *            (  a  )   ball of rounding                              (p, q, s), with a
 *            (   \ )   around the interval a b                       radius in p and q
 *            (_ _ b)
 *                  b: as far as depth may be off
 *
 * ## The interval on the line of sight
 *
 * The sample lies on the eye's ray through it, in an interval. A stored depth is off by a quantum,
 * what is drawn against it is off by another one, and both are off by the transformation to clip
 * coordinates in float. In four million random points (views of 1 to 120 degrees, far / near 3 to
 * 1e8; commit 7323db1) that was off by at most 5.4 * 2^-24 in window depth. It grows with the
 * distance of the image's corners from the eye. With r, this distance in units of that of the
 * image's centre, the interval reaches 2 quanta and 4 (1 + r) 2^-24 to both sides. (Where the depth
 * range is short for its distance the error is larger, but then a quantum is so small a length that
 * the next term covers it.)
 *
 * ## The radius around it
 *
 * In all directions the interval is widened by the rounding of a position, 2^-20 of its distance
 * from the eye, and of world coordinates in double, 2^-48 of their size.
 *
 * Devices draw the sides of a volume a little off their place, and the receiver's edge as well.
 * Litmaps and tiles must hold all samples for which a volume may be drawn. So the radius grows by a
 * quarter of a pixel. (A lexel may be smaller than that.)
 *
 * ## What VTK's shader takes to be in a spot's cone
 *
 * VTK's shader has another place for the sample when it decides whether it lies in a spot's cone.
 * It transforms corners as floats, wherever their origin is, to view coordinates in floats, while
 * depth comes from their transformation to clip coordinates. With u = 2^-24, and S the sum of the
 * distances of eye and sample from the origin and of eye and light from each other, each of these
 * is off by E = 5 u S times the length of its row in the matrix (DrawnPolygon.h in the tests
 * derives that). The way back from clip coordinates multiplies this error. It is smaller where VTK
 * shifts coordinates to the middle of what they belong to. Samples outside of the cone that only
 * this error brings in are receivers, too. They may get their shadow from casters that shadow
 * nothing in the cone: vtkShadowLitmap::GetWidestAngle() says how far off they are.
 *
 * With multisampling a fragment decides only once whether it lies in a spot's cone: at the place of
 * its surface, continued to the centre of the pixel. No sample knows how deep that is. So a sample
 * is also a receiver if the line of sight through the centre of its pixel meets the cone, and the
 * cone is not farther from the sample than 64 widths of a pixel: on surfaces that are seen at less
 * than a degree the centre might be that far.
 *
 * Lines and points are lit in their middle. So a sample is also a receiver if it is not farther
 * from the cone than vtkShadowView::LightingMargin widths of a pixel. That is infinity, and every
 * sample a receiver, if something is drawn whose shaders may light it for any place.
 *
 * ## Projection
 *
 * Both ends of the interval are projected to light coordinates. Where straight lines stay straight
 * that loses nothing. The decisions about cone and cube face are about the ball around the
 * interval: a sample that may be reached is a receiver. If the ball touches the light's plane s =
 * 0, so that its side or its p and q are not known, the radius is infinite.
 */
#ifndef vtkShadowReceiverProjector_h
#define vtkShadowReceiverProjector_h

#include "vtkShadowLight.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// The camera and the image that a depth image of receivers belongs to.
struct vtkShadowView
{
  /// The inverse of vtkCamera's world-to-clip matrix for z in [-w, w]. World coordinates are
  /// relative to Origin.
  glm::dmat4 ClipToWorld = glm::dmat4(1.0);

  glm::dvec3 Origin = { 0.0, 0.0, 0.0 }; ///< The world position of the eye.
  int Width = 0;                         ///< The number of columns, at most 65535.
  int Height = 0;                        ///< The number of rows, at most 65535.
  double DepthQuantum = 0x1p-24;         ///< The step of the depth format near 1.

  /// How far from a fragment, in pixels, the place may be for which VTK's shader lights it.
  double LightingMargin = 0.0;

  /// The places of the samples in a pixel, in [0, 1] from its lower left corner.
  std::vector<std::array<double, 2>> Samples = { { { 0.5, 0.5 } } };
};

class vtkShadowReceiverProjector
{
public:
  /// Where a receiver may lie, as vtkShadowLitmap::Add() and vtkShadowTiles::Add() take it.
  struct Receiver
  {
    /// The radius around the segment in p, q and s. That in s is part of the segment.
    glm::dvec3 GetRadii() const { return { this->Radius, this->Radius, 0.0 }; }

    glm::dvec3 A;  ///< One end of the segment in light coordinates.
    glm::dvec3 B;  ///< The other end.
    double Radius; ///< The radius around the segment in p and q.
    double Angle; ///< The largest angle from a spot's axis in radians if it is outside of the cone,
                  ///< or else 0.
  };

  vtkShadowReceiverProjector(
    const vtkShadowView& view, const vtkShadowLight& light, const vtkShadowLightSpace& space);

  /// Prepares for one row of pixels and the place of one sample in them.
  void SetRow(const std::array<double, 2>& sample, int y);

  /// The receiver in column x of the row at a window depth, or nothing if the light cannot reach
  /// it.
  std::optional<Receiver> Project(int x, double depth) const;

  /// A bound of |p| and |q| of what the light reaches.
  double GetLimit() const { return this->Limit; }

private:
  /// Returns false if the light reaches nothing in a ball.
  bool MayReach(const glm::dvec3& middle, double radius) const;

  void SetShaderError(const vtkShadowView& view);

  /// The largest angle from a spot's axis in a ball.
  double GetAngle(const glm::dvec3& middle, double radius) const;

  /// Returns true if the line of sight through the centre of a pixel may meet the cone, widened by
  /// a difference of cosines.
  bool MayCentreReach(int x, double widening) const;

  /// How far from its place VTK's shader may see what is at this distance from the eye.
  double GetShaderError(double distance) const;

  vtkShadowLightKind Kind;
  double DepthError; ///< What a window depth may be off by.
  double Limit = std::numeric_limits<double>::infinity();
  double ConeCosine;          ///< vtkShadowLight::GetConeCosine().
  double LightingMargin;      ///< vtkShadowView::LightingMargin.
  glm::dvec3 Direction;       ///< The light's direction along u, v and the axis.
  glm::dvec3 Eye;             ///< The eye relative to the apex, along u, v and the axis.
  double WorldError;          ///< The rounding of world coordinates.
  double ShaderOffset = 0.0;  ///< What is added to the distance to get S.
  double PlaceFactor = 0.0;   ///< What E is multiplied by in a place.
  double InverseFactor = 0.0; ///< What E is multiplied by in 1 / w.
  double GuardAtW1;           ///< A quarter of a pixel in world units, for w = 1.

  /// From (pixel x, pixel y, window depth, 1) to homogeneous coordinates along u, v and the axis,
  /// relative to the apex.
  glm::dmat4 Matrix;
  glm::dvec4 Row = glm::dvec4(0.0);       ///< Matrix * (sample, y, 0, 1).
  glm::dvec4 CentreRow = glm::dvec4(0.0); ///< The same for the centre of the pixel.
  bool ByCentre = false; ///< True if fragments decide about the cone at the centre of a pixel.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowReceiverProjector.h
