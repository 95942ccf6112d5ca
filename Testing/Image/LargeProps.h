// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LargeProps.h
 * @brief What tests of large props share, which the culler draws unit by unit.
 */
#ifndef LargeProps_h
#define LargeProps_h

#include "CullerTest.h"
#include "vtkNBufferGLM.h"

#include "vtkDataSetAttributes.h"
#include "vtkPoints.h"

#include <random>
#include <vector>

namespace LargeProps
{
/// A named scene.
struct Case : NamedCase
{
  std::function<void(Stage&)> Build;
};

/// A named change of a prop between two frames.
struct Change : NamedCase
{
  Comparison::Change Apply;
  bool IsDividedAfterwards = true; ///< Whether the culler still draws the prop unit by unit then.
};

/// Returns these changes, and those that any large prop can undergo.
std::vector<Change> AndCommonChanges(std::vector<Change> changes);

/// Returns options with which props of 100 primitives and more are divided at once, into units of
/// `unitSize` triangles.
ComparisonOptions MakeOptions(int unitSize = 8);

/// Returns the same options for mappers whose draws cannot be counted, because they announce
/// nothing when none of their units is drawn.
ComparisonOptions MakeOptionsWithoutDraws(int unitSize = 8);

///@{
/// Add two walls to a scene of about 60 x 60 units.
void AddWalls(Stage& stage);
void AddTallWalls(Stage& stage);
///@}
/// Adds a sphere as a large prop, and the walls of AddWalls().
void AddSphereAndWalls(Stage& stage);

/// Returns random points in a block of 60 x 60 x 8 units.
vtkSmartPointer<vtkPoints> MakeCloudPoints(int count);

/// Returns points at these places, in no order.
vtkSmartPointer<vtkPoints> MakeShuffledPoints(std::vector<glm::dvec3> places);

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

/// Sets the camera for the frame of this number.
using Path = std::function<void(vtkRenderer*, int)>;

///@{
/// Walk through a scene of about 60 x 60 units at eye height for eight frames, then look at it from
/// above. WalkFromOutside() begins farther outside.
void Walk(vtkRenderer* renderer, int frame);
void WalkFromOutside(vtkRenderer* renderer, int frame);
///@}

/// The sums over a walk of hidden units and, after its first three frames, of fresh units: those
/// that the culler draws late; and the units that the graphics device has tested.
struct Units
{
  int Hidden = 0;
  int Fresh = 0;
  int OnDevice = 0;
};

/// Compares 14 frames, and returns the sums. Expects that there are units from the third frame on.
Units CompareWalk(Comparison& comparison, const Path& path);

/// Compares a walk without multisampling, and one with it and with units of `largeUnitSize`.
/// Expects more hidden and fresh units than `least` in each. Calls `afterwards` after each.
void CompareWalks(const Comparison::Change& build, ComparisonOptions options, int largeUnitSize,
  const Path& path, const Units& least, const std::function<void(Comparison&)>& afterwards);

/// Compares 4 frames of a walk, expects that there are units then, applies the change, and compares
/// it and 6 more frames.
void CompareChange(Comparison& comparison, const Comparison::Change& change, const Path& path);

/// Compares three walks of 4 frames, in the second of which the culler does not divide props.
/// Expects `units` units after the first and the third one, and 0 after the second one.
void CompareSwitch(Comparison& comparison, const Path& path, int units);

/// Compares 6 frames of a walk. Expects that in each of them a hardware selection of all visible
/// cells finds the same cells in both stages, and at least one; and that units are hidden in some.
void ComparePicks(Comparison& comparison, const Path& path);
}

#endif
