// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowLight.h
 * @brief A light that casts, as geometry: which side of a triangle it sees, and its coordinates.
 * No OpenGL.
 *
 * A light sees the world along rays. Light coordinates (p, q, s) name the ray and the place on it:
 *
 *     directional   s = X . d,        p = X . u,        q = X . v          (world units)
 *     positional    s = (X - L) . d,  p = (X - L) . u / s,  q = (X - L) . v / s,  for s > 0
 *
 * with the unit axis d away from the light and u, v completing it. p and q are constant along a
 * ray, s increases along it, linearly in space. s is the distance along the axis, not from the
 * light: planes s = const are flat, so that what is extruded onto one stays flat (X. Decoret,
 * "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3), 2005, section 3.3 has
 * projected depths instead).
 *
 * Everything is double precision in world coordinates.
 */
#ifndef vtkShadowLight_h
#define vtkShadowLight_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

VTK_ABI_NAMESPACE_BEGIN

enum class vtkShadowLightKind
{
  Directional, ///< Parallel rays along Direction.
  Spot,        ///< From Position, within ConeAngle of Direction.
  Point        ///< From Position, everywhere.
};

/**
 * A light as VTK shades with it.
 */
struct VTKNBUFFER_EXPORT vtkShadowLight
{
  vtkShadowLightKind Kind = vtkShadowLightKind::Directional;
  double Position[3] = { 0.0, 0.0, 0.0 }; ///< World; not used for Directional.
  double Direction[3] = { 0.0, 0.0,
    -1.0 };                ///< World, unit length, away from the light; not for Point.
  double ConeAngle = 90.0; ///< Spot: degrees from the axis to the cone's surface.

  bool operator==(const vtkShadowLight& other) const;

  bool IsPositional() const { return this->Kind != vtkShadowLightKind::Directional; }

  /**
   * The side of triangle (a, b, c) that the light sees: 1 if its corners go round anticlockwise as
   * seen from the light (its normal by the right hand points to it), -1 if clockwise, 0 if it is
   * seen edge-on, has no area, or a coordinate is NaN. To be computed once per triangle and
   * stored: the sides of its edges must agree.
   */
  int GetFacing(const double a[3], const double b[3], const double c[3]) const;

  /// True if the light can reach X: in the cone for a spot (a hundredth of a degree wider), always
  /// for the others.
  bool IsInCone(const double x[3]) const;

  /// X is reached by a spot if the cosine of its angle from the axis is at least this; -1 for the
  /// others.
  double GetConeCosine() const;
};

/**
 * Light coordinates around one axis: the light's own, or one chosen for a caster of a point light.
 */
class VTKNBUFFER_EXPORT vtkShadowLightSpace
{
public:
  /// The axis of a directional or spot light.
  explicit vtkShadowLightSpace(const vtkShadowLight& light);

  /// A positional light's rays around another axis (normalised here; must not be null).
  vtkShadowLightSpace(const vtkShadowLight& light, const double axis[3]);

  bool IsPositional() const { return this->Positional; }
  const double* GetApex() const { return this->Apex; }
  const double* GetAxis() const { return this->Axis; }
  ///@{
  /// The directions of p and q.
  const double* GetU() const { return this->U; }
  const double* GetV() const { return this->V; }
  ///@}

  /// s alone; may be 0 or negative for positional lights.
  double GetDepth(const double x[3]) const;

  /// (p, q, s) of X. For a positional light p and q mean nothing unless s > 0.
  void ToLight(const double x[3], double pqs[3]) const;

  /// The inverse of ToLight.
  void ToWorld(const double pqs[3], double x[3]) const;

  /// The point on the ray through X with depth s. X must have a positive depth itself if the light
  /// is positional.
  void Extrude(const double x[3], double s, double result[3]) const;

private:
  void SetAxis(const double axis[3]);

  bool Positional;
  double Apex[3] = { 0.0, 0.0, 0.0 };
  double Axis[3];
  double U[3];
  double V[3];
};

VTK_ABI_NAMESPACE_END
#endif
