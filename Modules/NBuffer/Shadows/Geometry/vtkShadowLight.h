// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowLight.h
 * @brief The geometry of a light that casts shadows, and its light coordinates (p, q, s). No
 * OpenGL.
 *
 * A light sees the world along its rays. (p, q) names a ray, and s is the place on the ray:
 *
 *      directional light                     spot or point light at L
 *
 *      d   d   d   d   d  (parallel rays)             L          s = 0
 *      |   |   |   |   |                             /|\
 *      |   |   |   |   |                            / | \
 *     -+---+---+---+---+-  s = 1                 --/--+--\--     s = 1
 *      |   |   |   |   |                          /   |   \
 *     -+---+---+---+---+-  s = 2                -/----+----\-    s = 2
 *     p=-2 -1  0   1   2                    p=-1/2  p=0   p=1/2
 *
 * d is the unit vector along the axis; it points away from the light. u and v are the unit vectors
 * along which p and q grow. u, v and d are perpendicular to each other. Then
 *
 *     directional   s = X . d,        p = X . u,            q = X . v          (world units)
 *     positional    s = (X - L) . d,  p = (X - L) . u / s,  q = (X - L) . v / s,  for s > 0
 *
 * p and q are constant along a ray, and s increases along it, linearly in space. s is measured
 * along the axis and is not the distance from the light. So surfaces s = const are planes, and a
 * flat shape that is extruded onto one of them stays flat. (X. Decoret, "N-Buffers for efficient
 * depth map query", Computer Graphics Forum 24(3), 2005, section 3.3, uses projected depths.)
 *
 * All numbers are doubles, all points are in world coordinates.
 */
#ifndef vtkShadowLight_h
#define vtkShadowLight_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

enum class vtkShadowLightKind
{
  Directional, ///< The rays are parallel to Direction.
  Spot,        ///< The rays leave Position within ConeAngle of Direction.
  Point        ///< The rays leave Position in all directions.
};

/**
 * A light as VTK shades with it.
 */
struct VTKNBUFFER_EXPORT vtkShadowLight
{
  vtkShadowLightKind Kind = vtkShadowLightKind::Directional;

  /// The world position of a spot or point light. A directional light does not use it.
  glm::dvec3 Position = { 0.0, 0.0, 0.0 };

  /// The direction of the axis in the world, away from the light, with unit length. A point light
  /// does not use it.
  glm::dvec3 Direction = { 0.0, 0.0, -1.0 };

  /// The angle of a spot in degrees, from the axis to the surface of the cone.
  double ConeAngle = 90.0;

  /// Returns true if all members are equal. (GLM's operator subtracts, so that an infinite
  /// coordinate would not be equal to itself.)
  bool operator==(const vtkShadowLight& other) const
  {
    const auto isSame = [](const glm::dvec3& a, const glm::dvec3& b)
    { return a.x == b.x && a.y == b.y && a.z == b.z; };
    return this->Kind == other.Kind && this->ConeAngle == other.ConeAngle &&
      isSame(this->Position, other.Position) && isSame(this->Direction, other.Direction);
  }

  bool IsPositional() const { return this->Kind != vtkShadowLightKind::Directional; }

  /**
   * The side of triangle (a, b, c) that the light sees. It is 1 if the corners go round
   * anticlockwise as seen from the light (the normal by the right-hand rule points to the light),
   * and -1 if they go round clockwise. It is 0 if the light sees the triangle edge-on, if the
   * triangle has no area, or if a coordinate is NaN. Compute it once for each triangle and store
   * it, so that all edges of the triangle use the same value.
   */
  int GetFacing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;

  /// The cosine of the angle ConeAngle + 0.01 degrees, which is at most 180 degrees here. A point
  /// counts as inside a spot's cone if the cosine of its angle from the axis is at least this
  /// value. It is -1 for the kinds without a cone.
  double GetConeCosine() const;
};

/**
 * The light coordinates around one axis: the light's own axis, or one chosen for a point light.
 */
class VTKNBUFFER_EXPORT vtkShadowLightSpace
{
public:
  /// The light coordinates around the axis of a directional or spot light.
  explicit vtkShadowLightSpace(const vtkShadowLight& light)
    : vtkShadowLightSpace(light, light.Direction)
  {
  }

  /// The light coordinates of a spot or point light around another axis, in world coordinates. The
  /// axis may have any length except 0.
  vtkShadowLightSpace(const vtkShadowLight& light, const glm::dvec3& axis);

  /// The light coordinates for the six faces of a cube around a point light.
  static std::vector<vtkShadowLightSpace> MakeFaces(const vtkShadowLight& light);

  bool IsPositional() const { return this->Positional; }

  /// The light's position, or the origin of the world for a directional light.
  const glm::dvec3& GetApex() const { return this->Apex; }

  /// The direction d of s, with unit length.
  const glm::dvec3& GetAxis() const { return this->Axis; }

  /// The direction u of p, with unit length.
  const glm::dvec3& GetU() const { return this->U; }

  /// The direction v of q, with unit length.
  const glm::dvec3& GetV() const { return this->V; }

  /// The depth s of X. It may be 0 or negative for a positional light.
  double GetDepth(const glm::dvec3& x) const { return glm::dot(x - this->Apex, this->Axis); }

  /// The light coordinates (p, q, s) of X. For a positional light p and q mean something only if
  /// s > 0.
  glm::dvec3 ToLight(const glm::dvec3& x) const
  {
    const glm::dvec3 ray = x - this->Apex;
    const double s = glm::dot(ray, this->Axis);
    const double divisor = this->Positional ? s : 1.0;
    return { glm::dot(ray, this->U) / divisor, glm::dot(ray, this->V) / divisor, s };
  }

  /// The point with depth s on the ray through X. For a positional light the depth of X itself must
  /// be positive.
  glm::dvec3 Extrude(const glm::dvec3& x, double s) const;

private:
  bool Positional;
  glm::dvec3 Apex;
  glm::dvec3 Axis;
  glm::dvec3 U;
  glm::dvec3 V;
};

VTK_ABI_NAMESPACE_END
#endif
