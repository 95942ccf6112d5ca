// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Terrain.h
 * @brief Hills that come with the examples: elevations around the Jacksboro Fault in Tennessee.
 *
 * Examples/Data/README.md says where they come from.
 */
#ifndef Terrain_h
#define Terrain_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace NBufferExamples
{

/**
 * A surface of triangles with normals, 7.1 by 8.9 km: metres, x east, y north, z up, the origin in
 * the south-west. Between the points of the data, 97 x 97 at 3 arc seconds, twice as many are
 * interpolated by cubics in each direction. `program` is argv[0]. Throws std::runtime_error if the
 * data cannot be read.
 */
vtkSmartPointer<vtkPolyData> MakeTerrain(const std::string& program);

} // namespace NBufferExamples

#endif
