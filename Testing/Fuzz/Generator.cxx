// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Generator.h"

#include "Families.h"
#include "Undefined.h"

#include "vtkNBufferCuller.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>

namespace TestScene
{
namespace
{
//------------------------------------------------------------------------------------------------
/// What a few props are beside opaque surfaces.
void MakeOdd(Writer& writer, Prop& prop)
{
  switch (writer.Integer(0, 19))
  {
    case 0:
    case 1:
    case 2:
      prop.Opacity = writer.Between(0.2, 0.8);
      break;
    case 3:
      prop.ForceTranslucent = true;
      break;
    case 4:
      prop.Representation = writer.Any({ Representation::Wireframe, Representation::Points });
      prop.LineWidth = prop.PointSize = writer.Between(1.0, 5.0);
      break;
    case 5:
      prop.Edges = true;
      break;
    case 6:
      prop.Vertices = true;
      break;
    case 7:
      prop.Kind = writer.Any({ PropKind::Piped, PropKind::DataSet, PropKind::Composite });
      break;
    case 8:
      // Glyphs of lines are as wide as the lines that happened to be drawn before (docs/limits.md).
      prop.Kind = prop.Shape.Kind == ShapeKind::Lines
        ? writer.Any({ PropKind::Assembly, PropKind::Follower })
        : writer.Any({ PropKind::Assembly, PropKind::Follower, PropKind::Glyphs });
      break;
    case 9:
      prop.Kind =
        writer.Any({ PropKind::LOD, PropKind::NoMapper, PropKind::Text, PropKind::NoBounds });
      break;
    case 10:
      prop.Texture = writer.Any({ Translucency::Some, Translucency::Opaque });
      break;
    case 11:
      prop.Scalars = writer.Any({ Translucency::Some, Translucency::Opaque });
      break;
    case 12:
      prop.CulledFaces = writer.Integer(1, 2);
      break;
    case 13:
      prop.Shape.Kind = writer.Any({ ShapeKind::Empty, ShapeKind::NaNPoint, ShapeKind::Points });
      prop.UseBounds = writer.Chance(0.5);
      break;
    case 14:
    case 15:
      // Mirrored, sheared.
      prop.UserMatrix = { writer.Any({ -1.0, 1.0, 1.5 }), writer.Between(-0.4, 0.4), 0.0, 0.0, 0.0,
        1.0, writer.Between(-0.3, 0.3), 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
      break;
    case 16:
      prop.Orientation = { writer.Between(-90.0, 90.0), writer.Between(-90.0, 90.0), 0.0 };
      break;
    case 17:
    {
      const glm::dvec3& c = prop.Shape.Center;
      prop.ClippingPlane = { c[0], c[1], c[2], 1.0, writer.Between(-1.0, 1.0), 0.0 };
      break;
    }
    case 18:
      prop.OffsetUnits = writer.Any({ -4.0, 4.0, -2000.0, 2000.0 });
      prop.OffsetFactor = writer.Any({ 0.0, 0.01, 1.0 }) * prop.OffsetUnits;
      prop.Edges =
        prop.Id % 2 == 0; // They switch these offsets on, whatever the global setting is.
      break;
    default:
      if (writer.Chance(0.3))
      {
        prop.ForceOpaque = true;
        prop.Opacity = 0.5;
      }
      else if (writer.Chance(0.3))
      {
        prop.Shader = writer.Any({ Shader::MovesVertices, Shader::WritesDepth });
      }
      break;
  }
}

void MakeMaterials(Writer& writer)
{
  const double share = writer.Any({ 0.0, 0.0, 0.05, 0.2 });
  const double flat = writer.Any({ 0.0, 0.5 });
  const double piped = writer.Any({ 0.0, 0.0, 0.0, 0.0, 0.0, 0.5 });
  for (Prop& prop : writer.Scene.Props)
  {
    if (writer.Chance(share))
    {
      MakeOdd(writer, prop);
    }
    prop.Flat = writer.Chance(flat);
    prop.Kind = prop.Kind == PropKind::Actor && writer.Chance(piped) ? PropKind::Piped : prop.Kind;
  }
  // Not drawn, so that the rest of a scenario stays what it was for its seed.
  for (Prop& prop : writer.Scene.Props)
  {
    const bool hasBlocks = writer.Scene.Seed % 8 == 1 && prop.Id % 2 == 0;
    const bool isSlice = writer.Scene.Seed % 16 == 6 && prop.Id % 8 == 5;
    const PropKind other = isSlice ? PropKind::Slice : PropKind::Composite;
    prop.Kind = prop.Kind == PropKind::Actor && (isSlice || hasBlocks) ? other : prop.Kind;
    prop.BackOpacity = writer.Scene.Seed % 16 == 14 && prop.Id % 8 == 3 ? 0.5 : 1.0;
  }
  // These take long to draw in software, or their shaders to compile.
  if (writer.Chance(0.01))
  {
    Prop& prop = writer.Scene.Props[static_cast<std::size_t>(
      writer.Integer(0, static_cast<int>(writer.Scene.Props.size()) - 1))];
    prop.Kind = writer.Any({ PropKind::Volume, PropKind::Billboard });
  }
}

//------------------------------------------------------------------------------------------------
glm::dvec3 GetRandomVector(Writer& writer, double size)
{
  return { writer.Between(-size, size), writer.Between(-size, size), writer.Between(-size, size) };
}

void ChangeAnyProp(Writer& writer, int frame)
{
  const Prop& prop = writer.Scene.Props[writer.Random.Index(writer.Scene.Props.size())];
  const glm::dvec3 move = GetRandomVector(writer, 0.5 * writer.Scale);
  const glm::dvec3 moved = prop.Position + move;
  const auto add = [&](ChangeKind kind, std::vector<double> values)
  { writer.AddChange(frame, kind, prop.Id, std::move(values)); };
  switch (writer.Integer(0, 15))
  {
    case 0:
    case 1:
    case 2:
    case 3:
      if (prop.Kind == PropKind::Composite)
      {
        add(ChangeKind::MovePoints, { move[0], move[1], move[2] });
      }
      else
      {
        add(ChangeKind::Position, { moved[0], moved[1], moved[2] });
      }
      break;
    case 4:
    case 5:
      add(ChangeKind::MovePoints,
        { move[0], move[1], move[2], writer.Any({ 0.0, 0.0, 0.7 }),
          writer.Scene.Seed % 2 ? 1.0 : 0.0 });
      break;
    case 6:
      add(ChangeKind::ReplaceData,
        { writer.Between(0.1, 0.5) * writer.Scale, writer.Between(0.1, 0.5) * writer.Scale, 0.5,
          writer.Any({ 0.0, 1.0 }) });
      break;
    case 7:
      add(ChangeKind::Scale, { writer.Between(0.2, 6.0), writer.Between(0.2, 6.0), 1.0 });
      break;
    case 8:
      add(ChangeKind::Orientation, { 0.0, 0.0, writer.Between(0.0, 180.0) });
      break;
    case 9:
      add(ChangeKind::Color, { writer.Between(0.0, 1.0), 0.5, 0.9 });
      break;
    case 10:
      add(prop.Kind == PropKind::Composite ? ChangeKind::BlockOpacity : ChangeKind::Opacity,
        { writer.Any({ 0.5, 1.0 }) });
      break;
    case 11:
    case 12:
      add(ChangeKind::Visible, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 13:
      add(ChangeKind::Rejoin, {});
      break;
    case 14:
      // Glyphs of lines are as wide as the lines drawn before them (docs/limits.md).
      add(ChangeKind::Representation,
        { prop.Kind == PropKind::Glyphs ? 2.0 : writer.Any({ 1.0, 2.0 }) });
      break;
    default:
    {
      const ChangeKind kind =
        writer.Any({ ChangeKind::Edges, ChangeKind::ClippingPlane, ChangeKind::LineWidth });
      // Not drawn, so that the rest of a scenario stays what it was for its seed.
      switch (writer.Scene.Seed % 4)
      {
        case 0:
          add(
            ChangeKind::MarkedCells, { 3.0 * (frame % 2), writer.Scene.Seed % 8 == 4 ? 0.6 : 0.0 });
          break;
        case 1:
          add(ChangeKind::CulledFaces, { static_cast<double>(frame % 3) });
          break;
        default:
          add(kind, { 1.0, 0.5, 0.5 });
          break;
      }
      break;
    }
  }
}

/// What hides the others goes away, comes back, or moves aside.
void ChangeOccluder(Writer& writer, int frame)
{
  if (writer.Occluders.empty())
  {
    return;
  }
  const int id = writer.Occluders[writer.Random.Index(writer.Occluders.size())];
  if (writer.Chance(0.5))
  {
    writer.AddChange(frame, ChangeKind::Visible, id, { writer.Any({ 0.0, 1.0 }) });
  }
  else
  {
    writer.AddChange(
      frame, ChangeKind::Position, id, { writer.Between(-0.5, 0.5) * writer.Scale, 0.0, 0.0 });
  }
}

void ChangeSettings(Writer& writer, int frame)
{
  const auto add = [&](ChangeKind kind, std::vector<double> values)
  { writer.AddChange(frame, kind, 0, std::move(values)); };
  switch (writer.Integer(0, 13))
  {
    case 0:
      add(ChangeKind::WindowSize,
        { static_cast<double>(writer.Integer(20, 150)),
          static_cast<double>(writer.Integer(20, 150)) });
      break;
    case 1:
      add(ChangeKind::MultiSamples, { writer.Any({ 0.0, 4.0 }) });
      break;
    case 2:
      add(ChangeKind::Stereo, { writer.Any({ -1.0, static_cast<double>(VTK_STEREO_RED_BLUE) }) });
      break;
    case 3:
      add(ChangeKind::Viewport,
        { writer.Between(0.0, 0.4), writer.Between(0.0, 0.4), writer.Between(0.6, 1.0),
          writer.Between(0.6, 1.0) });
      break;
    case 4:
      add(ChangeKind::FXAA, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 5:
      add(ChangeKind::Pass, { static_cast<double>(writer.Integer(0, 5)) });
      break;
    case 6:
      add(ChangeKind::CullerEnabled, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 7:
      add(ChangeKind::CullerBackend, { writer.Any({ 0.0, 1.0, 2.0 }) });
      break;
    case 8:
      add(ChangeKind::CullerBaseFactor, { writer.Any({ 1.0, 2.0, 4.0, 8.0 }) });
      break;
    case 9:
      add(ChangeKind::CullerRoundSize, { writer.Any({ 1.0, 5.0, 64.0 }) });
      break;
    case 10:
      add(ChangeKind::CullerPresent, { writer.Any({ 0.0, 1.0 }) });
      break;
    case 11:
      add(ChangeKind::PolygonOffset, { writer.Any({ 0.0, 1.0, 2.0 }) });
      break;
    default:
    {
      const ChangeKind kind =
        writer.Any({ ChangeKind::NewContext, ChangeKind::Select, ChangeKind::Select });
      // Not drawn, so that the rest of a scenario stays what it was for its seed. The second
      // renderer, if there is one, keeps the picture or the depth of the first one.
      if (writer.Scene.Seed % 3 == 0)
      {
        writer.AddChange(frame,
          writer.Scene.Seed % 2 ? ChangeKind::Erase : ChangeKind::PreserveDepth, 1,
          { static_cast<double>(frame % 2) });
      }
      else
      {
        add(kind, {});
      }
      break;
    }
  }
}

void MakeChanges(Writer& writer)
{
  const double props = writer.Any({ 0.0, 0.5, 1.0, 3.0 });
  const double occluders = writer.Any({ 0.0, 0.0, 0.5 });
  const double settings = writer.Any({ 0.0, 0.0, 0.0, 0.3 });
  for (int frame = 1; frame < writer.Scene.Frames; ++frame)
  {
    for (double left = props; left > 0.0; left -= 1.0)
    {
      if (writer.Chance(left))
      {
        ChangeAnyProp(writer, frame);
      }
    }
    if (writer.Chance(occluders))
    {
      ChangeOccluder(writer, frame);
    }
    if (writer.Chance(settings))
    {
      ChangeSettings(writer, frame);
    }
  }
  if (writer.Chance(0.2))
  {
    for (Prop& prop : writer.Scene.Props)
    {
      if (writer.Chance(0.2))
      {
        prop.From = writer.Integer(0, writer.Scene.Frames - 1);
        prop.Until = writer.Chance(0.5) ? writer.Integer(0, writer.Scene.Frames) : -1;
      }
    }
  }
}

//------------------------------------------------------------------------------------------------
/// The whole scene larger or smaller, somewhere else. Where vertices are not moved to the origin on
/// their way to the device, pixels and steps of float are made comparable.
void MoveFarAway(Writer& writer)
{
  Scenario& scene = writer.Scene;
  const double offset = writer.Any({ 0.0, 1e3, 1e5, 5e6, 5e6 });
  const double step = std::ldexp(offset, -23);
  const double pixel = writer.Scale / scene.Window.Width;
  const double factor = offset == 0.0
    ? writer.Any({ 1e-3, 10.0, 1e3 })
    : std::max(writer.Any({ 0.5, 1.0, 2.0, 4.0, 16.0, 1e3 }) * step / pixel, 1e-3);
  const glm::dvec3 origin = { offset, 0.9 * offset, writer.Any({ 0.0, 0.0, 0.8 }) * offset };
  const bool inMatrix = writer.Chance(0.3);
  const bool shift = writer.Chance(0.3);
  // Rays are cast at double coordinates. VTK does not shift the matrices of glyphs.
  scene.Shadows.CompareRays = scene.Shadows.CompareRays && shift;
  const auto place = [&](glm::dvec3& point, bool absolute)
  { point = factor * point + (absolute ? origin : glm::dvec3(0.0)); };
  for (Prop& prop : scene.Props)
  {
    place(prop.Position, inMatrix);
    place(prop.Shape.Center, !inMatrix);
    place(prop.Shape.Size, false);
    prop.ShiftCoordinates = shift;
    scene.Shadows.CompareRays = scene.Shadows.CompareRays && prop.Kind != PropKind::Glyphs;
    if (prop.ClippingPlane.size() == 6)
    {
      prop.ClippingPlane.clear();
    }
    // These turn and mirror about the origin.
    if (!inMatrix)
    {
      prop.Orientation = { 0.0, 0.0, 0.0 };
      prop.UserMatrix.clear();
    }
  }
  for (View& view : scene.Views)
  {
    place(view.Position, true);
    place(view.FocalPoint, true);
    view.ParallelScale *= factor;
    view.Near *= factor;
    view.Far *= factor;
  }
  for (Light& light : scene.Lights)
  {
    if (light.Kind != LightKind::Camera)
    {
      place(light.Position, true);
      place(light.FocalPoint, true);
    }
  }
  for (Change& change : scene.Changes)
  {
    const bool ofLight =
      change.Kind == ChangeKind::LightPosition || change.Kind == ChangeKind::LightFocalPoint;
    if (ofLight || change.Kind == ChangeKind::Position || change.Kind == ChangeKind::MovePoints ||
      change.Kind == ChangeKind::ReplaceData)
    {
      const bool absolute = ofLight || (change.Kind == ChangeKind::Position && inMatrix);
      // A fourth value is a share, not a length.
      for (std::size_t i = 0; i < std::min<std::size_t>(change.Values.size(), 3); ++i)
      {
        change.Values[i] = factor * change.Values[i] + (absolute ? origin[i] : 0.0);
      }
    }
  }
}

const NamedFamily& ChooseFamily(Writer& writer, const std::vector<NamedFamily>& families)
{
  double sum = 0.0;
  for (const NamedFamily& family : families)
  {
    sum += family.Weight;
  }
  double left = writer.Between(0.0, sum);
  for (const NamedFamily& family : families)
  {
    if (left < family.Weight)
    {
      return family;
    }
    left -= family.Weight;
  }
  return families.back();
}

/// One in so many scenarios begins as a named one.
constexpr std::uint64_t ScenariosPerNamed = 10;
}

Scenario MakeScenario(std::uint64_t seed, ScenarioKind kind)
{
  Scenario scenario;
  scenario.Seed = seed;
  NBufferExamples::Random random(seed);
  Writer writer(scenario, random);

  const bool shadows = kind == ScenarioKind::Shadows;
  const NamedFamily& family =
    ChooseFamily(writer, shadows && writer.Chance(0.7) ? GetShadowFamilies() : GetFamilies());
  scenario.Family = family.Name;
  scenario.Frames = writer.Integer(4, 10);
  MakeWindow(writer);
  MakeCuller(writer);
  // Not drawn, so that scenarios of other seeds stay what they were.
  if (seed % ScenariosPerNamed == ScenariosPerNamed - 1)
  {
    BuildNamed(writer, shadows);
  }
  else
  {
    family.Build(writer);
  }
  if (writer.Chance(0.2))
  {
    // Neither props nor their order may depend on which was there first.
    for (std::size_t i = scenario.Props.size(); i > 1; --i)
    {
      std::swap(scenario.Props[i - 1], scenario.Props[random.Index(i)]);
    }
  }
  MakeMaterials(writer);
  MakeChanges(writer);
  ReversePoints(writer);
  MakeRenderers(writer);
  if (shadows)
  {
    AddShadows(writer);
  }
  if (writer.Chance(shadows ? 0.1 : 0.3))
  {
    MoveFarAway(writer);
  }
  if (!shadows)
  {
    // The lines of a wireframe on a caster's surface have depths that rays cannot judge.
    ShareMappers(writer);
  }
  NestAssemblies(writer);
  RemoveUndefined(scenario);
  return scenario;
}
}
