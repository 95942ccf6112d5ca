// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowScenes.h"

#include "ShadowShapes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>
#include <ostream>
#include <stdexcept>

using namespace ShadowShapes;

namespace
{
/// A floor with two boxes and a sphere that shadow it and each other, all of it moved to `o`.
void AddBasics(vtkRenderer* renderer, const Point& o = { 0.0, 0.0, 0.0 })
{
  AddMesh(renderer,
    MakeMesh({ { o[0] - 5.0, o[1] - 5.0, o[2] }, { o[0] + 5.0, o[1] - 5.0, o[2] },
               { o[0] + 5.0, o[1] + 5.0, o[2] }, { o[0] - 5.0, o[1] + 5.0, o[2] } },
      { { 0, 1, 2, 3 } }));
  AddBox(renderer, { o[0] - 1.0, o[1], o[2] + 0.75 }, { 1.0, 1.0, 1.5 });
  AddBox(renderer, { o[0] + 1.0, o[1] + 0.5, o[2] + 0.3 }, { 0.5, 1.5, 0.6 });
  AddSphere(renderer, { o[0] + 0.3, o[1] - 1.2, o[2] + 1.1 }, 0.5);
}

void LookAtBasics(vtkRenderer* renderer, const Point& o = { 0.0, 0.0, 0.0 })
{
  Look(renderer, { o[0] + 3.0, o[1] - 7.0, o[2] + 5.0 }, { o[0] + 0.3, o[1], o[2] + 0.3 });
}

const Point Slanted = { 0.6, 0.35, -0.7 };

//------------------------------------------------------------------------------
// Lights.

void Directional(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddDirectional(renderer, Slanted);
  LookAtBasics(renderer);
}

void Spot(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddSpot(renderer, { -4.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 25.0);
  LookAtBasics(renderer);
}

void PointLight(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddPoint(renderer, { -0.1, 0.2, 2.2 });
  LookAtBasics(renderer);
}

void ManyLights(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddDirectional(renderer, Slanted);
  AddSpot(renderer, { -4.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 }, 25.0);
  AddPoint(renderer, { -0.1, 0.2, 2.2 });
  LookAtBasics(renderer);
}

/// Half a degree above the floor.
void GrazingLight(vtkRenderer* renderer)
{
  AddBasics(renderer);
  const double angle = vtkMath::RadiansFromDegrees(0.5);
  AddDirectional(renderer, { std::cos(angle), 0.1, -std::sin(angle) });
  LookAtBasics(renderer);
}

/// The light runs along a facade, which it just reaches.
void WallAlongLight(vtkRenderer* renderer)
{
  AddFloor(renderer, 6.0);
  AddMesh(renderer,
    MakeMesh({ { -5.0, 2.0, 0.0 }, { 5.0, 2.0, 0.0 }, { 5.0, 2.0, 5.0 }, { -5.0, 2.0, 5.0 } },
      { { 0, 1, 2, 3 } }));
  AddBox(renderer, { -2.0, 1.9, 3.5 }, { 1.0, 0.1, 1.0 });
  AddDirectional(renderer, { 1.0, 0.05, -1.0 });
  Look(renderer, { -1.0, -12.0, 4.0 }, { 0.0, 0.0, 2.0 });
}

/// All of the floor is at one depth of the light.
void LightStraightDown(vtkRenderer* renderer)
{
  AddFloor(renderer, 5.0);
  AddBox(renderer, { -1.0, 0.0, 1.5 }, { 1.0, 1.0, 0.5 });
  AddSphere(renderer, { 1.0, 0.5, 1.0 }, 0.5);
  AddBox(renderer, { 0.5, -1.5, 0.5 }, { 1.0, 1.0, 1.0 });
  AddDirectional(renderer, { 0.0, 0.0, -1.0 });
  LookAtBasics(renderer);
}

const std::array<Point, 4> Tetrahedron = { { { 0.0, 0.0, 3.0 }, { 1.0, 0.0, 1.0 },
  { -0.5, 0.75, 1.0 }, { -0.5, -0.75, 1.0 } } };

/// A point light at a + b + c times the first three corners.
void LightAtTetrahedron(vtkRenderer* renderer, double a, double b, double c)
{
  AddFloor(renderer, 5.0);
  AddMesh(renderer, MakeTetrahedron(Tetrahedron));
  AddBox(renderer, { 1.0, 1.5, 0.5 }, { 0.5, 0.5, 1.0 });
  Point position;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = a * Tetrahedron[0][i] + b * Tetrahedron[1][i] + c * Tetrahedron[2][i];
  }
  AddPoint(renderer, position);
  Look(renderer, { 5.0, -8.0, 6.0 }, { 0.0, 0.0, 0.8 });
}

/// The light is above an upright edge, so that two faces are seen edge-on.
void LightOnEdgeLine(vtkRenderer* renderer)
{
  AddFloor(renderer, 5.0);
  AddBox(renderer, { 0.0, 0.0, 1.0 }, { 2.0, 2.0, 1.0 });
  AddPoint(renderer, { 1.0, 1.0, 4.0 });
  Look(renderer, { 5.0, -8.0, 6.0 }, { 0.0, 0.0, 0.8 });
}

/// Nothing outside of the box is lit.
void LightInsideCaster(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddBox(renderer, { 0.0, 0.5, 2.5 }, { 0.6, 0.6, 0.6 });
  AddPoint(renderer, { 0.1, 0.4, 2.6 });
  LookAtBasics(renderer);
}

/// A closed box around camera, light and casters, lit from inside.
void LightInRoom(vtkRenderer* renderer)
{
  AddMesh(renderer, MakeSharedBox({ 0.0, 0.0, 1.5 }, { 6.0, 6.0, 3.0 }));
  AddBox(renderer, { -0.5, 0.5, 0.4 }, { 1.5, 1.0, 0.8 });
  AddBox(renderer, { -0.5, 0.5, 1.2 }, { 0.2, 0.2, 0.8 });
  AddSphere(renderer, { 1.2, -0.5, 0.6 }, 0.5);
  AddPoint(renderer, { 0.3, -0.2, 2.4 });
  Look(renderer, { 2.6, -2.7, 1.8 }, { -0.5, 0.5, 0.7 }, 70.0);
}

/// A wall on both sides of the plane through the light and across its axis.
void WallAcrossSpotPlane(vtkRenderer* renderer)
{
  AddFloor(renderer, 8.0);
  AddMesh(renderer, MakeSharedBox({ 0.0, 1.0, 2.0 }, { 6.0, 0.2, 4.0 }));
  AddBox(renderer, { 3.0, -0.5, 0.5 }, { 1.0, 1.0, 1.0 });
  AddBox(renderer, { -2.0, 0.0, 1.0 }, { 0.5, 0.5, 2.0 });
  AddSpot(renderer, { 0.0, 0.0, 3.0 }, { 3.0, 0.5, 0.5 }, 65.0);
  Look(renderer, { 6.0, -9.0, 8.0 }, { 1.5, 0.5, 0.5 });
}

/// Spheres in rows under a spot light of this cone, far enough away for narrow ones.
void SpotCone(vtkRenderer* renderer, double height, double cone, double exponent)
{
  AddFloor(renderer, 5.0);
  for (int i = 0; i < 25; ++i)
  {
    AddSphere(renderer, { i % 5 - 2.0, i / 5 - 2.0, 0.6 }, 0.3, 12);
  }
  AddSpot(renderer, { 0.5, 0.3, height }, { 0.0, 0.0, 0.0 }, cone)->SetExponent(exponent);
  Look(renderer, { 2.0, -5.0, 4.0 }, { 0.0, 0.0, 0.3 });
}

//------------------------------------------------------------------------------
// Cameras and windows.

/// One-unit features where maps of the world have them.
void HugeCoordinates(vtkRenderer* renderer)
{
  const Point o = { 5e5, 4e6, 300.0 };
  AddBasics(renderer, o);
  AddDirectional(renderer, Slanted);
  AddPoint(renderer, { o[0] - 0.1, o[1] + 0.2, o[2] + 2.2 });
  LookAtBasics(renderer, o);
}

void ExtremeNearFar(vtkRenderer* renderer)
{
  Directional(renderer);
  renderer->GetActiveCamera()->SetClippingRange(1e-3, 1e5);
}

/// A roof between the light and the camera.
void CameraInShadow(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddBox(renderer, { 0.5, -4.0, 2.5 }, { 3.0, 3.0, 0.2 });
  AddDirectional(renderer, { 0.1, 0.2, -1.0 });
  Look(renderer, { 0.5, -4.0, 1.5 }, { 0.3, 0.0, 0.3 }, 60.0);
}

void NearPlaneInVolume(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddBox(renderer, { 1.5, -3.0, 3.5 }, { 1.0, 1.0, 0.2 });
  AddDirectional(renderer, { 0.1, 0.1, -1.0 });
  LookAtBasics(renderer);
  // The shadow of the box on top begins before the near plane and ends behind it.
  renderer->GetActiveCamera()->SetClippingRange(5.0, 30.0);
}

/// The plane y = 1 bounds the box's shadow.
void EyeOnSidePlane(vtkRenderer* renderer)
{
  AddFloor(renderer, 8.0);
  AddMesh(renderer, MakeSharedBox({ -2.0, 0.0, 2.0 }, { 1.0, 2.0, 1.0 }));
  AddBox(renderer, { -4.0, 1.5, 0.5 }, { 1.0, 1.0, 1.0 });
  AddDirectional(renderer, { 1.0, 0.0, -0.5 });
  Look(renderer, { 1.0, 1.0, 0.5 }, { -4.0, 1.0, 0.3 }, 70.0);
}

void Orbit(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddDirectional(renderer, Slanted);
  ShadowScenes::SetOrbitCamera(renderer, 0.06);
}

void ParallelCamera(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddDirectional(renderer, Slanted);
  AddPoint(renderer, { -0.1, 0.2, 2.2 });
  LookParallel(renderer, { 3.0, -7.0, 5.0 }, { 0.3, 0.0, 0.3 }, 2.5);
}

/// The camera's plane is amid the casters; what is behind it casts into view.
void ParallelCameraAmid(vtkRenderer* renderer)
{
  AddBasics(renderer);
  AddBox(renderer, { -1.0, -3.0, 1.5 }, { 0.5, 0.5, 3.0 });
  AddSphere(renderer, { -3.5, -3.5, 4.0 }, 0.6);
  AddDirectional(renderer, { 0.6, 0.8, -0.7 });
  LookParallel(renderer, { 0.3, -2.0, 1.0 }, { 0.3, 0.0, 0.2 }, 2.0);
}

void Inset(vtkRenderer* renderer)
{
  renderer->SetViewport(0.2, 0.1, 0.9, 0.8);
  Directional(renderer);
}

/// The lower right quarter of a picture twice as large, as vtkWindowToImageFilter renders it.
void Tile(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  window->SetTileScale(2);
  window->SetTileViewport(0.5, 0.0, 1.0, 0.5);
  Directional(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 * std::tan(half))));
  camera->SetWindowCenter(1.0, -1.0);
}
}

void PrintTo(const NamedScene& scene, std::ostream* stream)
{
  *stream << scene.Name;
}

std::vector<NamedScene> GetScenes()
{
  std::vector<NamedScene> result;
  for (const auto& part : { ShadowScenes::GetLightScenes(), ShadowScenes::GetViewScenes(),
         ShadowScenes::GetMeshScenes(), ShadowScenes::GetLargeScenes() })
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

NamedScene GetScene(const std::string& name)
{
  for (const NamedScene& scene : GetScenes())
  {
    if (scene.Name == name)
    {
      return scene;
    }
  }
  throw std::out_of_range("There is no scene " + name + ".");
}

namespace ShadowScenes
{
void SetOrbitCamera(vtkRenderer* renderer, double t)
{
  const double angle = 2.0 * vtkMath::Pi() * t;
  Look(renderer,
    { 2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.7 + 0.3 * std::sin(5.0 * angle) },
    { 0.0, 0.0, 0.4 }, 60.0);
}

std::vector<NamedScene> GetLightScenes()
{
  const auto atTetrahedron = [](double a, double b, double c)
  { return [=](vtkRenderer* renderer) { LightAtTetrahedron(renderer, a, b, c); }; };
  const auto cone = [](double height, double angle, double exponent)
  { return [=](vtkRenderer* renderer) { SpotCone(renderer, height, angle, exponent); }; };
  return {
    { "Directional", Directional },
    { "Spot", Spot },
    { "Point", PointLight },
    { "ManyLights", ManyLights },
    { "GrazingLight", GrazingLight },
    { "WallAlongLight", WallAlongLight },
    { "LightStraightDown", LightStraightDown },
    { "LightAtVertex", atTetrahedron(1.0, 0.0, 0.0) },
    { "LightOnEdge", atTetrahedron(0.5, 0.5, 0.0) },
    { "LightInFace", atTetrahedron(0.5, 0.25, 0.25) },
    { "LightInFacePlane", atTetrahedron(2.0, -0.5, -0.5) },
    { "LightOnEdgeLine", LightOnEdgeLine },
    { "LightInsideCaster", LightInsideCaster },
    { "LightInRoom", LightInRoom },
    { "WallAcrossSpotPlane", WallAcrossSpotPlane },
    { "SpotWide", cone(4.0, 89.9, 1.0) },
    { "SpotNarrow", cone(60.0, 1.0, 1.0) },
    { "SpotExponent", cone(5.0, 30.0, 5.0) },
  };
}

std::vector<NamedScene> GetViewScenes()
{
  return {
    { "HugeCoordinates", HugeCoordinates },
    { "ExtremeNearFar", ExtremeNearFar },
    { "CameraInShadow", CameraInShadow },
    { "NearPlaneInVolume", NearPlaneInVolume },
    { "EyeOnSidePlane", EyeOnSidePlane },
    { "Orbit", Orbit },
    { "ParallelCamera", ParallelCamera },
    { "ParallelCameraAmid", ParallelCameraAmid },
    { "MultiSamples", Directional, 200, 150, 4 },
    { "OddSize", Directional, 641, 479 },
    { "Inset", Inset, 301, 203 },
    { "Tile", Tile },
  };
}
}
