// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief The scenes that several image tests share. What is random has fixed seeds, so that both
 * stages of a comparison get the same scene.
 */
#ifndef Scenes_h
#define Scenes_h

#include "CullerTest.h"
#include "SceneBuilder.h"
#include "Shapes.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace Scenes
{
using TestScene::MakeBox;
using TestScene::Wall;

/// Returns the colour for the prop of this index.
void GetColor(int index, double color[3]);

/// Adds a box with this centre and this size. Returns its index in Stage::Props.
int AddBox(Stage& stage, double x, double y, double z, double sx, double sy, double sz,
  vtkRenderer* renderer = nullptr);

/// Makes an actor of two blocks, which have the flat indices 1 and 2.
vtkSmartPointer<vtkActor> MakeTwoBlocks(
  vtkDataObject* first, vtkDataObject* second, double opacityOfSecond = 1.0);

///@{
/// Add the wall scene: a wall at z = 0 across most of the view, and boxes behind it and before it
/// (TestScene::Wall). BuildWall() also sets the camera.
void BuildWall(Stage& stage);
void AddWall(Stage& stage, vtkRenderer* renderer);
///@}

/// Looks at the wall scene from (0, 0, 20), moved sideways by `shift`.
void SetWallCamera(vtkRenderer* renderer, double shift = 0.0);

///@{
/// Do so in both stages. FrameOfWall() also renders and compares a frame.
void MoveWallCamera(Comparison& comparison, double shift);
void FrameOfWall(Comparison& comparison, double shift, const std::string& what = "");
///@}

/// Renders and compares a frame of the wall scene for each of these shifts of the camera.
void FramesOfWall(Comparison& comparison, std::initializer_list<double> shifts);

///@{
/// Do so, and expect in each frame that the culler hides at least so many props, or that it steps
/// aside with this decision and hides none.
void ExpectFramesOfWall(Comparison& comparison, std::initializer_list<double> shifts, int hidden);
void ExpectStepsAside(
  Comparison& comparison, std::initializer_list<double> shifts, Decision decision);
///@}

/// Adds eight translucent boxes on both sides of the wall.
void AddTranslucentBoxes(Stage& stage);

/// Replaces all lights by a spot above and before the wall, with a cone angle of 60 degrees.
void SetSpotLight(Stage& stage);

/// Adds a city: a ground, and `count` x `count` blocks with streets between them, each an actor.
void BuildCity(Stage& stage, int count = 14, vtkRenderer* renderer = nullptr);

///@{
/// Walk along a street of the city at eye height, looking around, with t in [0, 1].
/// MoveCityCamera() does so in both stages, and FrameOfCity() also renders and compares a frame.
void SetCityCamera(vtkRenderer* renderer, double t);
void MoveCityCamera(Comparison& comparison, double t);
void FrameOfCity(Comparison& comparison, double t, const std::string& what = "");
///@}

/// Adds a rectangle in a plane z = const, of cells x cells quads. It is unlit, so that only its
/// colour distinguishes it from others. Returns its index in Stage::Props.
int AddQuad(Stage& stage, double x0, double y0, double x1, double y1, double z, int cells = 1);

/// Compares frames of quads that overlap at exactly equal depths (SceneBuilder::AddTies()), while a
/// door before them moves. `set` changes the scene beforehand. Returns how many props were drawn
/// once more to restore the order of equal depths.
int MoveTheDoorBeforeTies(unsigned int seed, int frames, const Comparison::Change& set,
  ComparisonOptions options = ComparisonOptions());

/// Returns options that make every verdict predictable: only vtkNBufferCuller, which tests in every
/// frame, however few props there are. The texels of level 0 are `baseFactor` pixels wide and high.
ComparisonOptions MakeExactOptions(int width, int height, int baseFactor = 1);

/// Sets a parallel camera in which a unit of x and y is a pixel of a viewport of this size, (0, 0)
/// is its lower left corner, and z from 99 to -101 becomes a window depth from 0 to 1.
void SetPixelCamera(
  vtkRenderer* renderer, int width, int height, double shiftX = 0.0, double shiftY = 0.0);

/// Gives the window depth of a format of vtkTextureObject. VTK's render windows have depth of 32
/// bits, or of 24 with stencil, and no switch for others: another texture takes the place of the
/// one in the render framebuffer. The size of the window must not change afterwards.
void SetDepthFormat(Stage& stage, int format);

/// Expects that the culler has warned once, and that the messages contain each of the words.
void ExpectOneWarning(const std::string& messages, const std::vector<std::string>& words);

/// Compares four frames of a scene with the camera of the wall scene. Expects that the culler draws
/// everything in view in each of them, with the decision `failure`, and that it warns only once,
/// with all of the words.
void ExpectFailure(const Comparison::Change& build, ComparisonOptions options, Decision failure,
  const std::vector<std::string>& words);

/// Compares four frames without changes. The first one draws some props untested, as occluders;
/// afterwards all of them have been tested, and the hidden ones are held back.
void Settle(Comparison& comparison);
}

#endif
