// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenario.h
 * @brief Some frames of a scene as plain data, which can be made from a seed, written as JSON, and
 * played several times.
 *
 * A member that has its default is left out of the file, so that the defaults, like the names, are
 * part of the format. Every combination of values can be played: what refers to something that does
 * not exist is ignored. The shrinker (Shrinker.h) relies on both.
 *
 * A member with the name of a property of VTK or of the module has its meaning and its unit.
 */
#ifndef Scenario_h
#define Scenario_h

#include "ScenarioChanges.h"
#include "ScenarioProps.h"
#include "ScenarioWindow.h"

#include <cstdint>
#include <string>
#include <vector>

namespace TestScene
{
enum class LightKind
{
  Directional,
  Spot,
  Point,
  Headlight,
  Camera ///< A directional light that moves with the camera; in its coordinates.
};
NBUFFER_SCENE_NAMES(LightKind, "Directional", "Spot", "Point", "Headlight", "Camera");

/// A light. Each renderer gets its own copy.
struct Light
{
  LightKind Kind = LightKind::Directional;
  glm::dvec3 Position = { 3.0, 8.0, 5.0 };
  glm::dvec3 FocalPoint = { 0.0, 0.0, 0.0 };
  double ConeAngle = 40.0; ///< From the axis to the edge, in degrees; for spots only.
  double Exponent = 0.0;   ///< For spots only.
  glm::dvec3 Attenuation = { 1.0, 0.0, 0.0 };
  glm::dvec3 Color = { 1.0, 1.0, 1.0 };
  double Intensity = 0.7;
  bool On = true;
  bool Casts = true; ///< vtkShadowVolumeClampPass::SetLightCasts
  double ShadowAttenuation = 1.0;

  NBUFFER_SCENE_MEMBERS(Kind, Position, FocalPoint, ConeAngle, Exponent, Attenuation, Color,
    Intensity, On, Casts, ShadowAttenuation);
};

enum class ShadowMode
{
  Unclamped,
  Scissored,
  Clamped,
  Automatic,
  Culled ///< Last, since recorded changes hold the numbers of the others.
};
NBUFFER_SCENE_NAMES(ShadowMode, "Unclamped", "Scissored", "Clamped", "Automatic", "Culled");

/// Properties of vtkShadowVolumeClampPass of the same names, and how it is used.
struct Shadows
{
  ShadowMode Mode = ShadowMode::Scissored;
  int LitmapResolution = 256;
  int SlabGap = 4;
  int BoxCost = 256;
  bool CasterKeys = false;  ///< Only props with Prop::Casts cast.
  bool OneForAll = false;   ///< Renderers share one pass object.
  bool CompareRays = false; ///< One frame is compared with rays in double precision, too.

  NBUFFER_SCENE_MEMBERS(
    Mode, LitmapResolution, SlabGap, BoxCost, CasterKeys, OneForAll, CompareRays);
};

struct Scenario
{
  std::uint64_t Seed = 0;
  std::string Family; ///< The name of the generator's family, or of the hazard; for reports.
  int Frames = 1;
  TestScene::Window Window;
  std::vector<TestScene::Renderer> Renderers = std::vector<TestScene::Renderer>(1);
  TestScene::Culler Culler;
  TestScene::Shadows Shadows;
  std::vector<TestScene::Light> Lights; ///< If there are none, VTK makes its headlight.
  std::vector<TestScene::Prop> Props;   ///< In the order in which they join the renderers.
  std::vector<TestScene::View> Views;
  std::vector<TestScene::Change> Changes;

  NBUFFER_SCENE_MEMBERS(
    Seed, Family, Frames, Window, Renderers, Culler, Shadows, Lights, Props, Views, Changes);
};
}

#endif
