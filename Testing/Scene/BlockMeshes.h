// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockMeshes.h
 * @brief Meshes for the blocks of composite data that every VTK draws in the same order.
 */
#ifndef BlockMeshes_h
#define BlockMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace TestScene
{
/// Makes empty meshes in the order of their addresses. VTK before 9.3 draws blocks in that order,
/// which has to be the same in scenes that are compared where blocks touch each other or blend.
inline std::vector<vtkSmartPointer<vtkPolyData>> MakeBlockMeshes(std::size_t count)
{
  std::vector<vtkSmartPointer<vtkPolyData>> meshes(count);
  std::generate(meshes.begin(), meshes.end(), [] { return vtkSmartPointer<vtkPolyData>::New(); });
  std::sort(meshes.begin(), meshes.end(),
    [](vtkPolyData* a, vtkPolyData* b) { return std::less<>()(a, b); });
  return meshes;
}
}

#endif
