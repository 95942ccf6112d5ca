// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadScene.h"

#include "CityFile.h"
#include "CityScene.h"
#include "FileFormats.h"
#include "SceneKinds.h"

#include <vtksys/SystemTools.hxx>

#include <filesystem>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
namespace fs = std::filesystem;

Scene MakeCityScene(City city, const std::string& name, const SceneOptions& options)
{
  options.Progress("building " + std::to_string(city.Buildings.size()) + " actors");
  Scene scene;
  scene.Name = name;
  scene.Actors = MakeCityActors(city);
  scene.Plan = std::make_shared<const City>(std::move(city));
  return scene;
}

constexpr int UsualPoints = 1000000;
constexpr int UsualInstances = 200000;

bool HasPoints(const std::string& name)
{
  return name == "points-wall" || name == "points-terrain";
}

bool HasInstances(const std::string& name)
{
  return name == "glyph-wall" || name == "glyph-cloud" || name == "glyph-open";
}
}

std::string FindData(const std::string& program, const std::string& name)
{
  std::string found = program;
  std::string error;
  vtksys::SystemTools::FindProgramPath(program.c_str(), found, error);
  const fs::path folder = fs::path(found).parent_path();
  for (const fs::path& candidate :
    { folder / NBUFFER_DATA_FROM_BIN / name, fs::path(NBUFFER_DATA_IN_SOURCE) / name })
  {
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored))
    {
      return candidate.lexically_normal().string();
    }
  }
  return std::string();
}

Scene LoadScene(const std::vector<std::string>& names, const SceneOptions& options)
{
  if (names.empty())
  {
    throw std::runtime_error("no scene is named");
  }
  const std::string& name = names.front();
  if (options.Points > 0 && !HasPoints(name))
  {
    throw std::runtime_error("the number of points can be chosen in the scenes points-wall and "
                             "points-terrain, not in " +
      name);
  }
  if (options.Instances > 0 && !HasInstances(name))
  {
    throw std::runtime_error("the number of instances can be chosen in the scenes glyph-wall, "
                             "glyph-cloud and glyph-open, not in " +
      name);
  }
  const int points = options.Points > 0 ? options.Points : UsualPoints;
  const int instances = options.Instances > 0 ? options.Instances : UsualInstances;
  options.Progress("reading " + name);
  Scene scene;
  if (name == "city")
  {
    const std::string file = FindData(options.Program, "neubrandenburg.city");
    if (file.empty())
    {
      throw std::runtime_error(
        "neubrandenburg.city is neither installed nor in the source tree; name a city file");
    }
    scene = MakeCityScene(ReadCity(file), name, options);
  }
  else if (name == "plant")
  {
    scene = MakePlant(options.Seed);
  }
  else if (name == "isosurface")
  {
    scene = MakeIsosurface();
  }
  else if (name == "terrain" || name == "points-terrain")
  {
    scene = MakeTerrain(HasPoints(name) ? points : 0);
  }
  else if (name == "points-wall")
  {
    scene = MakePointsBehindWall(points);
  }
  else if (HasInstances(name))
  {
    scene = MakeGlyphs(name, instances);
  }
  else if (name == "shells" || name == "leaves")
  {
    scene = name == "shells" ? MakeSpheresInSpheres() : MakeForest();
  }
  else if (IsKicadName(name))
  {
    scene = LoadKicad(name, options.Progress);
  }
  else if (IsBspName(name))
  {
    scene = LoadBsp(name);
  }
  else if (!fs::exists(name))
  {
    throw std::runtime_error("there is no file " + name +
      "; the scenes without a file are city, plant, isosurface, terrain, points-wall, "
      "points-terrain, glyph-wall, glyph-cloud, glyph-open, shells and leaves");
  }
  else if (IsCityFile(name))
  {
    scene = MakeCityScene(ReadCity(name), fs::path(name).filename().string(), options);
  }
  else
  {
    return ImportFiles(names, options.SplitRegions, options.Progress);
  }
  if (names.size() > 1)
  {
    throw std::runtime_error(name +
      " is a scene by itself; only files of these endings go together: " + ListEndings(true));
  }
  return scene;
}

} // namespace NBufferExamples
