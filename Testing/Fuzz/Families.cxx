// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "NamedScenarios.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace TestScene
{
namespace
{
int GetProps(Writer& writer)
{
  return writer.Integer(24, writer.Chance(0.1) ? 150 : 60);
}

//------------------------------------------------------------------------------------------------
/// A wall, whole or with holes, boxes behind it and some before it.
void BuildWall(Writer& writer)
{
  const double width = 10.0;
  const ShapeKind kind = writer.Any({ ShapeKind::Box, ShapeKind::Box, ShapeKind::Quad,
    ShapeKind::Lattice, ShapeKind::Grating, ShapeKind::Terrain, ShapeKind::Sphere });
  Prop& wall = writer.Add(kind, { 0.0, 0.0, 0.0 }, { 9.0, 7.0, 0.5 });
  wall.Shape.Fill = writer.Between(0.5, 1.0);
  writer.Occluders.push_back(wall.Id);
  if (writer.Chance(0.3))
  {
    writer.Occluders.push_back(writer.Box({ 1.0, 0.0, 2.0 }, { 3.0, 9.0, 0.1 }).Id);
  }
  const int count = GetProps(writer);
  for (int i = 0; i < count; ++i)
  {
    const bool behind = writer.Chance(0.8);
    const glm::dvec3 center = { writer.Between(-5.0, 5.0), writer.Between(-4.0, 4.0),
      behind ? writer.Between(-8.0, -0.8) : writer.Between(0.8, 6.0) };
    const double size = std::pow(10.0, writer.Between(-1.5, behind ? 0.3 : -0.3));
    writer.Add(writer.Chance(0.7) ? ShapeKind::Box
                                  : writer.Any({ ShapeKind::Sphere, ShapeKind::Quad,
                                      ShapeKind::Terrain, ShapeKind::Soup, ShapeKind::Lines }),
      center, { size, size * writer.Between(0.3, 2.0), size * writer.Between(0.1, 1.5) });
  }
  writer.AddViewsFromFront(width);
}

/// An occluder whose borders lie at chosen places between pixels, and small boxes behind it that
/// stick out of it by fractions of a pixel up to two.
void BuildPeeking(Writer& writer)
{
  const Window& window = writer.Scene.Window;
  const bool parallel = writer.Chance(0.6);
  const double angle = vtkMath::RadiansFromDegrees(30.0);
  // World units of a pixel at z = 0 and at z = -depth.
  const double pixel = writer.Any({ 0.1, 0.125 });
  const double distance = 0.5 * pixel * window.Height / std::tan(0.5 * angle);
  const auto getPixel = [&](double z)
  { return parallel ? pixel : pixel * (distance - z) / distance; };

  const double left = -0.5 * window.Width + writer.Integer(3, 12) + writer.Any({ 0.0, 0.25, 0.5 });
  const double right = 0.5 * window.Width - writer.Integer(3, 12) + writer.Any({ 0.0, 0.25, 0.5 });
  const double low = -0.5 * window.Height + writer.Integer(3, 12) + writer.Any({ 0.0, 0.25, 0.5 });
  const double high = 0.5 * window.Height - writer.Integer(3, 12) + writer.Any({ 0.0, 0.25, 0.5 });
  // The window is larger than that, unless it is tiny.
  Prop& wall = writer.Add(writer.Any({ ShapeKind::Quad, ShapeKind::Box }),
    { 0.5 * (left + right) * pixel, 0.5 * (low + high) * pixel, -0.05 },
    { (right - left) * pixel, (high - low) * pixel, 0.1 });
  wall.Shape.Center[2] = wall.Shape.Kind == ShapeKind::Quad ? 0.0 : -0.05;
  const int count = GetProps(writer);
  for (int i = 0; i < count; ++i)
  {
    const double z = -writer.Between(0.2, 4.0);
    const double unit = getPixel(z);
    const double out = writer.Any({ -1.0, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.5, 2.0 }) +
      writer.Any({ 0.0, 0.0, 0.01, -0.01 });
    const double width = writer.Between(1.0, 14.0);
    const double height = writer.Between(1.0, 14.0);
    double x = writer.Between(left + width, right - width);
    double y = writer.Between(low + height, high - height);
    switch (writer.Integer(0, 3))
    {
      case 0:
        x = right + out - 0.5 * width;
        break;
      case 1:
        x = left - out + 0.5 * width;
        break;
      case 2:
        y = high + out - 0.5 * height;
        break;
      default:
        y = low - out + 0.5 * height;
        break;
    }
    const double depth = writer.Chance(0.5) ? 0.0 : writer.Between(0.1, 1.0) * unit;
    writer.Add(depth == 0.0 ? ShapeKind::Quad : ShapeKind::Box,
      { x * unit, y * unit, z - 0.5 * depth }, { width * unit, height * unit, depth });
  }
  View first;
  first.Parallel = parallel;
  first.ParallelScale = 0.5 * pixel * window.Height;
  first.Position = { 0.0, 0.0, distance };
  writer.Scale = pixel * window.Width;
  writer.Scene.Views.push_back(first);
  for (int frame = 1; frame < writer.Scene.Frames; ++frame)
  {
    if (writer.Chance(0.7))
    {
      // By parts of a pixel; now and then away, so that all are seen in between.
      const double step = writer.Chance(0.2) ? 60.0 : writer.Any({ 0.0, 0.25, 0.5, 1.0 });
      View& view = writer.AddView(frame);
      view.Position = { step * pixel, writer.Any({ 0.0, 0.25, -0.5 }) * pixel, distance };
      view.FocalPoint = { view.Position[0], view.Position[1], 0.0 };
    }
  }
}

/// Quads and boxes that share planes exactly, and doors before them.
void BuildCoplanar(Writer& writer)
{
  const double width = 10.0;
  const bool large = writer.Chance(0.5);
  const int count = GetProps(writer);
  const int axis = writer.Integer(0, 2);
  const double plane = writer.Any({ 0.0, 0.3, 1.0 / 3.0 });
  for (int i = 0; i < count; ++i)
  {
    const double side = large ? writer.Between(1.0, 4.0) : 1.0;
    glm::dvec3 center = { writer.Between(-4.0, 4.0), writer.Between(-3.0, 3.0), 0.0 };
    if (!large)
    {
      center = { std::round(center[0]), std::round(center[1]), 0.0 };
    }
    center[2] = plane - 0.5 * writer.Integer(0, 2);
    const bool flush = writer.Chance(0.3);
    const double thickness = flush ? 0.5 : 0.0;
    // A box ends in the plane in which others lie.
    center[2] -= 0.5 * thickness;
    Prop& prop = writer.Add(ShapeKind::Box, center, { side, side, thickness });
    prop.Lighting = writer.Chance(0.2);
    if (writer.Chance(0.5))
    {
      // The same place by way of the actor's matrix.
      prop.Position = prop.Shape.Center;
      prop.Shape.Center = { 0.0, 0.0, 0.0 };
    }
    if (writer.Chance(0.4))
    {
      prop.From = writer.Integer(0, writer.Scene.Frames - 1);
    }
  }
  for (int i = writer.Integer(0, 2); i > 0; --i)
  {
    Prop& door =
      writer.Box({ writer.Between(-2.0, 2.0), 0.0, 3.0 }, { writer.Between(2.0, 6.0), 8.0, 0.2 });
    writer.Occluders.push_back(door.Id);
  }
  writer.AddViewsFromFront(width);
  if (axis == 0)
  {
    // Askew: equal planes, but depths that are rounded along slopes.
    for (View& view : writer.Scene.Views)
    {
      view.Position[0] += 0.9 * Writer::Distance;
      view.Position[1] += 0.3 * Writer::Distance;
    }
  }
}

/// Plates that face the camera, and decals inside of them at exactly their depth, which is the
/// depth of the decals' boxes as well: nothing but the tolerance keeps them from being hidden.
void BuildDecals(Writer& writer)
{
  const int plates = writer.Integer(2, 6);
  for (int i = 0; i < plates; ++i)
  {
    const double z = writer.Between(-6.0, 4.0);
    const double width = writer.Between(3.0, 9.0);
    const double height = writer.Between(3.0, 7.0);
    const double x = writer.Between(-3.0, 3.0);
    const double y = writer.Between(-2.0, 2.0);
    const double thickness = writer.Any({ 0.0, 0.0, 0.4 });
    const bool inMatrix = writer.Chance(0.5);
    Prop& plate = writer.Box({ x, y, z - 0.5 * thickness }, { width, height, thickness });
    plate.Lighting = false;
    const int decals = writer.Integer(6, 20);
    for (int j = 0; j < decals; ++j)
    {
      const double size = writer.Between(0.05, 0.25);
      const glm::dvec3 center = { x + writer.Between(-0.3, 0.3) * width,
        y + writer.Between(-0.3, 0.3) * height, z };
      Prop& decal = writer.Box(
        inMatrix ? glm::dvec3{ 0.0, 0.0, 0.0 } : center, { size * width, size * height, 0.0 });
      decal.Lighting = false;
      if (inMatrix)
      {
        decal.Position = center;
      }
      if (writer.Chance(0.3))
      {
        decal.From = writer.Integer(0, writer.Scene.Frames - 1);
      }
    }
  }
  if (writer.Chance(0.5))
  {
    writer.Occluders.push_back(writer.Box({ 0.0, 0.0, 5.0 }, { 6.0, 8.0, 0.2 }).Id);
  }
  writer.AddViewsFromFront(10.0);
  for (View& view : writer.Scene.Views)
  {
    // Straight on.
    view.FocalPoint = { view.Position[0], view.Position[1], 0.0 };
    if (writer.Chance(0.1))
    {
      view.Near = 0.1;
      view.Far = 1000.0;
    }
  }
}

/// Gratings with gaps of about a pixel and less.
void BuildSlits(Writer& writer)
{
  const double width = 10.0;
  const int gratings = writer.Integer(1, 3);
  for (int i = 0; i < gratings; ++i)
  {
    Prop& grating = writer.Add(ShapeKind::Grating, { 0.0, 0.0, 0.3 * i }, { 11.0, 11.0, 0.0 });
    grating.Shape.Detail = writer.Integer(8, 60);
    const double barWidth = 11.0 / grating.Shape.Detail;
    const double pixel = width / writer.Scene.Window.Height;
    grating.Shape.Fill = 1.0 - std::min(0.9, writer.Between(0.05, 1.5) * pixel / barWidth);
    if (writer.Chance(0.4))
    {
      grating.Orientation[2] = writer.Any({ 90.0, 3.0, 45.0 });
    }
    writer.Occluders.push_back(grating.Id);
  }
  const int count = GetProps(writer);
  for (int i = 0; i < count; ++i)
  {
    const double size = writer.Between(0.05, 0.8);
    writer.Add(writer.Any({ ShapeKind::Box, ShapeKind::Quad, ShapeKind::Sphere }),
      { writer.Between(-5.0, 5.0), writer.Between(-4.0, 4.0), writer.Between(-5.0, -0.5) },
      { size, size, writer.Between(0.05, 0.5) });
  }
  writer.AddViewsFromFront(width);
}

/// Meshes that are drawn unit by unit, of quads with equal depths, behind doors that move: units
/// come into view late and must not win over those that come later in their mesh.
void BuildScraps(Writer& writer)
{
  const double width = 10.0;
  writer.Scene.Culler.MinimumNumberOfPrimitives = 2;
  const int meshes = writer.Integer(1, 3);
  for (int i = 0; i < meshes; ++i)
  {
    const double z = writer.Any({ 0.0, -1.0, -1.0, writer.Between(-3.0, 0.0) });
    Prop& mesh =
      writer.Add(ShapeKind::Scraps, { writer.Between(-1.0, 1.0), writer.Between(-1.0, 1.0), z },
        { writer.Between(5.0, 9.0), writer.Between(5.0, 9.0), writer.Any({ 0.0, 1.0, 2.0 }) });
    mesh.Shape.Detail = writer.Integer(10, 64);
    mesh.Shape.Seed = writer.Integer(0, 1000);
    // What follows takes no more random numbers: the rest of a scenario stays what it was.
    mesh.Edges = mesh.Shape.Seed % 5 == 0;
    mesh.LineWidth = mesh.Edges ? 2.0 : mesh.LineWidth;
    if (mesh.Shape.Seed % 4 == 2)
    {
      mesh.Shape.Kind = ShapeKind::Ribbons;
    }
    const int kind = mesh.Shape.Seed % 16;
    if (kind % 4 == 0 || kind == 5)
    {
      mesh.Kind = PropKind::Glyphs;
      mesh.Opacity = mesh.Shape.Seed % 3 == 1 ? 0.5 : 1.0;
      mesh.Shape.Detail = std::min(mesh.Shape.Detail, 24);
    }
    if (kind % 4 == 1 && kind != 5)
    {
      mesh.Kind = PropKind::Splats;
      mesh.PointSize = 9.0 + mesh.Shape.Seed % 41;
    }
    else
    {
      // Of splats, VTK would read the color of each point from the fewer colors of cells.
      mesh.Shape.CellValues = mesh.Shape.Seed % 3 == 0;
    }
  }
  const int doors = writer.Integer(1, 3);
  for (int i = 0; i < doors; ++i)
  {
    const int door = writer
                       .Box({ writer.Between(-3.0, 3.0), writer.Between(-2.0, 2.0), 2.0 + i },
                         { writer.Between(2.0, 5.0), writer.Between(3.0, 8.0), 0.2 })
                       .Id;
    writer.Occluders.push_back(door);
    for (int frame = 1; frame < writer.Scene.Frames; ++frame)
    {
      writer.AddChange(frame, ChangeKind::Position, door,
        { writer.Between(-4.0, 4.0), writer.Between(-2.0, 2.0), 0.0 });
    }
  }
  writer.AddViewsFromFront(width);
}

/// Many props smaller than a pixel, lines and points of some pixels among them.
void BuildSpecks(Writer& writer)
{
  const double width = 10.0;
  const int walls = writer.Integer(1, 4);
  for (int i = 0; i < walls; ++i)
  {
    Prop& wall = writer.Box({ writer.Between(-3.0, 3.0), writer.Between(-3.0, 3.0), 0.1 * i },
      { writer.Between(2.0, 6.0), writer.Between(2.0, 6.0), 0.05 });
    writer.Occluders.push_back(wall.Id);
  }
  const int count = writer.Integer(60, 180);
  for (int i = 0; i < count; ++i)
  {
    const ShapeKind kind = writer.Chance(0.6)
      ? ShapeKind::Box
      : writer.Any({ ShapeKind::Points, ShapeKind::Lines, ShapeKind::Quad });
    const double size = std::pow(10.0, writer.Between(-3.0, -0.6));
    Prop& prop = writer.Add(kind,
      { writer.Between(-5.0, 5.0), writer.Between(-4.5, 4.5), writer.Between(-3.0, -0.01) },
      { size, size, size });
    prop.Shape.Detail = std::min(prop.Shape.Detail, 3);
    if (kind == ShapeKind::Points || kind == ShapeKind::Lines)
    {
      prop.LineWidth = prop.PointSize = writer.Any({ 1.0, 2.0, 5.0, 9.0 });
      prop.Kind = kind == ShapeKind::Points && i % 2 ? PropKind::Splats : prop.Kind;
    }
  }
  writer.AddViewsFromFront(width);
}

/// The eye among boxes, some of which it is inside of; a floor under it, explicit near planes.
void BuildNear(Writer& writer)
{
  const int count = GetProps(writer);
  writer.Box({ 0.0, 0.0, -1.2 }, { 40.0, 40.0, 0.4 });
  if (writer.Chance(0.3))
  {
    writer.Box({ 0.0, 0.0, 0.0 }, { 60.0, 60.0, 60.0 });
  }
  for (int i = 0; i < count; ++i)
  {
    const double size = std::pow(10.0, writer.Between(-0.7, 0.8));
    Prop& prop = writer.Box(
      { writer.Between(-10.0, 10.0), writer.Between(-10.0, 10.0), writer.Between(-1.0, 2.0) },
      { size, size * writer.Between(0.05, 1.0), size * writer.Between(0.1, 1.0) });
    if (size > 2.0)
    {
      writer.Occluders.push_back(prop.Id);
    }
  }
  writer.Scale = 10.0;
  const bool cuts = writer.Chance(0.4);
  View first;
  first.ViewUp = { 0.0, 0.0, 1.0 };
  first.ViewAngle = writer.Any({ 30.0, 60.0, 100.0 });
  first.Position = { writer.Between(-8.0, 8.0), writer.Between(-8.0, 8.0), 0.2 };
  if (writer.Chance(0.7))
  {
    first.Near = writer.Any({ 1e-3, 0.01, 0.1, 1.0 });
    first.Far = first.Near * writer.Any({ 1e3, 1e5, 1e7 });
    first.Far = std::max(first.Far, 30.0);
  }
  double heading = writer.Between(0.0, 6.3);
  first.FocalPoint = { first.Position[0] + std::cos(heading), first.Position[1] + std::sin(heading),
    first.Position[2] };
  writer.Scene.Views.push_back(first);
  for (int frame = 1; frame < writer.Scene.Frames; ++frame)
  {
    View& view = writer.AddView(frame);
    heading += cuts ? writer.Between(0.0, 6.3) : writer.Between(-0.3, 0.3);
    view.Position[0] += writer.Between(-0.6, 0.6);
    view.Position[1] += writer.Between(-0.6, 0.6);
    view.FocalPoint = { view.Position[0] + std::cos(heading), view.Position[1] + std::sin(heading),
      view.Position[2] + writer.Between(-0.3, 0.3) };
  }
}

/// Blocks along streets.
void BuildCity(Writer& writer)
{
  const int side = writer.Integer(5, 9);
  const double extent = 12.0 * side;
  writer.Box({ 0.5 * extent, 0.5 * extent, -0.5 }, { 1.2 * extent, 1.2 * extent, 1.0 });
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const double height = writer.Between(3.0, 17.0);
      const double width = writer.Chance(0.3) ? 12.0 : 8.0;
      writer.Occluders.push_back(
        writer.Box({ 12.0 * i + 6.0, 12.0 * j + 6.0, 0.5 * height }, { width, 8.0, height }).Id);
    }
  }
  writer.Scale = 30.0;
  View view;
  view.ViewUp = { 0.0, 0.0, 1.0 };
  view.ViewAngle = 60.0;
  double heading = 0.5 * vtkMath::Pi() + writer.Between(-0.5, 0.5);
  view.Position = { 12.0 * writer.Integer(1, side - 1) + writer.Between(-1.0, 1.0),
    writer.Between(0.0, 12.0), writer.Any({ 1.7, 6.0, 12.0 }) };
  const bool jumps = writer.Chance(0.3);
  for (int frame = 0; frame < writer.Scene.Frames; ++frame)
  {
    heading += jumps ? writer.Any({ 0.0, 0.5, 3.1 }) : writer.Between(-0.2, 0.2);
    view.Frame = frame;
    view.Position[1] += writer.Between(0.0, 3.0);
    view.FocalPoint = { view.Position[0] + std::cos(heading), view.Position[1] + std::sin(heading),
      view.Position[2] };
    writer.Scene.Views.push_back(view);
  }
}

/// Long props that recede, and others along them.
void BuildLong(Writer& writer)
{
  writer.Occluders.push_back(writer.Box({ -1.0, 0.0, -20.0 }, { 0.1, 6.0, 50.0 }).Id);
  const int count = GetProps(writer);
  for (int i = 0; i < count; ++i)
  {
    const double length = writer.Between(1.0, 44.0);
    const double y = writer.Between(-3.2, 3.2);
    writer.Box({ -1.1 - writer.Between(0.0, 2.0), y, -20.0 + writer.Between(-20.0, 20.0) },
      { writer.Between(0.01, 0.3), writer.Between(0.01, 0.3), length });
  }
  writer.Scale = 6.0;
  View view;
  view.ViewAngle = 60.0;
  for (int frame = 0; frame < writer.Scene.Frames; ++frame)
  {
    view.Frame = frame;
    view.Position = { writer.Between(-0.8, 1.5), writer.Between(-2.0, 2.0), 4.0 };
    view.FocalPoint = { -0.5, 0.0, -20.0 };
    writer.Scene.Views.push_back(view);
  }
}
}

void ShareMappers(Writer& writer)
{
  std::vector<Prop>& props = writer.Scene.Props;
  if (!writer.Chance(0.06))
  {
    return;
  }
  for (std::size_t i = 1; i < props.size(); ++i)
  {
    const Prop& owner = props[writer.Random.Index(i)];
    if (writer.Chance(0.3) && owner.Renderer == props[i].Renderer && owner.MapperOf < 0)
    {
      props[i].MapperOf = owner.Id;
      props[i].Representation =
        writer.Any({ Representation::Surface, Representation::Surface, Representation::Wireframe });
    }
  }
}

void ReversePoints(Writer& writer)
{
  const Scenario& scene = writer.Scene;
  if (scene.Culler.MinimumNumberOfPrimitives > 6 || scene.Frames < 3 || !writer.Chance(0.3))
  {
    return;
  }
  const int frame = writer.Integer(2, scene.Frames - 1);
  for (const Prop& prop : scene.Props)
  {
    const glm::dvec3& size = prop.Shape.Size;
    writer.AddChange(frame, ChangeKind::ReplaceData, prop.Id, { size.x, size.y, size.z, 1.0 });
  }
}

void NestAssemblies(Writer& writer)
{
  std::vector<Prop>& props = writer.Scene.Props;
  for (std::size_t i = 1; i < props.size(); ++i)
  {
    const Prop& whole = props[i - 1];
    const bool canBePart = props[i].Kind == PropKind::Actor || props[i].Kind == PropKind::Assembly;
    if (whole.Kind == PropKind::Assembly && canBePart && writer.Chance(0.5))
    {
      props[i].PartOf = whole.Id;
    }
  }
}

void BuildNamed(Writer& writer, bool shadows)
{
  static const std::vector<NamedScenario> ofCulling = GetCullingHazards();
  static const std::vector<NamedScenario> ofShadows = []
  {
    std::vector<NamedScenario> result = GetLightScenarios();
    for (const auto& more : { GetViewScenarios(), GetMeshScenarios() })
    {
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }();
  const std::vector<NamedScenario>& all = shadows ? ofShadows : ofCulling;
  const NamedScenario& named = all[writer.Random.Index(all.size())];
  writer.Scene.Family = "named " + named.Name;
  writer.Scene.Props = named.Scenario.Props;
  writer.Scene.Views = named.Scenario.Views;
  writer.Scene.Changes = named.Scenario.Changes;
  writer.Scene.Lights = named.Scenario.Lights;
  writer.Occluders = { named.Scenario.Props.front().Id };
}

const std::vector<NamedFamily>& GetFamilies()
{
  static const std::vector<NamedFamily> families = { { "wall", 3.0, BuildWall },
    { "peeking", 3.0, BuildPeeking }, { "coplanar", 2.0, BuildCoplanar },
    { "decals", 2.0, BuildDecals }, { "slits", 2.0, BuildSlits }, { "specks", 1.0, BuildSpecks },
    { "scraps", 2.0, BuildScraps }, { "near", 2.0, BuildNear }, { "city", 1.5, BuildCity },
    { "long", 1.0, BuildLong } };
  return families;
}
}
