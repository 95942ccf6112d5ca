// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedScenarios.h"

#include "SceneBuilder.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkTransform.h"

#include <cmath>

namespace TestScene
{
namespace
{
void ThinWall(SceneBuilder& scene)
{
  scene.Box({ 0.0, 0.0, 0.75 }, { 2.0, 1e-4, 1.5 });
  scene.Box({ 0.5, -1.2, 0.5 }, { 1e-4, 1.0, 1.0 });
}

void PaperSheets(SceneBuilder& scene)
{
  scene.Sheet({ -1.0, 0.0, 0.0 }, { 2.0, 0.5, 0.0 }, { 0.0, 0.0, 1.5 });
  scene.Sheet({ -1.0, -1.5, 1.0 }, { 1.0, 0.0, 0.2 }, { 0.0, 1.0, 0.1 });
}

/// Sheets with two sides that lie on each other: with each triangle twice, and as closed meshes
/// without a thickness, of which the two sides are divided into triangles in different ways.
void TwoSidedSheets(SceneBuilder& scene)
{
  scene.Mesh({ { -1.0, 0.0, 0.0 }, { 1.0, 0.5, 0.0 }, { 1.0, 0.5, 1.5 }, { -1.0, 0.0, 1.5 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 2, 1, 0 }, { 3, 2, 0 } });
  scene.Mesh({ { -1.0, -1.5, 1.0 }, { 0.0, -1.5, 1.2 }, { 0.0, -0.5, 1.3 }, { -1.0, -0.5, 1.1 } },
    { { 0, 1, 2, 3 }, { 3, 2, 1, 0 } });
  scene.Box({ 1.2, -1.0, 0.8 }, { 0.8, 0.8, 0.0 });
}

/// One long edge next to two short ones, whose common point is not exactly on the long one.
void TJunctions(SceneBuilder& scene)
{
  const auto at = [](double x, double y) { return glm::dvec3{ x, y, 1.0 + 0.1 * x + 0.07 * y }; };
  scene.Mesh({ at(-1.1, -0.9), at(0.0, -0.9), at(0.0, 0.7), at(-1.1, 0.7), at(0.0, 0.1),
               at(1.3, -0.9), at(1.3, 0.1), at(1.3, 0.7) },
    { { 0, 1, 2, 3 }, { 1, 5, 6, 4 }, { 4, 6, 7, 2 } });
}

/// A picture on the floor and boxes that share faces: what coincides does not shadow.
void Coplanar(SceneBuilder& scene)
{
  scene.Sheet({ -0.5, -1.5, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.5, 0.0 });
  scene.Box({ -0.5, 0.0, 0.25 }, { 0.5, 0.5, 0.5 });
  scene.Box({ -0.5, 0.0, 0.75 }, { 0.5, 0.5, 0.5 });
  scene.Box({ 0.0, 0.0, 0.25 }, { 0.5, 0.5, 0.5 });
}

/// Sheets above each other, more than a stencil of eight bits can count.
void Sheets(SceneBuilder& scene, int count)
{
  std::vector<glm::dvec3> points;
  std::vector<std::vector<int>> quads;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 + static_cast<double>(i) / count;
    points.insert(
      points.end(), { { -0.5, -0.5, z }, { 0.5, -0.5, z }, { 0.5, 0.5, z }, { -0.5, 0.5, z } });
    quads.push_back({ 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 });
  }
  scene.Mesh(points, quads);
}

/// Triangles without area, and every face twice.
void Degenerates(SceneBuilder& scene)
{
  scene.Mesh({ { 0.0, 0.0, 1.5 }, { 1.0, 0.0, 0.5 }, { -0.5, 0.75, 0.5 }, { -0.5, -0.75, 0.5 },
               { 0.5, 0.0, 1.0 }, { 1.0, 0.0, 0.5 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 0, 1 }, { 0, 4, 1 }, { 1, 5, 2 },
      { 3, 3, 3 }, { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
}

void MoebiusStrip(SceneBuilder& scene)
{
  constexpr int count = 40;
  std::vector<glm::dvec3> points;
  std::vector<std::vector<int>> quads;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    for (const double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(0.5 * angle);
      points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), 1.0 + side * std::sin(0.5 * angle) });
    }
    const bool last = i == count - 1;
    const int next = last ? 0 : 2 * i + 2;
    quads.push_back({ 2 * i, 2 * i + 1, next + (last ? 0 : 1), next + (last ? 1 : 0) });
  }
  scene.Mesh(points, quads);
}

/// Three faces at one edge, and four at another.
void SharedEdges(SceneBuilder& scene)
{
  scene.Mesh({ { -1.0, 0.0, 1.2 }, { 1.0, 0.0, 1.2 }, { -1.0, -0.8, 1.3 }, { 1.0, -0.8, 1.3 },
               { -1.0, 0.7, 1.0 }, { 1.0, 0.7, 1.0 }, { -1.0, 0.1, 0.4 }, { 1.0, 0.1, 0.4 },
               { -1.0, 1.2, 0.5 }, { 1.0, 1.2, 0.5 }, { -1.0, 0.7, 0.3 }, { 1.0, 0.7, 0.3 },
               { -1.0, 1.0, 1.5 }, { 1.0, 1.0, 1.5 } },
    { { 0, 1, 3, 2 }, { 0, 1, 5, 4 }, { 0, 1, 7, 6 }, { 4, 5, 9, 8 }, { 5, 4, 10, 11 },
      { 4, 5, 13, 12 } });
}

/// Actors whose matrices turn meshes inside out, shear and squeeze them.
void Matrices(SceneBuilder& scene)
{
  const glm::dvec3 size(0.8);
  Prop& mirrored = scene.Add(ShapeKind::SharedBox, { 0.0, 0.0, 0.0 }, size);
  mirrored.Position = { -0.8, 0.0, 0.9 };
  mirrored.Scale = { -1.0, 1.2, 0.7 };
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(35.0, 1.0, 2.0, 3.0);
  turn->GetOrientation(glm::value_ptr(mirrored.Orientation));
  scene.Add(ShapeKind::SharedBox, { 0.0, 0.0, 0.0 }, size).UserMatrix = { 1.0, 0.0, 0.7, 0.8, //
    -0.3, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5, 0.9, 0.0, 0.0, 0.0, 1.0 };
}

/// The mesh is open where it is cut, so that light falls in.
void ClippingPlanes(SceneBuilder& scene)
{
  scene.Sphere({ 0.0, 0.0, 1.0 }, 0.8).ClippingPlane = { 0.1, 0.0, 1.1, 0.6, -0.3, -0.8 };
}

/// What is not drawn as surfaces casts nothing. It is out of view, because it would be seen.
void NotSurfaces(SceneBuilder& scene)
{
  scene.Box({ 0.5, 0.5, 0.3 }, { 0.6, 0.6, 0.6 });
  scene.Sphere({ -2.4, -1.4, 3.0 }, 0.6).Representation = Representation::Wireframe;
  scene.Sphere({ -3.0, -1.0, 3.0 }, 0.6).Representation = Representation::Points;
  scene.Look({ 2.0, -4.0, 2.5 }, { 0.4, 0.2, 0.2 });
}

/// Quads whose corners are in no plane, strips, and polygons of many corners.
void QuadsStripsPolygons(SceneBuilder& scene)
{
  scene.Mesh({ { -1.5, -1.0, 1.4 }, { -0.5, -1.0, 0.6 }, { 0.5, -1.0, 1.4 }, { -1.5, 0.2, 0.6 },
               { -0.5, 0.2, 1.4 }, { 0.5, 0.2, 0.6 } },
    { { 0, 1, 4, 3 }, { 2, 5, 4, 1 } });
  scene.Add(ShapeKind::Strip, { 0.9, 0.8, 0.8 }, { 1.0, 1.0, 0.6 }, 8);
  scene.Add(ShapeKind::Cylinder, { 0.9, -0.8, 0.6 }, { 0.8, 1.0, 0.8 }, 7);
}

/// Invisible props, which do not cast: an actor, and an assembly whose parts are visible.
void HiddenActor(SceneBuilder& scene)
{
  scene.Box({ 0.5, 0.5, 0.3 }, { 0.6, 0.6, 0.6 });
  scene.Sphere({ -0.5, 0.0, 1.0 }, 0.6).Visible = false;
  Prop& assembly = scene.Sphere({ 0.8, -0.8, 1.0 }, 0.4);
  assembly.Kind = PropKind::Assembly;
  assembly.Visible = false;
}

/// One corner of a box is NaN. The bounds are those without it.
void NotANumber(SceneBuilder& scene)
{
  scene.Sphere({ 0.0, 0.0, 1.0 }, 0.7);
  Prop& box = scene.Add(ShapeKind::NaNPoint, { 0.8, -0.8, 0.5 }, glm::dvec3(0.5));
  box.Shape.Seed = 0;
  box.UseBounds = false;
}

/// Points repeated for every face of a prism, and at the seam of a sphere.
void RepeatedPoints(SceneBuilder& scene)
{
  constexpr int sides = 9;
  std::vector<glm::dvec3> points;
  std::vector<std::vector<int>> polygons(2); // begin with bottom and top
  for (int i = 0; i < sides; ++i)
  {
    const int first = static_cast<int>(points.size());
    for (const int side : { i, (i + 1) % sides })
    {
      const double angle = 2.0 * vtkMath::Pi() * side / sides;
      const glm::dvec3 low(0.5 * std::cos(angle) - 0.8, -0.5, 0.5 * std::sin(angle) + 1.0);
      const glm::dvec3 high = low + glm::dvec3(0.0, 1.0, 0.0);
      points.insert(points.end(), { low, high, low, high });
    }
    polygons.push_back({ first, first + 1, first + 5, first + 4 });
    polygons[0].push_back(first + 2);
    polygons[1].insert(polygons[1].begin(), first + 3);
  }
  scene.Mesh(points, polygons);
  scene.Sphere({ 0.8, 0.3, 0.8 }, 0.6);
}

/// Open meshes that are bent: a bowl and a dome.
void HalfSphere(SceneBuilder& scene)
{
  constexpr int meridians = 16;
  constexpr int rings = 7;
  std::vector<glm::dvec3> points(meridians, { 0.0, 0.0, 0.7 }); // the pole, as a ring
  std::vector<std::vector<int>> triangles;
  for (int i = 0; i < rings * meridians; ++i)
  {
    const double latitude = 0.5 * vtkMath::Pi() * (i / meridians + 1) / rings;
    const double longitude = 2.0 * vtkMath::Pi() * (i % meridians) / meridians;
    points.push_back(0.7 *
      glm::dvec3(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
        std::cos(latitude)));
  }
  for (int i = 0; i < rings * meridians; ++i)
  {
    const int next = i % meridians == meridians - 1 ? i + 1 - meridians : i + 1;
    triangles.push_back({ i < meridians ? 0 : i, i + meridians, next + meridians });
    if (i >= meridians)
    {
      triangles.push_back({ i, next + meridians, next });
    }
  }
  for (const bool dome : { false, true })
  {
    Prop& half = scene.Mesh(points, triangles);
    half.Position = { dome ? 0.8 : -0.8, 0.0, 1.0 };
    half.Orientation.x = dome ? -30.0 : 200.0;
  }
}

/// Assemblies in each other, with a part that is hidden.
void Assembly(SceneBuilder& scene)
{
  Prop& outer = scene.Box({ 0.0, 0.0, 0.0 }, glm::dvec3(0.8));
  outer.Kind = PropKind::Assembly;
  outer.Position.z = 0.6;
  outer.Orientation.y = 20.0;
  const int outerId = outer.Id;
  Prop& inner = scene.Sphere({ 0.0, 0.0, 0.9 }, 0.4);
  inner.Kind = PropKind::Assembly;
  inner.Orientation.x = 40.0;
  inner.PartOf = outerId;
  const int innerId = inner.Id;
  Prop& part = scene.Sphere({ -0.9, 0.0, 0.9 }, 0.4);
  part.PartOf = innerId;
  Prop& hidden = scene.Sphere({ 1.9, 0.0, 0.9 }, 0.4);
  hidden.PartOf = innerId;
  hidden.Visible = false;
}

/// Blocks within blocks, one of them hidden.
void Composite(SceneBuilder& scene)
{
  for (const double y : { 0.0, 1.0 })
  {
    Prop& prop = scene.Box({ -0.2, y, 0.8 }, glm::dvec3(0.5));
    prop.Kind = PropKind::Composite;
    scene.Change(ChangeKind::BlockVisible, prop.Id, { y > 0.0 ? 0.0 : 1.0 });
  }
}

/// Instances of closed and open sources, of any size and in any direction, some of them masked.
/// Some move in the second frame.
void Instances(SceneBuilder& scene)
{
  const int first = scene.GetNumberOfProps();
  scene.Box({ -1.0, -0.5, 0.9 }, { 1.2, 1.0, 1.0 });
  scene.Sphere({ 0.6, 0.7, 1.0 }, 0.6, 5);
  scene.Add(ShapeKind::Tiles, { 1.2, -0.8, 0.9 }, { 1.0, 1.0, 1.0 }, 3);
  for (int i = 0; i < 3; ++i)
  {
    Prop& prop = scene.Scene.Props[static_cast<std::size_t>(first + i)];
    prop.Kind = PropKind::Glyphs;
    prop.Shape.Seed = 2 * i + 1;
    prop.Orientation = { 10.0 * i, 0.0, 20.0 };
  }
  scene.NextFrame();
  scene.Change(ChangeKind::MovePoints, first, { 0.3, 0.1, 0.2, 0.7 });
}

/// The points of the first prop change in the second frame, under the actor.
void ChangingData(SceneBuilder& scene)
{
  const int box = scene.Add(ShapeKind::SharedBox, { -0.5, 0.0, 0.8 }, glm::dvec3(0.8)).Id;
  scene.Sphere({ 1.0, 0.5, 0.6 }, 0.5);
  scene.NextFrame();
  scene.Change(ChangeKind::MovePoints, box, { 0.0, -0.5, 0.2, 0.7 });
}
}

std::vector<NamedScenario> GetMeshScenarios()
{
  // What the casters stand on or float above, with a light from above.
  const auto make = [](const char* name, const std::function<void(SceneBuilder&)>& build)
  {
    return MakeShadowScenario(name,
      [&build](SceneBuilder& scene)
      {
        scene.Floor(5.0);
        scene.Directional({ 0.6, 0.35, -0.7 });
        scene.Look({ 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
        build(scene);
      });
  };
  const auto sheets = [](int count)
  { return [count](SceneBuilder& scene) { Sheets(scene, count); }; };
  return {
    make("ThinWall", ThinWall),
    make("PaperSheets", PaperSheets),
    make("TwoSidedSheets", TwoSidedSheets),
    make("TJunctions", TJunctions),
    make("Coplanar", Coplanar),
    make("Sheets256", sheets(256)),
    make("Sheets512", sheets(512)),
    make("Degenerates", Degenerates),
    make("MoebiusStrip", MoebiusStrip),
    make("SharedEdges", SharedEdges),
    make("Matrices", Matrices),
    make("ClippingPlanes", ClippingPlanes),
    make("NotSurfaces", NotSurfaces),
    make("QuadsStripsPolygons", QuadsStripsPolygons),
    make("HiddenActor", HiddenActor),
    make("NotANumber", NotANumber),
    make("RepeatedPoints", RepeatedPoints),
    make("HalfSphere", HalfSphere),
    make("Assembly", Assembly),
    make("Composite", Composite),
    make("ChangingData", ChangingData),
    make("Instances", Instances),
  };
}
}
