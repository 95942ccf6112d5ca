// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferSplatStream.h
 * @brief The points of a vtkPointGaussianMapper: what it draws, and which of them may be divided.
 *
 * The mapper lets a helper draw, which is a mapper of polydata with one vertex for each splat.
 * Since VTK 9.3 the helper draws by an index buffer. In older versions it calls glDrawArrays() for
 * all vertices, and setting the number of indices to 0 does not prevent that; see
 * vtkNBufferOwnDraw.
 *
 * Only splats with the scale factor 0, drawn as opaque points, are divided. Splats with a radius
 * are blended among opaque props, with the depth of the whole splat, so that what is drawn before
 * them shows through (vtkNBufferDrawOrder.h).
 */
#ifndef vtkNBufferSplatStream_h
#define vtkNBufferSplatStream_h

#include "vtkNBufferUnits.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLHelper;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;

namespace vtkNBufferSplatStream
{
/// The mapper if it is the helper that draws splats, otherwise nullptr.
vtkOpenGLPolyDataMapper* GetHelper(vtkAbstractMapper* mapper);

/// Whether the actor has a vtkPointGaussianMapper that draws one polydata.
bool DrawsSplats(vtkActor* actor);

/// Whether an actor draws splats as opaque points, in the actor's place and at their own depths.
bool MayBeDivided(vtkActor* actor);

/// The data of an actor that draws splats.
vtkPolyData* GetData(vtkActor* actor);

/// Whether a stream of the helper has no index buffer.
bool DrawsArrays(vtkOpenGLHelper* stream);

/// The vertices of a stream without an index buffer, in the order in which they are drawn.
void ReadVertices(vtkPolyData* data, vtkNBufferUnits::Mesh& mesh);
}

VTK_ABI_NAMESPACE_END
#endif
