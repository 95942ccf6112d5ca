// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-city.cxx
 * @brief Makes the compact city file of the examples from an OpenStreetMap extract.
 */
#include "CityFile.h"
#include "OsmImport.h"

#include <CLI/CLI.hpp>

#include <array>
#include <exception>
#include <filesystem>
#include <iostream>

namespace
{
void PrintSummary(const NBufferExamples::City& city, const NBufferExamples::OsmImportCounts& counts,
  const std::string& output)
{
  std::array<int, 3> heights = {};
  std::size_t corners = 0;
  for (const NBufferExamples::CityBuilding& building : city.Buildings)
  {
    ++heights[static_cast<std::size_t>(building.Source)];
    for (const NBufferExamples::CityRing& ring : building.Rings)
    {
      corners += ring.size();
    }
  }
  std::cout << city.Buildings.size() << " buildings with " << corners
            << " corners; left out: " << counts.TooSmall << " too small, " << counts.NotClosed
            << " not closed, " << counts.NoLocation << " cut off by the extract\n"
            << "heights: " << heights[1] << " tagged, " << heights[2] << " from storeys, "
            << heights[0] << " synthetic\n"
            << city.Streets.size() << " streets of " << city.StreetKinds.size() << " kinds\n"
            << "centre: latitude " << city.Latitude0 << ", longitude " << city.Longitude0 << "\n"
            << output << ": " << std::filesystem::file_size(output) << " bytes\n";
}
}

int main(int argc, char* argv[])
{
  CLI::App app("Make a compact city file (buildings and streets) from an OpenStreetMap extract.\n"
               "Heights come from the tags height and building:levels; all others are synthetic:\n"
               "by a rule from the area of the footprint.");
  app.set_version_flag("--version", NBUFFER_VERSION);
  std::string input;
  std::string output;
  NBufferExamples::OsmImportOptions options;
  app.add_option("input", input, "OSM extract: .osm, .osm.bz2, .osm.gz or .osm.pbf")->required();
  app.add_option("output", output, "City file to write")->required();
  app.add_flag("--multipolygons", options.Multipolygons,
    "Also take buildings that are multipolygon relations, with their courtyards");
  CLI11_PARSE(app, argc, argv);

  try
  {
    int shown = -1;
    options.Progress = [&shown](double share)
    {
      const int percent = static_cast<int>(100.0 * share);
      if (percent != shown)
      {
        std::cerr << "\rreading " << percent << " %" << std::flush;
        shown = percent;
      }
    };
    NBufferExamples::OsmImportCounts counts;
    const NBufferExamples::City city = NBufferExamples::ImportOsm(input, options, &counts);
    std::cerr << "\r             \r";
    NBufferExamples::WriteCity(city, output);
    PrintSummary(city, counts, output);
  }
  catch (const std::exception& error)
  {
    std::cerr << "\nnbuffer-city: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
