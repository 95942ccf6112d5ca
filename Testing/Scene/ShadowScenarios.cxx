// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NamedScenarios.h"

#include "SceneBuilder.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>

namespace TestScene
{
namespace
{
/// A floor with two boxes and a sphere that shadow it and each other, all of it moved to `o`.
void AddBasics(SceneBuilder& scene, const glm::dvec3& o = { 0.0, 0.0, 0.0 })
{
  scene.Sheet(o - glm::dvec3(5.0, 5.0, 0.0), { 10.0, 0.0, 0.0 }, { 0.0, 10.0, 0.0 });
  scene.Box({ o[0] - 1.0, o[1], o[2] + 0.75 }, { 1.0, 1.0, 1.5 });
  scene.Box({ o[0] + 1.0, o[1] + 0.5, o[2] + 0.3 }, { 0.5, 1.5, 0.6 });
  scene.Sphere({ o[0] + 0.3, o[1] - 1.2, o[2] + 1.1 }, 0.5);
}

void LookAtBasics(SceneBuilder& scene, const glm::dvec3& o = { 0.0, 0.0, 0.0 })
{
  scene.Look({ o[0] + 3.0, o[1] - 7.0, o[2] + 5.0 }, { o[0] + 0.3, o[1], o[2] + 0.3 });
}

const glm::dvec3 Slanted = { 0.6, 0.35, -0.7 };

//------------------------------------------------------------------------------
// Lights.

void Directional(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Directional(Slanted);
  LookAtBasics(scene);
}

/// The light runs along a facade, which it just reaches.
void WallAlongLight(SceneBuilder& scene)
{
  scene.Floor(6.0);
  scene.Sheet({ -5.0, 2.0, 0.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.0, 5.0 });
  scene.Box({ -2.0, 1.9, 3.5 }, { 1.0, 0.1, 1.0 });
  scene.Directional({ 1.0, 0.05, -1.0 });
  scene.Look({ -1.0, -12.0, 4.0 }, { 0.0, 0.0, 2.0 });
}

/// The whole floor has the same light depth.
void LightStraightDown(SceneBuilder& scene)
{
  scene.Floor(5.0);
  scene.Box({ -1.0, 0.0, 1.5 }, { 1.0, 1.0, 0.5 });
  scene.Sphere({ 1.0, 0.5, 1.0 }, 0.5);
  scene.Box({ 0.5, -1.5, 0.5 }, { 1.0, 1.0, 1.0 });
  scene.Directional({ 0.0, 0.0, -1.0 });
  LookAtBasics(scene);
}

const std::array<glm::dvec3, 4> Tetrahedron = { { { 0.0, 0.0, 3.0 }, { 1.0, 0.0, 1.0 },
  { -0.5, 0.75, 1.0 }, { -0.5, -0.75, 1.0 } } };

/// A point light at a + b + c times the first three corners.
void LightAtTetrahedron(SceneBuilder& scene, double a, double b, double c)
{
  scene.Floor(5.0);
  scene.Mesh({ Tetrahedron.begin(), Tetrahedron.end() },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  scene.Box({ 1.0, 1.5, 0.5 }, { 0.5, 0.5, 1.0 });
  scene.PointLight(a * Tetrahedron[0] + b * Tetrahedron[1] + c * Tetrahedron[2]);
  scene.Look({ 5.0, -8.0, 6.0 }, { 0.0, 0.0, 0.8 });
}

/// The light is above an upright edge, so that two faces are seen edge-on.
void LightOnEdgeLine(SceneBuilder& scene)
{
  scene.Floor(5.0);
  scene.Box({ 0.0, 0.0, 1.0 }, { 2.0, 2.0, 1.0 });
  scene.PointLight({ 1.0, 1.0, 4.0 });
  scene.Look({ 5.0, -8.0, 6.0 }, { 0.0, 0.0, 0.8 });
}

/// Nothing outside of the box is lit.
void LightInsideCaster(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Box({ 0.0, 0.5, 2.5 }, { 0.6, 0.6, 0.6 });
  scene.PointLight({ 0.1, 0.4, 2.6 });
  LookAtBasics(scene);
}

/// A closed box around camera, light and casters, lit from inside.
void LightInRoom(SceneBuilder& scene)
{
  scene.Add(ShapeKind::SharedBox, { 0.0, 0.0, 1.5 }, { 6.0, 6.0, 3.0 });
  scene.Box({ -0.5, 0.5, 0.4 }, { 1.5, 1.0, 0.8 });
  scene.Box({ -0.5, 0.5, 1.2 }, { 0.2, 0.2, 0.8 });
  scene.Sphere({ 1.2, -0.5, 0.6 }, 0.5);
  scene.PointLight({ 0.3, -0.2, 2.4 });
  scene.Look({ 2.6, -2.7, 1.8 }, { -0.5, 0.5, 0.7 }, 70.0);
}

/// A wall on both sides of the plane through the light and across its axis.
void WallAcrossSpotPlane(SceneBuilder& scene)
{
  scene.Floor(8.0);
  scene.Add(ShapeKind::SharedBox, { 0.0, 1.0, 2.0 }, { 6.0, 0.2, 4.0 });
  scene.Box({ 3.0, -0.5, 0.5 }, { 1.0, 1.0, 1.0 });
  scene.Box({ -2.0, 0.0, 1.0 }, { 0.5, 0.5, 2.0 });
  scene.Spot({ 0.0, 0.0, 3.0 }, { 3.0, 0.5, 0.5 }, 65.0);
  scene.Look({ 6.0, -9.0, 8.0 }, { 1.5, 0.5, 0.5 });
}

/// Spheres in rows under a spot light of this cone, far enough away for narrow ones.
void SpotCone(SceneBuilder& scene, double height, double cone, double exponent)
{
  scene.Floor(5.0);
  for (int i = 0; i < 25; ++i)
  {
    scene.Sphere({ i % 5 - 2.0, i / 5 - 2.0, 0.6 }, 0.3, 12);
  }
  scene.Spot({ 0.5, 0.3, height }, { 0.0, 0.0, 0.0 }, cone).Exponent = exponent;
  scene.Look({ 2.0, -5.0, 4.0 }, { 0.0, 0.0, 0.3 });
}

//------------------------------------------------------------------------------
// Cameras and windows.

/// Features one unit in size, at coordinates as large as in maps of the world.
void HugeCoordinates(SceneBuilder& scene)
{
  const glm::dvec3 o = { 5e5, 4e6, 300.0 };
  AddBasics(scene, o);
  scene.Directional(Slanted);
  scene.PointLight({ o[0] - 0.1, o[1] + 0.2, o[2] + 2.2 });
  LookAtBasics(scene, o);
}

void ExtremeNearFar(SceneBuilder& scene)
{
  Directional(scene);
  scene.Scene.Views[0].Near = 1e-3;
  scene.Scene.Views[0].Far = 1e5;
}

/// A roof between the light and the camera.
void CameraInShadow(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Box({ 0.5, -4.0, 2.5 }, { 3.0, 3.0, 0.2 });
  scene.Directional({ 0.1, 0.2, -1.0 });
  scene.Look({ 0.5, -4.0, 1.5 }, { 0.3, 0.0, 0.3 }, 60.0);
}

void NearPlaneInVolume(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Box({ 1.5, -3.0, 3.5 }, { 1.0, 1.0, 0.2 });
  scene.Directional({ 0.1, 0.1, -1.0 });
  LookAtBasics(scene);
  // The shadow of the box on top begins before the near plane and ends behind it.
  scene.Scene.Views[0].Near = 5.0;
  scene.Scene.Views[0].Far = 30.0;
}

/// The plane y = 1 bounds the box's shadow.
void EyeOnSidePlane(SceneBuilder& scene)
{
  scene.Floor(8.0);
  scene.Add(ShapeKind::SharedBox, { -2.0, 0.0, 2.0 }, { 1.0, 2.0, 1.0 });
  scene.Box({ -4.0, 1.5, 0.5 }, { 1.0, 1.0, 1.0 });
  scene.Directional({ 1.0, 0.0, -0.5 });
  scene.Look({ 1.0, 1.0, 0.5 }, { -4.0, 1.0, 0.3 }, 70.0);
}

void Orbit(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Directional(Slanted);
  const double angle = 0.12 * vtkMath::Pi();
  scene.Look({ 2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.7 + 0.3 * std::sin(5.0 * angle) },
    { 0.0, 0.0, 0.4 }, 60.0);
}

void ParallelCamera(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Directional(Slanted);
  scene.PointLight({ -0.1, 0.2, 2.2 });
  scene.LookParallel({ 3.0, -7.0, 5.0 }, { 0.3, 0.0, 0.3 }, 2.5);
}

/// The camera is amid the casters; those behind it cast shadows into the view.
void AmidCasters(SceneBuilder& scene)
{
  AddBasics(scene);
  scene.Box({ -1.0, -3.0, 1.5 }, { 0.5, 0.5, 3.0 });
  scene.Sphere({ -3.5, -3.5, 4.0 }, 0.6);
  scene.LookParallel({ 0.3, -2.0, 1.0 }, { 0.3, 0.0, 0.2 }, 2.0);
}

void ParallelCameraAmid(SceneBuilder& scene)
{
  AmidCasters(scene);
  scene.Directional({ 0.6, 0.8, -0.7 });
}

/// The near plane cuts casters, and the camera looks along the light, so that it sees the sides of
/// volumes edge-on; almost so, if `tilt` is not 0.
void ParallelCameraAlongLight(SceneBuilder& scene, double tilt)
{
  scene.Floor(6.0);
  scene.Box({ -1.0, 2.0, 1.0 }, { 1.0, 1.0, 2.0 });
  scene.Sphere({ 1.0, 1.0, 1.0 }, 0.6);
  scene.Box({ -1.2, -2.0, 1.1 }, { 0.6, 1.0, 0.5 }); // the near plane cuts it
  scene.Sphere({ 0.6, -2.2, 1.6 }, 0.4);
  scene.Sheet({ 0.2, -4.0, 0.3 }, { 0.8, 0.0, 0.1 }, { 0.1, 0.0, 0.6 }); // before the near plane
  scene.Sheet({ -5.0, 4.0, 0.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.5, 5.0 });
  scene.Directional({ tilt, 1.0, 0.0 });
  View& view = scene.LookParallel({ 0.0, -10.0, 1.0 }, { 0.0, 0.0, 1.0 }, 2.2);
  view.Near = 8.0;
  view.Far = 20.0;
}

void Inset(SceneBuilder& scene)
{
  scene.Scene.Renderers[0].Viewport = { 0.2, 0.1, 0.9, 0.8 };
  Directional(scene);
}

/// The lower right quarter of a picture twice as large, as vtkWindowToImageFilter renders it.
void SetTile(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  window->SetTileScale(2);
  window->SetTileViewport(0.5, 0.0, 1.0, 0.5);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 * std::tan(half))));
  camera->SetWindowCenter(1.0, -1.0);
}
}

NamedScenario MakeShadowScenario(const std::string& name,
  const std::function<void(SceneBuilder&)>& build, int width, int height, int multiSamples)
{
  SceneBuilder scene;
  scene.UsesDoubles = true;
  scene.Scene.Family = name;
  scene.Scene.Window.Width = width;
  scene.Scene.Window.Height = height;
  scene.Scene.Window.MultiSamples = multiSamples;
  build(scene);
  return { name, scene.Scene };
}

std::vector<NamedScenario> GetLightScenarios()
{
  const auto ofBasics = [](const std::function<void(SceneBuilder&)>& light)
  {
    return [light](SceneBuilder& scene)
    {
      AddBasics(scene);
      light(scene);
      LookAtBasics(scene);
    };
  };
  const auto atTetrahedron = [](double a, double b, double c)
  { return [=](SceneBuilder& scene) { LightAtTetrahedron(scene, a, b, c); }; };
  const auto cone = [](double height, double angle, double exponent)
  { return [=](SceneBuilder& scene) { SpotCone(scene, height, angle, exponent); }; };
  return {
    MakeShadowScenario("Directional", Directional),
    MakeShadowScenario("Spot",
      ofBasics(
        [](SceneBuilder& scene) {
          scene.Spot({ -4.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 25.0);
        })),
    MakeShadowScenario("Point",
      ofBasics(
        [](SceneBuilder& scene) {
          scene.PointLight({ -0.1, 0.2, 2.2 });
        })),
    MakeShadowScenario("ManyLights",
      ofBasics(
        [](SceneBuilder& scene)
        {
          scene.Directional(Slanted);
          scene.Spot({ -4.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 25.0);
          scene.PointLight({ -0.1, 0.2, 2.2 });
        })),
    // Half a degree above the floor.
    MakeShadowScenario("GrazingLight",
      ofBasics(
        [](SceneBuilder& scene)
        {
          const double angle = vtkMath::RadiansFromDegrees(0.5);
          scene.Directional({ std::cos(angle), 0.1, -std::sin(angle) });
        })),
    MakeShadowScenario("WallAlongLight", WallAlongLight),
    MakeShadowScenario("LightStraightDown", LightStraightDown),
    MakeShadowScenario("LightAtVertex", atTetrahedron(1.0, 0.0, 0.0)),
    MakeShadowScenario("LightOnEdge", atTetrahedron(0.5, 0.5, 0.0)),
    MakeShadowScenario("LightInFace", atTetrahedron(0.5, 0.25, 0.25)),
    MakeShadowScenario("LightInFacePlane", atTetrahedron(2.0, -0.5, -0.5)),
    MakeShadowScenario("LightOnEdgeLine", LightOnEdgeLine),
    MakeShadowScenario("LightInsideCaster", LightInsideCaster),
    MakeShadowScenario("LightInRoom", LightInRoom),
    MakeShadowScenario("WallAcrossSpotPlane", WallAcrossSpotPlane),
    MakeShadowScenario("SpotWide", cone(4.0, 89.9, 1.0)),
    MakeShadowScenario("SpotNarrow", cone(60.0, 1.0, 1.0)),
    MakeShadowScenario("SpotExponent", cone(5.0, 30.0, 5.0)),
  };
}

std::vector<NamedScenario> GetViewScenarios()
{
  NamedScenario tile = MakeShadowScenario("Tile", Directional);
  tile.Finish = SetTile;
  const auto parallel = [](double x, double y, double z)
  {
    return [=](SceneBuilder& scene)
    {
      AmidCasters(scene);
      scene.PointLight({ x, y, z });
    };
  };
  const auto along = [](double tilt)
  { return [=](SceneBuilder& scene) { ParallelCameraAlongLight(scene, tilt); }; };
  return {
    MakeShadowScenario("HugeCoordinates", HugeCoordinates),
    MakeShadowScenario("ExtremeNearFar", ExtremeNearFar),
    MakeShadowScenario("CameraInShadow", CameraInShadow),
    MakeShadowScenario("NearPlaneInVolume", NearPlaneInVolume),
    MakeShadowScenario("EyeOnSidePlane", EyeOnSidePlane),
    MakeShadowScenario("Orbit", Orbit),
    MakeShadowScenario("ParallelCamera", ParallelCamera),
    MakeShadowScenario("ParallelCameraAmid", ParallelCameraAmid),
    MakeShadowScenario("ParallelLightBefore", parallel(0.4, 3.0, 1.5)),
    MakeShadowScenario("ParallelLightBehind", parallel(-1.5, -6.0, 3.0)),
    MakeShadowScenario("ParallelLightBeside", parallel(5.0, -1.0, 2.0)),
    MakeShadowScenario("ParallelLightAmid", parallel(-0.6, -1.9, 1.6)),
    MakeShadowScenario("ParallelAlongLight", along(0.0)),
    MakeShadowScenario("ParallelAlmostAlongLight", along(1e-7)),
    MakeShadowScenario("MultiSamples", Directional, 200, 150, 4),
    MakeShadowScenario("OddSize", Directional, 641, 479),
    MakeShadowScenario("Inset", Inset, 301, 203),
    tile,
  };
}
}
