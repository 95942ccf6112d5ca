// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowReceiverProjector
 * @brief Where in light coordinates a sample of a depth image may lie. No OpenGL.
 *
 *        eye
 *         o
 *          \        a: the nearest possible place        both ends projected
 *           \  ___                                       -------->   a'----b'  segment in
 *            (  a  )   ball of rounding                              (p, q, s), with a
 *            (   \ )   around the interval a b                       radius in p and q
 *            (_ _ b)
 *                  b: the farthest possible place
 *
 * ## The interval on the line of sight
 *
 * The sample lies on the line of sight through its place in the image, in an interval of depths.
 * Three errors add up. First, the depth that was read is off by up to two quanta, one each for
 * storing and for reading it (vtkNBufferDepthSource::GetStep). Second, the depth of a volume that
 * is compared with it is off by a third quantum. Third, both depths were transformed to clip
 * coordinates in float. For four million random points (views of 1 to 120 degrees, far / near 3 to
 * 1e8; commit 7323db1) this last error was at most 5.4 * 2^-24 in window depth. It grows with r,
 * which is the distance from the eye to the image's farthest corner, divided by that to its centre.
 * So the interval reaches 3 quanta + 4 (1 + r) 2^-24 of window depth to both sides. (If the
 * distance between near and far plane is small compared with their distance from the eye, the last
 * error is larger. But then a quantum is so short a length that the radius below covers it.)
 *
 * Volumes of casters far from the origin of their coordinates are pushed away from the eye
 * (vtkShadowCounter.h): p is added to the z of their clip coordinates. Seen from the volume, the
 * receiver of depth d has moved towards the eye, to where (z + p) / w = d. With M the matrix from
 * clip to world coordinates and m its last row, w = (1 + p m_z) / (m (x/w, y/w, d, 1)) there. So
 * the place is 1 + p m_z times that of the receiver, minus p times the column of M for z; for a
 * parallel projection the factor is 1. The interval begins there for the largest push of all
 * volumes, which may be before the near plane. (If the factor is not positive, the push leads
 * beyond the eye. Nothing is in shadow then.)
 *
 * ## The radius around it
 *
 * In all directions the interval is widened by two rounding errors: that of a position, 2^-20 of
 * its distance from the eye, and that of world coordinates in double, 2^-48 of their size.
 *
 * Devices draw the sides of a volume and the edges of a receiver a little off their exact place.
 * Litmaps and tiles must hold all samples for which a volume may be drawn. So the radius grows by a
 * quarter of a pixel. (The margin of one lexel in vtkShadowLitmap::Query() may be smaller.)
 *
 * ## Samples that VTK's shader may find in a spot's cone
 *
 * When VTK's shader decides whether a sample lies in a spot's cone, it uses a position with other
 * errors than the depth. The position comes from corners that are transformed to view coordinates
 * in float, the depth from corners that are transformed to clip coordinates in float. Each of these
 * coordinates is off by up to E = 5 u S times the length of its row in the matrix (DrawnPolygon.h
 * in the folder Support derives that). Here u = 2^-24, and S is the sum of three distances: of the
 * eye from the world's origin, of the sample from the world's origin, and of eye from light. The
 * inverse transformation from clip coordinates multiplies this error. (It is smaller where VTK
 * shifts coordinates to the middle of their mesh.) A sample outside of the cone that this error may
 * bring into it is a receiver, too. Casters that shadow nothing in the cone may shadow such a
 * sample, so vtkShadowLitmap::GetWidestAngle() keeps the largest angle of these samples.
 *
 * With multisampling a fragment decides only once whether it lies in a spot's cone: for the centre
 * of the pixel, to which its surface is extrapolated. The depth there is not known from the
 * samples. So a sample is also a receiver if the line of sight through the centre of its pixel
 * meets the cone and the cone is at most 64 pixel widths from the sample. On a surface that is seen
 * at an angle of one degree, the point at the centre may be that far from the sample.
 *
 * VTK computes the light on a line or a point at the middle of its width. So a sample is also a
 * receiver if the cone is at most vtkShadowView::LightingMargin pixel widths from it. This margin
 * is infinite, and every sample is a receiver, if something is drawn whose shaders may compute the
 * light for any other place.
 *
 * ## Projection
 *
 * Both ends of the interval are projected to light coordinates. That loses nothing, because
 * straight lines stay straight in p and q. The tests against cone and cube face use the ball around
 * the interval, so that every sample that the light may reach is a receiver. If the ball touches
 * the light's plane s = 0, p and q of the sample are not known, and the radius is infinite.
 */
#ifndef vtkShadowReceiverProjector_h
#define vtkShadowReceiverProjector_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowConeReach.h"
#include "vtkShadowLight.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// The camera and the image format of a depth image of receivers.
struct vtkShadowView
{
  /// From clip coordinates, with z in [-w, w] as vtkCamera gives them, to world coordinates
  /// relative to Origin.
  glm::dmat4 ClipToWorld = glm::dmat4(1.0);

  glm::dvec3 Origin = { 0.0, 0.0, 0.0 }; ///< The world position of the eye.
  int Width = 0;                         ///< The number of columns, at most 65535.
  int Height = 0;                        ///< The number of rows, at most 65535.
  double DepthQuantum = 0x1p-24;         ///< The step of the depth format near 1.

  /// The largest distance, in pixels, from a fragment to the place at which VTK computes the light
  /// on it. Infinity stands for any place.
  double LightingMargin = 0.0;

  /// The largest distance that volumes are pushed (vtkShadowDrawList::View::GetPush()).
  double Push = 0.0;

  /// The places of the samples in a pixel, in [0, 1] from its lower left corner.
  std::vector<std::array<double, 2>> Samples = { { { 0.5, 0.5 } } };
};

class VTKNBUFFER_EXPORT vtkShadowReceiverProjector
{
public:
  /// Where a receiver may lie, as vtkShadowLitmap::Add() and vtkShadowTiles::Add() take it.
  struct Receiver
  {
    /// The radius around the segment in p, q and s. It is 0 in s, where A and B include it.
    glm::dvec3 GetRadii() const { return { this->Radius, this->Radius, 0.0 }; }

    glm::dvec3 A;  ///< One end of the segment in light coordinates.
    glm::dvec3 B;  ///< The other end.
    double Radius; ///< The radius around the segment in p and q.
    double Angle;  ///< The largest possible angle from a spot's axis in radians, if the receiver is
                   ///< outside of the cone; else 0.
  };

  vtkShadowReceiverProjector(
    const vtkShadowView& view, const vtkShadowLight& light, const vtkShadowLightSpace& space);

  /// Selects the row of pixels, and the place of the sample in a pixel, for Project().
  void SetRow(const std::array<double, 2>& sample, int y);

  /// Returns the receiver in column x of the row at a window depth, or nothing if the light cannot
  /// reach it.
  std::optional<Receiver> Project(int x, double depth) const;

  /// An upper bound of |p| and |q| of what the light reaches; infinity if there is none.
  double GetLimit() const { return this->Limit; }

  /// What is known of all samples that the view can have: how far from a spot's cone they may be
  /// and still be receivers, plus how far from its exact place a volume may be drawn there. With
  /// multisampling nothing is known.
  vtkShadowConeReach GetConeReach() const;

private:
  /// Returns false if the light reaches nothing in a ball. `middle` is relative to the apex, along
  /// u, v and the axis, here and in GetAngle().
  bool MayReach(const glm::dvec3& middle, double radius) const;

  void SetShaderError(const vtkShadowView& view);

  /// The largest angle from a spot's axis of any point in a ball, in radians.
  double GetAngle(const glm::dvec3& middle, double radius) const;

  /// Returns true if the line of sight through the centre of a pixel may meet the cone, widened by
  /// a difference of cosines.
  bool MayCentreReach(int x, double widening) const;

  /// The largest error, in world units, of the position that VTK's shader computes for a sample at
  /// this distance from the eye.
  double GetShaderError(double distance) const;

  vtkShadowLightKind Kind;
  glm::dvec2 Size;                          ///< The width and height of the image.
  double DepthError;                        ///< The largest error of a window depth.
  double PushFactor = 1.0;                  ///< By what the largest push multiplies a place.
  glm::dvec3 PushShift = { 0.0, 0.0, 0.0 }; ///< What it subtracts from the place after that.
  double Limit = std::numeric_limits<double>::infinity();
  double ConeCosine;          ///< vtkShadowLight::GetConeCosine().
  double LightingMargin;      ///< vtkShadowView::LightingMargin.
  glm::dvec3 Direction;       ///< The light's direction along u, v and the axis.
  glm::dvec3 Eye;             ///< The eye relative to the apex, along u, v and the axis.
  double WorldError;          ///< The rounding error of world coordinates, in world units.
  double ShaderOffset = 0.0;  ///< S minus the distance of the sample from the eye.
  double PlaceFactor = 0.0;   ///< The error of a position is E times this, if w is exact.
  double InverseFactor = 0.0; ///< The error of 1 / w is E times this.
  double GuardAtW1;           ///< The size of a quarter of a pixel in world units where w = 1.

  /// From (pixel x, pixel y, window depth, 1) to homogeneous coordinates along u, v and the axis,
  /// relative to the apex.
  glm::dmat4 Matrix;
  glm::dvec4 Row = glm::dvec4(0.0);       ///< Matrix * (sample, y, 0, 1).
  glm::dvec4 CentreRow = glm::dvec4(0.0); ///< The same for the centre of the pixel.
  bool ByCentre = false; ///< True if fragments decide about the cone at the centre of a pixel.
};

VTK_ABI_NAMESPACE_END
#endif
