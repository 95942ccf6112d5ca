// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowConeReach
 * @brief Which casters shadow nothing that a spot may light, for all samples that a view can have.
 * No OpenGL.
 *
 * Samples outside of a spot's cone may be receivers because of rounding errors, which grow with the
 * distance z from the eye (vtkShadowReceiverProjector.h). A sample at most z away that is a
 * receiver, or in which a volume may be drawn wrongly, is at most
 *
 *     E(z) = A0 + A1 z + A2 z^2
 *
 * from the cone or from the volume. Let a caster be at least d away from the light and, as seen
 * from the light, at least the angle b outside of the cone. What it shadows lies on its rays behind
 * it, at least max(d, z - e) from the light, where e is the distance of light and eye:
 *
 *               eye .---- e ----. light
 *                    \         /|\            The place P is in the caster's shadow. Its distance
 *                     \       / |b\           from the cone is at least |P - L| sin b (|P - L|
 *                    z \     / cone\ d        itself, from the apex, for b of more than 90
 *                       \   /   |   [caster]  degrees).
 *                        \ /    |    \
 *                                     P
 *
 * So the caster shadows no receiver if E(z) < max(d, z - e) sin b for all z up to the farthest
 * sample. E is convex and the right side is constant up to z = d + e and linear from there on.
 * Their difference is therefore largest at z = d + e or at the farthest sample.
 */
#ifndef vtkShadowConeReach_h
#define vtkShadowConeReach_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowConeReach
{
  /// The default is that of a view in which any sample may be a receiver.
  double A0 = std::numeric_limits<double>::infinity();
  double A1 = 0.0;
  double A2 = 0.0;
  double Farthest = 0.0;   ///< The distance of the farthest sample from the eye.
  double EyeToLight = 0.0; ///< The distance e.

  /// Returns true if a caster with this distance d and angle b, in radians, shadows no receiver.
  bool Excludes(double distance, double angle) const
  {
    constexpr double rightAngle = 1.5707963267948966;
    const double sine = std::sin(std::clamp(angle, 0.0, rightAngle));
    const auto isShort = [&](double z)
    {
      return this->A0 + z * (this->A1 + z * this->A2) <
        std::max(distance, z - this->EyeToLight) * sine;
    };
    return isShort(std::min(distance + this->EyeToLight, this->Farthest)) &&
      isShort(this->Farthest);
  }

  /// Returns the same rounded up to steps of 9 %, so that it seldom changes when the camera moves.
  vtkShadowConeReach RoundedUp() const
  {
    const auto roundUp = [](double x)
    { return x > 0.0 ? std::exp2(std::ceil(8.0 * std::log2(x)) / 8.0) : x; };
    return { roundUp(this->A0), roundUp(this->A1), roundUp(this->A2), roundUp(this->Farthest),
      roundUp(this->EyeToLight) };
  }

  bool operator==(const vtkShadowConeReach& other) const
  {
    return this->A0 == other.A0 && this->A1 == other.A1 && this->A2 == other.A2 &&
      this->Farthest == other.Farthest && this->EyeToLight == other.EyeToLight;
  }
};

VTK_ABI_NAMESPACE_END
#endif
