// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sun.h
 * @brief The place of the sun in the sky, and a city in its light.
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

#include "vtkNBufferGLM.h"

#include "vtkLight.h"
#include "vtkSmartPointer.h"

namespace NBufferExamples
{
struct Scene;

struct SunTime
{
  double Latitude = 53.56; ///< Degrees north; the default is that of Neubrandenburg.
  int Day = 172;           ///< Day of the year; the default is 21 June.
  double Hour = 9.0;       ///< Solar time.
};

/**
 * Returns the unit vector to the sun:
 *
 *     axis that points up  east  north  up
 *     z (2)                x     y      z
 *     y (1)                x     -z     y
 *     x (0)                y     z      x
 */
glm::dvec3 GetDirectionToSun(const SunTime& time, int upAxis = 2);

/// Makes a directional light from the sun. SetSun() moves it.
vtkSmartPointer<vtkLight> MakeSun(const SunTime& time, int upAxis = 2);
void SetSun(const SunTime& time, vtkLight* light, int upAxis = 2);

/// Lights the ground and the streets of a city, if the scene is one, or gives them the one colour
/// again that they have at first and that no shadow changes.
void LightGround(const Scene& scene, bool isLit = true);

} // namespace NBufferExamples

#endif
