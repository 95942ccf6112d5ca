// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file City.h
 * @brief What the examples know of a city: building footprints with heights, and streets.
 *
 * Coordinates are whole centimetres in a local metric frame: x points to the east, y to the north.
 * Scripts/make-city.py computes them by the equirectangular projection about the city's centre,
 *
 *     x = R cos(latitude of the centre) (longitude - longitude of the centre)
 *     y = R (latitude - latitude of the centre)
 *
 * with R = 6,371,008.8 m. 20 km from the centre lengths are off by less than 0.5 %, by almost the
 * same factor for neighbouring objects, so that a picture does not show it.
 */
#ifndef City_h
#define City_h

#include <cstdint>
#include <string>
#include <vector>

namespace NBufferExamples
{

/// A point of the plan in centimetres.
struct CityPoint
{
  std::int32_t X = 0;
  std::int32_t Y = 0;
};

/// A closed line; its first point is not repeated at the end.
using CityRing = std::vector<CityPoint>;

struct CityBuilding
{
  /// The outer ring counterclockwise, then holes clockwise.
  std::vector<CityRing> Rings;
  /// The height above the ground in centimetres.
  std::int32_t Height = 0;
};

struct CityStreet
{
  /// Index into City::StreetKinds.
  int Kind = 0;
  std::vector<CityPoint> Points;
};

struct City
{
  /// Values of OpenStreetMap's tag "highway".
  std::vector<std::string> StreetKinds;
  std::vector<CityBuilding> Buildings;
  std::vector<CityStreet> Streets;
};

constexpr double CityMetresPerUnit = 0.01;

/// Twice the signed area of a ring in square centimetres; positive when counterclockwise.
inline double GetSignedDoubleArea(const CityRing& ring)
{
  double sum = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
  {
    sum += static_cast<double>(ring[j].X) * ring[i].Y - static_cast<double>(ring[i].X) * ring[j].Y;
  }
  return sum;
}

} // namespace NBufferExamples

#endif
