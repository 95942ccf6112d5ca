// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Terrain.h
 * @brief The hills that come with the examples: elevations around the Jacksboro Fault in Tennessee.
 * Examples/Data/README.md names their source.
 */
#ifndef Terrain_h
#define Terrain_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace NBufferExamples
{

/**
 * Makes a surface of triangles with normals, 7.1 by 8.9 km, in metres. x points to the east, y to
 * the north, z up; the origin is in the south-west. The data have 97 x 97 points, 3 arc seconds
 * apart; two more points are interpolated by cubics between neighbours in each direction. `program`
 * is argv[0]. Throws std::runtime_error if the data cannot be read.
 */
vtkSmartPointer<vtkPolyData> MakeTerrain(const std::string& program);

} // namespace NBufferExamples

#endif
