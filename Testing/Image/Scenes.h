// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Scenes.h
 * @brief The scenes that several image tests share. Seeded, so that both stages get the same.
 */
#ifndef Scenes_h
#define Scenes_h

#include "CullerTest.h"
#include "SceneBuilder.h"
#include "Shapes.h"

#include <string>
#include <vector>

namespace Scenes
{
using TestScene::MakeBox;
using TestScene::Wall;

/// A colour that differs from prop to prop.
void GetColor(int index, double color[3]);

/// Add a box of its own colour; returns its index in Stage::Props.
int AddBox(Stage& stage, double x, double y, double z, double sx, double sy, double sz,
  vtkRenderer* renderer = nullptr);

/// An actor of two blocks, which have the flat indices 1 and 2; the second may be translucent.
vtkSmartPointer<vtkActor> MakeTwoBlocks(
  vtkDataObject* first, vtkDataObject* second, double opacityOfSecond = 1.0);

/// A wall at z = 0 across most of the view, boxes behind and before it, camera at (0, 0, 20).
void BuildWall(Stage& stage);
void AddWall(Stage& stage, vtkRenderer* renderer);

/// The wall scene's camera, moved a little sideways.
void SetWallCamera(vtkRenderer* renderer, double shift = 0.0);

/// The same in both stages; FrameOfWall() renders and compares them, too.
void MoveWallCamera(Comparison& comparison, double shift);
void FrameOfWall(Comparison& comparison, double shift, const std::string& what = "");

/// Eight translucent boxes on both sides of that wall.
void AddTranslucentBoxes(Stage& stage);

/// One light instead of all others: a spot of 60 degrees above and before that wall.
void SetSpotLight(Stage& stage);

/// Streets of blocks, `count` x `count`, each an actor of its own, on a ground.
void BuildCity(Stage& stage, int count = 14, vtkRenderer* renderer = nullptr);

/// A walk at eye height along a street of that city, looking around; t in [0, 1].
void SetCityCamera(vtkRenderer* renderer, double t);
void MoveCityCamera(Comparison& comparison, double t);
void FrameOfCity(Comparison& comparison, double t, const std::string& what = "");

/// Add an upright rectangle (normal z) of cells x cells quads, unlit, so that only its colour tells
/// it from others.
int AddQuad(Stage& stage, double x0, double y0, double x1, double y1, double z, int cells = 1);

/// Frames of a scene, changed by `set`, of props that cover each other at exactly the same depths,
/// while a door before them moves. Returns how many were drawn once more for their order.
int MoveTheDoorBeforeTies(unsigned int seed, int frames, const Comparison::Change& set,
  ComparisonOptions options = ComparisonOptions());

/// For tests that know every verdict: the culler alone, testing in every frame, however few props
/// there are, with texels of level 0 of `baseFactor` pixels.
ComparisonOptions MakeExactOptions(int width, int height, int baseFactor = 1);

/// A parallel camera in which a unit of x and y is a pixel of a viewport of this size, (0, 0) is
/// its lower left corner, and z from 99 to -101 becomes a window depth from 0 to 1.
void SetPixelCamera(
  vtkRenderer* renderer, int width, int height, double shiftX = 0.0, double shiftY = 0.0);

/// The culler has warned once, in words that name all of these.
void ExpectOneWarning(const std::string& messages, const std::vector<std::string>& words);

/// The wall, some frames of a walk, each drawn whole for the same reason; one warning in all that
/// names cause and remedy.
void ExpectFailure(const Comparison::Change& build, ComparisonOptions options, Decision failure,
  const std::vector<std::string>& words);

/// Render until what the first frame drew as a guess has been tested.
void Settle(Comparison& comparison);
}

#endif
