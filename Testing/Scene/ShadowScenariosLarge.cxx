// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedScenarios.h"

#include "SceneBuilder.h"

#include "vtkNew.h"
#include "vtkTransform.h"

#include <random>

namespace TestScene
{
namespace
{
/// Numbers that are the same with every library.
class RandomNumbers
{
public:
  double Get(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() % 100001) / 100000.0);
  }

  /// The components are drawn in their order.
  glm::dvec3 GetVector(const glm::dvec3& low, const glm::dvec3& high)
  {
    glm::dvec3 result;
    for (int i = 0; i < 3; ++i)
    {
      result[i] = this->Get(low[i], high[i]);
    }
    return result;
  }

private:
  std::mt19937 Engine{ 1 };
};

/// One light: from above at a slant, a spot or a point light at `position`.
void LightUp(SceneBuilder& scene, LightKind lighting, const glm::dvec3& position,
  const glm::dvec3& focalPoint, double cone)
{
  switch (lighting)
  {
    case LightKind::Directional:
      scene.Directional({ 0.6, 0.35, -0.7 });
      break;
    case LightKind::Spot:
      scene.Spot(position, focalPoint, cone);
      break;
    case LightKind::Point:
      scene.PointLight(position);
      break;
    default: // The other kinds do not cast.
      break;
  }
}

void City(SceneBuilder& scene, int side, LightKind lighting)
{
  // Metres: lots of 12, a street of 10 after every second one.
  const auto place = [&](int i) { return 12.0 * (i - side / 2) + 10.0 * (i / 2 - side / 4); };
  RandomNumbers random;
  scene.Floor(place(side) + 20.0);
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double height = random.Get(6.0, 36.0);
      scene.Box({ place(i) + 6.0, place(j) + 6.0, 0.5 * height },
        { random.Get(8.0, 12.0), random.Get(8.0, 12.0), height });
    }
  }
  // The street between the two halves, x from -10 to 0; the lamp is above the roofs beside it.
  LightUp(scene, lighting, { -40.0, 5.0, 60.0 }, { -5.0, 5.0, 0.0 }, 40.0);
  scene.Look({ -6.0, -30.0, 1.8 }, { -4.0, 20.0, 6.0 }, 60.0);
}

void Birds(SceneBuilder& scene, int count, LightKind lighting)
{
  RandomNumbers random;
  scene.Floor(60.0);
  for (int i = 0; i < 12; ++i)
  {
    const double height = random.Get(8.0, 25.0);
    scene.Box({ random.Get(-45.0, 45.0), random.Get(-45.0, 45.0), 0.5 * height },
      { random.Get(3.0, 6.0), random.Get(3.0, 6.0), height });
  }
  for (int i = 0; i < count; ++i)
  {
    scene.Sphere({ random.Get(-50.0, 50.0), random.Get(-50.0, 50.0), random.Get(10.0, 30.0) },
      random.Get(0.3, 0.9), 10);
  }
  LightUp(scene, lighting, { -20.0, -10.0, 70.0 }, { 0.0, 0.0, 0.0 }, 40.0);
  scene.Look({ 20.0, -90.0, 35.0 }, { 0.0, 0.0, 5.0 });
}

void Cad(SceneBuilder& scene, int count, LightKind lighting)
{
  RandomNumbers random;
  scene.Floor(12.0);
  const ShapeKind parts[4] = { ShapeKind::Box, ShapeKind::Cylinder, ShapeKind::Globe,
    ShapeKind::Cone };
  for (int i = 0; i < count; ++i)
  {
    const double size = parts[i % 4] == ShapeKind::Globe ? 1.2 : 1.0;
    Prop& part = scene.Add(parts[i % 4], { 0.0, 0.0, 0.0 }, glm::dvec3(size), 40);
    part.Position = random.GetVector({ -4.0, -4.0, 1.0 }, { 4.0, 4.0, 5.0 });
    part.Scale = random.GetVector({ 1.0, 1.0, 1.0 }, { 3.0, 3.0, 3.0 });
    const double angle = random.Get(0.0, 360.0);
    const glm::dvec3 axis = random.GetVector({ -1.0, -1.0, 0.1 }, { 1.0, 1.0, 1.0 });
    vtkNew<vtkTransform> turn;
    turn->RotateWXYZ(angle, glm::value_ptr(axis));
    turn->GetOrientation(glm::value_ptr(part.Orientation));
  }
  LightUp(scene, lighting, { -6.0, -8.0, 14.0 }, { 0.0, 0.0, 2.0 }, 30.0);
  scene.Look({ 10.0, -18.0, 12.0 }, { 0.0, 0.0, 2.0 });
}

void Glyphs(SceneBuilder& scene, int count, LightKind lighting)
{
  RandomNumbers random;
  scene.Floor(12.0, -8.0);
  const int first = scene.GetNumberOfProps();
  for (int i = 0; i < count; ++i)
  {
    Prop& glyph = scene.Sphere({ 0.0, 0.0, 0.0 }, 0.3, 8);
    glyph.MapperOf = i == 0 ? -1 : first;
    glyph.Position = random.GetVector(glm::dvec3(-6.0), glm::dvec3(6.0));
    glyph.Scale = glm::dvec3(random.Get(0.4, 1.4));
  }
  LightUp(scene, lighting, { -8.0, -10.0, 16.0 }, { 0.0, 0.0, 0.0 }, 30.0);
  scene.Look({ 10.0, -24.0, 14.0 }, { 0.0, 0.0, -1.0 });
}

/// Hazard: the lit surface of a caster of 14 km is drawn millimetres off its plane, and must not be
/// in its own shadow.
void VastGround(SceneBuilder& scene)
{
  scene.Floor(7000.0);
  for (int i = 0; i < 12; ++i)
  {
    scene.Box({ 60.0 * (i % 4) + 150.0, 80.0 * (i / 4) + 3200.0, 12.0 }, { 20.0, 20.0, 24.0 });
  }
  scene.Directional({ -0.72, 0.12, -0.68 });
  scene.Look({ 100.0, 2950.0, 160.0 }, { 300.0, 3350.0, 20.0 }, 30.0);
}

}

std::vector<NamedScenario> GetLargeScenarios()
{
  using Builder = void (*)(SceneBuilder&, int, LightKind);
  const struct
  {
    const char* Name;
    Builder Build;
    int Count;
  } scenes[] = { { "City", City, 8 }, { "Birds", Birds, 100 }, { "Cad", Cad, 20 },
    { "Glyphs", Glyphs, 200 } };
  std::vector<NamedScenario> result = { MakeShadowScenario("VastGround", VastGround, 640, 480) };
  for (const auto& scene : scenes)
  {
    for (const LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
    {
      result.push_back(MakeShadowScenario(
        scene.Name + std::string(EnumNames<LightKind>::Get()[static_cast<int>(kind)]),
        [&](SceneBuilder& builder) { scene.Build(builder, scene.Count, kind); }));
    }
  }
  return result;
}
}
