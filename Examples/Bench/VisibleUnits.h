// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VisibleUnits.h
 * @brief The units of large props that own a pixel.
 */
#ifndef VisibleUnits_h
#define VisibleUnits_h

#include "Session.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace NBufferBench
{

struct VisibleUnits
{
  std::vector<vtkSmartPointer<vtkActor>> Actors; ///< The caller keeps them alive.
  /// How many units (of instances: how many instances) they draw in each pose; empty if there is no
  /// large prop.
  std::vector<double> Counts;
};

/**
 * Replaces each large prop in `visible`, the visible props of every pose, by an actor that draws
 * exactly those of its units that own a pixel, with the units and the order of drawing of
 * vtkNBufferCuller. (The units of composite data are its blocks. VTK makes new buffers for those
 * that own a pixel, so that it need not look at all blocks as it does in the original.) Large are
 * props that it divides by default. Of instances those that own a pixel are drawn, and not whole
 * units. Each of the new actors has been drawn once, so that its buffers are on the device.
 *
 * A hardware selection of cells finds which primitives own a pixel (without multisampling), and a
 * drawing in the colours of their numbers which instances do.
 */
VisibleUnits ReplaceByVisibleUnits(Session& session, const NBufferExamples::CameraPath& path,
  std::vector<std::vector<vtkProp*>>& visible);

} // namespace NBufferBench

#endif
