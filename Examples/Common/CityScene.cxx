// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CityScene.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkContourTriangulator.h"
#include "vtkIdList.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkRibbonFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace NBufferExamples
{
using Actors = std::vector<vtkSmartPointer<vtkActor>>;

namespace
{
constexpr double Foundation = -0.5;    // metres
constexpr double PathLevel = 0.05;     // metres above the ground, so that nothing shares a plane
constexpr double CarriageLevel = 0.10; // metres
constexpr double TileSize = 1000.0;    // metres, of the streets that make one actor

double ToMetres(std::int32_t centimetres)
{
  return CityMetresPerUnit * centimetres;
}

/// A ring that crosses itself, which vtkContourTriangulator refuses: triangles that overlap are
/// better than a missing building.
void FillCrossedRing(vtkPoints* points, std::size_t count, vtkCellArray* triangles)
{
  vtkNew<vtkPolygon> polygon;
  polygon->GetPoints()->ShallowCopy(points);
  polygon->GetPointIds()->SetNumberOfIds(static_cast<vtkIdType>(count));
  std::iota(polygon->GetPointIds()->begin(), polygon->GetPointIds()->end(), 0);
  vtkNew<vtkIdList> corners;
  if (polygon->EarCutTriangulation(corners))
  {
    for (vtkIdType i = 0; i + 2 < corners->GetNumberOfIds(); i += 3)
    {
      triangles->InsertNextCell(3, corners->GetPointer(i));
    }
  }
}

/// The triangles of the plan, counterclockwise, as indices into the rings' points one after
/// another. Empty when the rings cannot be filled.
vtkSmartPointer<vtkCellArray> FillPlan(const CityBuilding& building)
{
  vtkNew<vtkPolyData> plan;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> loops;
  vtkNew<vtkIdList> polygon;
  points->SetDataTypeToDouble();
  for (const CityRing& ring : building.Rings)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    loops->InsertNextCell(static_cast<int>(ring.size()) + 1);
    for (const CityPoint& point : ring)
    {
      const vtkIdType id = points->InsertNextPoint(ToMetres(point.X), ToMetres(point.Y), 0.0);
      loops->InsertCellPoint(id);
      polygon->InsertNextId(id);
    }
    loops->InsertCellPoint(first);
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  bool filled = false;
  if (building.Rings.size() == 1)
  {
    filled = vtkContourTriangulator::TriangulatePolygon(polygon, points, triangles) != 0;
  }
  else
  {
    plan->SetPoints(points);
    plan->SetLines(loops);
    const double up[3] = { 0.0, 0.0, 1.0 };
    filled = vtkContourTriangulator::TriangulateContours(
               plan, 0, loops->GetNumberOfCells(), triangles, up) != 0;
  }
  if (!filled)
  {
    triangles->Initialize();
    FillCrossedRing(points, building.Rings.front().size(), triangles);
  }
  return triangles;
}

/// The walls of one ring whose corners at the foundation begin with the point `first`, and whose
/// corners at the roof lie `roof` points later.
void AddWalls(vtkIdType first, vtkIdType count, vtkIdType roof, vtkCellArray* polys)
{
  for (vtkIdType i = 0, j = count - 1; i < count; j = i++)
  {
    const vtkIdType quad[4] = { first + j, first + i, first + i + roof, first + j + roof };
    polys->InsertNextCell(4, quad);
  }
}

/// The plan as roof or, turned over, as floor.
void AddPlan(vtkCellArray* triangles, vtkIdType first, bool up, vtkCellArray* polys)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (triangles->InitTraversal(); triangles->GetNextCell(count, ids);)
  {
    const vtkIdType triangle[3] = { first + ids[0], first + ids[up ? 1 : 2],
      first + ids[up ? 2 : 1] };
    polys->InsertNextCell(3, triangle);
  }
}

/// Without light an actor has its colour as it is: for what is level anyway.
vtkSmartPointer<vtkActor> MakePaintedActor(vtkPolyData* data, const double color[3], bool isLit)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.56);
  actor->GetProperty()->SetDiffuse(0.54);
  actor->GetProperty()->SetLighting(isLit);
  return actor;
}

/// Plaster, brick and concrete; which building gets which follows from its place.
const std::array<double, 3>& GetBuildingColor(const CityBuilding& building)
{
  static const std::array<std::array<double, 3>, 10> colors = { { { 0.93, 0.90, 0.83 },
    { 0.88, 0.83, 0.72 }, { 0.91, 0.86, 0.66 }, { 0.85, 0.76, 0.64 }, { 0.80, 0.80, 0.78 },
    { 0.94, 0.93, 0.90 }, { 0.76, 0.66, 0.56 }, { 0.83, 0.79, 0.80 }, { 0.72, 0.74, 0.74 },
    { 0.89, 0.78, 0.62 } } };
  const CityPoint& corner = building.Rings.front().front();
  const auto mixed = static_cast<std::uint32_t>(corner.X) * 2654435761u ^
    static_cast<std::uint32_t>(corner.Y) * 2246822519u;
  return colors[(mixed >> 16) % colors.size()];
}

vtkSmartPointer<vtkActor> MakeGround(const City& city)
{
  std::int32_t reach = 0;
  for (const CityBuilding& building : city.Buildings)
  {
    for (const CityPoint& point : building.Rings.front())
    {
      reach = std::max({ reach, std::abs(point.X), std::abs(point.Y) });
    }
  }
  const double side = 1.5 * ToMetres(reach) + 1000.0;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-side, -side, 0.0);
  plane->SetPoint1(side, -side, 0.0);
  plane->SetPoint2(-side, side, 0.0);
  plane->Update();
  const double color[3] = { 0.50, 0.57, 0.42 };
  return MakePaintedActor(plane->GetOutput(), color, false);
}

/// Streets of one width inside one tile, as lines.
using TileKey = std::pair<std::int32_t, std::int32_t>;
using LinesByWidth = std::map<double, vtkSmartPointer<vtkPolyData>>;

void AddLine(const CityStreet& street, double level, vtkSmartPointer<vtkPolyData>& lines)
{
  if (!lines)
  {
    lines = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    lines->SetPoints(points);
    lines->SetLines(cells);
  }
  lines->GetLines()->InsertNextCell(static_cast<int>(street.Points.size()));
  for (const CityPoint& point : street.Points)
  {
    lines->GetLines()->InsertCellPoint(
      lines->GetPoints()->InsertNextPoint(ToMetres(point.X), ToMetres(point.Y), level));
  }
}

vtkSmartPointer<vtkPolyData> MakeRibbons(const LinesByWidth& linesByWidth)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& [width, lines] : linesByWidth)
  {
    vtkNew<vtkRibbonFilter> ribbon;
    ribbon->SetInputData(lines);
    ribbon->SetWidth(0.5 * width);
    ribbon->UseDefaultNormalOn();
    ribbon->SetDefaultNormal(0.0, 0.0, 1.0);
    append->AddInputConnection(ribbon->GetOutputPort());
  }
  append->Update();
  // The mapper shades faces flat where there are no normals, as it does for buildings.
  append->GetOutput()->GetPointData()->Initialize();
  return append->GetOutput();
}

/// The width of a street in metres.
double GetStreetWidth(const std::string& kind)
{
  static const std::map<std::string, double> widths = { { "motorway", 14.0 }, { "trunk", 12.0 },
    { "primary", 11.0 }, { "secondary", 9.0 }, { "tertiary", 8.0 }, { "residential", 6.5 },
    { "living_street", 6.0 }, { "unclassified", 6.0 }, { "road", 6.0 }, { "pedestrian", 6.0 },
    { "service", 4.0 }, { "track", 3.0 }, { "cycleway", 2.5 }, { "footway", 2.0 }, { "path", 1.8 },
    { "steps", 2.0 } };
  const auto found = widths.find(kind);
  return found == widths.end() ? 6.0 : found->second; // The rest: links.
}

/// Whether cars drive on a street; otherwise it is a path for feet and bicycles.
bool IsCarriageway(const std::string& kind)
{
  static const std::set<std::string> paths = { "pedestrian", "track", "cycleway", "footway", "path",
    "steps", "bridleway" };
  return paths.count(kind) == 0;
}

/// All streets of one sort as flat ribbons, one actor per tile of the plan.
void AddStreets(const City& city, bool carriageways, const double color[3], Actors& actors)
{
  std::map<TileKey, LinesByWidth> tiles;
  for (const CityStreet& street : city.Streets)
  {
    const std::string& kind = city.StreetKinds[static_cast<std::size_t>(street.Kind)];
    if (IsCarriageway(kind) == carriageways)
    {
      const CityPoint& middle = street.Points[street.Points.size() / 2];
      const auto tile = [](std::int32_t centimetres)
      { return static_cast<std::int32_t>(std::floor(ToMetres(centimetres) / TileSize)); };
      AddLine(street, carriageways ? CarriageLevel : PathLevel,
        tiles[{ tile(middle.X), tile(middle.Y) }][GetStreetWidth(kind)]);
    }
  }
  for (const auto& tile : tiles)
  {
    actors.push_back(MakePaintedActor(MakeRibbons(tile.second), color, false));
  }
}
}

vtkSmartPointer<vtkPolyData> MakeBuilding(const CityBuilding& building)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const vtkSmartPointer<vtkCellArray> plan = FillPlan(building);
  if (plan->GetNumberOfCells() == 0)
  {
    return data;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (const double z : { Foundation, ToMetres(building.Height) })
  {
    for (const CityRing& ring : building.Rings)
    {
      for (const CityPoint& point : ring)
      {
        points->InsertNextPoint(ToMetres(point.X), ToMetres(point.Y), z);
      }
    }
  }
  const vtkIdType roof = points->GetNumberOfPoints() / 2;
  vtkIdType first = 0;
  for (const CityRing& ring : building.Rings)
  {
    AddWalls(first, static_cast<vtkIdType>(ring.size()), roof, polys);
    first += static_cast<vtkIdType>(ring.size());
  }
  AddPlan(plan, 0, false, polys);
  AddPlan(plan, roof, true, polys);
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

Actors MakeCityActors(const City& city)
{
  Actors actors;
  for (const CityBuilding& building : city.Buildings)
  {
    actors.push_back(
      MakePaintedActor(MakeBuilding(building), GetBuildingColor(building).data(), true));
  }
  const double asphalt[3] = { 0.47, 0.48, 0.50 };
  const double gravel[3] = { 0.68, 0.64, 0.56 };
  actors.push_back(MakeGround(city));
  AddStreets(city, true, asphalt, actors);
  AddStreets(city, false, gravel, actors);
  return actors;
}

void LightCity(vtkRenderer* renderer)
{
  // One light that goes with the camera, over its left shoulder: whatever way one looks, fronts,
  // sides and roofs differ, and one light costs a software renderer least.
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->PositionalOff();
  light->SetPosition(-0.42, 0.75, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetColor(1.0, 0.98, 0.94);
  renderer->RemoveAllLights();
  renderer->AddLight(light);
  // One colour: a gradient makes VTK look through the buffers of all props in every frame.
  renderer->SetBackground(0.66, 0.79, 0.92);
}

} // namespace NBufferExamples
