// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScenes.h"

#include "ShadowShapes.h"

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkCylinderSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <random>

using namespace ShadowShapes;

namespace
{
/// Numbers that are the same with every library.
class Random
{
public:
  double Get(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() % 100001) / 100000.0);
  }

private:
  std::mt19937 Engine{ 1 };
};

/// One light: from above at a slant, a spot or a point light at `position`.
void AddLight(vtkRenderer* renderer, ShadowScenes::Lighting lighting, const Point& position,
  const Point& focalPoint, double cone)
{
  switch (lighting)
  {
    case ShadowScenes::Lighting::Directional:
      AddDirectional(renderer, { 0.6, 0.35, -0.7 });
      break;
    case ShadowScenes::Lighting::Spot:
      AddSpot(renderer, position, focalPoint, cone);
      break;
    case ShadowScenes::Lighting::Point:
      AddPoint(renderer, position);
      break;
  }
}
}

namespace ShadowScenes
{
void City(vtkRenderer* renderer, int side, Lighting lighting)
{
  // Metres: lots of 12, a street of 10 after every second one.
  const auto place = [&](int i) { return 12.0 * (i - side / 2) + 10.0 * (i / 2 - side / 4); };
  Random random;
  AddFloor(renderer, place(side) + 20.0);
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double height = random.Get(6.0, 36.0);
      AddBox(renderer, { place(i) + 6.0, place(j) + 6.0, 0.5 * height },
        { random.Get(8.0, 12.0), random.Get(8.0, 12.0), height });
    }
  }
  // The street between the two halves, x from -10 to 0; the lamp is above the roofs beside it.
  AddLight(renderer, lighting, { -40.0, 5.0, 60.0 }, { -5.0, 5.0, 0.0 }, 40.0);
  Look(renderer, { -6.0, -30.0, 1.8 }, { -4.0, 20.0, 6.0 }, 60.0);
}

void Birds(vtkRenderer* renderer, int count, Lighting lighting)
{
  Random random;
  AddFloor(renderer, 60.0);
  for (int i = 0; i < 12; ++i)
  {
    const double height = random.Get(8.0, 25.0);
    AddBox(renderer, { random.Get(-45.0, 45.0), random.Get(-45.0, 45.0), 0.5 * height },
      { random.Get(3.0, 6.0), random.Get(3.0, 6.0), height });
  }
  for (int i = 0; i < count; ++i)
  {
    AddSphere(renderer,
      { random.Get(-50.0, 50.0), random.Get(-50.0, 50.0), random.Get(10.0, 30.0) },
      random.Get(0.3, 0.9), 10);
  }
  AddLight(renderer, lighting, { -20.0, -10.0, 70.0 }, { 0.0, 0.0, 0.0 }, 40.0);
  Look(renderer, { 20.0, -90.0, 35.0 }, { 0.0, 0.0, 5.0 });
}

void Cad(vtkRenderer* renderer, int count, Lighting lighting)
{
  Random random;
  AddFloor(renderer, 12.0);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(40);
  cylinder->Update();
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(40);
  cone->Update();
  const vtkSmartPointer<vtkPolyData> parts[4] = { MakeBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }),
    cylinder->GetOutput(), MakeSphere({ 0.0, 0.0, 0.0 }, 0.6, 40), cone->GetOutput() };
  for (int i = 0; i < count; ++i)
  {
    vtkActor* actor = AddMesh(renderer, parts[i % 4]);
    actor->SetPosition(random.Get(-4.0, 4.0), random.Get(-4.0, 4.0), random.Get(1.0, 5.0));
    actor->SetScale(random.Get(1.0, 3.0), random.Get(1.0, 3.0), random.Get(1.0, 3.0));
    actor->RotateWXYZ(
      random.Get(0.0, 360.0), random.Get(-1.0, 1.0), random.Get(-1.0, 1.0), random.Get(0.1, 1.0));
  }
  AddLight(renderer, lighting, { -6.0, -8.0, 14.0 }, { 0.0, 0.0, 2.0 }, 30.0);
  Look(renderer, { 10.0, -18.0, 12.0 }, { 0.0, 0.0, 2.0 });
}

void Glyphs(vtkRenderer* renderer, int count, Lighting lighting)
{
  Random random;
  AddFloor(renderer, 12.0, -8.0);
  vtkActor* first = AddSphere(renderer, { 0.0, 0.0, 0.0 }, 0.3, 8);
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkActor> next;
    vtkActor* actor = i == 0 ? first : next.GetPointer();
    actor->SetMapper(first->GetMapper());
    actor->SetPosition(random.Get(-6.0, 6.0), random.Get(-6.0, 6.0), random.Get(-6.0, 6.0));
    actor->SetScale(random.Get(0.4, 1.4));
    renderer->AddActor(actor);
  }
  AddLight(renderer, lighting, { -8.0, -10.0, 16.0 }, { 0.0, 0.0, 0.0 }, 30.0);
  Look(renderer, { 10.0, -24.0, 14.0 }, { 0.0, 0.0, -1.0 });
}

/// Hazard: the lit surface of a caster of 14 km is drawn millimetres off its plane, and must not be
/// in its own shadow.
void VastGround(vtkRenderer* renderer)
{
  AddFloor(renderer, 7000.0);
  for (int i = 0; i < 12; ++i)
  {
    AddBox(
      renderer, { 60.0 * (i % 4) + 150.0, 80.0 * (i / 4) + 3200.0, 12.0 }, { 20.0, 20.0, 24.0 });
  }
  AddDirectional(renderer, { -0.72, 0.12, -0.68 });
  Look(renderer, { 100.0, 2950.0, 160.0 }, { 300.0, 3350.0, 20.0 }, 30.0);
}

std::vector<NamedScene> GetLargeScenes()
{
  using Builder = void (*)(vtkRenderer*, int, Lighting);
  const struct
  {
    const char* Name;
    Builder Build;
    int Count;
  } scenes[] = { { "City", City, 8 }, { "Birds", Birds, 100 }, { "Cad", Cad, 20 },
    { "Glyphs", Glyphs, 200 } };
  const std::pair<const char*, Lighting> lights[] = { { "Directional", Lighting::Directional },
    { "Spot", Lighting::Spot }, { "Point", Lighting::Point } };
  std::vector<NamedScene> result = { { "VastGround", VastGround, 640, 480 } };
  for (const auto& scene : scenes)
  {
    for (const auto& light : lights)
    {
      result.push_back({ std::string(scene.Name) + light.first,
        [build = scene.Build, count = scene.Count, lighting = light.second](vtkRenderer* renderer)
        { build(renderer, count, lighting); } });
    }
  }
  return result;
}
}
