// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OracleImage.h
 * @brief The light that the ray oracle (RayOracle.h) casts rays to, and the image that it makes.
 */
#ifndef OracleImage_h
#define OracleImage_h

#include <vector>

class vtkLight;

/// A light as VTK's shaders use it, in world coordinates.
struct OracleLight
{
  explicit OracleLight(vtkLight* light);

  /// Returns a unit vector from a place to the light.
  void GetDirectionTo(const double place[3], double direction[3]) const;

  bool Positional;
  double Position[3];
  double Direction[3];      ///< The unit vector along which the light shines.
  double ConeCosine = -2.0; ///< The cosine at the cone's edge; -2 for lights without a cone.
};

enum class OracleSample : unsigned char
{
  Background, ///< No triangle is seen.
  Lit,
  Shadowed, ///< The sample would be lit without shadows.
  Unlit ///< The light is on the other side of the triangle's plane than the eye, or the sample is
        ///< outside of the light's cone: VTK's two-sided lighting leaves it dark with or without
        ///< shadow.
};

struct OracleImage
{
  int Width = 0;
  int Height = 0;
  std::vector<OracleSample> Samples; ///< Row by row, the lowest first.
  /// For each sample, not 0 if rounding may decide whether it is lit (Oracle::IsAmbiguous(),
  /// ThinSides.h).
  std::vector<unsigned char> Ambiguous;

  int Count(OracleSample sample) const;
  int CountAmbiguous() const;
};

#endif
