// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeProps.h
 * @brief What the tests of props that are drawn unit by unit share.
 */
#ifndef LargeProps_h
#define LargeProps_h

#include "CullerTest.h"

#include "vtkDataSetAttributes.h"
#include "vtkPoints.h"

#include <random>

namespace LargeProps
{
/// The scene of one case.
struct Case : NamedCase
{
  std::function<void(Stage&)> Build;
};

/// What happens to a prop between two frames.
struct Change : NamedCase
{
  Comparison::Change Apply;
  bool IsDividedAfterwards = true;
};

/// Units of so many triangles, made without delay.
ComparisonOptions MakeOptions(int unitSize = 8);

/// The same for mappers that announce nothing when nothing of them is drawn.
ComparisonOptions MakeOptionsWithoutDraws(int unitSize = 8);

/// Two walls in a scene of about 60 x 60.
void AddWalls(Stage& stage);
void AddTallWalls(Stage& stage);

/// Points at random in a block of 60 x 60 x 8.
vtkSmartPointer<vtkPoints> MakeCloudPoints(int count);

/// Adds an array of random values between two bounds.
template <typename Array>
vtkSmartPointer<Array> AddRandomArray(vtkDataSetAttributes* data, vtkIdType tuples,
  const char* name, int components, double lowest, double highest)
{
  std::minstd_rand random(3);
  std::uniform_real_distribution<> uniform(lowest, highest);
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, static_cast<typename Array::ValueType>(uniform(random)));
  }
  data->AddArray(array);
  return array;
}

/// Sets the camera of a frame.
using Path = std::function<void(vtkRenderer*, int)>;

/// Walk through a scene of about 60 x 60 at eye height, then look at it from above.
void Walk(vtkRenderer* renderer, int frame);
/// The same, from farther outside.
void WalkFromOutside(vtkRenderer* renderer, int frame);

/// How many units were hidden on a walk, and fresh after its first three frames.
struct Units
{
  int Hidden = 0;
  int Fresh = 0;
};

/// Compare 14 frames. From the third one on there are units.
Units CompareWalk(Comparison& comparison, const Path& path);

/// Compare a walk without multisampling and one with it, where units are larger, each with more
/// hidden and fresh units than `least`. `afterwards` is called after each.
void CompareWalks(const Comparison::Change& build, ComparisonOptions options, int largeUnitSize,
  const Path& path, const Units& least, const std::function<void(Comparison&)>& afterwards);

/// Compare 4 frames of a walk, which have units, the change, and 6 more frames.
void CompareChange(Comparison& comparison, const Comparison::Change& change, const Path& path);

/// A walk with the culler as it is, one on which it does not divide props, and one on which it
/// divides them again.
void CompareSwitch(Comparison& comparison, const Path& path, int units);

/// In each frame of a walk a selection of all cells that are seen finds the same ones in both
/// stages, and at least one. In some frames units are hidden.
void ComparePicks(Comparison& comparison, const Path& path);
}

#endif
