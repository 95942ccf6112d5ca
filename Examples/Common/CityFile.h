// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CityFile.h
 * @brief The compact file of a city that Scripts/make-city.py writes: a gzip stream of the
 * following.
 *
 *     "NBufferCity\n"         12 bytes
 *     version                 u, 1
 *     attribution             string: whose data it is, and under which licence
 *     latitude, longitude     s, s in 1e-7 degrees: of the centre
 *     number of street kinds  u, then that many strings
 *     number of buildings     u, then for each
 *       height source         u: 0 synthetic, 1 tag "height", 2 tag "building:levels"
 *       height                u, centimetres
 *       number of rings       u, at least 1, then for each
 *         number of points    u, at least 3, then that many points
 *     number of streets       u, then for each
 *       kind                  u, index into the street kinds
 *       number of points      u, at least 2, then that many points
 *
 * u is an unsigned number in groups of seven bits, the lowest first, bit 7 set on all but the
 * last byte; s is a signed one, folded to u as 2 n or -2 n - 1; a string is its length in bytes
 * (u) and UTF-8. A point is two s: the step in x and y in centimetres from the point before it
 * in the file (the first one: from the origin). Rings do not repeat their first point.
 */
#ifndef CityFile_h
#define CityFile_h

#include "City.h"

namespace NBufferExamples
{

/// Returns whether a file begins like a city file; false if it cannot be read.
bool IsCityFile(const std::string& fileName);

/// Reads a city file. Throws std::runtime_error, with the name of the file and the cause, if it
/// cannot be read or is damaged.
City ReadCity(const std::string& fileName);

} // namespace NBufferExamples

#endif
