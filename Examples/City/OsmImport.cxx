// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OsmImport.h"

#include <osmium/area/assembler.hpp>
#include <osmium/area/multipolygon_manager.hpp>
#include <osmium/handler/node_locations_for_ways.hpp>
#include <osmium/index/map/flex_mem.hpp>
#include <osmium/io/any_input.hpp>
#include <osmium/visitor.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
using LocationIndex =
  osmium::index::map::FlexMem<osmium::unsigned_object_id_type, osmium::Location>;
using LocationHandler = osmium::handler::NodeLocationsForWays<LocationIndex>;

constexpr double SmallestBuilding = 4.0; // square metres
constexpr double RadiansPerDegree = 3.14159265358979323846 / 180.0;

using GeoLine = std::vector<osmium::Location>;

/// A building or street before the centre of the projection is known.
struct GeoBuilding
{
  std::vector<GeoLine> Rings;
  std::uint64_t Id = 0;
  double Height = 0.0;
  CityHeightSource Source = CityHeightSource::Synthetic;
};
struct GeoStreet
{
  std::string Kind;
  GeoLine Points;
};

/// Metres at the beginning of a tag ("12", "12.5 m"), 0 for none. "40 ft" and 7'4" are converted.
double ParseMetres(const char* text)
{
  if (!text)
  {
    return 0.0;
  }
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  const std::string unit(end);
  const bool feet = unit.find("ft") != std::string::npos || unit.rfind('\'', 0) == 0;
  return std::isfinite(value) && value > 0.0 && value < 1000.0 ? value * (feet ? 0.3048 : 1.0)
                                                               : 0.0;
}

bool GetLine(const osmium::NodeRefList& nodes, GeoLine& line)
{
  for (const osmium::NodeRef& node : nodes)
  {
    if (!node.location().valid())
    {
      return false;
    }
    if (line.empty() || line.back() != node.location())
    {
      line.push_back(node.location());
    }
  }
  return true;
}

/// The points of a closed line in an order that does not depend on where the line starts.
GeoLine GetKey(GeoLine line)
{
  std::sort(line.begin(), line.end());
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

class Handler : public osmium::handler::Handler
{
public:
  explicit Handler(OsmImportCounts& counts)
    : Counts(counts)
  {
  }

  void way(const osmium::Way& way)
  {
    const osmium::TagList& tags = way.tags();
    if (tags.has_key("building"))
    {
      this->AddBuilding(way);
    }
    if (const char* kind = tags.get_value_by_key("highway"))
    {
      this->AddStreet(way, kind);
    }
  }

  /// A multipolygon relation; areas made from ways come through way().
  void area(const osmium::Area& area)
  {
    const bool tagged = area.tags().has_key("building");
    if (!tagged || area.from_way())
    {
      return;
    }
    for (const osmium::OuterRing& outer : area.outer_rings())
    {
      GeoBuilding building;
      building.Id = static_cast<std::uint64_t>(area.orig_id());
      SetHeight(area.tags(), building);
      building.Rings.emplace_back();
      GetLine(outer, building.Rings.back());
      if (this->OuterRings.count(GetKey(building.Rings.back())))
      {
        continue; // The outer way is a building by itself.
      }
      for (const osmium::InnerRing& inner : area.inner_rings(outer))
      {
        building.Rings.emplace_back();
        GetLine(inner, building.Rings.back());
      }
      this->Buildings.push_back(std::move(building));
    }
  }

  std::vector<GeoBuilding> Buildings;
  std::vector<GeoStreet> Streets;
  bool RememberRings = false;

private:
  static void SetHeight(const osmium::TagList& tags, GeoBuilding& building)
  {
    building.Height = ParseMetres(tags.get_value_by_key("height"));
    building.Source = CityHeightSource::Tag;
    if (building.Height == 0.0)
    {
      const double levels = ParseMetres(tags.get_value_by_key("building:levels"));
      building.Height = levels > 0.0 ? GetHeightOfLevels(levels) : 0.0;
      building.Source = levels > 0.0 ? CityHeightSource::Levels : CityHeightSource::Synthetic;
    }
  }

  void AddBuilding(const osmium::Way& way)
  {
    GeoBuilding building;
    building.Id = static_cast<std::uint64_t>(way.id());
    SetHeight(way.tags(), building);
    building.Rings.emplace_back();
    if (!GetLine(way.nodes(), building.Rings.back()))
    {
      ++this->Counts.NoLocation;
    }
    else if (!way.is_closed() || building.Rings.back().size() < 4)
    {
      ++this->Counts.NotClosed;
    }
    else
    {
      if (this->RememberRings)
      {
        this->OuterRings.insert(GetKey(building.Rings.back()));
      }
      this->Buildings.push_back(std::move(building));
    }
  }

  void AddStreet(const osmium::Way& way, const std::string& kind)
  {
    if (kind == "proposed" || kind == "construction" || kind == "corridor" ||
      way.tags().has_tag("area", "yes") || way.tags().has_key("tunnel"))
    {
      return;
    }
    GeoStreet street;
    street.Kind = kind;
    if (GetLine(way.nodes(), street.Points) && street.Points.size() >= 2)
    {
      this->Streets.push_back(std::move(street));
    }
  }

  OsmImportCounts& Counts;
  /// Keys of the closed building ways, for area().
  std::set<GeoLine> OuterRings;
};

class Projection
{
public:
  explicit Projection(const std::vector<GeoBuilding>& buildings)
  {
    osmium::Box box;
    for (const GeoBuilding& building : buildings)
    {
      for (const osmium::Location& location : building.Rings.front())
      {
        box.extend(location);
      }
    }
    // Rounded as the file stores it, so that reading gives the same frame.
    this->Latitude0 = std::round((box.bottom_left().lat() + box.top_right().lat()) * 5e6) / 1e7;
    this->Longitude0 = std::round((box.bottom_left().lon() + box.top_right().lon()) * 5e6) / 1e7;
  }

  std::vector<CityPoint> operator()(const GeoLine& line) const
  {
    const double scale = CityEarthRadius * RadiansPerDegree / CityMetresPerUnit;
    const double shrink = std::cos(this->Latitude0 * RadiansPerDegree);
    std::vector<CityPoint> points;
    for (const osmium::Location& location : line)
    {
      CityPoint point;
      point.X = static_cast<std::int32_t>(
        std::lround(scale * shrink * (location.lon() - this->Longitude0)));
      point.Y = static_cast<std::int32_t>(std::lround(scale * (location.lat() - this->Latitude0)));
      if (points.empty() || points.back() != point)
      {
        points.push_back(point);
      }
    }
    return points;
  }

  double Latitude0 = 0.0;
  double Longitude0 = 0.0;
};

void AddBuildings(const std::vector<GeoBuilding>& buildings, const Projection& project, City& city,
  OsmImportCounts& counts)
{
  for (const GeoBuilding& source : buildings)
  {
    CityBuilding building;
    double area = 0.0;
    for (const GeoLine& line : source.Rings)
    {
      CityRing ring = project(line);
      if (ring.size() > 1 && ring.front() == ring.back())
      {
        ring.pop_back();
      }
      if (ring.size() < 3)
      {
        continue;
      }
      const double signedArea =
        0.5 * GetSignedDoubleArea(ring) * CityMetresPerUnit * CityMetresPerUnit;
      if (building.Rings.empty())
      {
        area = std::abs(signedArea);
      }
      if ((signedArea > 0.0) != building.Rings.empty())
      {
        std::reverse(ring.begin(), ring.end());
      }
      building.Rings.push_back(std::move(ring));
    }
    if (building.Rings.empty() || area < SmallestBuilding)
    {
      ++counts.TooSmall;
      continue;
    }
    building.Source = source.Source;
    const double height = source.Source == CityHeightSource::Synthetic
      ? GetSyntheticHeight(area, source.Id)
      : source.Height;
    building.Height = static_cast<std::int32_t>(std::lround(height / CityMetresPerUnit));
    city.Buildings.push_back(std::move(building));
  }
}

void AddStreets(const std::vector<GeoStreet>& streets, const Projection& project, City& city)
{
  for (const GeoStreet& source : streets)
  {
    CityStreet street;
    street.Points = project(source.Points);
    if (street.Points.size() < 2)
    {
      continue;
    }
    const auto kind = std::find(city.StreetKinds.begin(), city.StreetKinds.end(), source.Kind);
    street.Kind = static_cast<int>(kind - city.StreetKinds.begin());
    if (kind == city.StreetKinds.end())
    {
      city.StreetKinds.push_back(source.Kind);
    }
    city.Streets.push_back(std::move(street));
  }
}

void ReadInto(Handler& handler, const osmium::io::File& file, const OsmImportOptions& options)
{
  LocationIndex index;
  LocationHandler locations(index);
  locations.ignore_errors(); // Extracts lack nodes at their border; Handler counts them.

  using Manager = osmium::area::MultipolygonManager<osmium::area::Assembler>;
  osmium::area::Assembler::config_type assembly;
  osmium::TagsFilter filter{ false };
  filter.add_rule(true, "building");
  Manager manager(assembly, filter);
  if (options.Multipolygons)
  {
    handler.RememberRings = true;
    osmium::relations::read_relations(file, manager);
  }

  osmium::io::Reader reader(file, osmium::osm_entity_bits::node | osmium::osm_entity_bits::way);
  std::vector<osmium::memory::Buffer> areas;
  auto collect = manager.handler(
    [&areas](osmium::memory::Buffer&& buffer) { areas.push_back(std::move(buffer)); });
  while (osmium::memory::Buffer buffer = reader.read())
  {
    if (options.Multipolygons)
    {
      osmium::apply(buffer, locations, handler, collect);
    }
    else
    {
      osmium::apply(buffer, locations, handler);
    }
    if (options.Progress && reader.file_size() > 0)
    {
      options.Progress(
        static_cast<double>(reader.offset()) / static_cast<double>(reader.file_size()));
    }
  }
  reader.close();
  // Only now are all ways known that are buildings by themselves.
  for (const osmium::memory::Buffer& buffer : areas)
  {
    osmium::apply(buffer, handler);
  }
}
}

City ImportOsm(
  const std::string& fileName, const OsmImportOptions& options, OsmImportCounts* counts)
{
  OsmImportCounts unused;
  OsmImportCounts& c = counts ? *counts : unused;
  if (!std::filesystem::is_regular_file(fileName))
  {
    throw std::runtime_error("cannot open " + fileName + ": no such file");
  }
  Handler handler(c);
  try
  {
    ReadInto(handler, osmium::io::File(fileName), options);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("cannot read " + fileName + " as OSM data: " + error.what());
  }
  if (handler.Buildings.empty())
  {
    throw std::runtime_error(fileName + " holds no closed way with the tag \"building\"");
  }
  const Projection project(handler.Buildings);
  City city;
  city.Latitude0 = project.Latitude0;
  city.Longitude0 = project.Longitude0;
  city.Attribution = "(c) OpenStreetMap contributors, Open Database License (ODbL) 1.0";
  AddBuildings(handler.Buildings, project, city, c);
  AddStreets(handler.Streets, project, city);
  return city;
}

} // namespace NBufferExamples
