// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScene.h"

#include "Parts.h"
#include "Random.h"
#include "Sun.h"

#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace NBufferBench
{
namespace
{
using NBufferExamples::AddPart;
using NBufferExamples::MakePartMapper;
using NBufferExamples::Random;
using NBufferExamples::Scene;

/// A square slab, its top at height 0.
void AddGround(Scene& scene, vtkPolyDataMapper* box, double side)
{
  AddPart(scene, box, { 0.0, 0.0, -0.5 }, { side, side, 1.0 })
    ->GetProperty()
    ->SetColor(0.62, 0.66, 0.58);
}

vtkSmartPointer<vtkPolyDataMapper> MakeBirdMapper()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(10);
  sphere->SetPhiResolution(10);
  return MakePartMapper(sphere);
}

Scene MakeBirds(std::uint64_t seed)
{
  Scene scene;
  scene.Name = "birds";
  Random random(seed);
  const auto box = MakePartMapper(vtkNew<vtkCubeSource>());
  const auto bird = MakeBirdMapper();
  AddGround(scene, box, 120.0);
  for (int i = 0; i < 12; ++i)
  {
    const double height = random.Between(8.0, 25.0);
    const double x = random.Between(-45.0, 45.0);
    const double y = random.Between(-45.0, 45.0);
    const double width = random.Between(3.0, 6.0);
    AddPart(scene, box, { x, y, 0.5 * height }, { width, random.Between(3.0, 6.0), height });
  }
  for (int i = 0; i < 400; ++i)
  {
    const double x = random.Between(-50.0, 50.0);
    const double y = random.Between(-50.0, 50.0);
    const double z = random.Between(10.0, 30.0);
    const double size = random.Between(0.6, 1.8);
    AddPart(scene, bird, { x, y, z }, glm::dvec3(size));
  }
  return scene;
}

/// Puts 40 towers and a flock of 300 birds onto and over the hills of the scene "terrain".
Scene MakeTowers(Scene scene, std::uint64_t seed)
{
  scene.Name = "towers";
  Random random(seed);
  const auto box = MakePartMapper(vtkNew<vtkCubeSource>());
  const auto bird = MakeBirdMapper();
  vtkPolyData* ground = vtkPolyData::SafeDownCast(scene.Actors[0]->GetMapper()->GetInput());
  for (int i = 0; i < 40; ++i)
  {
    double foot[3];
    ground->GetPoint(random.Index(ground->GetNumberOfPoints()), foot);
    const double height = random.Between(0.15, 0.45);
    AddPart(scene, box, { foot[0], foot[1], foot[2] + 0.5 * height - 0.05 },
      { 0.08, 0.08, height + 0.1 });
  }
  for (int i = 0; i < 300; ++i)
  {
    const double x = random.Between(-3.5, 3.5);
    const double y = random.Between(-3.5, 3.5);
    AddPart(scene, bird, { x, y, random.Between(1.0, 1.6) }, { 0.05, 0.09, 0.02 });
  }
  return scene;
}

Scene MakeSwarm(std::uint64_t seed, int count)
{
  Scene scene;
  scene.Name = "swarm";
  Random random(seed);
  vtkNew<vtkCubeSource> cube;
  AddGround(scene, MakePartMapper(cube), 120.0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    double values[6];
    for (int j = 0; j < 6; ++j)
    {
      // Position, direction.
      values[j] = j < 2 ? random.Between(-50.0, 50.0)
        : j == 2        ? random.Between(2.0, 30.0)
                        : random.Between(-1.0, 1.0);
    }
    points->InsertNextPoint(values);
    directions->InsertNextTuple(values + 3);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->SetVectors(directions);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.3);
  auto glyphs = vtkSmartPointer<vtkActor>::New();
  glyphs->SetMapper(mapper);
  glyphs->GetProperty()->SetColor(0.9, 0.5, 0.2);
  scene.Actors.push_back(glyphs);
  return scene;
}

Scene MakeParts(std::uint64_t seed)
{
  Scene scene;
  scene.Name = "simple";
  Random random(seed);
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(48);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(48);
  const vtkSmartPointer<vtkPolyDataMapper> parts[] = { MakePartMapper(cube),
    MakePartMapper(cylinder), MakePartMapper(sphere), MakePartMapper(cone) };
  AddGround(scene, parts[0], 14.0);
  for (std::size_t i = 0; i < 20; ++i)
  {
    double values[9];
    for (int j = 0; j < 9; ++j)
    {
      // Position, size, axis of rotation.
      values[j] = j < 2 ? random.Between(-4.0, 4.0)
        : j == 2        ? random.Between(1.0, 5.0)
        : j < 6         ? random.Between(1.0, 3.0)
                        : random.Between(-1.0, 1.0);
    }
    vtkActor* actor = AddPart(scene, parts[i % std::size(parts)],
      { values[0], values[1], values[2] }, { values[3], values[4], values[5] });
    actor->RotateWXYZ(random.Between(0.0, 360.0), values[6], values[7], values[8]);
  }
  return scene;
}

vtkSmartPointer<vtkLight> MakeSpot(const NBufferExamples::CameraPath& path, const SpotLamp& lamp)
{
  constexpr double ahead = 20.0; // metres
  const NBufferExamples::CameraPose& pose = path[path.size() / 2];
  glm::dvec3 direction = pose.Target - pose.Eye;
  direction.z = 0.0;
  direction = vtkNBufferGLM::Normalize(direction);
  glm::dvec3 place = pose.Eye + ahead * direction;
  place.z = 0.0;
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(lamp.ConeAngle);
  light->SetExponent(0.0);
  light->SetFocalPoint(glm::value_ptr(place));
  light->SetPosition(glm::value_ptr(place + lamp.Offset));
  return light;
}

/// Returns whether a scene of this name is made here, and not loaded.
bool IsMadeHere(const std::string& name)
{
  return name == "birds" || name == "simple" || name == "swarm" || name == "towers";
}
}

SpotLamp ReadLamp(const std::string& name, const std::vector<double>& numbers)
{
  if (name != "city-spot")
  {
    throw std::runtime_error("a lamp is for the scene city-spot, not for " + name);
  }
  constexpr double rightAngle = 90.0;
  if (numbers.size() != 4 || !std::all_of(numbers.begin(), numbers.end(), vtkMath::IsFinite) ||
    numbers[2] <= 0.0 || numbers[3] <= 0.0 || numbers[3] >= rightAngle)
  {
    throw std::runtime_error(
      "a lamp is x,y,z,cone: metres from the place that it lights, z above 0, "
      "and an angle between 0 and 90 degrees");
  }
  return { { numbers[0], numbers[1], numbers[2] }, numbers[3] };
}

vtkLight* LightScene(const std::string& name, const Scene& scene,
  const NBufferExamples::CameraPath& path, vtkRenderer* renderer, const SpotLamp& lamp)
{
  NBufferExamples::LightGround(scene);
  const vtkSmartPointer<vtkLight> light =
    name == "city-spot" ? MakeSpot(path, lamp) : NBufferExamples::MakeSun({}, scene.UpAxis);
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  return light;
}

vtkSmartPointer<vtkInformation> MarkCasters(const Scene& scene)
{
  // The parts of one prop (--merge) cannot be distinguished either.
  const bool isOneProp = scene.Actors.size() == 1;
  if ((!scene.Plan && !IsMadeHere(scene.Name)) || isOneProp)
  {
    return nullptr;
  }
  static auto* const key = vtkInformationIntegerKey::MakeKey("CASTS", "NBufferBench");
  const auto makeKeys = []()
  {
    auto keys = vtkSmartPointer<vtkInformation>::New();
    keys->Set(key, 1);
    return keys;
  };
  // The ground is the first actor of scenes made here; in a city it follows the buildings.
  const std::size_t first = scene.Plan ? 0 : 1;
  const std::size_t end = scene.Plan ? scene.Plan->Buildings.size() : scene.Actors.size();
  for (std::size_t i = first; i < end; ++i)
  {
    // Of its own: render passes write themselves into it, once for each prop.
    scene.Actors[i]->SetPropertyKeys(makeKeys());
  }
  return makeKeys();
}

NBufferExamples::Scene LoadShadowScene(ViewOptions view)
{
  const std::string name = view.SceneNames.size() == 1 ? view.SceneNames[0] : "";
  const bool hasOptions = view.SplitRegions || !view.Merge.empty() || view.Shuffle || view.Edges ||
    view.Points > 0 || view.Props > 0 || (view.Instances > 0 && name != "swarm");
  if (IsMadeHere(name) && hasOptions)
  {
    throw std::runtime_error("the scene " + name +
      " cannot be changed by --split, --merge, --shuffle, --edges, --points, --instances (of swarm "
      "it can) or --props");
  }
  if (name == "birds" || name == "simple")
  {
    return name == "birds" ? MakeBirds(view.Seed) : MakeParts(view.Seed);
  }
  if (name == "swarm")
  {
    constexpr int usualInstances = 10000;
    return MakeSwarm(view.Seed, view.Instances > 0 ? view.Instances : usualInstances);
  }
  if (name == "city-sun" || name == "city-spot")
  {
    view.SceneNames = { "city" };
  }
  if (name == "towers")
  {
    view.SceneNames = { "terrain" };
    return MakeTowers(view.LoadScene(), view.Seed);
  }
  return view.LoadScene();
}

} // namespace NBufferBench
