// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuilder.h"

#include <algorithm>
#include <random>
#include <utility>

namespace TestScene
{
Prop& SceneBuilder::Add(
  ShapeKind kind, const glm::dvec3& center, const glm::dvec3& size, int detail)
{
  Prop prop;
  prop.Id = this->GetNumberOfProps();
  prop.Shape.Kind = kind;
  prop.Shape.Center = center;
  prop.Shape.Size = size;
  prop.Shape.Detail = detail;
  prop.Shape.Seed = this->UsesDoubles ? 1 : 0;
  prop.Color = { 0.4 + 0.1 * (prop.Id % 7), 0.4 + 0.1 * (prop.Id % 5), 0.4 + 0.2 * (prop.Id % 3) };
  this->Scene.Props.push_back(prop);
  return this->Scene.Props.back();
}

Prop& SceneBuilder::Box(const glm::dvec3& center, const glm::dvec3& size)
{
  return this->Add(ShapeKind::Box, center, size);
}

Prop& SceneBuilder::Quad(double x0, double y0, double x1, double y1, double z, int cells)
{
  Prop& prop = this->Add(
    ShapeKind::Tiles, { 0.5 * (x0 + x1), 0.5 * (y0 + y1), z }, { x1 - x0, y1 - y0, 0.0 }, cells);
  prop.Lighting = false;
  return prop;
}

Prop& SceneBuilder::Sphere(const glm::dvec3& center, double radius, int resolution)
{
  return this->Add(ShapeKind::Globe, center, glm::dvec3(2.0 * radius), resolution);
}

Prop& SceneBuilder::Mesh(
  const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons)
{
  Prop& prop = this->Add(ShapeKind::Mesh, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  for (const glm::dvec3& point : points)
  {
    prop.Shape.Points.insert(prop.Shape.Points.end(), { point.x, point.y, point.z });
  }
  for (const std::vector<int>& polygon : polygons)
  {
    prop.Shape.Polygons.push_back(static_cast<double>(polygon.size()));
    prop.Shape.Polygons.insert(prop.Shape.Polygons.end(), polygon.begin(), polygon.end());
  }
  return prop;
}

Prop& SceneBuilder::Sheet(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v)
{
  return this->Mesh({ corner, corner + u, corner + u + v, corner + v }, { { 0, 1, 2, 3 } });
}

Prop& SceneBuilder::Floor(double halfSize, double z)
{
  const double side = 2.0 * halfSize;
  return this->Sheet({ -halfSize, -halfSize, z }, { side, 0.0, 0.0 }, { 0.0, side, 0.0 });
}

void SceneBuilder::AddWall(int renderer)
{
  const int first = this->GetNumberOfProps();
  this->Box({ 0.0, 0.0, 0.0 }, { 12.0, 6.0, 0.5 });
  std::mt19937 random(3);
  const auto uniform = [&random](double a, double b)
  { return a + (b - a) * static_cast<double>(random() % 10000) / 10000.0; };
  for (int i = 0; i < Wall::Behind; ++i)
  {
    const double x = uniform(-4.0, 4.0);
    const double y = uniform(-2.0, 2.0);
    this->Box({ x, y, uniform(-8.0, -2.0) }, { 0.6, 0.6, 0.6 });
  }
  for (int i = 0; i < Wall::InFront; ++i)
  {
    // On both sides of the wall's edge, before it and beside it.
    const double z = uniform(1.0, 5.0);
    const double y = uniform(-4.0, 4.0);
    this->Box({ uniform(-9.0, 9.0), y, z }, { 0.5, 0.5, 0.5 });
  }
  for (int i = first; i < this->GetNumberOfProps(); ++i)
  {
    this->Scene.Props[i].Renderer = renderer;
  }
}

int SceneBuilder::AddTies(unsigned int seed, bool large)
{
  std::mt19937 random(seed);
  const auto uniform = [&random](double a, double b)
  { return a + (b - a) * static_cast<double>(random() % 1000) / 1000.0; };
  constexpr int quads = 60;
  std::vector<glm::dvec3> corners;
  std::vector<int> order;
  for (int i = 0; i <= quads; ++i)
  {
    const double x = uniform(-5.0, 4.0);
    corners.emplace_back(x, uniform(-3.0, 2.0), -0.5 * (i % 3));
    order.push_back(i);
  }
  std::shuffle(order.begin(), order.end(), random);
  const double side = large ? 3.0 : 1.0;
  int door = 0;
  for (const int i : order)
  {
    const glm::dvec3& c = corners[i];
    if (i == quads)
    {
      door = this->Box({ 0.0, 0.0, 3.0 }, { 5.0, 4.5, 0.2 }).Id;
    }
    else
    {
      this->Quad(c.x, c.y, c.x + side, c.y + side, c.z);
    }
  }
  return door;
}

Light& SceneBuilder::Directional(const glm::dvec3& direction)
{
  Light light;
  light.Kind = LightKind::Directional;
  light.Position = -direction;
  light.Exponent = 1.0;
  light.Intensity = 1.0;
  this->Scene.Lights.push_back(light);
  return this->Scene.Lights.back();
}

Light& SceneBuilder::Spot(const glm::dvec3& position, const glm::dvec3& focalPoint, double cone)
{
  Light& light = this->Directional({ 0.0, 0.0, 0.0 });
  light.Kind = LightKind::Spot;
  light.Position = position;
  light.FocalPoint = focalPoint;
  light.ConeAngle = cone;
  return light;
}

Light& SceneBuilder::PointLight(const glm::dvec3& position)
{
  Light& light = this->Spot(position, position - glm::dvec3(0.0, 0.0, 1.0), 90.0);
  light.Kind = LightKind::Point;
  return light;
}

View& SceneBuilder::LookFrom(const glm::dvec3& eye, const glm::dvec3& focalPoint)
{
  // What the view before does not change stays as it is.
  View view = this->Scene.Views.empty() ? View() : this->Scene.Views.back();
  view.Frame = this->GetFrame();
  view.Position = eye;
  view.FocalPoint = focalPoint;
  this->Scene.Views.push_back(view);
  return this->Scene.Views.back();
}

View& SceneBuilder::Look(const glm::dvec3& eye, const glm::dvec3& focalPoint, double viewAngle)
{
  View& view = this->LookFrom(eye, focalPoint);
  const bool alongZ = eye.x == focalPoint.x && eye.y == focalPoint.y;
  view.ViewUp = { 0.0, alongZ ? 1.0 : 0.0, alongZ ? 0.0 : 1.0 };
  view.ViewAngle = viewAngle;
  return view;
}

View& SceneBuilder::LookParallel(const glm::dvec3& eye, const glm::dvec3& focalPoint, double scale)
{
  View& view = this->Look(eye, focalPoint);
  view.Parallel = true;
  view.ParallelScale = scale;
  return view;
}

View& SceneBuilder::LookAtWall(double shift)
{
  return this->LookFrom({ shift, 0.25 * shift, 20.0 }, { 0.5 * shift, 0.0, 0.0 });
}

View& SceneBuilder::LookAtPixels(double shiftX, double shiftY)
{
  const double x = 0.5 * this->Scene.Window.Width + shiftX;
  const double y = 0.5 * this->Scene.Window.Height + shiftY;
  View& view = this->LookFrom({ x, y, 100.0 }, { x, y, 0.0 });
  view.Parallel = true;
  view.ParallelScale = 0.5 * this->Scene.Window.Height;
  view.Near = 1.0;
  view.Far = 201.0;
  return view;
}

void SceneBuilder::Move(int prop, const glm::dvec3& position)
{
  this->Change(ChangeKind::Position, prop, { position.x, position.y, position.z });
}

void SceneBuilder::Change(ChangeKind kind, int target, std::vector<double> values)
{
  this->Scene.Changes.push_back({ this->GetFrame(), kind, target, std::move(values) });
}

vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<glm::dvec3>& points, const std::vector<std::vector<int>>& polygons)
{
  SceneBuilder scene;
  scene.UsesDoubles = true;
  return MakeShape(scene.Mesh(points, polygons).Shape);
}
}
