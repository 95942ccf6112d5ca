// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds that are not a box.
#include "HazardBuilder.h"

#include <functional>
#include <limits>

namespace TestScene
{
namespace
{
using Verdict = vtkNBufferVerdict;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Add = std::function<void(SceneBuilder&)>;

/// Comparisons with NaN are false, infinite and uninitialised bounds have no order, and a prop may
/// have no bounds at all. Such bounds must not cull anything, and the other props must stay hidden.
/// `add` adds one prop.
NamedScenario AmongTheOthers(const std::string& name, const Add& add)
{
  HazardBuilder scene("Each/CullerOddBounds.AmongTheOthers/" + name);
  scene.BeExact(4);
  scene.AddWall();
  add(scene);
  scene.Box({ 0.0, 0.5, -5.0 }, glm::dvec3(0.5));
  add(scene);
  View& view = scene.LookFrom({ 0.0, 0.0, 20.0 });
  view.Near = 1.0;
  view.Far = 60.0;
  for (int i = 1; i < 5; ++i)
  {
    scene.NextFrame();
    scene.LookFrom({ 0.1 * i, 0.0, 20.0 });
  }
  scene.ExpectDecision(vtkNBufferDecision::Culled);
  scene.ExpectHidden(Wall::Hidden);
  scene.ExpectNone(
    { Wall::Count, Wall::Count + 2 }, { Verdict::Hidden, Verdict::Outside, Verdict::Unknown });
  return scene.Finish();
}

Prop& AddPlainBox(SceneBuilder& scene)
{
  return scene.Box({ 0.0, 0.0, -4.0 }, glm::dvec3(0.5));
}

Add MakeKind(PropKind kind)
{
  return [kind](SceneBuilder& scene) { AddPlainBox(scene).Kind = kind; };
}

/// `seed`: see ShapeKind.
Add MakeShape(ShapeKind kind, int seed)
{
  return [=](SceneBuilder& scene)
  {
    Shape& shape = AddPlainBox(scene).Shape;
    shape.Kind = kind;
    shape.Seed = seed;
  };
}

/// A box whose first `count` points are at `place`, and every second one of them opposite to it.
Add MakePoints(const glm::dvec3& place, int count)
{
  return [=](SceneBuilder& scene)
  {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 corner(i & 1 ? 0.25 : -0.25, i & 2 ? 0.25 : -0.25, i & 4 ? 0.25 : -0.25);
      points.push_back(i >= count ? corner : i % 2 ? -place : place);
    }
    scene
      .Mesh(points,
        { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
          { 1, 3, 7, 5 } })
      .Shape.Center.z = -4.0;
  };
}

/// A box with one element of its actor's matrix.
Add MakeMatrix(int row, int column, double value)
{
  return [=](SceneBuilder& scene)
  {
    std::vector<double>& matrix = AddPlainBox(scene).UserMatrix;
    matrix = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 };
    matrix[4 * row + column] = value;
  };
}
}

std::vector<NamedScenario> GetBoundsHazards()
{
  return {
    AmongTheOthers("Null", MakeKind(PropKind::NoBounds)),
    AmongTheOthers("NullOf2D", MakeKind(PropKind::Text)),
    AmongTheOthers("UninitialisedWithoutPoints", MakeShape(ShapeKind::Empty, 1)),
    AmongTheOthers("UninitialisedWithoutMapper", MakeKind(PropKind::NoMapper)),
    AmongTheOthers("InfinitePoint", MakeShape(ShapeKind::NaNPoint, 1)),
    AmongTheOthers("InfinitePoints", MakePoints({ 0.0, Infinity, 0.0 }, 8)),
    AmongTheOthers("OnlyNaNPoints", MakePoints(glm::dvec3(NaN), 8)),
    AmongTheOthers("LargestFloat", MakePoints({ std::numeric_limits<float>::max(), 0.0, 0.0 }, 1)),
    AmongTheOthers("NaNMatrix", MakeMatrix(0, 0, NaN)),
    AmongTheOthers("NaNTranslation", MakeMatrix(1, 3, NaN)),
    AmongTheOthers("InfiniteTranslation", MakeMatrix(2, 3, -Infinity)),
    AmongTheOthers("InfiniteScale", MakeMatrix(0, 0, Infinity)),
    AmongTheOthers("HugeScale", MakeMatrix(0, 0, 1e300)),
  };
}
}
