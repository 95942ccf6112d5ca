// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferRangeDraw.h
 * @brief Draws ranges of the primitives of a mesh that has scalars or normals of cells.
 *
 * The shader of vtkOpenGLPolyDataMapper reads the values of a cell from a texture, at the place
 * gl_PrimitiveID + PrimitiveIDOffset. OpenGL counts gl_PrimitiveID from the beginning of each draw.
 * The triangles of a shortened list of indices would therefore have the values of others. Instead,
 * ranges of VTK's own list are drawn, each with the number of its first primitive in the uniform
 * variable PrimitiveIDOffset.
 */
#ifndef vtkNBufferRangeDraw_h
#define vtkNBufferRangeDraw_h

#include "vtkNBufferUnits.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;

namespace vtkNBufferRangeDraw
{
/// Whether the shader, whose parameters are being set, reads values by the numbers of primitives.
bool IsNeeded(vtkOpenGLHelper* stream);

/// Draw these ranges of a stream of triangles or points for which everything has been bound
/// (vtkNBufferOwnDraw). Returns false if there are none.
bool Draw(const std::vector<vtkNBufferUnits::Range>& ranges, vtkOpenGLHelper* stream);
}
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferRangeDraw.h
