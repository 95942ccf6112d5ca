// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OsmImport.h
 * @brief A city from an OpenStreetMap extract, read by libosmium.
 *
 * A building is every closed way with the tag "building", whatever its value, of at least 4
 * square metres. Streets are all ways with the tag "highway" but areas, tunnels, and what is not
 * (yet) there: proposed, construction, corridor.
 */
#ifndef OsmImport_h
#define OsmImport_h

#include "City.h"

#include <functional>

namespace NBufferExamples
{

struct OsmImportOptions
{
  /// Also take buildings that are multipolygon relations, with their holes, unless their outer
  /// way carries the tag itself.
  bool Multipolygons = false;
  /// Called now and then with the share done, 0 to 1.
  std::function<void(double)> Progress;
};

/// What was left out and why.
struct OsmImportCounts
{
  int TooSmall = 0;   ///< Below 4 square metres.
  int NotClosed = 0;  ///< Its ring does not close, or has fewer than three corners.
  int NoLocation = 0; ///< The extract lacks some of its nodes.
};

/// Throws std::runtime_error that names the file and the cause, also when no building is found.
City ImportOsm(const std::string& fileName, const OsmImportOptions& options = {},
  OsmImportCounts* counts = nullptr);

} // namespace NBufferExamples

#endif
