// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file City.h
 * @brief What the examples know of a city: building footprints with heights, and streets.
 *
 * Coordinates are whole centimetres in a local metric frame: x to the east, y to the north, from
 * the centre (Latitude0, Longitude0) by the equirectangular projection
 *
 *     x = R cos(Latitude0) (longitude - Longitude0),    y = R (latitude - Latitude0)
 *
 * with R = 6,371,008.8 m. 20 km from the centre it is off by less than 0.5 %, the same way for
 * everything nearby, which a picture does not show.
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

  bool operator==(const CityPoint& other) const { return X == other.X && Y == other.Y; }
  bool operator!=(const CityPoint& other) const { return !(*this == other); }
};

/// Without repeating the first point at the end.
using CityRing = std::vector<CityPoint>;

/// Where a height comes from. Only Tag and Levels are data.
enum class CityHeightSource : std::uint8_t
{
  Synthetic, ///< By the rule of GetSyntheticHeight(): invented.
  Tag,       ///< From the tag "height".
  Levels     ///< From the tag "building:levels", GetHeightOfLevels() of it.
};

struct CityBuilding
{
  /// The outer ring counterclockwise, then holes clockwise.
  std::vector<CityRing> Rings;
  /// In centimetres above the ground.
  std::int32_t Height = 0;
  CityHeightSource Source = CityHeightSource::Synthetic;
};

struct CityStreet
{
  /// Index into City::StreetKinds.
  int Kind = 0;
  std::vector<CityPoint> Points;
};

struct City
{
  double Latitude0 = 0.0;
  double Longitude0 = 0.0;
  /// Whose data it is and under which licence; copied into every derived file.
  std::string Attribution;
  /// Values of OpenStreetMap's tag "highway".
  std::vector<std::string> StreetKinds;
  std::vector<CityBuilding> Buildings;
  std::vector<CityStreet> Streets;
};

constexpr double CityEarthRadius = 6371008.8;
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

/// Metres for a number of storeys: 3 m each and 1 m of parapet or roof.
inline double GetHeightOfLevels(double levels)
{
  return 3.0 * levels + 1.0;
}

/**
 * The rule for the heights of buildings that carry none. Footprints up to 30 square metres are
 * sheds and garages, up to 80 bungalows, up to 250 houses, up to 600 blocks of flats, up to 2000
 * larger blocks, and above that halls. `seed` (the OpenStreetMap id) spreads the heights evenly
 * within the class. Plausible for a Central European town and not more: synthetic.
 */
inline double GetSyntheticHeight(double squareMetres, std::uint64_t seed)
{
  struct Class
  {
    double UpToArea, Low, High;
  };
  constexpr Class classes[] = { { 30, 2.4, 3.0 }, { 80, 2.8, 5.0 }, { 250, 6.0, 10.0 },
    { 600, 9.0, 17.0 }, { 2000, 10.0, 24.0 }, { 1e300, 7.0, 14.0 } };
  // The finaliser of MurmurHash3: neighbouring ids get unrelated heights.
  seed ^= seed >> 33;
  seed *= 0xff51afd7ed558ccdULL;
  seed ^= seed >> 33;
  seed *= 0xc4ceb9fe1a85ec53ULL;
  seed ^= seed >> 33;
  const double t = static_cast<double>(seed >> 11) / 9007199254740992.0;
  const Class* c = classes;
  while (squareMetres > c->UpToArea)
  {
    ++c;
  }
  return c->Low + t * (c->High - c->Low);
}

} // namespace NBufferExamples

#endif
