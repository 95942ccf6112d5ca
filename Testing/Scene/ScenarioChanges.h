// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScenarioChanges.h
 * @brief The cameras of a scenario, and its changes from frame to frame.
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
/// The camera of a renderer from a frame on.
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
  ///@{
  /// The clipping range. If both are 0, vtkRenderer::ResetCameraClippingRange() computes it.
  double Near = 0.0;
  double Far = 0.0;
  ///@}
  std::array<double, 2> WindowCenter = { 0.0, 0.0 };
  double EyeAngle = 2.0;
  /// The factors by which the image is stretched in x and y; a negative one mirrors it.
  std::array<double, 2> Stretch = { 1.0, 1.0 };

  NBUFFER_SCENE_MEMBERS(Frame, Renderer, Position, FocalPoint, ViewUp, ViewAngle, Parallel,
    ParallelScale, Near, Far, WindowCenter, EyeAngle, Stretch);
};

//------------------------------------------------------------------------------------------------
/// What a change sets. It has one value, and `Target` is the Id of a prop, or the number of a light
/// for those that begin with Light, unless a comment says otherwise. Switches are 0 or 1.
enum class ChangeKind
{
  Position,       ///< 3 values.
  Orientation,    ///< 3 values.
  Scale,          ///< 3 values.
  UserMatrix,     ///< 16 values.
  Color,          ///< 3 values.
  Opacity,        //
  Visible,        //
  Representation, //
  LineWidth,      ///< The size of points gets the same value.
  Edges,          //
  MovePoints,    ///< Adds values 0 to 2 to the points of the data, in place, and value 3 times z to
                 ///< x. If value 4 is not 0, all observers of the points are removed first. Of a
                 ///< composite prop it moves the second block, and modifies no other object.
  ReplaceData,   ///< Replaces the data by a shape of another size (values 0 to 2). If value 3 is
                 ///< not 0, its points have the reverse order.
  ClippingPlane, ///< Moves the origin of the plane, in place; 3 values.
  Rejoin,        ///< Removes the prop from the renderer and adds it again, at the end of the list.
  WindowSize,    ///< Width and height in pixels; no target.
  MultiSamples,  ///< No target.
  Stereo,        ///< A stereo type of VTK, or -1 for none; no target.
  NewContext,    ///< Releases the window's context; no value and no target.
  Viewport,      ///< Of renderer `Target`; 4 values.
  Pass,          ///< Of renderer `Target`, a value of PassKind.
  FXAA,          ///< Of renderer `Target`.
  SSAO,          ///< Of renderer `Target`.
  CullerEnabled, ///< As the next four, of all cullers.
  CullerBackend, //
  CullerBaseFactor,
  CullerRoundSize,
  CullerPresent,   ///< Whether the cullers are in the renderers' lists of cullers.
  PolygonOffset,   ///< VTK's global switch: 0 off, 1 polygon offset, 2 shifted z-buffer; no target.
  Select,          ///< Makes a hardware selection of the whole window; no value and no target.
  Casts,           ///< Whether the prop has the key of Shadows::CasterKeys.
  BlockVisible,    ///< Of the second block of a composite prop.
  LightPosition,   ///< 3 values.
  LightFocalPoint, ///< 3 values.
  LightCone,
  LightOn,
  LightCasts,
  LightAttenuation, ///< Light::ShadowAttenuation.
  ShadowMode,       ///< As the next four, a member of Shadows; no target.
  LitmapResolution,
  SlabGap,
  CasterKeys,
  BoxCost,
  BlockOpacity, ///< Of the second block of a composite prop.
  CulledFaces,  ///< As Prop::CulledFaces.
  MarkedCells,  ///< How many cells, from the first on, are selected; how transparent they are.
  Erase,        ///< Of renderer `Target`.
  PreserveDepth ///< Of renderer `Target`.
};
NBUFFER_SCENE_NAMES(ChangeKind, "Position", "Orientation", "Scale", "UserMatrix", "Color",
  "Opacity", "Visible", "Representation", "LineWidth", "Edges", "MovePoints", "ReplaceData",
  "ClippingPlane", "Rejoin", "WindowSize", "MultiSamples", "Stereo", "NewContext", "Viewport",
  "Pass", "FXAA", "SSAO", "CullerEnabled", "CullerBackend", "CullerBaseFactor", "CullerRoundSize",
  "CullerPresent", "PolygonOffset", "Select", "Casts", "BlockVisible", "LightPosition",
  "LightFocalPoint", "LightCone", "LightOn", "LightCasts", "LightAttenuation", "ShadowMode",
  "LitmapResolution", "SlabGap", "CasterKeys", "BoxCost", "BlockOpacity", "CulledFaces",
  "MarkedCells", "Erase", "PreserveDepth");

/// A change before a frame is drawn. Changes of one frame are applied in the order of the list.
struct Change
{
  int Frame = 0;
  ChangeKind Kind = ChangeKind::Position;
  int Target = 0;
  std::vector<double> Values; ///< Missing values count as 0.

  NBUFFER_SCENE_MEMBERS(Frame, Kind, Target, Values);
};

/// Returns value n of a change, from 0 on, or 0 if it is missing.
inline double GetValue(const Change& change, std::size_t n)
{
  return n < change.Values.size() ? change.Values[n] : 0.0;
}
}

#endif
