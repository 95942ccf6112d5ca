// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioChanges.h
 * @brief What a scenario says of cameras, and of what changes from frame to frame.
 */
#ifndef ScenarioChanges_h
#define ScenarioChanges_h

#include "ScenarioNames.h"

#include "vtkNBufferGLM.h"

#include <array>
#include <cstddef>
#include <vector>

namespace TestScene
{
/// From this frame on a renderer's camera is this one.
struct View
{
  int Frame = 0;
  int Renderer = 0;
  glm::dvec3 Position = { 0.0, 0.0, 10.0 };
  glm::dvec3 FocalPoint = { 0.0, 0.0, 0.0 };
  glm::dvec3 ViewUp = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  bool Parallel = false;
  double ParallelScale = 1.0;
  double Near = 0.0; ///< Both 0: vtkRenderer::ResetCameraClippingRange.
  double Far = 0.0;
  std::array<double, 2> WindowCenter = { 0.0, 0.0 };
  double EyeAngle = 2.0;
  std::array<double, 2> Stretch = { 1.0, 1.0 }; ///< Of the image; a negative one mirrors it.

  NBUFFER_SCENE_MEMBERS(Frame, Renderer, Position, FocalPoint, ViewUp, ViewAngle, Parallel,
    ParallelScale, Near, Far, WindowCenter, EyeAngle, Stretch);
};

//------------------------------------------------------------------------------------------------
enum class ChangeKind
{
  Position,       ///< Of prop `Target`; 3 values.
  Orientation,    ///< 3 values.
  Scale,          ///< 3 values.
  UserMatrix,     ///< 16 values.
  Color,          ///< 3 values.
  Opacity,        ///< 1 value, as all below that say nothing else.
  Visible,        //
  Representation, //
  LineWidth,      ///< And the size of points.
  Edges,          //
  MovePoints,     ///< Add 3 values to the points of the data, in place; shear x by the fourth, too.
                  ///< All observers of the points are removed before where a fifth is not 0.
  ReplaceData,    ///< Another data set: its size, 3 values; a fourth reverses its points.
  ClippingPlane,  ///< The origin of the plane in place; 3 values.
  Rejoin,         ///< Removed from the renderer and added again, at the end.
  WindowSize,     ///< 2 values.
  MultiSamples,   //
  Stereo,         ///< A stereo type of VTK, or -1.
  NewContext,     ///< The window's context is released.
  Viewport,       ///< Of renderer `Target`; 4 values.
  Pass,           ///< Of renderer `Target`, a value of PassKind.
  FXAA,           ///< Of renderer `Target`.
  SSAO,           ///< Of renderer `Target`.
  CullerEnabled,  //
  CullerBackend,  //
  CullerBaseFactor,
  CullerRoundSize,
  CullerPresent, ///< In the renderers' lists of cullers or not.
  PolygonOffset, ///< VTK's global switch: off, polygon offset, or a shifted z-buffer.
  Select,        ///< A hardware selection of the whole window between two frames.
  Casts,
  BlockVisible,  ///< Of the second block of a composite prop.
  LightPosition, ///< Of light `Target`; 3 values.
  LightFocalPoint,
  LightCone,
  LightOn,
  LightCasts,
  LightAttenuation, ///< ShadowAttenuation.
  ShadowMode,       ///< A value of the enumeration of that name, as all below of Shadows' members.
  LitmapResolution,
  SlabGap,
  CasterKeys,
  BoxCost,
  BlockOpacity ///< Of the second block of a composite prop.
};
NBUFFER_SCENE_NAMES(ChangeKind, "Position", "Orientation", "Scale", "UserMatrix", "Color",
  "Opacity", "Visible", "Representation", "LineWidth", "Edges", "MovePoints", "ReplaceData",
  "ClippingPlane", "Rejoin", "WindowSize", "MultiSamples", "Stereo", "NewContext", "Viewport",
  "Pass", "FXAA", "SSAO", "CullerEnabled", "CullerBackend", "CullerBaseFactor", "CullerRoundSize",
  "CullerPresent", "PolygonOffset", "Select", "Casts", "BlockVisible", "LightPosition",
  "LightFocalPoint", "LightCone", "LightOn", "LightCasts", "LightAttenuation", "ShadowMode",
  "LitmapResolution", "SlabGap", "CasterKeys", "BoxCost", "BlockOpacity");

/// Done before the frame is drawn, in the order of the list.
struct Change
{
  int Frame = 0;
  ChangeKind Kind = ChangeKind::Position;
  int Target = 0;
  std::vector<double> Values; ///< Those that are missing are 0.

  NBUFFER_SCENE_MEMBERS(Frame, Kind, Target, Values);
};

/// The n-th value of a change, or 0.
inline double GetValue(const Change& change, std::size_t n)
{
  return n < change.Values.size() ? change.Values[n] : 0.0;
}
}

#endif
