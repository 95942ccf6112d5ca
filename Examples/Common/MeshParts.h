// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshParts.h
 * @brief Splits one mesh into several: by a number for each cell, or into its connected regions.
 */
#ifndef MeshParts_h
#define MeshParts_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace NBufferExamples
{

/// Returns a mesh for each number from 0 to `parts` - 1, with the cells that have this number,
/// their points, and the data of these points. Cells keep their order; those with a negative number
/// are left out.
std::vector<vtkSmartPointer<vtkPolyData>> SplitMesh(
  vtkPolyData* mesh, const std::vector<int>& numbers, int parts);

/// Returns, for every cell, the number of its region; regions are numbered in the order of their
/// first cells, and `count` is set to how many there are. Two cells belong to one region if they
/// use a point, or two points in one place, or are joined by a chain of such cells.
std::vector<int> FindRegions(vtkPolyData* mesh, int& count);

} // namespace NBufferExamples

#endif
