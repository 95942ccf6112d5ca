// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace TestScene
{
namespace
{
constexpr double Width = 10.0; // of the places where things are

glm::dvec3 GetAnyPlace(Writer& writer, double low, double high)
{
  return { writer.Between(-0.5, 0.5) * Width, writer.Between(low, high),
    writer.Between(-0.5, 0.5) * Width };
}

Prop& AddCaster(Writer& writer, const glm::dvec3& center)
{
  const double size = std::pow(10.0, writer.Between(-0.8, 0.5));
  const ShapeKind kind =
    writer.Any({ ShapeKind::Box, ShapeKind::Box, ShapeKind::Sphere, ShapeKind::Quad,
      ShapeKind::Lattice, ShapeKind::Soup, ShapeKind::Terrain, ShapeKind::Book, ShapeKind::Strip });
  Prop& prop = writer.Add(kind, center,
    { size, size * writer.Between(0.2, 1.5),
      size * (writer.Chance(0.1) ? 1e-4 : writer.Between(0.2, 1.5)) });
  prop.Shape.Detail = writer.Integer(1, 5);
  if (writer.Chance(0.3))
  {
    prop.Orientation = { writer.Between(-90.0, 90.0), writer.Between(-90.0, 90.0), 0.0 };
    // About the place where it is.
    prop.Position = prop.Shape.Center;
    prop.Shape.Center = { 0.0, 0.0, 0.0 };
  }
  if (writer.Chance(0.1))
  {
    prop.Scale = { -1.0, writer.Between(0.5, 2.0), 1.0 };
  }
  if (writer.Chance(0.1))
  {
    prop.Kind = PropKind::Composite;
  }
  else if (writer.Chance(0.1))
  {
    prop.Kind = PropKind::Glyphs;
  }
  if (writer.Chance(0.1))
  {
    const glm::dvec3& c = prop.Position;
    const glm::dvec3& shape = prop.Shape.Center;
    prop.ClippingPlane = { c[0] + shape[0], c[1] + shape[1], c[2] + shape[2], 1.0,
      writer.Between(-1.0, 1.0), 0.5 };
  }
  return prop;
}

/// From above, from the side or out of the middle of it; walks, cuts, stays.
void AddViewsAround(Writer& writer, double distance)
{
  writer.Scale = Width;
  View first;
  first.ViewAngle = writer.Any({ 30.0, 50.0, 80.0 });
  first.Parallel = writer.Chance(0.25);
  first.ParallelScale = writer.Between(0.2, 0.7) * Width;
  const auto getPlace = [&]() -> glm::dvec3
  {
    const double turn = writer.Between(0.0, 2.0 * vtkMath::Pi());
    const double height = writer.Between(0.02, 1.0);
    const double reach = distance * writer.Between(0.2, 1.0);
    return { reach * std::cos(turn), reach * height, reach * std::sin(turn) };
  };
  first.Position = getPlace();
  first.FocalPoint = GetAnyPlace(writer, 0.0, 2.0);
  if (writer.Chance(0.2))
  {
    first.Near = writer.Any({ 0.001, 0.1, 1.0, 4.0 });
    first.Far = writer.Any({ 50.0, 1e4 });
  }
  writer.Scene.Views.push_back(first);
  const int style = writer.Integer(0, 3);
  for (int frame = 1; frame < writer.Scene.Frames; ++frame)
  {
    if (style == 0 || (style == 1 && writer.Chance(0.5)))
    {
      continue;
    }
    View& view = writer.AddView(frame);
    if (style == 3)
    {
      view.Position = getPlace();
      view.FocalPoint = GetAnyPlace(writer, 0.0, 2.0);
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      view.Position[i] += writer.Between(-0.1, 0.1) * Width;
    }
  }
}

//------------------------------------------------------------------------------------------------
/// Things that stand on a floor or float over it.
void BuildGround(Writer& writer)
{
  Prop& floor =
    writer.Add(writer.Any({ ShapeKind::Box, ShapeKind::Quad, ShapeKind::Quad, ShapeKind::Terrain }),
      { 0.0, 0.0, 0.0 }, { 1.6 * Width, 1.6 * Width, 0.02 * Width });
  floor.Orientation = { 90.0, 0.0, 0.0 };
  floor.Casts = writer.Chance(0.4);
  writer.Occluders.push_back(floor.Id);
  const int count = writer.Integer(1, 14);
  for (int i = 0; i < count; ++i)
  {
    Prop& caster = AddCaster(writer, GetAnyPlace(writer, 0.0, 5.0));
    if (caster.Position[1] == 0.0 && writer.Chance(0.4))
    {
      caster.Shape.Center[1] = 0.5 * caster.Shape.Size[1]; // on the floor
    }
    writer.Occluders.push_back(caster.Id);
  }
  AddViewsAround(writer, 1.2 * Width);
}

/// The inside of a box, with things in the middle of it.
void BuildRoom(Writer& writer)
{
  writer.Box({ 0.0, 1.0, 0.0 }, { 1.2 * Width, 0.6 * Width, 1.2 * Width }).Casts =
    writer.Chance(0.5);
  const int count = writer.Integer(1, 10);
  for (int i = 0; i < count; ++i)
  {
    writer.Occluders.push_back(AddCaster(writer, GetAnyPlace(writer, -1.0, 3.0)).Id);
  }
  AddViewsAround(writer, 0.55 * Width);
}

/// Sheets behind each other along the light, as many as the stencil can count and more.
void BuildSheets(Writer& writer)
{
  writer.Box({ 0.0, -0.1, 0.0 }, { 1.6 * Width, 0.1, 1.6 * Width }).Casts = writer.Chance(0.5);
  // Four times 64 are as many as eight bits take for none.
  const bool full = writer.Chance(0.5);
  const int props = full ? 4 : writer.Integer(1, 6);
  for (int i = 0; i < props; ++i)
  {
    Prop& stack = writer.Add(
      full ? ShapeKind::Stack : writer.Any({ ShapeKind::Soup, ShapeKind::Book, ShapeKind::Stack }),
      { writer.Between(-1.0, 1.0), 1.0 + i, writer.Between(-1.0, 1.0) }, { 4.0, 0.5, 4.0 });
    stack.Shape.Detail = full ? 64 : writer.Any({ 8, 32, 64 });
    stack.Casts = full || writer.Chance(0.9);
    writer.Occluders.push_back(stack.Id);
  }
  AddViewsAround(writer, Width);
}

//------------------------------------------------------------------------------------------------
Light MakeLight(Writer& writer, const glm::dvec3& middle)
{
  Light light;
  const double scale = writer.Scale;
  light.Kind = writer.Chance(0.05)
    ? LightKind::Headlight
    : writer.Any({ LightKind::Directional, LightKind::Directional, LightKind::Spot, LightKind::Spot,
        LightKind::Spot, LightKind::Point, LightKind::Point, LightKind::Camera });
  if (light.Kind == LightKind::Camera || light.Kind == LightKind::Headlight)
  {
    light.Position = { writer.Between(-1.0, 1.0), writer.Between(-1.0, 1.0), 1.0 };
  }
  else
  {
    const double reach = scale * writer.Any({ 0.1, 0.3, 0.6, 1.0, 4.0 });
    for (int i = 0; i < 3; ++i)
    {
      light.FocalPoint[i] = middle[i] + writer.Between(-0.3, 0.3) * scale;
      light.Position[i] = middle[i] + writer.Between(i == 1 ? -0.1 : -1.0, 1.0) * reach;
    }
  }
  if (writer.Chance(0.1))
  {
    // Straight down.
    light.Position = { light.FocalPoint[0], light.FocalPoint[1] + scale, light.FocalPoint[2] };
  }
  light.ConeAngle = writer.Any({ 1.0, 10.0, 30.0, 45.0, 60.0, 80.0, 89.9, 90.0 });
  light.Exponent = writer.Any({ 0.0, 0.0, 1.0, 10.0 });
  light.Attenuation = { 1.0, writer.Chance(0.2) ? 0.05 : 0.0, 0.0 };
  light.Color = { writer.Between(0.3, 1.0), writer.Between(0.3, 1.0), writer.Between(0.3, 1.0) };
  light.Intensity = writer.Between(0.2, 1.0);
  light.On = writer.Chance(0.93);
  light.Casts = writer.Chance(0.93);
  light.ShadowAttenuation = writer.Any({ 1.0, 1.0, 0.5, 0.0 });
  return light;
}

/// Lets a parallel camera look along a light from above, and cut some of what is in view.
void LookAlong(Light& light, std::vector<View>& views)
{
  light.Kind = LightKind::Directional;
  light.FocalPoint = views.front().FocalPoint;
  light.Position = light.FocalPoint + glm::dvec3(0.0, 1.0, 0.0);
  for (View& view : views)
  {
    view.Parallel = true;
    view.ViewUp = { 0.0, 0.0, 1.0 };
    view.Position =
      view.FocalPoint + glm::dvec3(0.0, glm::length(view.Position - view.FocalPoint), 0.0);
    view.Near = view.Position.y - view.FocalPoint.y - 1.0;
    view.Far = view.Near + 100.0;
  }
}

void ChangeShadows(Writer& writer, int frame)
{
  const int lights = static_cast<int>(writer.Scene.Lights.size());
  const int target = lights > 0 ? writer.Integer(0, lights - 1) : 0;
  const auto add = [&](ChangeKind kind, std::vector<double> values)
  { writer.AddChange(frame, kind, target, std::move(values)); };
  const auto moved = [&](glm::dvec3 place)
  {
    for (int i = 0; i < 3; ++i)
    {
      place[i] += writer.Between(-0.3, 0.3) * writer.Scale;
    }
    return std::vector<double>{ place.x, place.y, place.z };
  };
  const Light& light = lights > 0 ? writer.Scene.Lights[target] : Light();
  const auto props = static_cast<int>(writer.Scene.Props.size());
  switch (writer.Integer(0, 14))
  {
    case 0:
    case 1:
    case 2:
      add(ChangeKind::LightPosition, moved(light.Position));
      break;
    case 3:
      add(ChangeKind::LightFocalPoint, moved(light.FocalPoint));
      break;
    case 4:
      add(ChangeKind::LightCone, { writer.Any({ 5.0, 25.0, 50.0, 89.0 }) });
      break;
    case 5:
      add(ChangeKind::LightOn, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 6:
      add(ChangeKind::LightCasts, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 7:
      add(ChangeKind::LightAttenuation, { writer.Any({ 0.0, 0.5, 1.0 }) });
      break;
    case 8:
      add(ChangeKind::ShadowMode, { static_cast<double>(writer.Integer(0, 4)) });
      break;
    case 9:
      add(ChangeKind::LitmapResolution, { writer.Any({ 1.0, 16.0, 100.0 }) });
      break;
    case 10:
      add(ChangeKind::SlabGap, { writer.Any({ 1.0, 8.0, 64.0 }) });
      break;
    case 11:
      add(ChangeKind::CasterKeys, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 12:
      add(ChangeKind::BoxCost, { writer.Any({ 0.0, 16.0, 1024.0 }) });
      break;
    case 13:
      writer.AddChange(
        frame, ChangeKind::Casts, writer.Integer(0, props - 1), { writer.Any({ 0.0, 1.0 }) });
      break;
    default:
      writer.AddChange(frame, ChangeKind::BlockVisible, writer.Integer(0, props - 1),
        { writer.Any({ 0.0, 1.0 }) });
      break;
  }
}

/// Whether every pixel shows what rays are cast at: plain surfaces as their triangles are.
bool IsPlain(const Scenario& scene)
{
  const bool plainProps = std::all_of(scene.Props.begin(), scene.Props.end(),
    [](const Prop& prop)
    {
      return (prop.Kind == PropKind::Actor || prop.Kind == PropKind::Piped ||
               prop.Kind == PropKind::Composite || prop.Kind == PropKind::Glyphs) &&
        !HasSeveralSources(prop) && prop.Shape.Kind != ShapeKind::Lines &&
        prop.Shape.Kind != ShapeKind::Points && prop.Shape.Kind != ShapeKind::NaNPoint &&
        prop.Shape.Kind != ShapeKind::Mesh && prop.Representation == Representation::Surface &&
        !prop.Edges && !prop.Vertices && prop.Shader == Shader::Original && prop.CulledFaces == 0 &&
        prop.OffsetUnits == 0.0 && prop.Opacity == 1.0 && !prop.ForceTranslucent &&
        prop.Texture != Translucency::Some && prop.Scalars != Translucency::Some;
    });
  const bool plainChanges = std::all_of(scene.Changes.begin(), scene.Changes.end(),
    [](const Change& change)
    {
      return change.Kind != ChangeKind::Representation && change.Kind != ChangeKind::Edges &&
        change.Kind != ChangeKind::Opacity && change.Kind != ChangeKind::BlockOpacity &&
        change.Kind != ChangeKind::PolygonOffset && change.Kind != ChangeKind::CulledFaces &&
        change.Kind != ChangeKind::MarkedCells;
    });
  return plainProps && plainChanges;
}
}

const std::vector<NamedFamily>& GetShadowFamilies()
{
  static const std::vector<NamedFamily> families = { { "shadows on the ground", 4.0, BuildGround },
    { "shadows in a room", 3.0, BuildRoom }, { "shadows of sheets", 1.0, BuildSheets } };
  return families;
}

void AddShadows(Writer& writer)
{
  Scenario& scene = writer.Scene;
  for (Renderer& renderer : scene.Renderers)
  {
    if (&renderer == &scene.Renderers.front() || writer.Chance(0.7))
    {
      renderer.Pass =
        writer.Chance(0.7) ? PassKind::ShadowVolumes : PassKind::ShadowVolumesInSequence;
      renderer.Shadows = false;
    }
  }
  const glm::dvec3 middle =
    scene.Views.empty() ? glm::dvec3{ 0.0, 0.0, 0.0 } : scene.Views.front().FocalPoint;
  const int lights = writer.Chance(0.03) ? 0 : writer.Any({ 1, 1, 1, 1, 2, 2, 3, 6 });
  // Named scenarios have theirs.
  for (int i = static_cast<int>(scene.Lights.size()); i < lights; ++i)
  {
    scene.Lights.push_back(MakeLight(writer, middle));
  }
  // Not drawn, so that the rest of a scenario stays what it was for its seed.
  if (scene.Seed % 16 == 5 && !scene.Views.empty() && !scene.Lights.empty())
  {
    LookAlong(scene.Lights.front(), scene.Views);
  }
  Shadows& shadows = scene.Shadows;
  shadows.Mode = writer.Any({ ShadowMode::Scissored, ShadowMode::Scissored, ShadowMode::Clamped });
  // Large litmaps take long to make, and small ones err as soon.
  shadows.LitmapResolution =
    writer.Chance(0.05) ? writer.Any({ 256, 512 }) : writer.Any({ 1, 2, 7, 16, 31, 64, 64, 128 });
  shadows.SlabGap = writer.Any({ 1, 2, 4, 4, 16, 64 });
  shadows.CasterKeys = writer.Chance(0.5);
  shadows.OneForAll = writer.Chance(0.2);
  for (Prop& prop : scene.Props)
  {
    prop.Casts = prop.Casts && writer.Chance(0.8);
  }
  const double changes = writer.Any({ 0.0, 0.3, 1.0 });
  for (int frame = 1; frame < scene.Frames; ++frame)
  {
    if (writer.Chance(changes))
    {
      ChangeShadows(writer, frame);
    }
  }
  if (writer.Chance(0.5))
  {
    scene.Culler.AddedInFrame = -1; // without the culler
  }
  shadows.CompareRays = writer.Chance(0.7) && IsPlain(scene);
  if (writer.Chance(0.2))
  {
    shadows.Mode = ShadowMode::Automatic;
  }
  shadows.BoxCost = writer.Any({ 0, 16, 256, 256, 4096 });
  if (shadows.Mode == ShadowMode::Scissored && writer.Chance(0.15))
  {
    shadows.Mode = ShadowMode::Culled;
  }
}
}
