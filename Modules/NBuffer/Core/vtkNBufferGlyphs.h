// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGlyphs.h
 * @brief The instances of a vtkGlyph3DMapper: the sources, and where each of their copies is.
 *
 * VTK's mapper computes the matrices of the instances only when it draws them, and in a private
 * class. The functions below give them earlier, and also for props that are never drawn.
 * GetMatrices() repeats what vtkOpenGLGlyph3DMapper::RebuildStructures() does in VTK 9.1 to 9.7:
 * position, orientation, scale and mask of each point, computed in doubles and rounded to floats. A
 * test compares the result with the buffers that VTK uploads, bit for bit.
 */
#ifndef vtkNBufferGlyphs_h
#define vtkNBufferGlyphs_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"
#include "vtkType.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkGlyph3DMapper;
class vtkMapper;

namespace vtkNBufferGlyphs
{
/**
 * The mapper if it is VTK's own and draws copies of polydata, which are called its sources, at the
 * points of one data set, otherwise nullptr. It is nullptr for a tree of sources and composite
 * data; with VTK's own culling of instances, which replaces sources by coarser ones; and for
 * subclasses, which may draw anything.
 */
VTKNBUFFER_EXPORT vtkGlyph3DMapper* GetMapper(vtkMapper* mapper);

/// The newest time of what the matrices of such a mapper are computed from.
VTKNBUFFER_EXPORT vtkMTimeType GetTime(vtkGlyph3DMapper* mapper);

/// The number of the source that such a mapper copies to each point, or -1 if the source has no
/// points, so that VTK leaves it out. Masks are ignored.
VTKNBUFFER_EXPORT std::vector<int> GetSources(vtkGlyph3DMapper* mapper);

/**
 * The matrices of the instances that such a mapper draws, from the coordinates of their sources to
 * those of the actor, row by row, in the order of the points. Their elements are floats. Instances
 * that the mask leaves out are missing, and so are those that nothing can be seen of: those with a
 * number that is not finite, and those with two or three scales of 0, which are points or lines. If
 * an array has a wrong number of components, VTK reports it and draws nothing, and the result is
 * empty.
 */
VTKNBUFFER_EXPORT std::vector<std::array<double, 16>> GetMatrices(vtkGlyph3DMapper* mapper);
}
VTK_ABI_NAMESPACE_END
#endif
