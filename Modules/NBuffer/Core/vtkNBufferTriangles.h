// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferTriangles.h
 * @brief The triangles of a polydata as VTK's OpenGL mappers draw them as surfaces.
 */
#ifndef vtkNBufferTriangles_h
#define vtkNBufferTriangles_h

#include "vtkNBufferVTKVersion.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

namespace vtkNBufferTriangles
{
/// Three points for each, of polygons and then of strips, made by the mapper's own functions. None
/// of a mesh without points.
std::vector<unsigned int> Get(vtkPolyData* mesh);
}

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferTriangles.h
