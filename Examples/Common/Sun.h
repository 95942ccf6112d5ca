// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sun.h
 * @brief Where the sun stands, and a city in its light.
 *
 * With the latitude phi, day n of the year (1 January: 1) and solar time t in hours (12: the sun in
 * the south):
 *
 *     declination  d = 23.45 deg * sin(360 deg * (284 + n) / 365)    (P. I. Cooper, "The absorption
 *                                    of radiation in solar stills", Solar Energy 12(3), 1969)
 *     hour angle   h = 15 deg * (t - 12)
 *     to the sun:  east   -cos d sin h
 *                  north   cos phi sin d - sin phi cos d cos h
 *                  up      sin phi sin d + cos phi cos d cos h
 */
#ifndef Sun_h
#define Sun_h

#include "vtkLight.h"
#include "vtkSmartPointer.h"

namespace NBufferExamples
{
struct Scene;

struct SunTime
{
  double Latitude = 53.56; ///< Degrees north; of Neubrandenburg.
  int Day = 172;           ///< Of the year: 21 June.
  double Hour = 9.0;       ///< Solar time.
};

/// Unit vector to the sun, x east, y north, z up.
void GetDirectionToSun(const SunTime& time, double direction[3]);

/// Of the sun above the horizon, degrees.
double GetElevation(const SunTime& time);

/// A directional light from the sun; move it with SetSun.
vtkSmartPointer<vtkLight> MakeSun(const SunTime& time);
void SetSun(const SunTime& time, vtkLight* light);

/// Light the ground and the streets as well, which otherwise have one colour that no shadow
/// changes.
void LightGround(const Scene& city);

} // namespace NBufferExamples

#endif
